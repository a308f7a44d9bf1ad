// SPDX-License-Identifier: BSD-3-Clause
// What the commands that write files share: --out, the folder with its lock, and how a call ends that was stopped.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "post/report/output_folder.hpp"
#include "solver/digest.hpp"

namespace CLI {
class App;
}

namespace tiretherm::app {

/// --out, which must have a name. @param what the line of the help  @param type "DIR" or "FILE"
void add_out_option(CLI::App& command, std::string& target, const std::string& what, const char* type = "DIR",
                    const char* names = "--out");

/// Opens the folder for a call's files; reports why that cannot be done.
/// @param inputs files that the call reads  @param names of files that it may write or remove
/// @param consequence "nothing was run"  @returns null after an error
[[nodiscard]] std::unique_ptr<post::OutputFolder> open_output(const std::filesystem::path& folder,
                                                              std::vector<std::string> inputs,
                                                              const std::vector<std::string>& names,
                                                              const std::string& consequence, bool json);

/// Lets files be written to the stage and moves them into place; reports why that cannot be done, and then nothing has
/// changed. @param stale names of files of an earlier call that these do away with
[[nodiscard]] bool write_output(post::OutputFolder& folder, const std::vector<std::string>& stale, bool json,
                                const std::function<void()>& write);

/// Whether a file that is to be written is one that the call reads, by whatever link or path; reports it.
[[nodiscard]] bool replaces_input(const std::filesystem::path& target, const std::vector<std::string>& inputs,
                                  bool json);

/// What an interrupted call must agree in with the one that goes on: program, files and what else its results follow from.
[[nodiscard]] solver::Digest::Value call_identity(const std::vector<std::string>& files,
                                                  const std::vector<std::string>& arguments);

/// --quiet, of a command that takes long and prints a page.
void add_quiet_option(CLI::App& command, bool& quiet);

/// An option of seconds: a finite number above 0, or from 0 on.
enum class Seconds { above_zero, from_zero };
void add_seconds_option(CLI::App& command, const std::string& name, double& seconds, const std::string& what,
                        Seconds range = Seconds::above_zero);

/// --fresh.
void add_fresh_option(CLI::App& command, bool& fresh);

/// One line on stderr. @param kept "1200 s of 3600 s are kept"
void tell_of_continuation(const std::string& kept);

/// One line on stderr. @param consequence "the run begins anew"
void tell_of_damage(const std::string& consequence);

/// Whether Ctrl-C or SIGTERM asks for an end; reports it. @param consequence "nothing was run"
[[nodiscard]] bool was_stopped(const std::string& consequence, bool json);

/// "stopped", or that the time limit has passed.
[[nodiscard]] std::string stop_sentence();
/// The exit code of a call that was stopped before it had an answer: a signal is not a time limit that was too short.
[[nodiscard]] int stop_exit();

}  // namespace tiretherm::app
