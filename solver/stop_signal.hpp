#pragma once

namespace tiretherm::solver {

/// From now on Ctrl-C (SIGINT) and SIGTERM only ask for an end; asked a second time, the program ends at once.
void heed_stop_signals();

/// Whether the user has asked for an end.
[[nodiscard]] bool stop_requested();

}  // namespace tiretherm::solver
