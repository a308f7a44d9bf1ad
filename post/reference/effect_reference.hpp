// SPDX-License-Identifier: BSD-3-Clause
// What the catalogue says of an effect, in the words of `tiretherm effects`, and the page docs/effects.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physics/effect.hpp"
#include "physics/plausible_ranges.hpp"

namespace tiretherm::post {

[[nodiscard]] std::string kind_name(physics::Kind kind);
/// Whether it is part of the thesis's model.
[[nodiscard]] std::string origin(const physics::Effect& effect);
/// What a file of a structural code may give an effect, and what else may replace its total.
[[nodiscard]] std::string field_text(const physics::Effect& effect);
/// A unit as a table shows it: "-" for a pure number.
[[nodiscard]] std::string unit_text(std::string_view unit);
/// What an effect acts on, and what it needs; empty where it is nothing special.
[[nodiscard]] std::string acts_on_text(const physics::Effect& effect);
[[nodiscard]] std::string needs_text(const physics::Effect& effect);

/// The plausible ranges of an effect's parameters, of "conduction" those of material laws.
[[nodiscard]] std::vector<physics::PlausibleRange> ranges_of(const physics::Effect& effect);
/// The parameter of a range as a reader wants it: "tau, probe in rubber".
[[nodiscard]] std::string parameter_text(const physics::PlausibleRange& range);
/// The unit of a range: of its parameter, of any of the effect's for "*", or of a material law.
[[nodiscard]] std::string range_unit(const physics::Effect& effect, const physics::PlausibleRange& range);

/// The page docs/effects.md as Markdown: the effects by what they change.
[[nodiscard]] std::string effects_page();

}  // namespace tiretherm::post
