// SPDX-License-Identifier: BSD-3-Clause
// Looks the numbers of the forced law up in air_convection.

#include "physics/convection.hpp"

#include <string_view>

namespace tiretherm::physics {

ForcedConvection forced_convection(const PlacementContext& context) {
    ForcedConvection law;
    if (const ActiveEffect* air = context.find("air_convection")) {
        const auto number = [&](std::string_view key) {
            return (*air)[static_cast<std::size_t>(find_parameter(*air->effect, key))];
        };
        law = {.coefficient = number("coefficient"),
               .exponent = number("exponent"),
               .air_conductivity = number("air_conductivity"),
               .air_viscosity = number("air_viscosity")};
    }
    return law;
}

}  // namespace tiretherm::physics
