// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm check`: reads a case, with measured data where they are given, without running it, and prints a summary with
// its size or all input errors, as text or JSON; of a log, what is in it.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/commands/check_log.hpp"
#include "app/commands/check_study.hpp"
#include "app/messages.hpp"
#include "calls/doing.hpp"
#include "input/log_survey/log_survey.hpp"
#include "input/model/size_limits.hpp"
#include "input/runs/read_experiment.hpp"
#include "input/runs/reader.hpp"
#include "input/text/characters.hpp"
#include "input/text/word_lists.hpp"
#include "input/tire_property_file/tire_size.hpp"
#include "physics/celsius.hpp"
#include "physics/tire_laws/load_capacity.hpp"
#include "post/report/table.hpp"
#include "post/run/tire_laws.hpp"

namespace tiretherm::app {

namespace {

std::vector<std::string> effect_names(const solver::Problem& problem) {
    std::vector<std::string> names;
    for (const physics::ActiveEffect& active : problem.effects) {
        names.emplace_back(active.title());
    }
    return names;
}

std::vector<std::string> channel_names(const solver::Problem& problem) {
    std::vector<std::string> names;
    for (const solver::Channel& channel : problem.channels) {
        names.push_back(channel.name);
    }
    return names;
}

std::string duration(const solver::Settings& settings) {
    return settings.steady ? fmt::format("steady state with the drive at {:.6g} s", settings.end)
                           : fmt::format("{:.6g} s to {:.6g} s", settings.start, settings.end);
}

/// "1 536 cells, 361 rows, 2 fields; about 1 MB of files, 60 MB of memory".
std::string size_text(const input::CaseSize& size) {
    const auto count = [](double n, const char* what) {
        return fmt::format("{} {}{}", post::grouped(n), what, n == 1.0 ? "" : "s");
    };
    return fmt::format("{}, {}, {}{}; about {} of files, {} of memory", count(size.cells, "cell"),
                       size.rows > 0.0 ? count(size.rows, "row") : "a row for each step", count(size.fields, "field"),
                       size.steps ? ", " + count(*size.steps, "step") : "", input::spell_bytes(size.output),
                       input::spell_bytes(size.memory));
}

struct CheckOptions {
    std::string case_file;
    std::vector<std::string> data;
    std::vector<std::string> units;
    bool json = false;
};

/// A sound case with what is to be said of it.
struct Checked {
    const solver::Problem& problem;
    std::vector<std::string> warnings;
    std::vector<input::MeasuredRun> runs{};  ///< of --data; empty without
    std::vector<std::string> names{};        ///< of the case's own runs
    std::vector<input::PlySummary> plies{};  ///< materials of cords in rubber
};

/// "run1.csv: 2401 samples of surface and bulk, 0 s to 2400 s".
std::string run_text(const input::MeasuredRun& run) {
    std::vector<std::string> measured;
    for (const input::MeasuredSeries& series : run.series) {
        measured.push_back(run.problem.channels[series.channel].name);
    }
    for (const input::MeasuredFrames& frames : run.frames) {
        measured.push_back("camera " + frames.camera);
    }
    return fmt::format("{}: {} samples of {}, {}", run.file, run.time.size(), input::listed(measured),
                       duration(run.problem.settings));
}

/// What the service description of the size says beside the loads and speeds of the case; empty without one.
std::string tire_text(const solver::Problem& problem) {
    const auto read = input::read_tire_size(problem.tire.name);
    const auto* size = std::get_if<input::TireSize>(&read);
    const std::optional<double> load = size != nullptr && size->service ? size->service->load() : std::nullopt;
    if (!load) {
        return {};
    }
    std::string text = fmt::format("{}: {:.0f} N at {:.0f} kPa", size->text, *load, 1e-3 * size->load_pressure());
    if (const std::optional<double> speed = size->service->speed()) {
        text += fmt::format(", up to {:.0f} km/h", 3.6 * *speed);
    }
    double highest = 0.0;  // of the load over what the tire may carry
    physics::Inputs there;
    std::vector<double> times{problem.settings.start};
    times.insert(times.end(), problem.input_signals.stops().begin(), problem.input_signals.stops().end());
    times.insert(times.end(), problem.input_signals.samples().begin(), problem.input_signals.samples().end());
    for (const double t : times) {
        const physics::Inputs in = problem.input_signals.at(t, solver::JumpSide::after);
        const double pressure = problem.tire.reference_pressure > 0.0 ? in.inflation_pressure : size->load_pressure();
        const double share =
            in.vertical_load / physics::load_capacity(*load, std::max(pressure, 1.0), size->load_pressure());
        if (share > highest) {
            highest = share;
            there = in;
            there.inflation_pressure = pressure;
        }
    }
    if (highest > 0.0) {
        text += fmt::format("; {:.0f} N at {:.0f} kPa are {:.0f} % of what it may carry there", there.vertical_load,
                            1e-3 * there.inflation_pressure, 100.0 * highest);
    }
    return text;
}

/// "22.6 GPa", "13.8 MPa".
std::string modulus_text(double pascal) {
    return pascal < 1e9 ? fmt::format("{:.3g} MPa", pascal * 1e-6) : fmt::format("{:.3g} GPa", pascal * 1e-9);
}

/// "33 MPa around the circumference, 14 MPa along the meridian, G_xy 6.06 MPa, nu_xy 1.02"
std::string sheet_text(const physics::Sheet& sheet) {
    return fmt::format("{} around the circumference, {} along the meridian, G_xy {}, nu_xy {:.3g}",
                       modulus_text(sheet.E_x), modulus_text(sheet.E_y), modulus_text(sheet.G_xy), sheet.nu_xy);
}

/// "belt: 11.3 % cords; at 20 degC 0.313 W/mK through, 1.09 along the meridian, 5.09 around the circumference"; its moduli on lines
/// of their own.
void add_ply(post::TextTable& table, const input::PlySummary& ply) {
    table.add({"plies",
               fmt::format("{}: {:.3g} % cords; at {:.6g} degC {:.3g} W/mK through, {:.3g} along the meridian, {:.3g} "
                           "around the circumference",
                           ply.material, ply.cord_share * 100.0, celsius(ply.temperature), ply.through, ply.meridian,
                           ply.circumference)});
    if (!ply.elastic) {
        return;
    }
    const physics::Lamina& lamina = ply.elastic->lamina;
    table.add({"", fmt::format("one ply {} along its cords, {} across, G12 {}, nu12 {:.3g}", modulus_text(lamina.E1),
                               modulus_text(lamina.E2), modulus_text(lamina.G12), lamina.nu12)});
    table.add({"", "one ply " + sheet_text(ply.elastic->ply)});
    if (ply.elastic->plies > 1) {
        table.add({"", fmt::format("{} plies together {}", ply.elastic->plies, sheet_text(ply.elastic->layer))});
    }
}

/// "tan delta at most 0.786 at -8 degC and 52 Hz"; of several compounds with their layers.
std::string loss_text(const std::vector<post::CompoundPeak>& compounds) {
    std::vector<std::string> parts;
    for (const post::CompoundPeak& compound : compounds) {
        parts.push_back(fmt::format("{}{:.3g} at {:.4g} degC and {:.4g} Hz",
                                    compounds.size() > 1 ? input::listed(compound.layers) + " " : "",
                                    compound.peak.value, celsius(compound.peak.temperature), compound.peak.frequency));
    }
    return fmt::format("tan delta at most {}", fmt::join(parts, ", "));
}

void print_as_text(const Checked& checked) {
    const solver::Problem& problem = checked.problem;
    post::TextTable table({true, true});
    table.add({"mesh", fmt::format("{} ({})", problem.mesh.kind, fmt::join(problem.mesh.layers, ", "))});
    if (const std::string tire = tire_text(problem); !tire.empty()) {
        table.add({"tire", tire});
    }
    for (const input::PlySummary& ply : checked.plies) {
        add_ply(table, ply);
    }
    if (const auto compounds = post::compound_peaks(problem); !compounds.empty()) {
        table.add({"loss", loss_text(compounds)});
    }
    table.add({"effects", fmt::format("{}", fmt::join(effect_names(problem), ", "))});
    table.add({"channels", fmt::format("{}", fmt::join(channel_names(problem), ", "))});
    table.add({"time", duration(problem.settings)});
    table.add({"size", size_text(input::size_of(problem))});
    for (const input::MeasuredRun& run : checked.runs) {
        table.add({"data", run_text(run)});
    }
    if (checked.names.size() > 1) {
        table.add(
            {"runs", fmt::format("{}; run takes the first, or that of --run NAME", input::listed(checked.names))});
    }
    table.add(
        {"checked", "the case and its files; nothing was simulated: the errors of grid and time steps are not known"});
    fmt::print("{}: no errors\n", input::printable(problem.name));
    for (const std::string& line : table.lines(2)) {
        fmt::print("{}\n", input::printable(line));
    }
    for (const std::string& warning : checked.warnings) {
        fmt::print("warning: {}\n", input::printable(warning));
    }
}

using Json = nlohmann::ordered_json;

Json json_of(const physics::Sheet& sheet) {
    return {{"modulus_circumference", sheet.E_x},
            {"modulus_meridian", sheet.E_y},
            {"shear_modulus", sheet.G_xy},
            {"poisson", sheet.nu_xy}};
}

void print_as_json(const Checked& checked) {
    const solver::Problem& problem = checked.problem;
    const input::CaseSize size = input::size_of(problem);
    Json json{{"case", problem.name},
              {"title", problem.title},
              {"cells", problem.mesh.n_cells},
              {"layers", problem.mesh.layers},
              {"effects", effect_names(problem)},
              {"channels", channel_names(problem)},
              {"start", problem.settings.start},
              {"end", problem.settings.end},
              {"steady", problem.settings.steady},
              {"size",
               {{"rows", size.rows > 0.0 ? Json(size.rows) : Json()},
                {"fields", size.fields},
                {"steps", size.steps ? Json(*size.steps) : Json()},
                {"output_bytes", size.output},
                {"memory_bytes", size.memory}}},
              {"warnings", checked.warnings},
              {"errors", Json::array()},
              {"mistakes", Json::array()}};
    for (const input::PlySummary& ply : checked.plies) {
        json["plies"].push_back({{"material", ply.material},
                                 {"cord_share", ply.cord_share},
                                 {"temperature", ply.temperature},
                                 {"conductivity_through", ply.through},
                                 {"conductivity_meridian", ply.meridian},
                                 {"conductivity_circumference", ply.circumference}});
        if (ply.elastic) {
            const physics::Lamina& lamina = ply.elastic->lamina;
            json["plies"].back().update({{"modulus_along", lamina.E1},
                                         {"modulus_across", lamina.E2},
                                         {"shear_modulus", lamina.G12},
                                         {"poisson_along_across", lamina.nu12},
                                         {"modulus_circumference", ply.elastic->ply.E_x},
                                         {"one_ply", json_of(ply.elastic->ply)},
                                         {"all_plies", json_of(ply.elastic->layer)}});
        }
    }
    if (const post::Value tire = post::tire_laws_data(problem); tire.held().index() != 0) {
        json["tire"] = Json::parse(post::compact_json(tire));
    }
    for (const input::MeasuredRun& run : checked.runs) {
        Json measured = Json::array();
        for (const input::MeasuredSeries& series : run.series) {
            measured.push_back(run.problem.channels[series.channel].name);
        }
        json["runs"].push_back({{"name", run.name},
                                {"file", run.file},
                                {"samples", run.time.size()},
                                {"measured", measured},
                                {"start", run.problem.settings.start},
                                {"end", run.problem.settings.end}});
    }
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print(const Checked& checked, bool json) { json ? print_as_json(checked) : print_as_text(checked); }

/// What is unusual about the case, then about its data.
std::vector<std::string> joined(std::vector<std::string> of_case, const std::vector<std::string>& of_data) {
    of_case.insert(of_case.end(), of_data.begin(), of_data.end());
    return of_case;
}

int check(const CheckOptions& options) {
    if (input::is_log_file(options.case_file)) {
        if (options.data.empty()) {
            return check_log(options.case_file, options.units, options.json);
        }
        report_error(fmt::format("{} is a log, and --data is for a case", options.case_file),
                     "check one log at a time, or name a case before --data", options.json);
        return Exit::input_error;
    }
    if (!options.units.empty()) {
        report_error("--unit is for a log", "a case says units itself: units = { \"GPS Speed\" = \"km/h\" } in [data]",
                     options.json);
        return Exit::input_error;
    }
    calls::now_doing(fmt::format("reading {} and the files that it names", options.case_file));
    if (options.data.empty()) {
        if (const std::optional<int> exit_code = check_study(options.case_file, options.json)) {
            return *exit_code;
        }
        const input::Reading reading = input::read_case(options.case_file);
        if (!reading.problem) {
            const bool lacks_inputs = std::ranges::any_of(reading.errors, [](const input::InputError& error) {
                return error.code == input::ErrorCode::missing_input;
            });
            report_errors(reading,
                          lacks_inputs ? "the case cannot be run; with measured runs beside it: check --data FILE"
                                       : "the case cannot be run",
                          options.json);
            return Exit::input_error;
        }
        print({*reading.problem, joined(reading.warnings, reading.data_warnings), {}, reading.runs, reading.plies},
              options.json);
        return Exit::done;
    }
    const input::ExperimentReading reading =
        input::read_experiment(options.case_file, {options.data.begin(), options.data.end()});
    if (!reading.experiment) {
        report_errors({.errors = reading.errors, .warnings = reading.warnings},
                      "the case cannot be compared with these data", options.json);
        return Exit::input_error;
    }
    print({.problem = reading.experiment->runs.front().problem,
           .warnings = joined(reading.warnings, reading.data_warnings),
           .runs = reading.experiment->runs,
           .plies = reading.plies},
          options.json);
    return Exit::done;
}

}  // namespace

void add_check_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand(
        "check", "Read a case or a study without running it, and list all its errors at once; of a log: what is in it");
    const auto options = std::make_shared<CheckOptions>();
    command->add_option("CASE|LOG", options->case_file, "Case file (TOML), or a data logger's file")
        ->required()
        ->option_text(" ");
    command
        ->add_option("--data", options->data,
                     "A measured run (CSV or HDF5), once for each: is the case one for compare, identify and diagnose "
                     "with these?")
        ->option_text("FILE ...");
    command->add_option("--unit", options->units, "Of a log: a unit that it lacks, as tiretherm new takes it")
        ->option_text("COLUMN=UNIT ...");
    command->add_flag("--json", options->json, "One JSON object");
    command->footer(
        "The size is an estimate: what is beyond [limits] is refused.\n"
        "Of a log (CSV, .vbo, MoTeC .ld, HDF5): its format, channels with rate and range, laps, and what looks "
        "wrong.\n\n"
        "Exit code: 0 the case can be run, 1 it has errors.\n\n"
        "Examples:\n"
        "  tiretherm check cases/laser/one_watt.toml\n"
        "  tiretherm check cases/practice/two_node_bench.toml \\\n"
        "      --data cases/practice/run1.csv\n"
        "  tiretherm check cases/practice/run1.csv");
    command->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace tiretherm::app
