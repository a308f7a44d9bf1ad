// SPDX-License-Identifier: BSD-3-Clause
// The film at 1 K, and the density of the gas.

#include "physics/tire_laws/cavity_film.hpp"

#include <cmath>
#include <numbers>

#include "physics/tire_laws/rotating_disk.hpp"

namespace tiretherm::physics {

namespace {

constexpr double atmosphere = 101325.0;     // Pa
constexpr double gas_constant = 287.05;     // J/(kg K), dry air
constexpr double heat_capacity = 1007.0;    // J/(kg K), at constant pressure
constexpr double filled_at = 293.15;        // K
constexpr double film_temperature = 320.0;  // K
constexpr double gravity = 9.80665;         // m/s2
constexpr double usual_pressure = 220e3;    // Pa above the atmosphere, of the thesis tire

}  // namespace

double gas_density(const Tire& tire, const Inputs& inputs) {
    const double stated = tire.reference_pressure > 0.0 ? tire.reference_pressure : usual_pressure;
    const double pressure = inputs.inflation_pressure > 0.0 ? inputs.inflation_pressure : stated;
    return (pressure + atmosphere) / (gas_constant * filled_at);
}

double CavityFilm::at_one_kelvin(const Tire& tire, const Inputs& inputs, double radius) const {
    const double turning = 2.0 * std::numbers::pi * tire.revolutions(inputs);
    const double acceleration = std::hypot(turning * turning * radius, gravity);
    const double conductivity = Air::conductivity(film_temperature);
    // mu does not depend on the pressure; the kinematic one of Air is at that of the atmosphere.
    const double viscosity = Air::viscosity(film_temperature) * atmosphere / (gas_constant * film_temperature);
    const double density = gas_density(tire, inputs);
    return nusselt * conductivity *
           std::cbrt(acceleration * density * density * heat_capacity / (film_temperature * viscosity * conductivity));
}

}  // namespace tiretherm::physics
