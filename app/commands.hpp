// SPDX-License-Identifier: BSD-3-Clause
// What main.cpp and the files of the commands share: the functions that add a command, and exit codes.
#pragma once

#include "calls/caller.hpp"

namespace CLI {
class App;
}

/// The command line: a file for each command.
namespace tiretherm::app {

using calls::Exit;

/// Each adds a command to the program; called by the user, it leaves its exit code in `exit_code`.
#define COMMAND(name, example) void add_##name##_command(CLI::App& program, int& exit_code);
#include "app/commands.list"
#undef COMMAND

}  // namespace tiretherm::app
