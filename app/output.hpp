// SPDX-License-Identifier: BSD-3-Clause
// Options of several commands, and the file that a case is written to.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tiretherm::app {

/// --out, which must have a name. @param what the line of the help  @param type "DIR" or "FILE"
void add_out_option(CLI::App& command, std::string& target, const std::string& what, const char* type = "DIR",
                    const char* names = "--out");

/// Whether a file that is to be written is one that the call reads, by whatever link or path; reports it.
[[nodiscard]] bool replaces_input(const std::filesystem::path& target, const std::vector<std::string>& inputs,
                                  bool json);

/// --quiet, of a command that takes long and prints a page.
void add_quiet_option(CLI::App& command, bool& quiet);

/// --json. @param instead_of what it takes the place of, "page"
void add_json_option(CLI::App& command, bool& json, const std::string& instead_of);

/// An option of seconds: a finite number above 0, or from 0 on.
enum class Seconds { above_zero, from_zero };
void add_seconds_option(CLI::App& command, const std::string& name, double& seconds, const std::string& what,
                        Seconds range = Seconds::above_zero);

/// --fresh.
void add_fresh_option(CLI::App& command, bool& fresh);

}  // namespace tiretherm::app
