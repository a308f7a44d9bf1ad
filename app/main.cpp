// SPDX-License-Identifier: BSD-3-Clause
// Entry point: adds all subcommands to the CLI11 parser and explains calls that it refuses.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/completion/completion.hpp"
#include "app/failure.hpp"
#include "app/help/help_text.hpp"
#include "app/messages.hpp"
#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "solver/stop_signal.hpp"

namespace {

using namespace tiretherm;

/// Names of what may stand on the command line: commands of the program, or options of a command.
std::vector<std::string> command_names(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    return names;
}

/// A command by the word that another program has for it.
std::string other_word_for(const std::string& word) {
    static const std::map<std::string, std::string> words{{"simulate", "run"},      {"sim", "run"},
                                                          {"start", "run"},         {"validate_case", "check"},
                                                          {"verify", "check"},      {"lint", "check"},
                                                          {"fit", "identify"},      {"calibrate", "identify"},
                                                          {"estimate", "identify"}, {"plan", "identify --plan"},
                                                          {"diff", "compare"},      {"sweep", "study"},
                                                          {"batch", "study"},       {"init", "new"},
                                                          {"create", "new"},        {"list", "effects"},
                                                          {"topics", "help"},       {"units", "help units"},
                                                          {"signs", "help signs"},  {"sensors", "help sensors"},
                                                          {"version", "--version"}};
    const auto found = words.find(word);
    return found == words.end() ? std::string() : found->second;
}

/// What to do about a first word that is no command: a file before its command, another word, or a slip of the finger.
std::string command_remedy(const CLI::App& program, const std::string& word) {
    if (word.ends_with(".toml") || word.find('/') != std::string::npos) {
        return fmt::format("a command comes first: tiretherm run {}", word);
    }
    if (word == "convert" || word == "import") {
        return "the converter of workbooks is a script: tools/spreadsheet_to_case.py WORKBOOK --out DIR";
    }
    const std::string other = other_word_for(word);
    return other.empty() ? input::suggest(word, command_names(program), "commands")
                         : fmt::format("did you mean `{}`?", other);
}

/// "--out needs a value (DIR)" in place of CLI11's "--out: 1 required TEXT missing".
std::string refusal_text(const CLI::App& command, const CLI::ParseError& error) {
    const std::string text = error.what();
    const std::string name = text.substr(0, text.find(':'));
    const CLI::Option* option = name.starts_with('-') ? command.get_option_no_throw(name) : nullptr;
    if (option != nullptr && error.get_name() == "ArgumentMismatch" && option->get_items_expected_min() > 0) {
        return fmt::format("{} needs a value: {} {}", name, name, option->get_option_text());
    }
    return text;
}

/// The word that stands in the place of the command, where the command comes later; or empty.
std::string before_command(std::span<char*> arguments, const std::string& command) {
    const bool is_first = arguments.size() < 2 || arguments[1] == command;
    return is_first ? std::string() : std::string(arguments[1]);
}

/// Says what is wrong with a call that CLI11 refused.
void report_wrong_call(const CLI::App& program, const CLI::ParseError& error, std::span<char*> arguments, bool json) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    const CLI::App& command = chosen.empty() ? program : *chosen.front();
    const std::vector<std::string> extra = program.remaining(true);
    const std::string help = fmt::format("see tiretherm {}--help", chosen.empty() ? "" : command.get_name() + " ");
    const auto is_option = [](const std::string& argument) { return argument.starts_with('-'); };
    const auto option = std::find_if(extra.begin(), extra.end(), is_option);
    const auto word = std::find_if_not(extra.begin(), extra.end(), is_option);
    if (chosen.empty() && word != extra.end()) {
        app::report_error(fmt::format("there is no command \"{}\"", *word), command_remedy(program, *word), json);
    } else if (option != extra.end()) {
        app::report_error(fmt::format("there is no option \"{}\"", *option),
                          input::suggest(*option, option_names(command), "options"), json);
    } else if (chosen.empty()) {
        app::report_error(fmt::format("no command; the commands are {}", input::listed(command_names(program))), help,
                          json);
    } else if (!extra.empty() && before_command(arguments, command.get_name()) == extra.front()) {
        app::report_error(fmt::format("\"{}\" stands before its command", extra.front()),
                          fmt::format("write tiretherm {} {}", command.get_name(), extra.front()), json);
    } else if (!extra.empty()) {
        app::report_error(fmt::format("one argument too many: \"{}\"", extra.front()), help, json);
    } else {
        app::report_error(refusal_text(command, error), help, json);
    }
}

/// A line of the examples under the program's help.
std::string example_call(const std::string& command, const std::string& arguments) {
    return fmt::format("  tiretherm {}{}{}\n", command, arguments.empty() ? "" : " ", arguments);
}

/// Runs the call. @returns its exit code
int run_call(int argc, char** argv) {
    int exit_code = app::Exit::done;
    CLI::App program{"tiretherm: temperature field of a tire, compared with measured data", "tiretherm"};
    program.set_version_flag("--version", "tiretherm " TIRETHERM_VERSION);
    program.formatter(app::help_formatter());  // before the commands, which inherit it
    program.require_subcommand(1);
    std::string examples = "Examples:\n";
#define COMMAND(name, example)                     \
    app::add_##name##_command(program, exit_code); \
    examples += example_call(#name, example);
#include "app/commands.list"
#undef COMMAND
    for (CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
        command->group("Commands");
    }
    // For ./run, which must tell commands from cases; not for people, whom --help tells more.
    program
        .add_flag_callback("--commands",
                           [&] {
                               fmt::print("{}\n", fmt::join(command_names(program), "\n"));
                               throw CLI::Success();
                           })
        ->group("");
    program.footer(
        examples +
        "\nHelp for a command: tiretherm COMMAND --help\n\nInputs, signs, units, sensors and more: tiretherm help");

    const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
    if (argc > 1 && std::string_view(argv[1]) == "complete") {  // not for people either: the words are no call
        fmt::print("{}", app::completion_lines(program, {arguments.begin() + 2, arguments.end()}));
        return app::Exit::done;
    }
    const bool json =
        std::any_of(arguments.begin(), arguments.end(), [](const char* a) { return std::string(a) == "--json"; });
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return program.exit(help);
    } catch (const CLI::ParseError& error) {
        report_wrong_call(program, error, arguments, json);
        return app::Exit::input_error;
    } catch (const solver::Interrupted&) {
        app::report_error(calls::stop_sentence() + " while " + calls::now_done(), "nothing was written", json);
        return calls::stop_exit();
    } catch (const std::exception& error) {
        if (!app::is_lost_output(error)) {  // which is said at the end
            const calls::Failure failure = calls::failure_of(error);
            app::report_error(failure.sentence, failure.remedy, json);
        }
        return app::Exit::input_error;
    }
    return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
    app::keep_standard_streams();
    int exit_code = app::Exit::input_error;
    try {
        exit_code = run_call(argc, argv);
    } catch (const std::exception&) {  // the message itself could not be written
        exit_code = app::Exit::input_error;
    }
    const bool written = app::flush_standard_output();
    return written || exit_code != app::Exit::done ? exit_code : static_cast<int>(app::Exit::input_error);
}
