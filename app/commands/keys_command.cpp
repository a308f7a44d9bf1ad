// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm keys`: every key of a case with its form, unit, range and meaning, as the readers ask for it.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "input/schema/all_tables.hpp"
#include "input/text/suggestions.hpp"
#include "post/reference/case_reference.hpp"

namespace tiretherm::app {

namespace {

struct KeysOptions {
    std::string table;
    bool markdown = false;
};

/// "[[mesh.layer]]" and "mesh.layer" are the same.
std::string without_brackets(std::string name) {
    std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
    return name;
}

int show(const KeysOptions& options) {
    const std::vector<input::TableKeys>& tables = input::all_tables();
    if (options.markdown) {
        fmt::print("{}", post::case_reference_markdown(tables));
        return Exit::done;
    }
    if (options.table.empty()) {
        fmt::print("{}\nOne of them in full: tiretherm keys TABLE\n", post::case_tables_text(tables));
        return Exit::done;
    }
    const std::string path = without_brackets(options.table);
    const auto found = std::ranges::find_if(tables, [&](const input::TableKeys& table) {
        return table.path == path || without_brackets(post::heading_of(table)) == path;
    });
    if (found == tables.end()) {
        std::vector<std::string> known;
        for (const input::TableKeys& table : tables) {
            known.push_back(without_brackets(post::heading_of(table)));
        }
        report_error(fmt::format("a case has no table \"{}\"", options.table), input::suggest(path, known, "tables"),
                     false);
        return Exit::input_error;
    }
    fmt::print("{}", post::case_table_text(*found));
    return Exit::done;
}

}  // namespace

void add_keys_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("keys", "List every key of a case: form, unit, range, meaning");
    const auto options = std::make_shared<KeysOptions>();
    command->add_option("TABLE", options->table, "A table of a case, such as mesh.layer; without it all are listed")
        ->option_text(" ");
    command->add_flag("--markdown", options->markdown, "The page docs/case-reference.md");
    command->footer(
        "Parameters of an effect: tiretherm effects EFFECT\n\n"
        "Example:\n"
        "  tiretherm keys\n"
        "  tiretherm keys mesh.layer");
    command->callback([options, &exit_code] { exit_code = show(*options); });
}

}  // namespace tiretherm::app
