#pragma once

#include <string>

#include "input/model/reader.hpp"

namespace tiretherm::app {

/// Whether a person sees what is written there.
[[nodiscard]] bool on_terminal(std::FILE* stream);

/// Whether text on stdout may be set in bold: on a terminal, unless NO_COLOR is set.
[[nodiscard]] bool may_be_bold();

/// Tells what went wrong, on stderr; with `json` as an object {"error", "mistakes"} on stdout instead.
/// @param sentence without its full stop   @param remedy what to do, or empty
void tell_error(const std::string& sentence, const std::string& remedy, bool json);

/// Tells every mistake of a case at once and counts them: "3 mistakes; nothing was run".
/// @param consequence what follows from them, "nothing was run"
void tell_mistakes(const input::Reading& reading, const std::string& consequence, bool json);

}  // namespace tiretherm::app
