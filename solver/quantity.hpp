// SPDX-License-Identifier: BSD-3-Clause
// What a channel may read: one description a quantity, from which the units, the reader's list of sensor kinds and the
// evaluation follow. A new quantity is a value of the enumeration and a row of the table in solver/quantities.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "mesh/mesh.hpp"
#include "physics/signals.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::solver {

class System;
struct Problem;

/// What a channel reads. Temperatures are functionals of the nodes; the others follow from the tire's laws, the inputs
/// and, where it says so, the temperature of `where`.
enum class Quantity : std::uint8_t {
    temperature,               ///< K
    drag_force,                ///< N, rolling resistance of all that is lost by deformation (51)
    rolling_moment,            ///< N m (50)
    loaded_radius,             ///< m (37)
    cornering_stiffness,       ///< N/rad, at the temperature of `where` (52)
    bulk_temperature_factor,   ///< lambda_Tb of the Magic Formula at the temperature of `where` (60)
    lateral_force,             ///< N, Magic Formula with the cornering stiffness at the temperature of `where` (59)
    reference_lateral_force,   ///< N, Magic Formula that knows no temperature (10)
    longitudinal_force,        ///< N, Magic Formula in pure longitudinal slip (8)
    surface_at_entry,          ///< K, where the tread meets the road, in each revolution of which `where` is the mean
    surface_at_exit,           ///< K, where it leaves the road
    gas_pressure,              ///< Pa above the atmosphere, heated at constant volume to the temperature of `where`
    contact_pressure_outside,  ///< 1, over the mean of the tread, of the outside shoulder
    contact_pressure_middle,   ///< the same of the crown
    contact_pressure_inside,   ///< the same of the inside shoulder
    heat_flux,                 ///< W/m2 out of the rubber: flow into the surface nodes of `where`, weighted by 1/area
    grip,                      ///< friction over that at the reference temperature, at the temperature of `where` (30)
    peak_lateral_force         ///< N, the largest in pure slip, with that friction
};

/// What a quantity may be followed from along a step.
struct FollowedState {
    const System& system;
    const mesh::Functional& where;        ///< of the channel, as its sensor models left it
    std::span<const double> temperature;  ///< [n_nodes] K
    std::span<const double> watts;        ///< [n_effects] W
    std::span<double> flow;               ///< [n_nodes] to work in
    std::span<double> means;              ///< [n_regions] to work in
};

/// A moment at which a channel is read.
struct SensorMoment {
    const Problem& problem;
    const System& system;
    Quantity quantity;
    double followed;                 ///< what `follow` gave, after lag and delay
    const physics::Inputs& inputs;   ///< after the input corrections
    const physics::Inputs& logged;   ///< as logged
    double gas_start;                ///< K, of the gas at the start of the case
    std::span<double> coefficients;  ///< [n_coefficients] to work in
    double surface = 0.0;            ///< K, mean of the region surface, where friction follows it
};

/// All that the program knows about a quantity.
struct QuantityDescription {
    Quantity quantity;
    std::string_view kind;     ///< of a [[sensor]]; a temperature is read by the kinds of places instead
    std::string_view meaning;  ///< where the case says none
    std::string_view unit;     ///< SI, as UDUNITS reads it
    ShownUnit shown;           ///< how users see it
    std::span<const std::string_view> signals{};  ///< from which it follows
    std::string_view region{};   ///< whose temperature it follows, unless the case names a sensor; empty: none
    bool through_patch = false;  ///< it passes the boundary: the case names a patch
    bool needs_tire = true;
    bool needs_magic_formula = false;
    bool needs_peak = false;  ///< a property file, or the peak of the lateral force
    bool needs_grip = false;
    std::string_view needs_effect{};
    bool follows_watts = false;  ///< `follow` looks at the watts of effects
    /// What is followed along a step, through which lag and delay act; null: the temperature of `where`.
    double (*follow)(const FollowedState& state) = nullptr;
    /// The quantity from what was followed; null: it is what was followed.
    double (*evaluate)(const SensorMoment& moment) = nullptr;
};

/// All quantities, in the order of the enumeration.
[[nodiscard]] std::span<const QuantityDescription> quantities();
[[nodiscard]] const QuantityDescription& description_of(Quantity quantity);

[[nodiscard]] std::string_view unit_of(Quantity quantity);  ///< SI, as UDUNITS reads it

}  // namespace tiretherm::solver
