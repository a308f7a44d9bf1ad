// SPDX-License-Identifier: BSD-3-Clause
// The Magic Formula leans with the camber and knows how fast its contact slides; everything else reads what it needs.

#include "solver/quantity_inputs.hpp"

#include <array>

namespace tiretherm::solver {

namespace {
constexpr std::array<std::string_view, 1> leaning{"camber"};
}

std::span<const std::string_view> optional_signals(Quantity quantity) {
    switch (quantity) {
        case Quantity::bulk_temperature_factor:
        case Quantity::lateral_force:
        case Quantity::reference_lateral_force:
        case Quantity::longitudinal_force:
            return leaning;
        case Quantity::temperature:
        case Quantity::drag_force:
        case Quantity::rolling_moment:
        case Quantity::loaded_radius:
        case Quantity::cornering_stiffness:
        case Quantity::surface_at_entry:
        case Quantity::surface_at_exit:
        case Quantity::gas_pressure:
        case Quantity::heat_flux:
            return {};
    }
    return {};
}

}  // namespace tiretherm::solver
