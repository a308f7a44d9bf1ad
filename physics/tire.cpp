// SPDX-License-Identifier: BSD-3-Clause
// Evaluates thesis (35), (37)-(49), (57), (62) and (66)-(68); tables measured against the load replace the laws of
// contact and radii where they are given.

#include "physics/tire.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiretherm::physics {

double Tire::contact_length(double vertical_load) const {
    if (contact_length_table) {
        return contact_length_table->value(vertical_load);
    }
    const double exponent = contact_length_slope * vertical_load / 1000.0;
    return contact_length_limit - 2.0 * contact_length_limit / (1.0 + std::exp(exponent));
}

double Tire::contact_area(double vertical_load) const {
    if (!touches(vertical_load)) {
        return 0.0;
    }
    const double area = contact_area_table ? contact_area_table->value(vertical_load)
                                           : contact_area_at_zero + contact_area_slope * vertical_load;
    return std::clamp(area, 0.0, outer_area());
}

double Tire::loaded_radius(double vertical_load) const {
    return loaded_radius_table ? loaded_radius_table->value(vertical_load)
                               : loaded_radius_at_zero + loaded_radius_slope * vertical_load;
}

double Tire::rolling_radius(double vertical_load) const {
    if (rolling_radius_table) {
        return rolling_radius_table->value(vertical_load);
    }
    // The power law is singular at no load; below the smallest load that counts as contact it is held.
    return rolling_radius_factor *
           std::pow(std::max(vertical_load, std::max(minimum_load, 1.0)), rolling_radius_exponent);
}

double Tire::outer_area() const { return 2.0 * std::numbers::pi * unloaded_radius * width; }

double Tire::band_mass() const { return density * outer_area() * tread_thickness; }

double Tire::area_ratio() const {
    const double sidewall = sidewall_thickness * (section_height - tread_thickness);
    return (width * tread_thickness + 2.0 * sidewall) / (width * section_height);
}

double Tire::revolutions(double speed, double vertical_load) const {
    return std::abs(speed) / (2.0 * std::numbers::pi * rolling_radius(vertical_load));
}

double Tire::vertical_stiffness(double pressure) const {
    constexpr double newton_per_metre = 9.80665e3;  // of 1 kg/mm
    const double p = std::max(0.0, pressure) * 1e-3;
    const double W = width * 1e3;
    const double D = 2e3 * (unloaded_radius - section_height);  // of the rim, mm
    const double A = 100.0 * section_height / width;
    return newton_per_metre * (0.00028 * p * std::sqrt((1.03 - 0.004 * A) * W * (W * A / 50.0 + D)) + 3.45);
}

double Tire::reference_load(const Inputs& inputs) const {
    return reference_pressure <= 0.0 || inputs.inflation_pressure == reference_pressure
               ? inputs.vertical_load
               : inputs.vertical_load * vertical_stiffness(reference_pressure) /
                     vertical_stiffness(inputs.inflation_pressure);
}

double Tire::pressure_factor_of_loss(double pressure) const {
    constexpr double least_share = 0.2;  // of the reference: a flat tire is none of this law
    return reference_pressure > 0.0
               ? std::pow(std::max(pressure / reference_pressure, least_share), -pressure_exponent_of_loss)
               : 1.0;
}

double LossTangent::shift(double frequency) const {
    const double decades = std::log10(frequency / f0);
    return C2 * decades / (C1 - decades);
}

LossTangent::Place LossTangent::on_gaussian(double T_eq) const {
    constexpr double reach = 8.0;  // K, of the parabola that joins the two branches
    const double above = T_eq - peak;
    if (peak <= 0.0 || b >= peak || above >= reach) {
        return {.T = T_eq};
    }
    if (above <= -reach) {
        return {.T = peak - above, .dT = -1.0};
    }
    return {.T = peak + 0.5 * (above * above / reach + reach), .dT = above / reach};
}

double LossTangent::value(double T_eq) const {
    const double x = (on_gaussian(T_eq).T - b) / c;
    return a * std::exp(-x * x);
}

double LossTangent::log_slope(double T_eq) const {
    const Place place = on_gaussian(T_eq);
    return -2.0 * (place.T - b) / (c * c) * place.dT;
}

double strain_power(const Tire& tire, double speed, double vertical_load) {
    if (std::abs(speed) <= standing_speed || !tire.touches(vertical_load)) {
        return 0.0;
    }
    const double deflection = std::max(0.0, tire.unloaded_radius - tire.loaded_radius(vertical_load));
    const double strain = deflection / tire.section_height;
    const double energy = vertical_load * strain * tire.area_ratio() * tire.section_height;  // (43) / tan delta
    const double volumes = 2.0 * std::numbers::pi * tire.unloaded_radius / tire.contact_length(vertical_load);  // (44)
    return energy * volumes * tire.revolutions(speed, vertical_load);  // (45)(46)
}

double strain_power(const Tire& tire, const Inputs& inputs) {
    return strain_power(tire, rolling_speed(inputs), inputs.vertical_load) *
           tire.pressure_factor_of_loss(inputs.inflation_pressure);
}

}  // namespace tiretherm::physics
