// SPDX-License-Identifier: BSD-3-Clause
// Writes the completion for bash, without the functions of the package bash-completion, which may be absent.

#include <fmt/format.h>

#include "app/completion/call_syntax.hpp"

namespace tiretherm::app {

namespace {

constexpr const char* bash_head = R"BASH(# bash completion for tiretherm, written by `tiretherm completion bash`.
# For this shell: source <(tiretherm completion bash)

_tiretherm_words() {  # WORD ...: those that begin like what is typed, up to the last colon of which readline has done
    local typed=${COMP_LINE:0:COMP_POINT} done i
    typed=${typed##*[[:space:]=]}
    done=${typed%"${typed##*:}"}
    mapfile -t COMPREPLY < <(compgen -W "$*" -- "$typed")
    for i in "${!COMPREPLY[@]}"; do COMPREPLY[i]=${COMPREPLY[i]#"$done"}; done
}

_tiretherm_files() {  # CURRENT [ENDING ...]: files with these endings, and folders
    local current=$1 ending
    shift
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <({
        compgen -d -- "$current"
        for ending; do compgen -f -X "!*.$ending" -- "$current"; done
    } | sort -u)
}

)BASH";

constexpr const char* body = R"BASH(
_tiretherm() {
    local current=${COMP_WORDS[COMP_CWORD]} command= option= place=1 i word
    COMPREPLY=()
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        if [[ $word == '=' ]]; then
            continue
        elif [[ -n $option ]]; then
            option=  # this word is its value
        elif [[ $word == -* ]]; then
            [[ $_tiretherm_valued == *" $command $word "* ]] && option=$word
        elif [[ -n $command ]]; then
            ((++place))
        elif [[ $_tiretherm_commands == *" $word "* ]]; then
            command=$word
        elif [[ ${1##*/} == run ]]; then
            command=run place=2  # ./run CASE
        else
            return
        fi
    done
    [[ $current == '=' ]] && current=
    if [[ -n $option ]]; then
        _tiretherm_value "$command" "$option" "$current"
    elif [[ $current == -* ]]; then
        _tiretherm_words "$(_tiretherm_options "$command")"
    elif [[ -n $command ]]; then
        _tiretherm_value "$command" "$place" "$current"
    else
        _tiretherm_words "$_tiretherm_commands"
        if [[ ${1##*/} == run ]]; then
            local commands=("${COMPREPLY[@]}")
            _tiretherm_value run 1 "$current"
            COMPREPLY+=("${commands[@]}")
        fi
    fi
}

complete -F _tiretherm tiretherm ./run
)BASH";

std::string option_line(const CommandSyntax& command) {
    std::string words;
    for (const Argument& option : command.options) {
        words += fmt::format("{}{}", words.empty() ? "" : " ", fmt::join(option.names, " "));
    }
    return fmt::format("        '{}') echo '{}' ;;\n", command.name, words);
}

/// The line of _tiretherm_value for one option or place; empty where nothing can be offered.
std::string value_line(const std::string& command, const std::string& which, const Offer& offer) {
    std::string does;
    if (!offer.words.empty()) {
        does = fmt::format("_tiretherm_words '{}'", fmt::join(offer.words, " "));
    } else if (!offer.endings.empty() || offer.folders) {
        does =
            fmt::format("_tiretherm_files \"$3\"{}{}", offer.endings.empty() ? "" : " ", fmt::join(offer.endings, " "));
    }
    return does.empty() ? std::string() : fmt::format("        '{} {}') {} ;;\n", command, which, does);
}

}  // namespace

std::string bash_script(const CallSyntax& syntax) {
    std::string commands;
    std::string options = option_line(syntax.program);
    std::string values;
    std::string valued;
    for (const CommandSyntax& command : syntax.commands) {
        commands += " " + command.name;
        options += option_line(command);
        for (const Argument& option : command.options) {
            for (const std::string& name : option.names) {
                if (option.takes_value) {
                    valued += fmt::format("{} {} ", command.name, name) + " ";
                    values += value_line(command.name, name, option.offer);
                }
            }
        }
        for (std::size_t i = 0; i < command.arguments.size(); ++i) {
            values += value_line(command.name, std::to_string(i + 1), command.arguments[i].offer);
        }
    }
    return fmt::format(
        "{}_tiretherm_commands='{} '\n_tiretherm_valued=' {}'  # options that a value follows\n\n"
        "_tiretherm_options() {{  # COMMAND\n    case \"$1\" in\n{}    esac\n}}\n\n"
        "_tiretherm_value() {{  # COMMAND, OPTION or place of the argument, CURRENT\n    case \"$1 $2\" in\n{}    "
        "esac\n}}\n{}",
        bash_head, commands, valued, options, values, body);
}

}  // namespace tiretherm::app
