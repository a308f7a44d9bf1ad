// SPDX-License-Identifier: BSD-3-Clause
// What the catalogue says of an effect as a report, and of all effects as the page docs/effects.md.
#pragma once

#include <string>

#include "physics/effect.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// All that the catalogue says of an effect: what it means, its equation and parameters with their plausible ranges, what it
/// reads and where it acts.
[[nodiscard]] Report effect_report(const physics::Effect& effect);

/// The page docs/effects.md as Markdown: the effects by what they change.
[[nodiscard]] std::string effects_page();

}  // namespace tiretherm::post
