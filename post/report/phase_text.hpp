// SPDX-License-Identifier: BSD-3-Clause
// The words of driving phases.
#pragma once

#include <string_view>

#include "diagnosis/compare/phase.hpp"

namespace tiretherm::post {

[[nodiscard]] std::string_view name_of(diagnosis::Phase phase);
/// "speed below 0.1 m/s"
[[nodiscard]] std::string_view meaning_of(diagnosis::Phase phase);

}  // namespace tiretherm::post
