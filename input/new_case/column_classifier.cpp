// SPDX-License-Identifier: BSD-3-Clause
// Exact names come first, then names without capitals and blanks, then what loggers of cars call them; the rest is suggested.
#include "input/new_case/column_classifier.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "input/case_text/case_writer.hpp"
#include "input/laps/file_laps.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/new_case/car_candidates.hpp"
#include "input/new_case/rig_columns.hpp"
#include "input/text/characters.hpp"
#include "input/text/column_names.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

namespace {

/// Classifies the headings of one file.
class Classifier {
public:
    Classifier(const DataFile& file, const MeshTemplate& mesh, InputErrors& errors)
        : file_(file), mesh_(mesh), meanings_(meanings_of(mesh)), errors_(errors) {}

    LogMeaning meaning(const std::map<int, std::string>& dead) {
        const std::vector<ColumnHead>& heads = file_.heads();
        for (std::size_t i = 0; i < heads.size(); ++i) {
            columns_.push_back({.column = static_cast<int>(i), .heading = heads[i].heading, .name = {}});
        }
        for (const auto& [column, why] : dead) {
            LogColumn& of = columns_[static_cast<std::size_t>(column)];
            of.reason = why;
            of.must_ignore = meaning_of(of.heading.name) != nullptr;
        }
        refuse_duplicates();
        for (LogColumn& column : columns_) {
            if (heads[static_cast<std::size_t>(column.column)].is_clock) {
                take(column, meanings_.front());
            }
        }
        // All exact names first: "Speed" must not take the place of a later column "speed".
        for (const bool exact : {true, false}) {
            for (LogColumn& column : columns_) {
                take_by_name(column, exact);
            }
        }
        // Then what only some files have. A laser's power and a rig's symbols would be taken for a car's channels otherwise.
        take_laser();
        take_of_a_rig();
        take_time_by_unit();
        candidates_ = car_candidates(columns_, meanings_);
        is_car_ = looks_like_a_car();
        if (is_car_) {
            take_by_car();
        } else {
            release_motion();
            for (LogColumn& column : columns_) {
                suggest_for(column);
            }
        }
        return {.columns = std::move(columns_),
                .meanings = std::move(meanings_),
                .is_car = is_car_,
                .infrared_zones = infrared_zones_};
    }

private:
    /// Whether there are readings of several tires, or of how or where a car moves, and no load of one tire.
    [[nodiscard]] bool looks_like_a_car() const {
        std::set<std::string> corners;
        bool moves = tells_course(file_) ||
                     std::ranges::any_of(columns_, [](const LogColumn& column) { return is_motion(column.name); });
        for (const CarCandidate& candidate : candidates_) {
            moves = moves || is_motion(candidate.is.name);
            corners.insert(candidate.is.corner);
        }
        corners.erase("");
        return !taken_.contains("vertical_load") && (moves || corners.size() > 1);
    }

    /// Two columns of one name of the program would be one thing.
    void refuse_duplicates() {
        std::set<std::string> seen;
        for (const LogColumn& column : columns_) {
            const bool known = meaning_of(column.heading.name) != nullptr;
            if (known && !seen.insert(column.heading.name).second) {
                errors_.add(file_.heads()[static_cast<std::size_t>(column.column)].place,
                            fmt::format("two columns are called {}", column.heading.name), "rename one in the file");
            }
        }
    }

    void take_by_name(LogColumn& column, bool exact) {
        const std::string& written = column.heading.name;
        if (column.is_used() || !column.reason.empty() || written.empty()) {
            return;
        }
        const auto meaning = std::ranges::find_if(meanings_, [&](const ColumnMeaning& m) {
            return exact ? m.name == written : bare_name(m.name) == bare_name(written);
        });
        if (meaning == meanings_.end() || taken_.contains(meaning->name)) {
            return;
        }
        if (!is_printable(written)) {
            column.reason = "its name is not UTF-8: save the file as UTF-8";
            return;
        }
        take(column, *meaning);
    }

    /// "P laser [W]": the power, in its unit, or called so.
    void take_laser() {
        const ColumnMeaning* power = meaning_of("laser_power");
        for (LogColumn& column : columns_) {
            const std::vector<std::string> words = words_of(column.heading.name);
            const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
            const bool is_laser = has("laser") && (column.heading.unit || has("power") || has("p"));
            if (is_laser && !column.is_used() && column.reason.empty() && !taken_.contains(power->name) &&
                has_unit_for(column.heading, power)) {
                take(column, *power);
            } else if (has("laser") && column.heading.unit == "%" && column.reason.empty()) {
                column.reason = "how many W are 100 %?";
                column.suggestion = power->name;
            }
        }
    }

    /// What a tire test machine calls by a symbol, where its unit is one of what the symbol stands for.
    void take_of_a_rig() {
        if (!is_rig_file(columns_)) {
            return;
        }
        std::vector<std::pair<const RigColumn*, LogColumn*>> known;
        for (LogColumn& column : columns_) {
            const RigColumn* is = find_rig_column(column.heading.name);
            if (is != nullptr && !column.is_used() && column.reason.empty()) {
                known.emplace_back(is, &column);
            }
        }
        std::ranges::sort(known);  // as in the table, the surer of two first
        for (const auto& [is, of] : known) {
            LogColumn& column = *of;
            const ColumnMeaning* meaning = meaning_of(is->name);
            if (is->name.empty()) {
                column.reason = "a tire's temperature does not follow from it";
                column.is_foreign = true;
            } else if (taken_.contains(std::string(is->name))) {
                column.reason = fmt::format("another column is taken for {}", is->name);
            } else if (meaning == nullptr) {
                column.reason = no_place_for(std::string(is->name));
            } else if (has_unit_for(column.heading, meaning)) {
                take(column, *meaning);
            }
        }
    }

    /// Uses a column whose unit is known.
    void take(LogColumn& column, const ColumnMeaning& meaning) {
        const UnitRead read =
            meaning.any_unit ? any_unit(column.heading) : read_heading_unit(column.heading, meaning.spec);
        if (read.error) {
            // A time without unit counts seconds in nearly every log.
            const bool bare_time = meaning.name == "time" && trim(column.heading.unit.value_or("")).empty();
            column.unit =
                bare_time ? "s" : guess_unit(column.heading.unit.value_or(""), meaning.spec.unit, meaning.spec.scale);
        }
        if (read.error && column.unit.empty()) {
            column.reason = read.error->what;
            column.suggestion = meaning.name;
            column.suggested_unit = usual_unit(meaning.spec);
            column.must_ignore = column.heading.name == meaning.name;
            return;
        }
        column.name = meaning.name;
        column.is_input = meaning.is_input;
        column.is_sensor = meaning.is_sensor;
        taken_.insert(column.full_name());
    }

    /// Of a column whose unit does not matter, if it only has one.
    static UnitRead any_unit(const Heading& heading) {
        const std::string unit = heading.unit ? meant_unit(*heading.unit, "1") : "";
        UnitRead read{};
        if (!heading.unit || signature(unit.empty() ? "1" : unit).empty()) {
            read.error = ErrorText{heading.unit ? fmt::format("[{}] is no unit", *heading.unit) : "it has no unit", ""};
        }
        return read;
    }

    [[nodiscard]] const ColumnMeaning* meaning_of(std::string_view name) const { return find_meaning(meanings_, name); }

    void take_by_car() {
        infrared_zones_ = name_arrays(candidates_);
        ask_about_equals(candidates_);
        for (int i = 1; i <= infrared_zones_ && mesh_.name == "section"; ++i) {
            meanings_.push_back(
                {.name = fmt::format("infrared_{}", i), .spec = quantity_specs::temperature, .is_sensor = true});
        }
        for (const CarCandidate& candidate : candidates_) {
            LogColumn& column = columns_[candidate.column];
            if (column.is_used() || !column.reason.empty()) {
                continue;
            }
            column.corner = candidate.is.corner;
            const ColumnMeaning* meaning = meaning_of(candidate.is.name);
            if (meaning == nullptr) {
                column.reason = no_place_for(candidate.is.name, candidate.is.place ? "section" : "");
            } else if (!candidate.is.question.empty()) {
                column.reason = candidate.is.question;
                column.suggestion = meaning->name;
            } else if (taken_.contains(of_corner(candidate.is))) {
                column.reason = fmt::format("another column is taken for {}", of_corner(candidate.is));
            } else {
                take(column, *meaning);
            }
        }
        for (LogColumn& column : columns_) {
            if (!column.is_used() && column.reason.empty()) {
                column.reason = "nothing that the model knows by this name";
                column.is_foreign = true;
            }
        }
    }

    [[nodiscard]] static std::string of_corner(const CarColumn& column) {
        return column.corner.empty() ? column.name : fmt::format("{} of {}", column.name, column.corner);
    }

    /// How a car moves says nothing where the load of one tire is given.
    void release_motion() {
        for (LogColumn& column : columns_) {
            if (is_vehicle_signal(column.name)) {
                column.name.clear();
                column.is_input = false;
                column.reason = "of a car; this log is of one tire";
            }
        }
    }

    /// Where no column is called time, the only one in a unit of time.
    void take_time_by_unit() {
        const auto in_time = [](const LogColumn& column) {
            return !column.is_used() && column.heading.unit && !trim(*column.heading.unit).empty() &&
                   is_printable(column.heading.name) && !column.heading.name.empty() &&
                   !read_heading_unit(column.heading, quantity_specs::moment).error;
        };
        if (!taken_.contains("time") && std::ranges::count_if(columns_, in_time) == 1) {
            take(*std::ranges::find_if(columns_, in_time), meanings_.front());
        }
    }

    void suggest_for(LogColumn& column) {
        if (column.is_used() || !column.reason.empty() || column.heading.name.empty()) {
            return;
        }
        if (const std::string elsewhere = mesh_with(column.heading.name); !elsewhere.empty()) {
            column.reason = no_place_for("it", elsewhere);
            return;
        }
        std::vector<ColumnMeaning> free;
        std::ranges::copy_if(meanings_, std::back_inserter(free), [&](const ColumnMeaning& m) {
            return !taken_.contains(m.name) && !is_vehicle_signal(m.name);
        });
        const ColumnMeaning* guess = is_printable(column.heading.name) ? guess_meaning(column.heading, free) : nullptr;
        column.reason = "not a standard name";
        if (guess != nullptr) {
            column.suggestion = guess->name;
            if (read_heading_unit(column.heading, guess->spec).error) {
                const std::string unit =
                    guess_unit(column.heading.unit.value_or(""), guess->spec.unit, guess->spec.scale);
                column.suggested_unit = unit.empty() ? usual_unit(guess->spec) : unit;
            }
        }
    }

    /// @param elsewhere a mesh that has a place for it; empty: that which has a sensor of this name
    [[nodiscard]] std::string no_place_for(const std::string& name, std::string_view elsewhere = "") const {
        return fmt::format("the mesh {} cannot represent {}, --mesh {} can", mesh_.name, name,
                           elsewhere.empty() ? mesh_with(name) : elsewhere);
    }

    /// Another mesh that has a sensor of this name; empty: none.
    [[nodiscard]] std::string mesh_with(const std::string& heading) const {
        for (const std::string_view name : mesh_template_names()) {
            const MeshTemplate other = mesh_template(name, 0.0);
            if (name != mesh_.name && std::ranges::any_of(other.sensors, [&](const TemplateSensor& sensor) {
                    return bare_name(sensor.name) == bare_name(heading);
                })) {
                return other.name;
            }
        }
        return {};
    }

    const DataFile& file_;
    const MeshTemplate& mesh_;
    std::vector<ColumnMeaning> meanings_;
    InputErrors& errors_;
    std::vector<LogColumn> columns_;
    std::vector<CarCandidate> candidates_;
    std::set<std::string> taken_;  ///< "surface_temperature of FL"
    bool is_car_ = false;
    int infrared_zones_ = 0;
};

}  // namespace

LogMeaning meaning_of_columns(const DataFile& file, const MeshTemplate& mesh, const std::map<int, std::string>& dead,
                              InputErrors& errors) {
    return Classifier(file, mesh, errors).meaning(dead);
}

}  // namespace tiretherm::input
