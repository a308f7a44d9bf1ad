// SPDX-License-Identifier: BSD-3-Clause
// Writes the completion for zsh, with the sentences of the help.

#include <string_view>

#include <fmt/format.h>

#include "app/completion/call_syntax.hpp"

namespace tiretherm::app {

namespace {

constexpr const char* zsh_head = R"(#compdef tiretherm -p */./run
# zsh completion for tiretherm, written by `tiretherm completion zsh`.
# For this shell, after compinit: source <(tiretherm completion zsh)

_tiretherm() {
    local curcontext=$curcontext state line
    local -a commands=(
)";

constexpr const char* middle = R"(    )
    _arguments -C \
{}        '1: :->command' '*:: :->arguments'
    case $state in
        command)
            _describe -t commands command commands
            [[ ${{service:t}} != run ]] || _files -g '*.toml' ;;
        arguments)
            if [[ ${{service:t}} == run && -z ${{(M)commands:#$words[1]:*}} ]]; then
                words=(run "${{words[@]}}")  # ./run CASE
                ((++CURRENT))
            fi
            curcontext=${{curcontext%:*:*}}:tiretherm-$words[1]:
            case $words[1] in
)";

constexpr const char* tail = R"(            esac ;;
    esac
}

if [[ $funcstack[1] == _tiretherm ]]; then
    _tiretherm "$@"
else
    compdef _tiretherm tiretherm -p '*/./run'
fi
)";

/// A text in single quotes in which colons and brackets are not marks of _arguments.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'') {
            result += "'\\''";
        } else if (c == ':' || c == '[' || c == ']' || c == '\\') {
            result += '\\';
            result += c;
        } else {
            result += c;
        }
    }
    return result;
}

/// What follows the second colon of a spec.
std::string action(const Offer& offer) {
    if (!offer.words.empty()) {
        std::string words;
        for (const std::string& word : offer.words) {
            words += fmt::format("{}{}", words.empty() ? "" : " ", escaped(word));
        }
        return fmt::format("({})", words);
    }
    if (offer.endings.size() == 1) {
        return fmt::format("_files -g \"*.{}\"", offer.endings.front());
    }
    if (!offer.endings.empty()) {
        return fmt::format("_files -g \"*.({})\"", fmt::join(offer.endings, "|"));
    }
    return offer.folders ? "_files -/" : " ";
}

std::string option_spec(const Argument& option) {
    std::string spec;
    for (const std::string& name : option.names) {
        // An option that has been given is not offered again, under none of its names.
        const std::string once = option.repeats            ? "*"
                                 : option.names.size() > 1 ? fmt::format("({})", fmt::join(option.names, " "))
                                                           : "";
        spec += fmt::format(
            "'{}{}[{}]{}' ", once, name, escaped(option.sentence),
            option.takes_value ? fmt::format(":{}:{}", escaped(option.placeholder), action(option.offer)) : "");
    }
    return spec;
}

std::string specs(const CommandSyntax& command, std::size_t indent) {
    std::string lines;
    for (const Argument& option : command.options) {
        lines += fmt::format("{:{}}{}\\\n", "", indent, option_spec(option));
    }
    return lines;
}

}  // namespace

std::string zsh_script(const CallSyntax& syntax) {
    std::string text = zsh_head;
    std::string cases;
    for (const CommandSyntax& command : syntax.commands) {
        text += fmt::format("        '{}:{}'\n", command.name, escaped(command.sentence));
        std::string lines = specs(command, 20);
        for (std::size_t i = 0; i < command.arguments.size(); ++i) {
            const Argument& argument = command.arguments[i];
            lines +=
                fmt::format("{:20}'{}:{}:{}' \\\n", "", i + 1, escaped(argument.placeholder), action(argument.offer));
        }
        cases += fmt::format("                {})\n{:20}_arguments \\\n{:20}&& return ;;\n", command.name, "",
                             lines + std::string(20, ' '));
    }
    return text + fmt::format(middle, specs(syntax.program, 8)) + cases + tail;
}

}  // namespace tiretherm::app
