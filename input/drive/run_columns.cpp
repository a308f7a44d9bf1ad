// SPDX-License-Identifier: BSD-3-Clause
// Applies `columns`, `units`, `unit_names` and `ignore` to the headings and reports names that are unknown or used twice.

#include "input/drive/run_columns.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "input/loggers/logger_units.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

void apply_unit(ColumnHead& head, const LocatedString& unit, InputErrors& errors) {
    const bool turns_sign =
        head.heading.unit && unit.text == fmt::format("{}{}", turned_sign, meant_unit(*head.heading.unit, "N"));
    if (head.heading.unit && *head.heading.unit != unit.text && head.form == FieldForm::number && !turns_sign) {
        errors.warn(unit.place, "the column {} is in [{}] by its heading; {} is taken instead", head.heading.name,
                    *head.heading.unit, unit.text);
    }
    head.heading.unit = unit.text;
    head.unit_place = unit.place;
}

/// What a column may be called.
std::vector<std::string> known_names(const std::vector<std::string>& sensors,
                                     const std::vector<std::string>& followed) {
    std::vector<std::string> names = names_of(physics::signals());
    const auto is_formula = [](const std::string& text) {
        return text.find_first_of(" +-*/^()<>?") != std::string::npos;
    };
    for (const std::vector<std::string>* more : {&sensors, &followed}) {
        std::copy_if(more->begin(), more->end(), std::back_inserter(names), [&](const std::string& name) {
            return name != "time" && (more == &sensors || !is_formula(name)) &&
                   std::find(names.begin(), names.end(), name) == names.end();
        });
    }
    names.emplace_back("time");
    return names;
}

}  // namespace

std::vector<int> RunColumns::chosen() const {
    std::vector<int> columns;
    std::ranges::transform(used, std::back_inserter(columns), &UsedColumn::column);
    std::ranges::transform(followed, std::back_inserter(columns), &FollowedColumn::column);
    return columns;
}

RunColumns classify_columns(DataFile& file, ColumnKeys& keys, const std::vector<std::string>& sensors,
                            const std::vector<std::string>& followed, InputErrors& errors) {
    RunColumns found;
    std::map<std::string, std::string> taken;  // heading of each name
    const bool has_time = std::ranges::any_of(file.heads(), [&](const ColumnHead& head) {
        return keys.name_of(head.heading.name, head.place).text == "time";
    });
    for (std::size_t i = 0; i < file.heads().size(); ++i) {
        ColumnHead& head = file.heads()[i];
        const std::string& heading = head.heading.name;
        const bool ignored = keys.ignores(heading);
        LocatedString name = keys.name_of(heading, head.place);
        const bool is_time = head.is_clock && !has_time && name.text == heading;
        name.text = is_time ? "time" : name.text;
        if (const LocatedString* unit = keys.unit_of(heading)) {
            apply_unit(head, *unit, errors);
        } else if (const LocatedString* meant = head.heading.unit ? keys.unit_named(*head.heading.unit) : nullptr) {
            head.heading.unit = meant->text;
            head.unit_place = meant->place;
        } else if (head.heading.unit && std::ranges::find(followed, name.text) != followed.end() &&
                   physics::find_signal(name.text) == nullptr && !ignored) {
            MeantUnit by_name = meant_unit_by_name(heading, *head.heading.unit);
            if (by_name.error && name.text != heading) {  // what the case calls it may tell
                MeantUnit by_meaning = meant_unit_by_name(name.text, *head.heading.unit);
                by_name = by_meaning.error ? std::move(by_name) : std::move(by_meaning);
            }
            if (by_name.error) {
                errors.add(head.unit_place.file >= 0 ? head.unit_place : head.place, std::move(*by_name.error));
            }
            head.heading.unit = std::move(by_name.unit);
        }
        if (ignored || heading.empty()) {
            continue;
        }
        const auto column = static_cast<int>(i);
        const physics::Signal* input = physics::find_signal(name.text);
        const bool is_sensor = std::find(sensors.begin(), sensors.end(), name.text) != sensors.end();
        const bool is_followed = name.text != "time" && input == nullptr &&
                                 std::find(followed.begin(), followed.end(), name.text) != followed.end();
        if (name.text != "time" && input == nullptr && !is_sensor) {
            if (name.text == heading || is_followed) {
                found.unused.push_back(column);
            } else {
                found.misnamed = true;
                errors.add(name.place,
                           fmt::format("\"{}\" is {}", name.text,
                                       sensors.empty() ? "not an input" : "neither an input nor a sensor"),
                           suggest(name.text, known_names(sensors, followed), sensors.empty() ? "inputs" : "names"));
            }
            if (!is_followed) {
                continue;
            }
        }
        const auto [first, is_new] = taken.try_emplace(name.text, heading);
        if (!is_new) {
            first->second == heading
                ? errors.add(head.place, fmt::format("the heading \"{}\" stands twice", heading),
                             "rename or remove one of the columns in the file")
                : errors.add(head.place, fmt::format("{} and {} are both {}", first->second, heading, name.text),
                             fmt::format("leave one of them out: ignore = [\"{}\"]", heading));
            continue;
        }
        if (is_followed) {
            found.followed.push_back({.column = column, .name = name.text});
        }
        if (name.text == "time") {
            found.time = column;
        } else if (input != nullptr || is_sensor) {
            found.used.push_back({.column = column, .name = name.text, .input = input, .is_sensor = is_sensor});
        }
    }
    return found;
}

}  // namespace tiretherm::input
