// SPDX-License-Identifier: BSD-3-Clause
// The Magic Formula follows camber and pressure where they are given, the contact pressure these and the lateral force, what
// rolls the slip; everything else reads what it needs.

#include "solver/quantity_inputs.hpp"

#include <array>

namespace tiretherm::solver {

namespace {
constexpr std::array<std::string_view, 2> turning{"slip_ratio", "slip_speed"};
constexpr std::array<std::string_view, 3> of_the_formula{"camber", "inflation_pressure", "slip_speed"};
constexpr std::array<std::string_view, 3> across_tread{"camber", "lateral_force", "inflation_pressure"};
}  // namespace

std::span<const std::string_view> optional_signals(Quantity quantity) {
    const QuantityDescription& description = description_of(quantity);
    if (description.follows_watts) {
        return turning;
    }
    if (description.needs_effect == "pressure_across_tread") {
        return across_tread;
    }
    if (!description.needs_magic_formula && !description.needs_peak && quantity != Quantity::cornering_stiffness) {
        return {};
    }
    const std::span<const std::string_view> all = of_the_formula;
    return quantity == Quantity::longitudinal_force ? all : all.first(2);
}

}  // namespace tiretherm::solver
