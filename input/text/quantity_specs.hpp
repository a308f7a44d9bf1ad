// SPDX-License-Identifier: BSD-3-Clause
// Specifications (unit, allowed range, usual range) of the quantities that many tables share.
#pragma once

#include "input/text/quantity.hpp"
#include "physics/effect.hpp"
#include "physics/signals.hpp"

/// What the quantities of a case must be. The usual ranges only lead to warnings; they take in everything from foamed
/// rubber to steel cord and from arctic roads to burning tires.
namespace tiretherm::input::quantity_specs {

inline constexpr QuantitySpec thickness{
    .unit = "m", .low = 0.0, .high = 1.0, .above = true, .usual_low = 1e-5, .usual_high = 0.2};
inline constexpr QuantitySpec length{
    .unit = "m", .low = 0.0, .high = 100.0, .above = true, .usual_low = 1e-5, .usual_high = 5.0};
inline constexpr QuantitySpec coordinate{.unit = "m", .low = -100.0, .high = 100.0};
inline constexpr QuantitySpec depth{.unit = "m", .low = 0.0, .high = 100.0};
inline constexpr QuantitySpec area{.unit = "m2", .low = 0.0, .high = 1e4, .above = true};
inline constexpr QuantitySpec density{
    .unit = "kg m-3", .low = 0.0, .high = 3e4, .above = true, .usual_low = 100.0, .usual_high = 1e4};
inline constexpr QuantitySpec heat_capacity{
    .unit = "J kg-1 K-1", .low = 0.0, .high = 1e6, .above = true, .usual_low = 100.0, .usual_high = 1e4};
inline constexpr QuantitySpec conductivity{
    .unit = "W m-1 K-1", .low = 0.0, .high = 1e5, .above = true, .usual_low = 0.01, .usual_high = 500.0};
inline constexpr QuantitySpec temperature{
    .unit = "K", .low = 0.0, .high = 3000.0, .usual_low = 200.0, .usual_high = 600.0};
inline constexpr QuantitySpec tolerance{.unit = "K",
                                        .scale = Scale::difference,
                                        .low = 0.0,
                                        .high = 100.0,
                                        .above = true,
                                        .usual_low = 1e-6,
                                        .usual_high = 1.0};
inline constexpr QuantitySpec moment{.unit = "s", .low = -1e10, .high = 1e10};
inline constexpr QuantitySpec duration{.unit = "s", .low = 0.0, .high = 1e10, .above = true};
inline constexpr QuantitySpec interval{.unit = "s", .low = 0.0, .high = 1e10};
inline constexpr QuantitySpec load{.unit = "N", .low = 0.0, .high = 1e6};

/// What load cells, pressure gauges and power meters read where there is nothing.
constexpr double zero_error_of(std::string_view signal) {
    return signal == "vertical_load"        ? 100.0  // N
           : signal == "inflation_pressure" ? 5e3    // Pa
           : signal == "laser_power"        ? 0.05   // W
                                            : 0.0;
}

constexpr QuantitySpec of(const physics::Signal& signal) {
    return {.unit = signal.unit, .low = signal.low, .high = signal.high, .zero_error = zero_error_of(signal.name)};
}

constexpr QuantitySpec of(const physics::ParameterSpec& parameter) {
    return {.unit = parameter.unit,
            .scale = parameter.difference ? Scale::difference : Scale::absolute,
            .low = parameter.low,
            .high = parameter.high};
}

}  // namespace tiretherm::input::quantity_specs
