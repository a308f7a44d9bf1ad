// SPDX-License-Identifier: BSD-3-Clause
// Output of all commands: reports, errors with a remedy, and lists of input errors, as text or JSON.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

#include "input/runs/reader.hpp"
#include "post/report/report.hpp"

namespace tiretherm::app {

/// Whether a person sees what is written there.
[[nodiscard]] bool on_terminal(std::FILE* stream);

/// Columns of the page on stdout: those of the terminal (COLUMNS, otherwise as it says), at least 60; in a file or a pipe
/// post::standard_width.
[[nodiscard]] std::size_t page_width();

/// The same for prose, at most post::widest_prose.
[[nodiscard]] std::size_t prose_width();

/// A text as it may go to a terminal: control characters, which a title or a cell of a sheet may hold, as blanks.
/// @param bold leaves the program's own marks of bold text
[[nodiscard]] std::string terminal_text(std::string_view text, bool bold = false);

/// A text of the program's on stdout, with bold parts where it may have them.
void print_text(std::string_view text);

/// A result on stdout: its page, or with `json` its data.
void print_report(const post::Report& report, bool json);

/// Reports what went wrong, on stderr; with `json` as an object {"error", "errors"} (and "mistakes", as it was called before 0.3) on stdout instead.
/// @param sentence without its full stop   @param remedy what to do, or empty
void report_error(const std::string& sentence, const std::string& remedy, bool json);

/// Reports all errors of a case at once and counts them: "3 errors; nothing was run".
/// @param consequence what follows from them, "nothing was run"
void report_errors(const input::CaseFindings& reading, const std::string& consequence, bool json);

}  // namespace tiretherm::app
