// SPDX-License-Identifier: BSD-3-Clause
// What a fitted case says of effects: numbers that were fitted, and effects that were switched on.
#pragma once

#include <span>

#include "input/parameters/parameter_path.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::input {

/// Writes a value into a document that is laid over a case. Its lists have the tables that the path names: they are made.
void lay_over(TomlValue& over, const ParameterPath& path, TomlValue value);

/// Lays the numbers of what was fitted over a case, and the effects that were switched on; the user's own as [[source]]
/// and [[exchange]].
/// @param user_effects what those of the user's own follow that `before` does not have
/// @errors std::invalid_argument names one that is not among them
void lay_effects_over(TomlValue& over, const solver::Problem& before, const solver::Problem& fitted,
                      std::span<const solver::FreeParameter> parameters,
                      std::span<const solver::UserEffect> user_effects);

/// Lays the values of effects that belong to some runs over [[corner]] tables.
/// @param into the table of one corner  @param fitted the problem of a run of this corner  @param run its index
void lay_corner_over(TomlValue& into, const solver::Problem& fitted, std::span<const solver::FreeParameter> parameters,
                     std::size_t run);

}  // namespace tiretherm::input
