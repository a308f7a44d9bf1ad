// SPDX-License-Identifier: BSD-3-Clause
// Version and build of the program: a study keeps a result only for the program that computed it.
#pragma once

#include <string>

namespace tiretherm::calls {

/// Version and build of this program: results that it kept count only for the program that made them. The build is the
/// linker's hash over the whole of it; where a linker writes none, the version stands alone.
[[nodiscard]] std::string build_identity();

}  // namespace tiretherm::calls
