// SPDX-License-Identifier: BSD-3-Clause
// Classifies the columns of a log by their names and units, and reads those that are used.
#include "input/new_case/log_columns.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "input/laps/file_laps.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/measurements/run_inputs.hpp"
#include "input/new_case/car_columns.hpp"
#include "input/new_case/case_writer.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/vehicle/vehicle_log.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

namespace {

std::vector<ColumnMeaning> meanings_of(const MeshTemplate& mesh) {
    std::vector<ColumnMeaning> all{{.name = "time", .spec = quantity_specs::moment}};
    for (const physics::Signal& signal : physics::signals()) {
        all.push_back({.name = std::string(signal.name), .spec = quantity_specs::of(signal), .is_input = true});
    }
    for (const TemplateSensor& sensor : mesh.sensors) {
        all.push_back({.name = sensor.name, .spec = sensor.spec, .is_sensor = true});
    }
    for (const VehicleSignal& signal : vehicle_signals()) {
        all.push_back({.name = std::string(signal.name),
                       .spec = {.unit = signal.unit.empty() ? "1" : signal.unit},
                       .is_input = true,
                       .any_unit = signal.unit.empty()});
    }
    return all;
}

/// Classifies the headings of one file.
class Classifier {
public:
    Classifier(DataFile& file, const MeshTemplate& mesh, InputErrors& errors)
        : file_(file), mesh_(mesh), meanings_(meanings_of(mesh)), errors_(errors) {}

    std::vector<LogColumn> columns() {
        const std::vector<ColumnHead>& heads = file_.heads();
        for (std::size_t i = 0; i < heads.size(); ++i) {
            columns_.push_back({.column = static_cast<int>(i), .heading = heads[i].heading, .name = {}});
        }
        refuse_duplicates();
        for (LogColumn& column : columns_) {
            if (heads[static_cast<std::size_t>(column.column)].is_clock) {
                take(column, meanings_.front());
            }
        }
        for (const bool exact : {true, false}) {
            for (LogColumn& column : columns_) {
                take_by_name(column, exact);
            }
        }
        take_time_by_unit();
        find_car_columns();
        is_car_ = looks_like_a_car();
        if (is_car_) {
            take_by_car();
        } else {
            release_motion();
            for (LogColumn& column : columns_) {
                suggest_for(column);
            }
        }
        return std::move(columns_);
    }

    [[nodiscard]] bool is_car() const { return is_car_; }
    /// Readings across the tread of each tire; 0: no array.
    [[nodiscard]] int infrared_zones() const { return infrared_zones_; }
    [[nodiscard]] const std::vector<ColumnMeaning>& meanings() const { return meanings_; }

private:
    /// A column and a thing that it may be by a rule for cars.
    struct CarCandidate {
        std::size_t column = 0;
        CarColumn is{};
    };

    /// Whether there are readings of several tires, or of how a car moves, and no load of one tire.
    [[nodiscard]] bool looks_like_a_car() const {
        std::set<std::string> corners;
        bool moves = std::ranges::any_of(columns_, [](const LogColumn& column) { return is_motion(column.name); });
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
            const bool known =
                std::ranges::find(meanings_, column.heading.name, &ColumnMeaning::name) != meanings_.end();
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

    /// Uses a column, unless nobody can tell its unit.
    void take(LogColumn& column, const ColumnMeaning& meaning) {
        const UnitRead read =
            meaning.any_unit ? any_unit(column.heading) : read_heading_unit(column.heading, meaning.spec);
        if (read.error) {
            // A time without unit counts seconds in nearly every log.
            const bool bare_time = meaning.name == "time" && trim(column.heading.unit.value_or("")).empty();
            column.unit = bare_time ? "s" : guess_unit(column.heading.unit.value_or(""), meaning.spec);
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

    [[nodiscard]] const ColumnMeaning* meaning_of(std::string_view name) const {
        const auto found = std::ranges::find(meanings_, name, &ColumnMeaning::name);
        return found == meanings_.end() ? nullptr : &*found;
    }

    /// What the columns may be in the log of a car, the surest first; units of another kind rule a thing out.
    void find_car_columns() {
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const Heading& heading = columns_[i].heading;
            if (columns_[i].is_used() || !columns_[i].reason.empty() || !is_printable(heading.name)) {
                continue;
            }
            for (CarColumn& is : car_columns(heading.name)) {
                if (suits(heading, meaning_of(is.name))) {
                    candidates_.push_back({i, std::move(is)});
                }
            }
        }
        std::ranges::stable_sort(candidates_, {}, [](const CarCandidate& candidate) { return candidate.is.rank; });
    }

    /// Whether the unit is one of this quantity, or missing. @param meaning null: a temperature, for which another mesh has a place
    [[nodiscard]] static bool suits(const Heading& heading, const ColumnMeaning* meaning) {
        const QuantitySpec& spec = meaning == nullptr ? quantity_specs::temperature : meaning->spec;
        return !heading.unit || trim(*heading.unit).empty() || (meaning != nullptr && meaning->any_unit) ||
               !read_heading_unit(heading, spec).error || !guess_unit(*heading.unit, spec).empty();
    }

    /// Readings of one tire that are numbered without a gap are an array; its sensors are called infrared_1, infrared_2 ...
    void find_arrays() {
        std::map<std::string, std::map<int, std::vector<CarCandidate*>>> places;
        for (CarCandidate& candidate : candidates_) {
            if (candidate.is.place) {
                places[candidate.is.corner][*candidate.is.place].push_back(&candidate);
            }
        }
        for (auto& [corner, by_number] : places) {
            const int first = by_number.begin()->first;
            const int count = by_number.rbegin()->first - first + 1;
            const bool whole = first <= 1 && count > 1 && std::cmp_equal(count, by_number.size()) &&
                               (infrared_zones_ == 0 || infrared_zones_ == count) &&
                               std::ranges::all_of(by_number, [](const auto& one) { return one.second.size() == 1; });
            infrared_zones_ = whole ? count : infrared_zones_;
            for (auto& [number, columns] : by_number) {
                for (CarCandidate* candidate : columns) {
                    if (whole) {
                        candidate->is.name = fmt::format("infrared_{}", number - first + 1);
                    } else {
                        candidate->is.question = "which place across the tread?";
                    }
                }
            }
        }
        for (int i = 1; i <= infrared_zones_ && mesh_.name == "section"; ++i) {
            meanings_.push_back(
                {.name = fmt::format("infrared_{}", i), .spec = quantity_specs::temperature, .is_sensor = true});
        }
    }

    void take_by_car() {
        find_arrays();
        ask_about_equals();
        for (const CarCandidate& candidate : candidates_) {
            LogColumn& column = columns_[candidate.column];
            if (column.is_used() || !column.reason.empty()) {
                continue;
            }
            column.corner = candidate.is.corner;
            const ColumnMeaning* meaning = meaning_of(candidate.is.name);
            if (meaning == nullptr) {
                const std::string elsewhere = candidate.is.place ? "section" : mesh_with(candidate.is.name);
                column.reason = fmt::format("the mesh {} has no place for {}, --mesh {} has", mesh_.name,
                                            candidate.is.name, elsewhere);
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

    /// Several readings of one tire's tread of which none is the surer: which is it?
    void ask_about_equals() {
        for (CarCandidate& one : candidates_) {
            const auto is_equal = [&](const CarCandidate& other) {
                return other.column != one.column && other.is.name == one.is.name && other.is.corner == one.is.corner &&
                       other.is.rank == one.is.rank;
            };
            if (one.is.name.ends_with("surface_temperature") && one.is.question.empty() &&
                std::ranges::any_of(candidates_, is_equal)) {
                one.is.question = "which of several across the tread?";
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
            column.reason = fmt::format("the mesh {} has no place for it, --mesh {} has", mesh_.name, elsewhere);
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
                const std::string unit = guess_unit(column.heading.unit.value_or(""), guess->spec);
                column.suggested_unit = unit.empty() ? usual_unit(guess->spec) : unit;
            }
        }
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

    DataFile& file_;
    const MeshTemplate& mesh_;
    std::vector<ColumnMeaning> meanings_;
    InputErrors& errors_;
    std::vector<LogColumn> columns_;
    std::vector<CarCandidate> candidates_;
    std::set<std::string> taken_;  ///< "surface_temperature of FL"
    bool is_car_ = false;
    int infrared_zones_ = 0;
};

void drop(LogColumn& column, std::string reason) {
    column.reason = std::move(reason);
    column.must_ignore = column.heading.name == column.name;
    column.suggestion = column.name;
    column.suggested_unit = column.unit;
    column.unit.clear();
    column.name.clear();
    column.is_input = column.is_sensor = false;
}

/// Reads the used columns. @returns false after an error
bool read_values(DataFile& file, const std::vector<ColumnMeaning>& meanings, Log& log, InputErrors& errors) {
    std::vector<ColumnRequest> requests;
    std::vector<LogColumn*> targets;
    for (LogColumn& column : log.columns) {
        if (!column.is_used()) {
            continue;
        }
        if (!column.unit.empty()) {
            file.heads()[static_cast<std::size_t>(column.column)].heading.unit = column.unit;
        }
        const auto meaning = std::ranges::find(meanings, column.name, &ColumnMeaning::name);
        requests.push_back({.column = column.column,
                            .name = column.name,
                            .spec = meaning->spec,
                            .purpose = column.name == "time" ? Purpose::clock
                                       : meaning->any_unit   ? Purpose::unused
                                                             : Purpose::measured});
        targets.push_back(&column);
    }
    std::vector<std::vector<double>> values = file.read(requests, errors);
    for (std::size_t i = 0; i < values.size(); ++i) {
        (targets[i]->name == "time" ? log.time : targets[i]->value) = std::move(values[i]);
    }
    return !values.empty();
}

bool has_gap(const LogColumn& column) {
    return std::ranges::any_of(column.value, [](double v) { return std::isnan(v); });
}

/// Columns with too little in them are not used.
void drop_gaps(Log& log) {
    for (LogColumn& column : log.columns) {
        if (column.is_input) {
            if (const auto error = gap_error(column.name, log.time, column.value, "")) {
                drop(column, error->what);
            }
        } else if (column.is_sensor && !column.first_value()) {
            drop(column, fmt::format("{} has no value in the file", column.name));
        }
    }
}

/// A log without a sensor's column can still drive the case; [[drive.file]] reads CSV, units as the headings have them,
/// without a gap.
void choose_use(Log& log) {
    if (std::ranges::any_of(log.columns, &LogColumn::is_sensor)) {
        log.use = LogUse::run;
        return;
    }
    for (LogColumn& column : log.columns) {
        if (!column.corner.empty() && column.is_used()) {
            drop(column, "nothing is measured on the tires that it could be compared with");
        }
    }
    const LogColumn* time = log.find("time");
    const std::string whole = !log.is_text          ? "inputs without a measured temperature are read from CSV alone"
                              : !time->unit.empty() ? "the time has no unit that can be read: write \"time [s]\""
                                                    : "";
    for (LogColumn& column : log.columns) {
        if (column.is_input && !whole.empty()) {
            drop(column, whole);
        } else if (column.is_input && !column.unit.empty()) {
            drop(column,
                 fmt::format("[{}] is no unit of it: write [{}]", column.heading.unit.value_or(""), column.unit));
        } else if (column.is_input && has_gap(column)) {
            drop(column, fmt::format("{} has missing values", column.name));
        }
    }
    log.use = std::ranges::any_of(log.columns, &LogColumn::is_input) ? LogUse::drive : LogUse::nothing;
}

}  // namespace

std::string LogColumn::full_name() const {
    return name.empty() || corner.empty() ? name : fmt::format("{} of {}", name, corner);
}

std::string LogColumn::full_suggestion() const {
    return suggestion.empty() || corner.empty() ? suggestion : fmt::format("{} of {}", suggestion, corner);
}

std::string LogColumn::title() const {
    return heading.unit ? fmt::format("{} [{}]", heading.name, *heading.unit) : heading.name;
}

std::optional<double> LogColumn::first_value() const {
    const auto found = std::ranges::find_if(value, [](double v) { return !std::isnan(v); });
    return found == value.end() ? std::nullopt : std::optional(*found);
}

const LogColumn* Log::find(std::string_view name) const {
    const auto found = std::ranges::find(columns, name, &LogColumn::name);
    return found == columns.end() ? nullptr : &*found;
}

bool Log::has_motion() const {
    return std::ranges::any_of(columns, [](const LogColumn& column) { return is_motion(column.name); });
}

std::vector<std::string> Log::corners() const {
    std::vector<std::string> found;
    for (const std::string_view corner : physics::corner_names) {
        if (std::ranges::any_of(columns,
                                [&](const LogColumn& column) { return column.is_used() && column.corner == corner; })) {
            found.emplace_back(corner);
        }
    }
    return found;
}

std::optional<Log> read_log(const std::filesystem::path& path, const MeshTemplate& mesh, InputErrors& errors) {
    std::optional<DataFile> file = DataFile::open(path, {}, errors);
    if (!file) {
        return std::nullopt;
    }
    Log log{.path = path.generic_string(), .is_text = file->is_text()};
    Classifier classifier(*file, mesh, errors);
    log.columns = classifier.columns();
    log.is_car = classifier.is_car();
    log.infrared_zones = classifier.infrared_zones();
    std::vector<int> used;
    for (const LogColumn& column : log.columns) {
        if (column.is_used()) {
            used.push_back(column.column);
        }
    }
    file->choose_rows(used);
    if (log.find("time") == nullptr) {
        errors.add(file->heads().front().place, "no column of the file is the time",
                   "call one time [s], as in time [s],speed [km/h]");
    }
    if (errors.count() > 0 || !read_values(*file, classifier.meanings(), log, errors)) {
        return std::nullopt;
    }
    if (log.time.size() < 2) {
        errors.add({.file = file->number()}, "the file has a single sample: a run goes from one time to another");
        return std::nullopt;
    }
    drop_gaps(log);
    choose_use(log);
    InputErrors of_laps;  // what is wrong with its lines is said above
    log.laps = find_laps(*file, log.time, std::nullopt, true, of_laps);
    return log;
}

}  // namespace tiretherm::input
