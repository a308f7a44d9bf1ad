// SPDX-License-Identifier: BSD-3-Clause
// Coefficients of a moment from the speed of the wheel, and the film from them and the temperature of the surface, with
// its derivative.

#include "physics/tire_laws/disk_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/tire_laws/rotating_disk.hpp"

namespace tiretherm::physics::disk_film {

namespace {

enum : std::size_t { its_scale, its_laminar, its_turbulent, its_transition, its_natural };
enum : std::size_t { air_temperature, laminar_part, turbulent_part, natural_at_1K };

double number(const ActiveEffect& active, std::size_t which) {
    return active[active.effect->parameters.size() - n_parameters + which];
}

/// natural_convection acts on a wheel at rest; where it is on, the floor is its own.
bool has_natural_convection(const ActiveEffect& active, std::span<const ActiveEffect> effects) {
    return active.lumped_nodes.empty() && std::ranges::any_of(effects, [&](const ActiveEffect& other) {
               return other.effect->id == "natural_convection" &&
                      std::ranges::find_first_of(other.patches, active.patches) != other.patches.end();
           });
}

}  // namespace

Ring sidewalls_of(const Tire& tire) {
    return {.inner = std::max(0.0, tire.unloaded_radius - tire.section_height), .outer = tire.unloaded_radius};
}

Ring rim_of(const Tire& tire) { return {.inner = 0.0, .outer = tire.unloaded_radius - tire.section_height}; }

double area_of(const Ring& ring) {
    return 2.0 * std::numbers::pi * (ring.outer * ring.outer - ring.inner * ring.inner);
}

bool is_chosen(const ActiveEffect& active) {
    const int choice = find_choice(*active.effect, key);
    return choice >= 0 && active.choices[static_cast<std::size_t>(choice)] == 1;
}

double reynolds_in_millions(const ActiveEffect& active, const Ring& ring, const Tire& tire, const Inputs& inputs) {
    if (!is_chosen(active) || std::abs(rolling_speed(inputs)) <= standing_speed) {
        return 0.0;
    }
    const double turning = 2.0 * std::numbers::pi * std::abs(tire.revolutions(inputs));
    return 1e-6 * turning * ring.outer * ring.outer / Air::viscosity(inputs.air_temperature);
}

void evaluate(const ActiveEffect& active, const Ring& ring, const OperatingPoint& point, std::span<double> out) {
    const Inputs& in = point.inputs;
    const bool stands = std::abs(rolling_speed(in)) <= standing_speed;
    const double turning = stands ? 0.0 : 2.0 * std::numbers::pi * point.tire.revolutions(in);
    const RotatingDisk disk{.laminar = number(active, its_laminar),
                            .turbulent = number(active, its_turbulent),
                            .transition = number(active, its_transition)};
    const RotatingDisk::Film film = disk.mean(turning, ring.inner, ring.outer, in.air_temperature);
    const bool has_floor = !stands || !has_natural_convection(active, point.effects);
    out[air_temperature] = in.air_temperature;
    out[laminar_part] = film.laminar;
    out[turbulent_part] = film.turbulent;
    out[natural_at_1K] = has_floor ? number(active, its_natural) * std::pow(2.0 * ring.outer, -0.25) : 0.0;
}

Film at(const ActiveEffect& active, std::span<const double> coefficients, double T) {
    const double T_air = coefficients[air_temperature];
    const double warmer = (T + T_air) / (2.0 * T_air);  // film over air
    const double laminar_h = coefficients[laminar_part] * std::pow(warmer, RotatingDisk::laminar_exponent);
    const double turbulent_h = coefficients[turbulent_part] * std::pow(warmer, RotatingDisk::turbulent_exponent);
    const double above = T - T_air;
    const double natural_h = coefficients[natural_at_1K] * std::pow(std::abs(above), 0.25);
    const double factor = number(active, its_scale);
    if (natural_h > laminar_h + turbulent_h) {
        return {.h = factor * natural_h, .dh_dT = factor * 0.25 * natural_h / above};
    }
    const double slope =
        (RotatingDisk::laminar_exponent * laminar_h + RotatingDisk::turbulent_exponent * turbulent_h) / (T + T_air);
    return {.h = factor * (laminar_h + turbulent_h), .dh_dT = factor * slope};
}

}  // namespace tiretherm::physics::disk_film
