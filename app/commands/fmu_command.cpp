// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm fmu`: a case as an FMU, which other programs run in co-simulation.

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "calls/doing.hpp"
#include "input/case_text/case_writer.hpp"
#include "input/runs/reader.hpp"
#include "input/text/suggestions.hpp"
#include "post/fmu/fmu_file.hpp"
#include "post/report/file.hpp"
#include "post/report/table.hpp"

namespace tiretherm::app {

namespace {

using Json = nlohmann::ordered_json;

struct FmuOptions {
    std::string case_file;
    std::string run;
    std::string version = "2";
    std::string target;
    bool json = false;
};

constexpr const char* nothing = "no FMU was written";

/// The run that is to be exported; null after an error, which has been reported.
const input::RunOfCase* chosen_run(const input::Reading& reading, const FmuOptions& options) {
    if (!reading.problem) {
        report_errors(reading, nothing, options.json);
        return nullptr;
    }
    if (reading.chosen.size() > 1) {
        std::vector<std::string> names;
        for (const input::RunOfCase& run : reading.chosen) {
            names.push_back(run.name);
        }
        report_error("an FMU is one tire, and the case has " + std::to_string(names.size()),
                     fmt::format("name one of them: --run {}", fmt::join(names, ", --run ")), options.json);
        return nullptr;
    }
    const input::RunOfCase& run = reading.chosen.front();
    if (const std::vector<std::string> defects = solver::defects(run.problem); !defects.empty()) {
        report_error(fmt::format("{}: {}", options.case_file, fmt::join(defects, "; ")), nothing, options.json);
        return nullptr;
    }
    if (run.problem.channels.empty()) {
        report_error("the case has no sensor: the FMU would have no output", "add a [[sensor]]", options.json);
        return nullptr;
    }
    return &run;
}

/// The case as one text, with all that it includes.
std::string resolved_case(const std::string& file) {
    input::InputErrors errors;
    input::CaseWriter writer;
    if (const auto document = input::read_document(file, errors)) {
        writer.document(*document);
    }
    return writer.text();
}

std::vector<std::string> names_of(const post::FmuContent& content, post::FmuVariable::Role role) {
    std::vector<std::string> names;
    for (const post::FmuVariable& variable : content.variables) {
        if (variable.role == role) {
            names.push_back(variable.name);
        }
    }
    return names;
}

void tell(const post::PackedFmu& packed, const FmuOptions& options, const std::string& target) {
    using Role = post::FmuVariable::Role;
    const std::pair<const char*, Role> roles[] = {
        {"inputs", Role::input}, {"parameters", Role::parameter}, {"outputs", Role::output}};
    const std::string version = options.version + ".0";
    if (options.json) {
        Json all{{"fmu", target}, {"fmi", version}, {"bytes", packed.bytes.size()}, {"token", packed.content.token}};
        for (const auto& [what, role] : roles) {
            all[what] = names_of(packed.content, role);
        }
        fmt::print("{}\n", all.dump(2));
        return;
    }
    fmt::print("{}: FMI {} for co-simulation, {:.1f} MB\n", target, version,
               1e-6 * static_cast<double>(packed.bytes.size()));
    for (const auto& [what, role] : roles) {
        const std::vector<std::string> names = names_of(packed.content, role);
        fmt::print("{}", names.empty()
                             ? ""
                             : post::wrap(fmt::format("{}: {}", what, fmt::join(names, ", ")), 2, prose_width()));
    }
}

int write_fmu(const FmuOptions& options) {
    const input::Reading reading =
        calls::while_reading(options.case_file, [&] { return input::read_case_run(options.case_file, options.run); });
    const input::RunOfCase* run = chosen_run(reading, options);
    if (run == nullptr) {
        return Exit::input_error;
    }
    const std::string target =
        !options.target.empty() ? options.target : std::filesystem::path(options.case_file).stem().string() + ".fmu";
    if (replaces_input(target, reading.files, options.json)) {
        return Exit::input_error;
    }
    try {
        const post::PackedFmu packed =
            post::pack_fmu(solver::session_model(run->problem, run->parameters),
                           {.version = options.version == "3" ? post::FmiVersion::fmi3 : post::FmiVersion::fmi2,
                            .case_text = resolved_case(options.case_file)});
        post::write_with_folder(target, packed.bytes);
        tell(packed, options, target);
        return Exit::done;
    } catch (const std::runtime_error& failure) {
        report_error(failure.what(), nothing, options.json);
        return Exit::input_error;
    }
}

}  // namespace

void add_fmu_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("fmu", "Export a case as an FMU for co-simulation");
    const auto options = std::make_shared<FmuOptions>();
    command->add_option("CASE", options->case_file, "Case file (TOML)")->required()->option_text(" ");
    command
        ->add_option("--run", options->run,
                     "Which of the case's [[run]] tables, of a car's tires RUN_FL. Default: the first")
        ->option_text("NAME");
    command->add_option("--fmi", options->version, "Version of the standard: 2 (default) or 3")
        ->option_text("2|3")
        ->check(CLI::IsMember({"2", "3"}));
    add_out_option(*command, options->target, "The file. Default: the case's name, .fmu, here", "FILE", "-o,--out");
    command->add_flag("--json", options->json, "One JSON object instead of the summary");
    command->footer(
        "The FMU runs on Linux, x86-64, and needs no other file. Inputs are those that\n"
        "the case's effects read, parameters the numbers of its [[parameter]] tables,\n"
        "outputs its sensors, all in SI units. It begins with the temperatures of the\n"
        "case; what its logs and schedules say later is not used. Page: docs/fmu.md\n\n"
        "Example:\n"
        "  tiretherm fmu cases/two_node/4000N_100kmh.toml --out tire.fmu");
    command->callback([options, &exit_code] { exit_code = write_fmu(*options); });
}

}  // namespace tiretherm::app
