// SPDX-License-Identifier: BSD-3-Clause
// Reads commands, options and choices out of the parser; the table of what each placeholder stands for.

#include "app/completion/call_syntax.hpp"

#include <map>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/help/topics.hpp"
#include "input/schema/all_tables.hpp"
#include "physics/effect.hpp"
#include "physics/signals.hpp"

namespace tiretherm::app {

namespace {

const std::vector<std::string> log_endings{"csv", "txt", "tsv", "dat", "log", "h5", "hdf5"};

std::vector<std::string> effect_names() {
    std::vector<std::string> names;
    for (const physics::Effect* effect : physics::catalogue()) {
        names.emplace_back(effect->id);
    }
    return names;
}

std::vector<std::string> input_names() {
    std::vector<std::string> names;
    for (const physics::Signal& signal : physics::signals()) {
        names.emplace_back(signal.name);
    }
    return names;
}

std::vector<std::string> table_names() {
    std::vector<std::string> names;
    for (const input::TableKeys& table : input::all_tables()) {
        if (!table.path.empty()) {
            names.emplace_back(table.path);
        }
    }
    return names;
}

std::vector<std::string> topic_names() {
    std::vector<std::string> names;
    for (const Topic& topic : topics()) {
        names.emplace_back(topic.name);
    }
    return names;
}

/// What the values are that the help calls so, in all commands.
const std::map<std::string, Offer>& offers() {
    static const std::map<std::string, Offer> table{
        {"CASE", {.endings = {"toml"}}},
        {"STUDY", {.endings = {"toml"}}},
        {"EXPERIMENTS", {.endings = {"toml"}}},
        {"FILE", {.endings = log_endings}},
        {"SIZE|LOG", {.endings = log_endings}},
        {"DIR", {.folders = true}},
        {"EFFECT", {.words = effect_names()}},
        {"INPUT", {.words = input_names()}},
        {"TABLE", {.words = table_names()}},
        {"TOPIC", {.words = topic_names()}},
        // What only the user knows: names of a case's own, sizes, numbers.
        {"NAME", {}},
        {"ID,...", {}},
        {"SIZE", {}},
        {"PRESSURE", {}},
        {"SECONDS", {}},
        {"N", {}},
        {"K/N", {}},
    };
    return table;
}

/// The choices of CLI::IsMember, which the parser keeps in the name of the type: "TEXT:{bash,zsh}".
std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t begin = type.find(":{");
    const std::size_t end = type.find('}', begin);
    if (begin == std::string::npos || end == std::string::npos) {
        return {};
    }
    return CLI::detail::split(type.substr(begin + 2, end - begin - 2), ',');
}

std::string first_sentence(const std::string& text) {
    const std::size_t end = std::min(text.find(". "), text.find("; "));
    return text.substr(0, end);
}

/// "FILE" of "FILE ...".
std::string placeholder_of(const CLI::Option& option) {
    const std::string text = option.get_positional() ? option.get_name(true) : option.get_option_text();
    return text.substr(0, text.find(' '));
}

Argument argument_of(const CLI::Option& option) {
    Argument argument{.names = {},
                      .placeholder = {},
                      .sentence = first_sentence(option.get_description()),
                      .takes_value = option.get_items_expected_max() > 0,
                      .repeats = option.get_items_expected_max() > 1};
    for (const std::string& name : option.get_snames()) {
        argument.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        argument.names.push_back("--" + name);
    }
    if (argument.takes_value) {
        argument.placeholder = placeholder_of(option);
        const Offer* known = offer_for(argument.placeholder);
        argument.offer = known != nullptr ? *known : Offer{};
        if (std::vector<std::string> choices = choices_of(option); !choices.empty()) {
            argument.offer.words = std::move(choices);
        }
    }
    return argument;
}

CommandSyntax syntax_of(const CLI::App& command) {
    CommandSyntax syntax{.name = command.get_parent() != nullptr ? command.get_name() : std::string(),
                         .sentence = first_sentence(command.get_description()),
                         .options = {},
                         .arguments = {}};
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_group().empty()) {
            continue;  // not for people
        }
        (option->get_positional() ? syntax.arguments : syntax.options).push_back(argument_of(*option));
    }
    return syntax;
}

}  // namespace

const Offer* offer_for(const std::string& placeholder) {
    const auto found = offers().find(placeholder);
    return found == offers().end() ? nullptr : &found->second;
}

CallSyntax call_syntax(const CLI::App& program) {
    CallSyntax syntax{.program = syntax_of(program), .commands = {}};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        syntax.commands.push_back(syntax_of(*command));
    }
    // Help is to be had of commands, too.
    for (CommandSyntax& command : syntax.commands) {
        for (Argument& argument : command.arguments) {
            for (const CommandSyntax& other : syntax.commands) {
                const bool is_listed =
                    std::ranges::find(argument.offer.words, other.name) != argument.offer.words.end();
                if (argument.placeholder == "TOPIC" && !is_listed) {
                    argument.offer.words.push_back(other.name);
                }
            }
        }
    }
    return syntax;
}

}  // namespace tiretherm::app
