// SPDX-License-Identifier: BSD-3-Clause
// What the calls that write files share: the folder with its lock, and how a call ends that was stopped.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "calls/caller.hpp"
#include "post/report/output_folder.hpp"
#include "solver/digest.hpp"

namespace tiretherm::calls {

/// Opens the folder for a call's files; says why that cannot be done.
/// @param inputs files that the call reads  @param names of files that it may write or remove
/// @param consequence "nothing was run"  @returns null after an error
[[nodiscard]] std::unique_ptr<post::OutputFolder> open_output(const std::filesystem::path& folder,
                                                              std::vector<std::string> inputs,
                                                              const std::vector<std::string>& names,
                                                              const std::string& consequence, Caller& caller);

/// Lets files be written to the stage and moves them into place; says why that cannot be done, and then nothing has
/// changed. @param stale names of files of an earlier call that these do away with
[[nodiscard]] bool write_output(post::OutputFolder& folder, const std::vector<std::string>& stale, Caller& caller,
                                const std::function<void()>& write);

/// What an interrupted call must agree in with the one that goes on: program, files and what else its results follow from.
[[nodiscard]] solver::Digest::Value call_identity(const std::vector<std::string>& files,
                                                  const std::vector<std::string>& arguments);

/// @param kept "1200 s of 3600 s are kept"
void tell_of_continuation(const std::string& kept, Caller& caller);

/// @param consequence "the run begins anew"
void tell_of_damage(const std::string& consequence, Caller& caller);

/// Whether Ctrl-C or SIGTERM asks for an end; says so. @param consequence "nothing was run"
[[nodiscard]] bool was_stopped(const std::string& consequence, Caller& caller);

/// "stopped", or that the time limit has passed.
[[nodiscard]] std::string stop_sentence();
/// The exit code of a call that was stopped before it had an answer: a signal is not a time limit that was too short.
[[nodiscard]] int stop_exit();

}  // namespace tiretherm::calls
