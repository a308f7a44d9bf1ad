// SPDX-License-Identifier: BSD-3-Clause
// What kind of sensor a channel belongs to, as far as it follows from what it reads.
#pragma once

#include <cstddef>

#include "physics/plausible_ranges.hpp"
#include "solver/problem.hpp"
#include "solver/sensitivity/free_parameter.hpp"

namespace tiretherm::diagnosis {

/// Cameras, and channels that read nothing but an outer surface, are infrared, unless their name or description says that they
/// touch it (thermocouple, probe); of those at the back or the sides of a specimen only that tells (otherwise any); those of a node in the gas and of its
/// pressure sit in the gas; other temperatures are probes; of forces and radii nothing is known (any).
/// @param channel index into Problem::channels
[[nodiscard]] physics::SensorKind sensor_kind(const solver::Problem& problem, std::size_t channel);

/// The kind of all the sensors that a free parameter of a sensor model acts on; any, where they differ or it is none.
[[nodiscard]] physics::SensorKind sensor_kind(const solver::Problem& problem, const solver::FreeParameter& parameter);

}  // namespace tiretherm::diagnosis
