// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm help`: pages on what commands have in common, and the help of each command.

#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/help/help_text.hpp"
#include "app/help/topics.hpp"
#include "app/messages.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::app {

namespace {

constexpr std::size_t column = 14;

int list_topics(const CLI::App& program) {
    fmt::print("Topics, for example tiretherm help units:\n");
    for (const Topic& topic : topics()) {
        fmt::print("{}", entry_text(std::string(topic.name), std::string(topic.summary), column));
    }
    fmt::print("\nCommands, for example tiretherm help run:\n");
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        fmt::print("{}", entry_text(command->get_name(), command->get_description(), column));
    }
    return Exit::done;
}

int show(const CLI::App& program, const std::string& name) {
    if (name.empty()) {
        return list_topics(program);
    }
    const Topic* topic = find_topic(name);
    std::vector<std::string> known;
    for (const Topic& one : topics()) {
        known.emplace_back(one.name);
    }
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        known.push_back(command->get_name());
        if (command->get_name() == name && topic == nullptr) {
            fmt::print("{}", command->help("tiretherm"));
            return Exit::done;
        }
        if (command->get_name() == name) {
            fmt::print("{}\nThe command of that name: tiretherm {} --help\n", topic->text(), name);
            return Exit::done;
        }
    }
    if (topic == nullptr) {
        report_error(fmt::format("there is no topic or command \"{}\"", name),
                     input::suggest(name, known, "topics and commands"), false);
        return Exit::input_error;
    }
    fmt::print("{}", topic->text());
    return Exit::done;
}

}  // namespace

void add_help_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("help", "Explain a topic (inputs, signs, units, sensors ...) or a command");
    const auto name = std::make_shared<std::string>();
    command->add_option("TOPIC", *name, "A topic or a command; without it all are listed")->option_text(" ");
    command->footer(
        "Exit code: 0 done, 1 there is no such topic.\n\n"
        "Example:\n"
        "  tiretherm help signs");
    command->callback([name, &program, &exit_code] { exit_code = show(program, *name); });
}

}  // namespace tiretherm::app
