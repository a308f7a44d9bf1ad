// SPDX-License-Identifier: BSD-3-Clause
// The words of what a diagnosis remarks on.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"

namespace tiretherm::post {

/// A remark as a sentence, or as the part of one that it is.
[[nodiscard]] std::string text_of(const diagnosis::Remark& remark);
/// @returns [remarks]
[[nodiscard]] std::vector<std::string> texts_of(const diagnosis::Remarks& remarks);

}  // namespace tiretherm::post
