// SPDX-License-Identifier: BSD-3-Clause
// What may stand on the command line, as CLI11 knows it: commands, their options and arguments, and what each takes.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tiretherm::app {

/// What a shell may offer for a value. All empty: a value that only the user knows, such as a number of seconds.
struct Offer {
    std::vector<std::string> words{};
    std::vector<std::string> endings{};  ///< of files, without the dot; folders that may lead to them are offered, too
    bool folders = false;                ///< folders alone are an answer

    friend bool operator==(const Offer&, const Offer&) = default;
};

/// An option of a command, or one of its arguments.
struct Argument {
    std::vector<std::string> names;  ///< "-h" and "--help"; none for an argument that goes by its place
    std::string placeholder;         ///< how the help calls its value, "DIR"; empty for a flag
    std::string sentence;            ///< the first of its help
    bool takes_value = false;
    bool repeats = false;
    Offer offer{};
};

struct CommandSyntax {
    std::string name;  ///< empty for the program itself
    std::string sentence;
    std::vector<Argument> options;
    std::vector<Argument> arguments;  ///< in the order of their places
};

struct CallSyntax {
    CommandSyntax program;
    std::vector<CommandSyntax> commands;
};

/// Reads it from the parser, so that an option that is added there is offered without more ado. What a value may be follows
/// from its placeholder, which means one thing in all commands, or from the choices of the parser.
[[nodiscard]] CallSyntax call_syntax(const CLI::App& program);

/// What a placeholder of the help stands for. @returns null for one that is not known
[[nodiscard]] const Offer* offer_for(const std::string& placeholder);

/// Scripts that complete calls of `tiretherm` and `./run`.
[[nodiscard]] std::string bash_script(const CallSyntax& syntax);
[[nodiscard]] std::string zsh_script(const CallSyntax& syntax);

}  // namespace tiretherm::app
