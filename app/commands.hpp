// SPDX-License-Identifier: BSD-3-Clause
// What main.cpp and the files of the commands share: the functions that add a command, and exit codes.
#pragma once

namespace CLI {
class App;
}

/// The command line: a file for each command.
namespace tiretherm::app {

/// How a call ends, for the shell.
enum Exit : int { done = 0, input_error = 1, numerical_failure = 2, interrupted = 130 };

/// Each adds a command to the program; called by the user, it leaves its exit code in `exit_code`.
#define COMMAND(name, example) void add_##name##_command(CLI::App& program, int& exit_code);
#include "app/commands.list"
#undef COMMAND

}  // namespace tiretherm::app
