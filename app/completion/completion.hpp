// SPDX-License-Identifier: BSD-3-Clause
// What may follow on the command line, as the parser knows it: `tiretherm complete WORDS` for the scripts of the shells.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tiretherm::app {

/// Offers for the last of the words. Commands, options and choices are read from the parser, so that what is added there is
/// offered without more ado; what another value may be follows from its placeholder, which means one thing in all commands.
/// @param words  the name by which the program is called (`tiretherm` or a path to `run`), then the words of the line up to the
///               cursor; the last is the one that is typed, and may be empty
/// @returns lines: an offer, with a tab and what it means where that is known; ":files" with the endings of the files that the
///          shell may offer, ":folders" for folders alone
[[nodiscard]] std::string completion_lines(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace tiretherm::app
