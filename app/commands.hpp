// SPDX-License-Identifier: BSD-3-Clause
// The subcommands of the command line, one function each, and the exit codes of the program.
#pragma once

namespace CLI {
class App;
}

/// The command line: a file for each command.
namespace tiretherm::app {

/// How a call ends, for the shell.
enum Exit : int { done = 0, input_error = 1, numerical_failure = 2, interrupted = 130 };

/// Each adds a command to the program; called by the user, it leaves its exit code in `exit_code`.
void add_run_command(CLI::App& program, int& exit_code);
void add_check_command(CLI::App& program, int& exit_code);
void add_compare_command(CLI::App& program, int& exit_code);
void add_convert_command(CLI::App& program, int& exit_code);
void add_diagnose_command(CLI::App& program, int& exit_code);
void add_effects_command(CLI::App& program, int& exit_code);
void add_identify_command(CLI::App& program, int& exit_code);
void add_keys_command(CLI::App& program, int& exit_code);
void add_study_command(CLI::App& program, int& exit_code);
void add_validate_command(CLI::App& program, int& exit_code);

}  // namespace tiretherm::app
