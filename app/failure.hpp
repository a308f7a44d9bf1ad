// SPDX-License-Identifier: BSD-3-Clause
// A standard output that takes nothing.
#pragma once

#include <exception>

namespace tiretherm::app {

/// Descriptors 0 to 2 that the caller has closed lead to nowhere, so that no file of results gets their number.
void keep_standard_streams();

/// Remembers why standard output took nothing, where that is what an exception is about. @returns whether it is
[[nodiscard]] bool is_lost_output(const std::exception& error);

/// Writes what is left for standard output. @returns whether all of it has been taken; otherwise it has been reported
[[nodiscard]] bool flush_standard_output();

}  // namespace tiretherm::app
