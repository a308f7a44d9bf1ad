// SPDX-License-Identifier: BSD-3-Clause
// Indices of nodes, faces and cells are int, as in files and libraries; containers count in std::size_t.
#pragma once

#include <cstddef>

namespace tiretherm {

/// @pre i >= 0
[[nodiscard]] constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace tiretherm
