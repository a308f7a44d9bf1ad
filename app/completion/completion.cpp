// SPDX-License-Identifier: BSD-3-Clause
// Follows the words of a line through the parser's commands and options; the table of what each placeholder stands for.

#include "app/completion/completion.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/help/topics.hpp"
#include "input/schema/all_tables.hpp"
#include "physics/effect.hpp"
#include "physics/signals.hpp"

namespace tiretherm::app {

namespace {

constexpr std::string_view logs = ":files"
#define LOG_ENDING(ending) " " ending
#include "input/loggers/loggers.list"
    ;

std::string first_sentence(std::string_view text) {
    return std::string(text.substr(0, std::min(text.find(". "), text.find("; "))));
}

std::string offer_line(std::string_view word, std::string_view meaning) {
    return fmt::format("{}\t{}\n", word, first_sentence(meaning));
}

const CLI::App* command_named(const CLI::App& program, const std::string& name) {
    const auto named = program.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
    return named.empty() ? nullptr : named.front();
}

std::string command_lines(const CLI::App& program) {
    std::string lines;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        lines += offer_line(command->get_name(), command->get_description());
    }
    return lines;
}

/// What may stand for a placeholder of the help; empty where only the user knows: a number, a name of the case's own.
std::string lines_for(const CLI::App& program, std::string_view placeholder) {
    std::string lines;
    if (placeholder == "CASE" || placeholder == "STUDY" || placeholder == "EXPERIMENTS") {
        lines = ":files .toml\n";
    } else if (placeholder == "FILE" || placeholder == "LOG") {
        lines = fmt::format("{}\n", logs);
    } else if (placeholder == "DIR" || placeholder == "OTHER") {
        lines = ":folders\n";
    } else if (placeholder == "EFFECT") {
        for (const physics::Effect* effect : physics::catalogue()) {
            lines += offer_line(effect->id, effect->meaning);
        }
    } else if (placeholder == "INPUT") {
        for (const physics::Signal& signal : physics::signals()) {
            lines += offer_line(signal.name, signal.meaning);
        }
    } else if (placeholder == "TABLE") {
        for (const input::TableKeys& table : input::all_tables()) {
            lines += table.path.empty() ? std::string() : offer_line(table.path, table.sentence);
        }
    } else if (placeholder == "TOPIC") {
        for (const Topic& topic : topics()) {
            lines += offer_line(topic.name, topic.summary);
        }
        lines += command_lines(program);
    }
    return lines;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }
bool repeats(const CLI::Option& option) { return option.get_items_expected_max() > 1; }

/// Offers for the value of an option or for an argument.
std::string value_lines(const CLI::App& program, const CLI::Option& option) {
    // CLI::IsMember keeps its choices in the name of the type: "TEXT:{bash,zsh}".
    const std::string type = option.get_type_name();
    std::string lines;
    if (const std::size_t begin = type.find(":{"); begin != std::string::npos) {
        for (const std::string& word : CLI::detail::split(type.substr(begin + 2, type.find('}') - begin - 2), ',')) {
            lines += word + "\n";
        }
        return lines;
    }
    const std::string text = option.get_positional() ? option.get_name(true) : option.get_option_text();
    for (const std::string& placeholder : CLI::detail::split(text.substr(0, text.find(' ')), '|')) {
        lines += lines_for(program, placeholder);
    }
    return lines;
}

std::string option_lines(const CLI::App& command, const std::set<const CLI::Option*>& given) {
    std::string lines;
    for (const CLI::Option* option : command.get_options()) {
        const bool is_hidden = option->get_group().empty();
        if (is_hidden || option->get_positional() || (given.contains(option) && !repeats(*option))) {
            continue;
        }
        for (const std::string& name : option->get_snames()) {
            lines += offer_line("-" + name, option->get_description());
        }
        for (const std::string& name : option->get_lnames()) {
            lines += offer_line("--" + name, option->get_description());
        }
    }
    return lines;
}

/// @returns null where there is none in that place; the last takes all further words if it takes several
const CLI::Option* argument_at(const CLI::App& command, std::size_t place) {
    const std::vector<const CLI::Option*> arguments =
        command.get_options([](const CLI::Option* option) { return option->get_positional(); });
    if (place >= arguments.size() && !arguments.empty() && repeats(*arguments.back())) {
        return arguments.back();
    }
    return place < arguments.size() ? arguments[place] : nullptr;
}

}  // namespace

std::string completion_lines(const CLI::App& program, const std::vector<std::string>& words) {
    if (words.size() < 2) {
        return {};
    }
    const bool is_script = std::filesystem::path(words.front()).filename() == "run";
    const CLI::App* command = nullptr;
    const CLI::Option* awaiting = nullptr;
    std::set<const CLI::Option*> given;
    std::size_t place = 0;
    const auto option_of = [&](const std::string& word) {
        return (command == nullptr ? program : *command).get_option_no_throw(word.substr(0, word.find('=')));
    };
    for (std::size_t i = 1; i + 1 < words.size(); ++i) {
        const std::string& word = words[i];
        if (awaiting != nullptr) {
            awaiting = nullptr;  // this word is its value
        } else if (word.starts_with('-')) {
            const CLI::Option* option = option_of(word);
            given.insert(option);
            const bool has_value = word.find('=') != std::string::npos;
            awaiting = option != nullptr && takes_value(*option) && !has_value ? option : nullptr;
        } else if (command != nullptr) {
            ++place;
        } else if ((command = command_named(program, word)) == nullptr && is_script) {
            command = command_named(program, "run");  // ./run CASE
            place = 1;
        } else if (command == nullptr) {
            return {};
        }
    }
    const std::string& typed = words.back();
    if (awaiting == nullptr && typed.starts_with("--") && typed.find('=') != std::string::npos) {
        awaiting = option_of(typed);
    }
    if (awaiting != nullptr) {
        return value_lines(program, *awaiting);
    }
    if (typed.starts_with('-') && typed.find('=') == std::string::npos) {
        return option_lines(command == nullptr ? program : *command, given);
    }
    if (command == nullptr) {
        return command_lines(program) + (is_script ? lines_for(program, "CASE") : std::string());
    }
    const CLI::Option* argument = argument_at(*command, place);
    return argument == nullptr ? std::string() : value_lines(program, *argument);
}

}  // namespace tiretherm::app
