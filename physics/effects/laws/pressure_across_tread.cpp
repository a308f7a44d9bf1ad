// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: the contact pressure across the tread leans with camber and lateral force, and moves between crown and
// shoulders with the deflection (geometry and balance of moments, derived in this file).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { by_camber, by_lateral_force, by_deflection, reference_load };

// With b half the tread's width and y/b from -1 at the inside edge to 1 at the outside one,
//     p/mean = 1 + a y/b + c (1 - 3 (y/b)^2)/2,
// the first two even and odd polynomials of Legendre, so that the mean is 1 whatever a and c.
//
// Camber: a band that leans by gamma is pressed down by delta + gamma y, and its bedding answers in proportion: a =
// gamma b/delta. A 225/50 R17 under 4 kN, b = 0.11 m, delta = 17 mm: 6.5 1/rad of a band that does not bend. It bends.
//
// Lateral force: the road pulls at the tread's bottom, the sidewalls hold the band h above it. Their couple Fy h is borne
// by a load that moves by a b/3: a = 3 h/b Fy/Fz. Between the tread's thickness, 12 mm, and half the section's height, 56
// mm, it is 0.3 to 1.5. The road pulls the outer tire of a bend inwards, and its outside shoulder is pressed down.
//
// Deflection: the gas carries the crown, whose pressure it sets; what the load has beyond goes to the shoulders, which the
// sidewalls press down, and the other way round. How much depends on the tire's contour. If the crown followed the gas and the
// area did not change, p/mean in the middle, 1 + c/2, would rise as the gas: 2. That is the most; the area does change.
constexpr std::array parameters{
    ParameterSpec{"by_camber", "rad-1", 5.0, -100.0, 100.0,
                  "skew a per radian of camber; assumed, 6.5 of a stiff band by geometry", false, 0.0},
    ParameterSpec{"by_lateral_force", "1", 0.6, -10.0, 10.0,
                  "skew a per Fy/Fz; assumed, the sidewalls hold the band 22 mm above the road", false, 0.0},
    ParameterSpec{"by_deflection", "1", 1.0, -10.0, 10.0,
                  "crown c that is lost per share of deflection beyond that at the reference; assumed", false, 0.0},
    ParameterSpec{"reference_load", "N", 4500.0, 1.0, 1e6,
                  "load at which the contact is even at the reference_pressure of [tire]"},
};
constexpr std::string_view wrong_sign =
    "the sign: camber and lateral force may be logged the other way round, or left "
    "and right exchanged";
constexpr std::array plausible{
    PlausibleRange{"by_camber",
                   0.0,
                   12.0,
                   "geometry of a leaning band: 6.5 of a stiff one at 17 mm of deflection",
                   "no band leans more than its wheel does",
                   SensorKind::any,
                   {},
                   wrong_sign},
    PlausibleRange{"by_lateral_force",
                   0.0,
                   1.5,
                   "balance of moments: sidewalls hold the band 12 to 56 mm above the road",
                   "the force would act above the middle of the sidewalls",
                   SensorKind::any,
                   {},
                   wrong_sign},
    PlausibleRange{"by_deflection", 0.0, 2.0, "a crown that follows the gas, on an area that does not change: 2",
                   "the crown cannot follow the gas more than in proportion: reference_load or the pressure is off"},
};
constexpr std::array confounded{
    ConfoundedGroup{
        {"pressure_across_tread.by_camber", "camber_asymmetry"},
        "rolling without slip, where the loss alone differs across the tread, and probes in the bulk beside "
        "the surface: what the contact shifts fades within millimetres"},
    ConfoundedGroup{{"pressure_across_tread.by_lateral_force", "pressure_across_tread.by_camber"},
                    "bends to both sides: the lateral force changes its sign, the camber does not"},
};
constexpr std::array<std::string_view, 4> may_read{"camber", "lateral_force", "vertical_load", "inflation_pressure"};

void modify_laws(const ActiveEffect& active, const Tire& tire, const Inputs& in, Laws& laws) {
    if (tire.touches(in.vertical_load)) {
        laws.contact_skew +=
            active[by_camber] * in.camber + active[by_lateral_force] * in.lateral_force / in.vertical_load;
        laws.contact_crown += active[by_deflection] * (1.0 - tire.reference_load(in) / active[reference_load]);
    }
}

}  // namespace

extern const Effect pressure_across_tread;
const Effect pressure_across_tread{
    .id = "pressure_across_tread",
    .kind = EffectKind::property,
    .equation =
        "p/mean = 1 + a y + c (1 - 3 y^2)/2 >= 0, y from -1 inside to 1 outside; a = by_camber gamma + "
        "by_lateral_force Fy/Fz, c = by_deflection (1 - deflection/reference), deflection/reference = Fz "
        "K_z(reference_pressure)/(reference_load K_z(p))",
    .source =
        "geometry and balance of moments, this file; K_z: Rhyne, Tire Sci. Technol. 33(3), 2005. Directions: contact "
        "of a "
        "radial tire under camber, Tire Sci. Technol. 28(1), 2, 2000, and World Electr. Veh. J. 16(9), 525, 2025 "
        "(abstracts); gas sets the pressure in the middle and load that at the edges: De Beer, Fisher & Jooste, 8th "
        "ICAP, "
        "1997 (recalled)",
    .valid =
        "the directions are measured, the sizes assumed: fit them to surface temperatures inside, in the middle and "
        "outside; camber below some 8 degrees; a place that the law would draw off the road carries nothing",
    .meaning =
        "Where across the tread the contact presses. Heat of sliding follows the pressure, and so does the lumped "
        "exchange "
        "with the road; that of a rolling contact its root, as half-spaces exchange with the root of the time that "
        "they "
        "touch. Each total stays. Camber and lateral force load one shoulder: a positive lateral force, towards the "
        "middle "
        "of the vehicle as at the outer tires of a bend, the outside one. A soft or heavily loaded tire presses with "
        "its "
        "shoulders, a hard one with its crown; without `inflation_pressure` the load alone counts. It acts on "
        "sliding_friction, road_contact, resolved_contact, travelling_contact and contact_pressure_conductance, on top "
        "of "
        "their `profile`; a `field` of a structural code says the pressure itself. Sensors of the kinds "
        "contact_pressure_outside, contact_pressure_middle and contact_pressure_inside tell it. A mesh with one column "
        "does not show it.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .may_read = may_read,
    .needs_tire = true,
    .needs_grid = true,
    .model = PropertyModifier{.modify_laws = modify_laws},
};

}  // namespace tiretherm::physics::effects
