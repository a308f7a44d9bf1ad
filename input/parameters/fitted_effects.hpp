#pragma once

#include <span>
#include <string>

#include "solver/sensitivity/free_parameter.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::input {

/// The tables [effects.NAME] of what was fitted, and of effects that were switched on; the user's own as [[source]] and
/// [[exchange]].
/// @param own what those of the user's own follow that `before` does not have  @returns TOML, or nothing
/// @errors std::invalid_argument names one that is not among them
[[nodiscard]] std::string effects_text(const solver::Problem& before, const solver::Problem& fitted,
                                       std::span<const solver::FreeParameter> parameters,
                                       std::span<const solver::UserEffect> user_effect);

}  // namespace tiretherm::input
