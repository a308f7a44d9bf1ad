// SPDX-License-Identifier: BSD-3-Clause
// Parts of the kind of parameters of effects: those of the catalogue, the user's own and those of cameras.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "input/parameters/parameter_kind.hpp"
#include "physics/effect.hpp"

namespace tiretherm::input {

/// What follows the effect in a path: "h", or "h_by_patch.top".
struct EffectKey {
    std::string key;
    SourceLocation at{};
    std::optional<physics::Scope> scope{};
    LocatedString place{};  ///< where `scope` is given
};

[[nodiscard]] EffectKey effect_key(const ParameterPath& path);
/// Whether a path has the keys of a number: three, or four where its place is named. Otherwise an error.
[[nodiscard]] bool has_shape(const ParameterPath& path, const CaseAsRead& in);
/// A number of an effect that is on, everywhere or at the place that its key names.
[[nodiscard]] std::optional<FreeParameters> free_effect_parameter(const CaseAsRead& in, std::size_t effect,
                                                                  std::size_t parameter, const EffectKey& key);
/// A parameter of an effect of the catalogue.
[[nodiscard]] std::optional<FreeParameters> find_effect_parameter(const ParameterPath& path, const CaseAsRead& in);
/// Where a parameter of an effect that is on stands: the value that counts everywhere.
[[nodiscard]] ParameterPath path_of(const physics::ActiveEffect& active, std::size_t parameter);

/// Writes the parameters of effects that were fitted for all runs, and the effects that were switched on; the user's own as
/// [[source]] and [[exchange]].
/// @errors std::invalid_argument names one of the user's own that is not among Overlay::user_effects
void write_effects(TomlValue& over, const Overlay& overlay, const TomlValue& original);
/// Writes those that belong to some runs.
/// @param into the table of one corner  @param fitted the problem of a run of this corner  @param run its index
void write_effects_of_run(TomlValue& into, const solver::Problem& fitted,
                          std::span<const solver::FreeParameter> parameters, std::size_t run);

}  // namespace tiretherm::input
