#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/effects/user_effects.hpp"
#include "input/model/problem_builder.hpp"
#include "solver/sensitivity/free_parameter.hpp"

namespace tiretherm::input {

/// The numbers that one [[parameter]] frees: where they are in the problem. Prior and bounds are read afterwards.
struct FreeParameters {
    std::vector<solver::FreeParameter> numbers;
    QuantitySpec spec;  ///< what their values must be
};

/// A parameter of an effect that is on, everywhere or at a place: effect, key, and patch, layer, zone or channel. An
/// effect of the user's own may be named here as well.
[[nodiscard]] std::optional<FreeParameters> free_effect(TomlTable& parameter, const ProblemBuilder& builder,
                                                        const TomlValue& document);
/// The number of a user effect: source or exchange, and its key, which may be left out.
[[nodiscard]] std::optional<FreeParameters> free_user_effect(TomlTable& parameter, const ProblemBuilder& builder,
                                                             const TomlValue& document, const UserEffectKind& kind);
/// A number of a camera: camera, key.
[[nodiscard]] std::optional<FreeParameters> free_camera(TomlTable& parameter, const ProblemBuilder& builder,
                                                        const TomlValue& document);
/// The law of a material by its values at one to three temperatures: material, law, at.
[[nodiscard]] std::optional<FreeParameters> free_law(TomlTable& parameter, const ProblemBuilder& builder);
/// The law of the link between two lumps: link, at.
[[nodiscard]] std::optional<FreeParameters> free_link(TomlTable& parameter, const ProblemBuilder& builder);
/// Initial temperatures, of each run: initial, one word or several.
[[nodiscard]] std::optional<FreeParameters> free_initial(TomlTable& parameter, const ProblemBuilder& builder,
                                                         const std::vector<std::string>& run_names);

}  // namespace tiretherm::input
