// SPDX-License-Identifier: BSD-3-Clause
// The thesis's tire in proportion: identities, and numbers computed by hand from the formulas in the header.
#include <gtest/gtest.h>

#include "physics/tire_laws/scaled_tire.hpp"

namespace tiretherm::physics {
namespace {

constexpr double inch = 0.0254;

// The size and the inflation that the laws belong to change nothing: every factor is 1.
TEST(ScaledTire, ThesisSizeGivesTheThesisTire) {
    const Tire tire = scaled_tire({});
    const Tire thesis;
    EXPECT_NEAR(tire.unloaded_radius, thesis.unloaded_radius, 1e-15);
    EXPECT_NEAR(tire.contact_length_limit, thesis.contact_length_limit, 1e-15);
    EXPECT_DOUBLE_EQ(tire.contact_length_slope, thesis.contact_length_slope);
    EXPECT_DOUBLE_EQ(tire.contact_area_slope, thesis.contact_area_slope);
    EXPECT_DOUBLE_EQ(tire.loaded_radius_slope, thesis.loaded_radius_slope);
    EXPECT_NEAR(tire.rolling_radius_factor, thesis.rolling_radius_factor, 1e-15);
    EXPECT_EQ(tire.tread_thickness, thesis.tread_thickness);
}

// p 220, W 225, A 50, D 431.8: sqrt(0.83 225 (225 + 431.8)) = 350.225, 0.00028 220 350.225 + 3.45 = 25.0239 kg/mm, which
// times 9806.65 are 245.40 kN/m.
TEST(ScaledTire, StiffnessOfTheThesisTireIs245KilonewtonsPerMetre) {
    EXPECT_NEAR(vertical_stiffness({}), 245.40e3, 10.0);
}

// 265/65 R16 at 450 kPa. D 406.4, A 65: sqrt(0.77 265 (344.5 + 406.4)) = 391.437, 0.126 391.437 + 3.45 = 52.7711 kg/mm,
// 2.10883 times the thesis tire's. R0 = 203.2 + 172.25 + 2.4 = 377.85 mm.
TEST(ScaledTire, InflatedLightTruckTireIsStiffer) {
    const TireOutline outline{
        .width = 0.265, .section_height = 0.17225, .rim_diameter = 16.0 * inch, .inflation_pressure = 450e3};
    const Tire tire = scaled_tire(outline);
    EXPECT_NEAR(vertical_stiffness(outline) / vertical_stiffness({}), 2.10883, 1e-4);
    EXPECT_NEAR(tire.unloaded_radius, 0.37785, 1e-12);
    EXPECT_NEAR(tire.loaded_radius_at_zero, 0.37785, 1e-12);
    EXPECT_NEAR(tire.contact_length_limit, 0.160 * 377.85 / 330.8, 1e-12);
    EXPECT_NEAR(tire.contact_length_slope, 0.35 / 2.10883, 1e-5);
    EXPECT_NEAR(tire.loaded_radius_slope, -4.2e-6 / 2.10883, 1e-10);
    EXPECT_NEAR(tire.contact_area_slope, 2.333e-6 * 220.0 / 450.0, 1e-15);
    EXPECT_NEAR(tire.rolling_radius_factor, 0.3483 * 377.85 / 330.8, 1e-12);
}

}  // namespace
}  // namespace tiretherm::physics
