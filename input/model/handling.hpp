// SPDX-License-Identifier: BSD-3-Clause
// What [tire] says of cornering stiffness, lateral force and friction, and what was measured beside the laws.
#pragma once

#include <vector>

#include "input/model/materials.hpp"
#include "physics/tire_laws/handling.hpp"

namespace tiretherm::input {

/// Reads `modulus`, `property_file`, `cornering_stiffness`, `lateral_peak`, `grip` and `measured` of [tire].
[[nodiscard]] physics::Handling read_handling(TomlTable& tire);

/// The belt's modulus of the plies that `belt_material` of [tire.modulus] names, which are used then; errors where the moduli
/// fall to nothing.
void settle_belt(TomlTable& root, std::vector<Stock>& stock, physics::Handling& handling);

}  // namespace tiretherm::input
