// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm check`: reads a case without running it and prints a summary or all input errors, as text or JSON.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "input/model/reader.hpp"
#include "post/report/table.hpp"

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

void print_text(const solver::Problem& problem, const std::vector<std::string>& warnings) {
    post::Table table({true, true});
    table.add({"mesh", fmt::format("{}, {} cells, layers {}", problem.mesh.kind, post::grouped(problem.mesh.n_cells),
                                   fmt::join(problem.mesh.layers, ", "))});
    table.add({"effects", fmt::format("{}", fmt::join(effect_names(problem), ", "))});
    table.add({"channels", fmt::format("{}", fmt::join(channel_names(problem), ", "))});
    table.add({"time", duration(problem.settings)});
    fmt::print("{}: no errors\n", problem.name);
    for (const std::string& line : table.lines(2)) {
        fmt::print("{}\n", terminal_text(line));
    }
    for (const std::string& warning : warnings) {
        fmt::print("warning: {}\n", terminal_text(warning));
    }
}

void print_json(const solver::Problem& problem, const std::vector<std::string>& warnings) {
    using Json = nlohmann::ordered_json;
    const Json json{{"case", problem.name},
                    {"title", problem.title},
                    {"cells", problem.mesh.n_cells},
                    {"layers", problem.mesh.layers},
                    {"effects", effect_names(problem)},
                    {"channels", channel_names(problem)},
                    {"start", problem.settings.start},
                    {"end", problem.settings.end},
                    {"steady", problem.settings.steady},
                    {"warnings", warnings},
                    {"mistakes", Json::array()}};
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

int check(const std::string& case_file, bool json) {
    const input::Reading reading = input::read_case(case_file);
    if (!reading.problem) {
        report_errors(reading, "the case cannot be run", json);
        return Exit::input_error;
    }
    json ? print_json(*reading.problem, reading.warnings) : print_text(*reading.problem, reading.warnings);
    return Exit::done;
}

}  // namespace

void add_check_command(CLI::App& program, int& exit_code) {
    struct Options {
        std::string case_file;
        bool json = false;
    };
    CLI::App* command = program.add_subcommand("check", "Read a case without running it; all errors at once");
    const auto options = std::make_shared<Options>();
    command->add_option("CASE", options->case_file, "Case file (TOML)")->required()->option_text(" ");
    command->add_flag("--json", options->json, "One JSON object");
    command->footer(
        "Exit code: 0 the case can be run, 1 it has errors.\n\n"
        "Example:\n"
        "  tiretherm check cases/laser/one_watt.toml");
    command->callback([options, &exit_code] { exit_code = check(options->case_file, options->json); });
}

}  // namespace tiretherm::app
