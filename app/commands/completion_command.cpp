// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm completion`: a script that lets bash or zsh complete commands, options and their values.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"

namespace tiretherm::app {

namespace {

// Both ask the program that the line calls for each Tab; ./run itself would build first.
constexpr const char* bash_script = R"BASH(# bash completion for tiretherm: source <(tiretherm completion bash)

_tiretherm() {
    local program=$1 words=("$1") offers=() typed before piece offer
    [[ ${1##*/} == run ]] && program=${TIRETHERM_PROGRAM:-${1%run}build/release/tiretherm}
    for piece in "${COMP_WORDS[@]:1:COMP_CWORD}"; do  # readline splits at = and :
        if [[ $piece == [=:] || ${words[-1]} == *[=:] ]]; then words[-1]+=$piece; else words+=("$piece"); fi
    done
    typed=${words[-1]#--*=}
    COMPREPLY=()
    while IFS=$'\t' read -r offer piece; do
        case $offer in
            :folders) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- "$typed") ;;
            :files*)
                compopt -o filenames
                mapfile -t COMPREPLY < <({
                    compgen -d -- "$typed"
                    for piece in ${offer#:files}; do compgen -f -X "!*$piece" -- "$typed"; done
                } | sort -u) ;;
            *) offers+=("$offer") ;;
        esac
    done < <("$program" complete "${words[@]}" 2>/dev/null)
    before=${typed%"${typed##*:}"}
    for offer in "${offers[@]}"; do
        [[ $offer == "$typed"* ]] && COMPREPLY+=("${offer#"$before"}")
    done
}

complete -F _tiretherm tiretherm ./run
)BASH";

constexpr const char* zsh_script = R"ZSH(#compdef tiretherm -p */./run
# zsh completion for tiretherm, after compinit: source <(tiretherm completion zsh)

_tiretherm() {
    local program=$words[1] offer
    local -a offers
    [[ ${program:t} != run ]] || program=${TIRETHERM_PROGRAM:-${program%run}build/release/tiretherm}
    for offer in ${(f)"$($program complete "${(@Q)words[1,CURRENT]}" 2>/dev/null)"}; do
        case $offer in
            :folders) compset -P '--*='; _files -/ ;;
            :files*) compset -P '--*='; _files -g "*${(j: *:)${=offer#:files}}" ;;
            *) offers+=("${${offer%%$'\t'*}//:/\\:}:${offer#*$'\t'}") ;;
        esac
    done
    (( ! $#offers )) || { compset -P '--*='; _describe tiretherm offers }
}

if [[ $funcstack[1] == _tiretherm ]]; then
    _tiretherm "$@"
else
    compdef _tiretherm tiretherm -p '*/./run'
fi
)ZSH";

}  // namespace

void add_completion_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("completion", "Print a script that completes calls in bash or zsh");
    const auto shell = std::make_shared<std::string>();
    command->add_option("SHELL", *shell, "bash or zsh")
        ->required()
        ->option_text(" ")
        ->check(CLI::IsMember(std::vector<std::string>{"bash", "zsh"}));
    command->footer(
        "The Tab key then completes commands, options, effects, inputs, tables and topics, and offers the files that "
        "an option takes. For the shell you are in:\n\n"
        "  source <(tiretherm completion bash)\n\n"
        "For every shell, add that line to ~/.bashrc or, with zsh for bash and below compinit, to ~/.zshrc. cmake "
        "--install puts both scripts where shells look for them. From the source tree ./run works, too:\n\n"
        "  source <(./run completion bash)\n\n"
        "Example:\n"
        "  tiretherm completion bash");
    command->callback([shell, &exit_code] {
        fmt::print("{}", *shell == "bash" ? bash_script : zsh_script);
        exit_code = Exit::done;
    });
}

}  // namespace tiretherm::app
