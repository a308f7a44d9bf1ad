// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the catalogue whose signature has to be taken at several values, or together with another parameter.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "physics/effect.hpp"

namespace tiretherm::diagnosis {

/// How the signature of a parameter is taken where its slope at the absent effect is not enough.
struct TrialValues {
    std::string_view effect;         ///< of the catalogue
    std::string_view parameter;      ///< of this effect
    std::string_view other{};        ///< another parameter of it, which moves along or is held
    double factor = 0.0;             ///< of what moves along
    std::array<double, 11> held{};   ///< values of `other` on trial, ascending, two or more, and zeros
    std::array<double, 4> trials{};  ///< values at which the signature is taken, as many as are not 0
    bool left_out = false;           ///< says nothing that another parameter of the effect does not say
};

[[nodiscard]] std::span<const TrialValues> trial_values();
/// @returns null where the slope is enough
[[nodiscard]] const TrialValues* trial_values_of(const physics::Effect& effect,
                                                 const physics::ParameterSpec& parameter);

}  // namespace tiretherm::diagnosis
