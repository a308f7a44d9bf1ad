#pragma once

#include <span>
#include <string>

#include "solver/adjustable.hpp"

namespace tiretherm::cases {

/// The tables [effects.NAME] of what was fitted, and of effects that were switched on. @returns TOML, or nothing
[[nodiscard]] std::string effects_text(const solver::Problem& before, const solver::Problem& fitted,
                                       std::span<const solver::Adjustable> parameters);

}  // namespace tiretherm::cases
