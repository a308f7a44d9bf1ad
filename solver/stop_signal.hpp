// SPDX-License-Identifier: BSD-3-Clause
// Regular end of a run on Ctrl-C or SIGTERM.
#pragma once

namespace tiretherm::solver {

/// From now on Ctrl-C (SIGINT) and SIGTERM request a regular end; the second signal ends the program at once.
void install_stop_handlers();

/// Whether the user has asked for an end.
[[nodiscard]] bool stop_requested();

}  // namespace tiretherm::solver
