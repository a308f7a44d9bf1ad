// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm convert`: turns the thesis's spreadsheet (.xls, .xlsx or a folder of CSV files) into a case file and lists
// what became of each parameter.

#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "input/spreadsheet/sheet_case.hpp"
#include "input/text/suggestions.hpp"
#include "post/report/file.hpp"
#include "post/report/table.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t widest_value = 24;  // a law is reported with its reason

struct ConvertOptions {
    std::string sheet;
    std::string directory = ".";
    bool force = false;
    bool json = false;
};

/// "tire.toml" of "sheets/tire.xls" or of the folder "sheets/tire/".
fs::path case_file(const ConvertOptions& options) {
    fs::path sheet = fs::path(options.sheet).lexically_normal();
    if (sheet.filename().empty()) {
        sheet = sheet.parent_path();
    }
    std::error_code error;
    const fs::path name = fs::is_directory(sheet, error) ? sheet.filename() : sheet.stem();
    const bool nameless = name.empty() || name == "." || name == "..";
    return (fs::path(options.directory) / (nameless ? "tire" : name.string() + ".toml")).lexically_normal();
}

void print_json(const input::SheetCase& made, const std::string& file) {
    Json json{{"case", file},
              {"sheets", made.sheets},
              {"mapped", Json::array()},
              {"unmapped", Json::array()},
              {"missing", Json::array()},
              {"warnings", made.warnings},
              {"mistakes", Json::array()}};
    for (const input::SheetMapped& m : made.mapped) {
        const Json value = m.is_number ? Json(m.number) : Json(m.value);
        json["mapped"].push_back(
            {{"sheet", m.sheet}, {"parameter", m.parameter}, {"key", m.key}, {"value", value}, {"unit", m.unit}});
    }
    for (const input::SheetUnmapped& u : made.unmapped) {
        json["unmapped"].push_back(
            {{"sheet", u.sheet}, {"parameter", u.parameter}, {"value", u.value}, {"reason", u.reason}});
    }
    for (const input::SheetMissing& m : made.missing) {
        json["missing"].push_back(
            {{"sheet", m.sheet}, {"parameter", m.parameter}, {"key", m.key}, {"value", m.value}, {"reason", m.reason}});
    }
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_table(const char* title, const post::Table& table) {
    fmt::print("\n{}\n", title);
    for (const std::string& line : table.lines(2)) {
        fmt::print("{}\n", terminal_text(line));
    }
}

void print_text(const input::SheetCase& made, const std::string& file) {
    fmt::print("{}: a case of the two-node model\n", input::printable(file));
    const std::size_t n = made.mapped.size();
    fmt::print("  {} of {} sheets {} in it\n", n == 1 ? "1 parameter" : fmt::format("{} parameters", n),
               made.sheets.size(), n == 1 ? "has its place" : "have their place");
    if (!made.missing.empty()) {
        post::Table table({true, true, true});
        for (const input::SheetMissing& m : made.missing) {
            const bool wide = m.value.size() > widest_value;
            const std::string reason = wide ? fmt::format("{}: {}", m.value, m.reason) : m.reason;
            table.add({m.key, wide ? "" : m.value,
                       m.sheet.empty() ? reason : fmt::format("{}: {}: {}", m.sheet, m.parameter, reason)});
        }
        print_table("Not in the sheets and assumed", table);
    }
    if (!made.unmapped.empty()) {
        post::Table table({true, true, true});
        for (const input::SheetUnmapped& u : made.unmapped) {
            table.add({fmt::format("{}: {}", u.sheet, u.parameter), u.value, u.reason});
        }
        print_table("In the sheets, but without a place in a case", table);
    }
    for (const std::string& warning : made.warnings) {
        fmt::print("\nwarning: {}", input::printable(warning));
    }
    fmt::print("{}\nIt runs with: tiretherm run {}\n", made.warnings.empty() ? "" : "\n", input::printable(file));
}

int convert(const ConvertOptions& options) {
    solver::install_stop_handlers();
    const fs::path target = case_file(options);
    const std::string file = target.generic_string();
    now_doing(fmt::format("reading the sheets of {}", options.sheet));
    const input::SheetCase made = input::convert_sheet(options.sheet);
    if (!made.errors.empty()) {
        report_errors({.problem = std::nullopt, .errors = made.errors, .warnings = made.warnings},
                      "no case was written", options.json);
        return Exit::input_error;
    }
    if (was_stopped("no case was written", options.json)) {
        return Exit::interrupted;
    }
    if (replaces_input(target, {options.sheet}, options.json)) {
        return Exit::input_error;
    }
    std::error_code error;
    if (fs::exists(fs::symlink_status(target, error)) && !options.force) {
        report_error(fmt::format("{} exists and is left as it is", file),
                     "replace it with --force, or write elsewhere with --out DIR", options.json);
        return Exit::input_error;
    }
    try {
        post::write_with_folder(target, made.text);
    } catch (const post::FileError& failure) {
        report_error(failure.what(), "no case was written; choose another directory with --out", options.json);
        return Exit::input_error;
    }
    options.json ? print_json(made, file) : print_text(made, file);
    return Exit::done;
}

}  // namespace

void add_convert_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("convert", "Make a case from the thesis's spreadsheet of ten sheets");
    const auto options = std::make_shared<ConvertOptions>();
    command->add_option("SHEET", options->sheet, "Workbook (.xls, .xlsx), or a folder with a CSV file for each sheet")
        ->required()
        ->option_text(" ");
    add_out_option(*command, options->directory, "Where the case goes, called like the spreadsheet. Default: here");
    command->add_flag("--force", options->force, "Replace a case that is there already");
    command->add_flag("--json", options->json, "One JSON object: what became of each parameter");
    command->footer(
        "The sheets and where each of their parameters goes are described in cases/convert/README.md. What a case\n"
        "needs and the sheets do not say is assumed and listed, here and at the top of the case.\n\n"
        "Exit code: 0 the case was written, 1 an error in the call or the sheets, 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm convert cases/convert/thesis_225_50_R17.xlsx --out out/my_cases\n"
        "  tiretherm run out/my_cases/thesis_225_50_R17.toml");
    command->callback([options, &exit_code] { exit_code = convert(*options); });
}

}  // namespace tiretherm::app
