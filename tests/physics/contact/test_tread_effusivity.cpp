// SPDX-License-Identifier: BSD-3-Clause
// Effusivity of a tread by its own laws, and the parabola that stands for what the contact makes of it.

#include <cmath>

#include <gtest/gtest.h>

#include "physics/contact/contact_in_revolutions.hpp"
#include "physics/contact/rolling_contact.hpp"
#include "physics/contact/tread_effusivity.hpp"
#include "tests/physics/effects/bench.hpp"

namespace tiretherm::physics {
namespace {

constexpr double of_road = 1576.0;

/// A tread whose conductivity rises as the thesis's K1: 0.29 W/mK at 20 degC, 0.95 at 90 degC.
Material tread() {
    Material material{.name = "tread", .density = 1100.0, .heat_capacity = Curve::constant(1800.0), .conductivity = {}};
    material.conductivity.fill(Curve::quadratic_about(293.15, 0.29, 0.66 / 70.0, 0.0).within(293.15, 393.15));
    return material;
}

/// Effusivities as `place` finds them for one layer of that tread.
ActiveEffect placed(const Material& material) {
    mesh::Mesh mesh;
    mesh.layer = {0};
    const MaterialModel model{.materials = {material}, .link_laws = {}, .tire = {}};
    ActiveEffect active;
    active.nodes = {0};
    place_effusivities({.mesh = mesh, .material_model = model, .effects = {}}, of_road, active);
    return active;
}

}  // namespace

// sqrt(0.29 1100 1800) = 757.8; sqrt(0.95 1100 1800) = 1371.5, of which k'/(2 k) = 0.009429/1.9 a kelvin.
TEST(TreadEffusivity, FollowsTheTreadsOwnLaws) {
    EXPECT_NEAR(effusivity(tread(), 293.15).value, 757.76, 0.01);
    EXPECT_NEAR(effusivity(tread(), 363.15).value, 1371.50, 0.01);
    EXPECT_NEAR(effusivity(tread(), 363.15).slope, 1371.50 * 0.66 / 70.0 / 1.9, 1e-3);
    EXPECT_EQ(effusivity(tread(), 250.0).slope, 0.0) << "held";
}

TEST(TreadEffusivity, OneIsEnoughForRubberThatKeepsIt) {
    Material material = tread();
    material.conductivity.fill(Curve::constant(0.29));
    const ActiveEffect one = placed(material);
    ASSERT_EQ(one.effusivities.size(), 1U);
    const EffusivityInterpolation same(one.effusivities, of_road, {.value = 757.8, .slope = 0.0});
    EXPECT_EQ(same.value({3.0, 9.0, 9.0}), 3.0);
    EXPECT_EQ(same.slope({3.0, 9.0, 9.0}), 0.0);
}

// What a contact takes, and what of the heat of sliding the road does, is worked out at three effusivities, of 0.29 to 1.23
// W/mK: between them the parabola is off by less than a thousandth, and its slope by less than a hundredth.
TEST(TreadEffusivity, ParabolaStandsForTheContactBetweenThree) {
    const ActiveEffect active = placed(tread());
    ASSERT_EQ(active.effusivities.size(), 3U);
    EXPECT_NEAR(active.effusivities.front(), 757.76, 0.01);
    EXPECT_NEAR(active.effusivities.back(), std::sqrt((0.29 + 0.66 / 70.0 * 100.0) * 1.98e6), 0.01);
    const auto contact = [](double e) {
        return ContactInRevolutions({.interface_h = 2.5e4, .effusivity_a = e, .effusivity_b = of_road}, 3.48e-3,
                                    0.0731);
    };
    std::array<double, most_effusivities> mean{};
    std::array<double, most_effusivities> share{};
    std::array<double, most_effusivities> charm{};
    for (std::size_t i = 0; i < most_effusivities; ++i) {
        const double e = active.effusivities[i];
        mean[i] = contact(e).mean_conductance();
        share[i] = contact(e).road_share();
        charm[i] = e / (e + of_road);
    }
    for (const double T : {295.0, 310.0, 330.0, 350.0, 380.0}) {
        const TreadEffusivity at = effusivity(tread(), T);
        const EffusivityInterpolation here(active.effusivities, of_road, at);
        const ContactInRevolutions exact = contact(at.value);
        EXPECT_NEAR(here.value(mean) / exact.mean_conductance(), 1.0, 1e-3) << T;
        EXPECT_NEAR(here.value(share) / exact.road_share(), 1.0, 1e-3) << T;
        EXPECT_NEAR(here.value(charm), at.value / (at.value + of_road), 1e-12) << T;
        const double above = contact(effusivity(tread(), T + 0.5).value).mean_conductance();
        const double below = contact(effusivity(tread(), T - 0.5).value).mean_conductance();
        EXPECT_NEAR(here.slope(mean) / (above - below), 1.0, 2e-2) << T;
    }
}

}  // namespace tiretherm::physics
