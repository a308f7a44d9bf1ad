// SPDX-License-Identifier: BSD-3-Clause
// Reads the columns of a log that are used, and leaves out those with too little in them.
#include "input/new_case/log_columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "input/files/wildcard.hpp"
#include "input/laps/file_laps.hpp"
#include "input/loggers/car_columns.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/measurements/dead_stretches.hpp"
#include "input/measurements/logged_signal.hpp"
#include "input/new_case/acceleration_axes.hpp"
#include "input/new_case/column_classifier.hpp"
#include "input/new_case/rig_columns.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/units.hpp"
#include "input/text/word_lists.hpp"
#include "input/vehicle/dead_channels.hpp"
#include "input/vehicle/vehicle_log.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input {

namespace {

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
        const ColumnMeaning* meaning = find_meaning(meanings, column.name);
        QuantitySpec spec = meaning->spec;
        spec.low = column.name == "vertical_load" ? -spec.high : spec.low;  // its sign is looked at afterwards
        requests.push_back({.column = column.column,
                            .name = column.name,
                            .spec = spec,
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

/// Columns with too little in them are not used.
void drop_gaps(Log& log) {
    for (LogColumn& column : log.columns) {
        if (column.is_input) {
            if (const auto error = gap_error(column.name, log.time, column.value)) {
                column.drop(error->what);
            }
        } else if (column.is_sensor && !column.first_value()) {
            column.drop(fmt::format("{} has no value in the file", column.name));
        }
    }
}

/// A log without a sensor's column can still drive the case.
void choose_use(Log& log) {
    if (std::ranges::any_of(log.columns, &LogColumn::is_sensor)) {
        log.use = LogUse::run;
        return;
    }
    for (LogColumn& column : log.columns) {
        if (!column.corner.empty() && column.is_used()) {
            column.drop("the log has no tire temperature to compare it with");
        }
    }
    log.use = std::ranges::any_of(log.columns, &LogColumn::is_input) ? LogUse::drive : LogUse::nothing;
}

}  // namespace

std::string_view text_of_other_use(std::string_view use) {
    return use == "laps" ? "counts the laps" : "tells the turns of the car";
}

void LogColumn::drop(std::string why) {
    reason = std::move(why);
    is_dropped = true;
    must_ignore = heading.name == name;
    suggestion = name;
    suggested_unit = unit;
    unit.clear();
    name.clear();
    is_input = is_sensor = false;
}

std::string LogColumn::unit_remark() const {
    return unit_is_given ? "given" : unit_ground.empty() ? "assumed" : "assumed: " + unit_ground;
}

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
    return has_course || std::ranges::any_of(columns, [](const LogColumn& column) {
               return is_motion(column.name) && column.name != "longitudinal_acceleration";
           });
}

namespace {

template <typename Belongs>
std::vector<std::string> corners_with(const std::vector<LogColumn>& columns, Belongs belongs) {
    std::vector<std::string> found;
    for (const std::string_view corner : physics::corner_names) {
        if (std::ranges::any_of(columns,
                                [&](const LogColumn& column) { return column.corner == corner && belongs(column); })) {
            found.emplace_back(corner);
        }
    }
    return found;
}

}  // namespace

std::vector<std::string> Log::corners() const { return corners_with(columns, std::mem_fn(&LogColumn::is_used)); }

std::vector<std::string> Log::corners_measured() const {
    return corners_with(columns, std::mem_fn(&LogColumn::is_sensor));
}

namespace {

/// Puts the units that the user gives into the headings. @returns whose units they are, by the column's index
std::set<std::size_t> give_units(const std::vector<GivenUnit>& units, DataFile& file, InputErrors& errors) {
    std::set<std::size_t> given;
    for (const GivenUnit& one : units) {
        if (signature(meant_unit(one.unit, "K")).empty() && signature(meant_unit(one.unit, "m s-2")).empty()) {
            errors.add({.file = file.number()},
                       fmt::format("\"{}\", the unit given to {}, is no unit", one.unit, one.column),
                       "give one such as km/h, degC, bar, g or deg/s");
            continue;
        }
        bool any = false;
        for (std::size_t i = 0; i < file.heads().size(); ++i) {
            const Heading& heading = file.heads()[i].heading;
            const std::string unit = heading.unit.value_or("");
            if (matches(one.column, heading.name) || one.column == fmt::format("{} [{}]", heading.name, unit) ||
                one.column == fmt::format("{} ({})", heading.name, unit)) {
                file.heads()[i].heading.unit = one.unit;
                given.insert(i);
                any = true;
            }
        }
        if (!any) {
            const std::vector<std::string> names =
                names_of(file.heads(), [](const ColumnHead& head) { return head.heading.name; });
            errors.add({.file = file.number()},
                       fmt::format("no column is called {}, which is given a unit", one.column),
                       suggest(one.column, names, "columns"));
        }
    }
    return given;
}

/// A column whose name says what it is, and whose unit, which the user gave, is one of something else.
void report_wrong_units(const Log& log, const std::vector<ColumnMeaning>& meanings, const std::set<std::size_t>& given,
                        const DataFile& file, InputErrors& errors) {
    for (const LogColumn& column : log.columns) {
        if (column.is_used() || !given.contains(static_cast<std::size_t>(column.column))) {
            continue;
        }
        const std::vector<CarColumn> names = car_columns(column.heading);
        const std::string name = !column.suggestion.empty() ? column.suggestion
                                 : names.empty()            ? ""
                                                            : names.front().name;
        const ColumnMeaning* meaning = find_meaning(meanings, name);
        if (meaning != nullptr && !meaning->any_unit && read_heading_unit(column.heading, meaning->spec).error) {
            errors.add(file.heads()[static_cast<std::size_t>(column.column)].place,
                       fmt::format("{} looks like {}, and the unit given to it is {}", column.heading.name, name,
                                   column.heading.unit.value_or("")),
                       "give it one of this quantity, or none");
        }
    }
}

/// What the log says of the car itself.
VehicleLog log_of_car(const Log& log, const DataFile& file, const InputErrors& errors) {
    VehicleLog of_car;
    of_car.course = course_over_ground(file, log.time, errors);
    if (!log.is_car && of_car.course.course.time.empty()) {
        return of_car;
    }
    const auto history = [&](std::string_view name) {
        const LogColumn* column = log.find(name);
        return column == nullptr ? solver::SignalHistory{} : known_samples(log.time, column->value);
    };
    of_car.speed = history("speed");
    for (const VehicleSignal& signal : vehicle_signals()) {
        of_car.*member_of(signal.name) = history(signal.name);
    }
    of_car.course = where_it_drives(std::move(of_car.course), of_car.speed);
    return of_car;
}

/// Columns of a car's motion to which no sensor is connected, by their index, and why.
std::map<int, std::string> dead_columns(const Log& log, const VehicleLog& of_car) {
    std::map<int, std::string> dead;
    for (const DeadChannel& channel : dead_channels(of_car)) {
        dead[log.find(channel.name)->column] = channel.why;
    }
    for (const LogColumn& column : log.columns) {
        const bool has_other = std::ranges::any_of(log.columns, [&](const LogColumn& other) {
            return !other.is_used() && other.reason == fmt::format("another column is taken for {}", column.name);
        });
        if (is_motion(column.name) && has_other && moves_like_noise(column.name, of_car.*member_of(column.name))) {
            dead.try_emplace(column.column, "moves by no more than noise, and another column may be it");
        }
    }
    const bool stands = std::ranges::all_of(of_car.speed.value, [](double v) { return v == 0.0; });
    if (log.find("speed") != nullptr && stands && log.has_motion()) {
        dead[log.find("speed")->column] = "stands at 0 in all its samples";
    }
    return dead;
}

/// Makes missing what a column of a temperature or a speed says while nothing is measured.
void remove_dead_samples(Log& log, const std::vector<ColumnMeaning>& meanings) {
    for (LogColumn& column : log.columns) {
        const ColumnMeaning* meaning = find_meaning(meanings, column.name);
        if (meaning != nullptr && !column.value.empty()) {
            remove_dead(log.time, column.value, meaning->spec.unit);
        }
    }
}

/// Without anything that tells its turns there is no [vehicle], which alone could use the other signals of a car.
void drop_signals_of_the_car(Log& log) {
    for (LogColumn& column : log.columns) {
        if (log.is_car && !log.has_motion() && is_vehicle_signal(column.name)) {
            column.drop(
                "of the car, and the log has no lateral acceleration, yaw rate, steering or GPS heading that would "
                "tell its turns");
        }
    }
}

/// @returns whether the time has no unit and goes on by whole numbers of five or more
bool may_be_in_ms(const Log& log, const LogColumn& time) {
    // No logger of a car lets five seconds pass between two samples.
    constexpr double least = 5.0;
    return !time.heading.unit && time.unit == "s" && log.time.size() > 1 &&
           std::ranges::adjacent_find(log.time, [](double before, double after) {
               return after - before < least || std::floor(after - before) != after - before;
           }) == log.time.end();
}

/// @param dead columns that are not to be used, and why
std::optional<Log> read_log_without(const std::map<int, std::string>& dead, const std::filesystem::path& path,
                                    const MeshTemplate& mesh, const std::vector<GivenUnit>& units,
                                    InputErrors& errors) {
    std::optional<DataFile> file = DataFile::open(path, {}, errors);
    if (!file) {
        return std::nullopt;
    }
    const std::set<std::size_t> given = give_units(units, *file, errors);
    Log log{.path = path.generic_string()};
    LogMeaning meaning = meaning_of_columns(*file, mesh, dead, errors);
    log.columns = std::move(meaning.columns);
    log.is_car = meaning.is_car;
    log.infrared_zones = meaning.infrared_zones;
    report_wrong_units(log, meaning.meanings, given, *file, errors);
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
    if (errors.count() > 0 || !read_values(*file, meaning.meanings, log, errors)) {
        return std::nullopt;
    }
    if (log.time.size() < 2) {
        return errors.add({.file = file->number()},
                          "the file has a single sample: a run goes from one time to another");
    }
    for (LogColumn& column : log.columns) {
        if (given.contains(static_cast<std::size_t>(column.column))) {
            column.unit = column.heading.unit.value_or("");
            column.unit_is_given = true;
        } else if (log.is_car && column.name == "time" && may_be_in_ms(log, column)) {
            column.unit = "ms";
            column.unit_ground = fmt::format("the rows are {:g} apart", log.time[1] - log.time[0]);
            std::ranges::for_each(log.time, [](double& t) { t *= 1e-3; });
        }
    }
    remove_dead_samples(log, meaning.meanings);
    const VehicleLog of_car = log_of_car(log, *file, errors);
    if (std::map<int, std::string> found = log.is_car ? dead_columns(log, of_car) : std::map<int, std::string>{};
        // Read once more without them: another column may be what they seemed to be.
        !found.empty()) {
        found.insert(dead.begin(), dead.end());
        return read_log_without(found, path, mesh, units, errors);
    }
    settle_axes(log, of_car);
    log.has_course = !of_car.course.course.time.empty();
    turn_signs(log);
    drop_gaps(log);
    drop_signals_of_the_car(log);
    choose_use(log);
    log.laps = find_laps(*file, log.time, std::nullopt, true, errors);
    const auto tells_course = [&](std::string_view name) {
        const std::string& source = of_car.course.source;
        return log.has_course && (name == source || (source == positions_as_source && is_of_position(name)));
    };
    for (LogColumn& column : log.columns) {
        const std::string& name = column.heading.name;
        column.other_use = column.is_used()                                                  ? ""
                           : log.laps.source == LapSource::column && name == log.laps.column ? "laps"
                           : tells_course(name)                                              ? "course"
                                                                                             : "";
        column.is_foreign = column.is_foreign && column.other_use.empty();
    }
    return log;
}

}  // namespace

std::optional<Log> read_log(const std::filesystem::path& path, const MeshTemplate& mesh,
                            const std::vector<GivenUnit>& units, InputErrors& errors) {
    return read_log_without({}, path, mesh, units, errors);
}

void leave_out(Log& log, const std::string& name, const std::string& reason) {
    for (LogColumn& column : log.columns) {
        if (column.name == name) {
            column.drop(reason);
        }
    }
    drop_signals_of_the_car(log);
    choose_use(log);
}

}  // namespace tiretherm::input
