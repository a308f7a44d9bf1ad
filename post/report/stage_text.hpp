// SPDX-License-Identifier: BSD-3-Clause
// The words of what a diagnosis is doing.
#pragma once

#include <string>
#include <string_view>

#include "diagnosis/remarks/stage.hpp"

namespace tiretherm::post {

/// "search of causes"; empty of none.
[[nodiscard]] std::string_view text_of(diagnosis::Part part);
/// "candidate", "run1 alone: candidate", without the number of the piece.
[[nodiscard]] std::string text_of(const diagnosis::Activity& stage);

}  // namespace tiretherm::post
