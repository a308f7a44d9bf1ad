// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm completion`: a script that lets bash or zsh complete commands, options and their values.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/completion/call_syntax.hpp"

namespace tiretherm::app {

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
    command->callback([shell, &program, &exit_code] {
        const CallSyntax syntax = call_syntax(program);
        fmt::print("{}", *shell == "bash" ? bash_script(syntax) : zsh_script(syntax));
        exit_code = Exit::done;
    });
}

}  // namespace tiretherm::app
