// SPDX-License-Identifier: BSD-3-Clause
// Scales the thesis's tire, its laws (35), (37), (57) and (62), by radius, stiffness and inflation.
#include "physics/tire_laws/scaled_tire.hpp"

#include <cmath>

namespace tiretherm::physics {

double vertical_stiffness(const TireOutline& outline) {
    Tire tire;
    tire.width = outline.width;
    tire.section_height = outline.section_height;
    tire.unloaded_radius = 0.5 * outline.rim_diameter + outline.section_height;
    return tire.vertical_stiffness(outline.inflation_pressure);
}

double load_ratio(const TireOutline& outline) {
    const auto load = [](const TireOutline& of) {
        const double radius = 0.5 * of.rim_diameter + of.section_height;
        return of.width * std::sqrt(radius * of.section_height) * std::pow(of.inflation_pressure, 0.8);
    };
    return load(outline) / load({});
}

Tire scaled_tire(const TireOutline& outline) {
    const TireOutline base;
    Tire tire;
    const double surplus = tire.unloaded_radius - 0.5 * base.rim_diameter - base.section_height;
    const double radius = 0.5 * outline.rim_diameter + outline.section_height + surplus;
    const double size = radius / tire.unloaded_radius;
    const double stiffness = vertical_stiffness(outline) / vertical_stiffness(base);
    tire.width = outline.width;
    tire.section_height = outline.section_height;
    tire.unloaded_radius = radius;
    tire.contact_length_limit *= size;
    tire.contact_length_slope /= stiffness;
    tire.contact_area_slope *= base.inflation_pressure / outline.inflation_pressure;
    tire.loaded_radius_at_zero = radius;
    tire.loaded_radius_slope /= stiffness;
    tire.rolling_radius_factor *= size;
    return tire;
}

}  // namespace tiretherm::physics
