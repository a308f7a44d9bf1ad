// SPDX-License-Identifier: BSD-3-Clause
// Puts a new case together, reads it as `tiretherm run` would, and lists what it lacks.
#include "input/new_case/new_case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/loggers/car_columns.hpp"
#include "input/new_case/case_tables.hpp"
#include "input/runs/runs.hpp"
#include "input/text/characters.hpp"
#include "input/text/word_lists.hpp"
#include "physics/tire.hpp"

namespace tiretherm::input {

namespace {

// Of the library's light truck tire, beside the thesis's passenger tire: cases/tires/drum_265_65_R16C.toml says why.
constexpr double passenger_pressure = 220e3;   // Pa above the atmosphere
constexpr double kart_pressure = 100e3;        // Pa, of slicks that are warm (recalled)
constexpr double light_truck_tread = 3e-3;     // m more
constexpr double light_truck_sidewall = 2e-3;  // m more
constexpr double truck_tread = 13e-3;          // m more: a deeper pattern and four belts of steel
constexpr double truck_sidewall = 5e-3;        // m more
// A motorcycle's: a pattern of 5 mm over 4 mm in front, of 7 to 8 mm over 4 to 5 mm behind, which is as much as a passenger tire's,
// as new tires for the road have (recalled); sidewalls of one or two plies.
constexpr double motorcycle_front_tread = -3e-3;  // m more
constexpr double motorcycle_sidewall = -3e-3;     // m more
constexpr std::string_view mesh_of_a_car = "two_node";

/// By how much crown and sidewall are thicker than a passenger tire's, m.
struct MoreRubber {
    double crown = 0.0;
    double sidewall = 0.0;
};
MoreRubber more_rubber(const TireSize& size) {
    if (size.motorcycle) {
        return {size.is_motorcycle_front() ? motorcycle_front_tread : 0.0, motorcycle_sidewall};
    }
    return size.truck         ? MoreRubber{truck_tread, truck_sidewall}
           : size.light_truck ? MoreRubber{light_truck_tread, light_truck_sidewall}
                              : MoreRubber{};
}

CaseDraft begin(const NewCaseRequest& request, NewCase& result) {
    const physics::Tire thesis;
    const TireSize& size = request.size;
    CaseDraft draft{.request = request, .mesh = {}, .result = result};
    const MoreRubber more = more_rubber(size);
    draft.tread_thickness = thesis.tread_thickness + more.crown;
    draft.sidewall_thickness = thesis.sidewall_thickness + more.sidewall;
    const bool is_of_car = !size.light_truck && !size.motorcycle;
    draft.inflation_pressure = request.inflation_pressure.value_or(size.is_kart() ? kart_pressure
                                                                   : is_of_car    ? passenger_pressure
                                                                                  : size.load_pressure());
    draft.pressure_ground = request.inflation_pressure   ? ""
                            : size.is_kart()             ? "assumed: a kart's"
                            : size.is_motorcycle_front() ? "assumed: a motorcycle's in front"
                            : size.motorcycle            ? "assumed: a motorcycle's behind"
                                                         : "";
    return draft;
}

/// Where nobody gives the pressure and the log has it, the mean of what its tires begin with.
void take_pressure(CaseDraft& draft) {
    constexpr double least = 20e3;  // Pa; what is lower is no tire's
    if (draft.request.inflation_pressure || draft.log() == nullptr || draft.log()->use == LogUse::nothing) {
        return;
    }
    double sum = 0.0;
    double tires = 0.0;
    for (const LogColumn& column : draft.log()->columns) {
        if (column.name == "inflation_pressure" && column.first_value().value_or(0.0) > least) {
            sum += *column.first_value();
            tires += 1.0;
        }
    }
    if (tires > 0.0) {
        draft.inflation_pressure = 1e3 * std::round(1e-3 * sum / tires);
        draft.pressure_ground = "what the log's inflation_pressure begins with";
    }
}

void take_mesh(CaseDraft& draft, std::string_view name) {
    if (name == specimen_mesh) {  // cut from the thesis's tire, whatever the size
        const physics::Tire thesis;
        draft.tread_thickness = thesis.tread_thickness;
        draft.sidewall_thickness = thesis.sidewall_thickness;
    }
    draft.mesh = mesh_template(name, draft.tread_thickness * 1e3);
    draft.result.mesh = draft.mesh.what;
    draft.result.mesh_name = name;
}

/// Whether readings lie side by side across a tread, which a single column of a tire does not tell apart.
bool has_places_across(const Log& log) {
    return log.infrared_zones > 0 || std::ranges::any_of(log.columns, [](const LogColumn& column) {
               return column.is_sensor && column.name.ends_with("_surface_temperature") &&
                      column.name != "surface_temperature";
           });
}

/// Whether a column has, or seems to have, the power of a laser, which no rolling tire is under.
bool has_laser(const Log& log) {
    return std::ranges::any_of(log.columns, [](const LogColumn& column) {
        return column.name == "laser_power" || column.suggestion == "laser_power";
    });
}

/// Mesh and log, which depend on each other: a mesh says what may have been measured. @returns false after an error
bool read_mesh_and_log(CaseDraft& draft) {
    const NewCaseRequest& request = draft.request;
    take_mesh(draft, request.mesh.empty() ? mesh_template_names().front() : std::string_view(request.mesh));
    if (!request.log) {
        return true;
    }
    InputErrors& errors = draft.errors;
    draft.result.log = read_log(*request.log, draft.mesh, request.units, errors);
    if (request.mesh.empty() && draft.log() != nullptr && has_laser(*draft.log())) {
        take_mesh(draft, specimen_mesh);
        draft.result.log = read_log(*request.log, draft.mesh, request.units, errors);
    } else if (request.mesh.empty() && draft.log() != nullptr && draft.log()->is_car &&
               !has_places_across(*draft.log())) {
        // Four tires over many laps: seconds in place of minutes. Not where a tire would lose its only reading.
        std::optional<Log> lumped = read_log(*request.log, mesh_template(mesh_of_a_car, 0.0), request.units, errors);
        if (lumped && lumped->use == draft.log()->use &&
            lumped->corners_measured() == draft.log()->corners_measured()) {
            take_mesh(draft, mesh_of_a_car);
            draft.result.log = std::move(lumped);
        }
    }
    take_pressure(draft);
    draft.result.errors = errors.in_order();
    draft.result.files = errors.files();
    return draft.result.errors.empty();
}

void write_head(CaseDraft& draft) {
    CaseWriter& writer = draft.writer;
    const NewCaseRequest& request = draft.request;
    const std::string target = request.target.filename().string();
    const std::string log = request.log ? request.log->filename().string() : "";
    const std::string size = draft.is_specimen() ? "" : fmt::format("the size {}", request.size.text);
    writer.remark(fmt::format("{}, made by `tiretherm new`{}{}{}{}. It runs as it is:",
                              draft.is_specimen() ? "A specimen under a laser" : "A tire on " + draft.mesh.what,
                              log.empty() && size.empty() ? "" : " from ", log,
                              log.empty() || size.empty() ? "" : " and ", size));
    if (!draft.result.unread.empty()) {
        writer.remark(draft.result.unread);
    }
    const bool measured = draft.log() != nullptr && draft.log()->use == LogUse::run;
    for (const std::string_view command : {"run", "compare", "check"}) {
        if (command != "compare" || measured) {
            writer.lines({printable(fmt::format("#     tiretherm {} {}", command, target))});
        }
    }
    writer.remark(
        "`check` lists everything that is wrong after a change, with line and remedy. A quantity is a text with its "
        "unit; any unit of the right kind will do. Behind the # stands what a value means and where it comes from: "
        "from the thesis, which measured one 225/50 R17, or assumed. Replace first what is assumed.");
    writer.remark(fmt::format("About the values of mesh and materials, those of the library's case of the thesis's {}:",
                              draft.is_specimen() ? "experiment" : "tire"));
    writer.lines(draft.mesh.origin);
    writer.blank();
    const std::string subject = draft.is_specimen() ? "specimen under a laser" : request.size.text;
    const std::string title = request.log           ? fmt::format("{}, {}", subject, request.log->stem().string())
                              : draft.is_specimen() ? subject
                                                    : fmt::format("{} on {}", subject, draft.mesh.what);
    writer.entry("title", printable(title));
    writer.entry("sources", draft.mesh.sources);
}

/// Why the case does not read the log, which must be said before all else.
std::string why_unread(const Log& log) {
    const auto is_known = [](const LogColumn& column) { return !column.suggestion.empty(); };
    const auto asked = std::ranges::find_if(log.columns, is_known);
    return fmt::format(
        "The case does not read {}: no column of it is known to be an input or a sensor's{}. It lasts as long as the "
        "log, with constant inputs.",
        log.path,
        asked == log.columns.end()
            ? std::string()
            : fmt::format(" ({} may be {}: {})", asked->title(), asked->full_suggestion(), asked->reason));
}

/// Reports the columns that were not used.
void list_missing(const CaseDraft& draft) {
    const Log* log = draft.log();
    std::vector<MissingPart>& missing = draft.result.missing;
    if (log == nullptr) {
        return;
    }
    for (const LogColumn& column : log->columns) {
        if (!column.is_used() && (column.must_ignore || column.suggestion == column.heading.name)) {
            const bool has_unit = !trim(column.heading.unit.value_or("")).empty();
            const std::string absolute = absolute_pressure_remedy(column.heading.unit.value_or(""), {.unit = "Pa"});
            missing.push_back(
                {fmt::format("{} is not used: {}", column.title(), column.reason),
                 !absolute.empty()               ? absolute
                 : column.suggested_unit.empty() ? fmt::format("complete the column {}", column.heading.name)
                 : has_unit
                     ? fmt::format("if [{}] is {}, say --unit \"{}={}\", or else what it is", *column.heading.unit,
                                   column.suggested_unit, column.heading.name, column.suggested_unit)
                     : fmt::format("write \"{} [{}]\" into the log, or say --unit \"{}={}\"", column.heading.name,
                                   column.suggested_unit, column.heading.name, column.suggested_unit)});
        }
    }
    if (log->use == LogUse::run) {
        return;
    }
    std::vector<std::string> names;
    for (const TemplateSensor& sensor : draft.mesh.sensors) {
        if (sensor.shipped) {
            names.push_back(sensor.name);
        }
    }
    const auto asks_for_unit = [](const LogColumn& column) {
        return !column.is_used() && !column.suggested_unit.empty() && trim(column.heading.unit.value_or("")).empty();
    };
    const auto asked = std::ranges::find_if(log->columns, asks_for_unit);
    if (log->is_car && asked != log->columns.end()) {
        missing.push_back({fmt::format("{} columns have no unit, such as {}",
                                       std::ranges::count_if(log->columns, asks_for_unit), asked->heading.name),
                           fmt::format("say them, as in --unit \"{}={}\" or, of several, --unit \"*temp*=degC\", and "
                                       "call `tiretherm new` again with --force",
                                       asked->heading.name, asked->suggested_unit)});
        return;
    }
    const bool guessed = std::ranges::any_of(log->columns, [&](const LogColumn& column) {
        return !column.is_used() && draft.mesh.find_sensor(column.suggestion) != nullptr;
    });
    missing.push_back({"nothing to compare with: no column is known to be a sensor's",
                       guessed ? "look at [run.columns] at the end of the case, and take the # away where it is right"
                               : fmt::format("call a column by one of the sensors' names: {}", listed(names))});
}

/// Reads the case as if it stood where it will be.
void check(const NewCaseRequest& request, const std::string& text, const InputErrors& of_log, NewCase& result) {
    InputErrors errors;
    errors.share_tables(of_log);
    const TextFile file{.number = errors.add_file(request.target.generic_string(), text), .text = text};
    Runs runs;
    if (const std::optional<TomlValue> document = parse_toml(file, errors)) {
        runs = read_runs(*document, case_name(request.target), {}, ReadMode::measured, errors);
    }
    result.errors = errors.in_order();
    result.warnings = render(errors.warnings(), runs.corners.size());
    result.warnings.insert(result.warnings.end(), runs.data_warnings.begin(), runs.data_warnings.end());
}

/// The tables of the case, and what it assumes and lacks.
void write_case(CaseDraft& draft) {
    const NewCaseRequest& request = draft.request;
    NewCase& result = draft.result;
    draft.writer = CaseWriter();
    result.assumed.clear();
    result.missing.clear();
    result.unread = draft.log() != nullptr && draft.log()->use == LogUse::nothing ? why_unread(*draft.log()) : "";
    if (request.size_is_assumed && !draft.is_specimen()) {
        draft.assume("tire.size", request.size.text,
                     "the tire of the thesis: the log does not name its tire; --size does");
    }
    write_head(draft);
    if (!draft.is_specimen()) {
        write_tire(draft);
    }
    write_mesh(draft);
    if (!draft.is_specimen()) {
        write_effects(draft);
    }
    if (request.test) {
        write_drum_effects(draft, *request.test);
        write_drum_drive(draft, *request.test);
    } else {
        write_drive(draft);
        write_vehicle(draft);
        write_initial(draft);
        write_time(draft);
    }
    write_sensors(draft);
    write_log(draft);
    if (request.test) {
        write_drum_critical(draft);
    }
    list_missing(draft);
}

/// Leaves out the input of the log by which the case is refused: the one that the error is about, and where it is about none all
/// that tell the motion of a car. @returns whether there was one
bool leave_out_culprit(CaseDraft& draft) {
    NewCase& result = draft.result;
    for (const InputError& error : result.errors) {
        if (!result.log || error.file != draft.request.target.generic_string()) {
            continue;  // the log itself is wrong
        }
        for (const bool named : {true, false}) {
            const auto is_culprit = [&](const LogColumn& column) {
                return column.is_input && (named ? error.about == column.name : is_motion(column.name));
            };
            if (const auto found = std::ranges::find_if(result.log->columns, is_culprit);
                found != result.log->columns.end()) {
                leave_out(*result.log, std::string(found->name), error.what);
                return true;
            }
        }
    }
    return false;
}

}  // namespace

NewCase make_new_case(const NewCaseRequest& request) {
    NewCase result;
    CaseDraft draft = begin(request, result);
    if (!read_mesh_and_log(draft)) {
        return result;
    }
    do {
        write_case(draft);
        check(request, draft.writer.text(), draft.errors, result);
    } while (leave_out_culprit(draft));
    if (result.errors.empty()) {
        result.text = draft.writer.text();
    }
    return result;
}

}  // namespace tiretherm::input
