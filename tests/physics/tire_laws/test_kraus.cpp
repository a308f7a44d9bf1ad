// SPDX-License-Identifier: BSD-3-Clause
// The loss of Kraus against the properties of its formula.
#include "physics/tire_laws/kraus.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tiretherm::physics {
namespace {

// At e_c the fraction 2 x / (1 + x^2) is 1, its largest value; it is the same at e_c k and e_c / k, as x becomes 1/x. With A = 0.5 and
// m = 0.5, at four times e_c x = 2: 1 + 0.5 * 4/5 = 1.4.
TEST(KrausLaw, IsLargestAtItsStrainAndFallsAlikeToBothSides) {
    const KrausLaw law{.amplitude = 0.5, .strain = 0.02, .exponent = 0.5};
    EXPECT_DOUBLE_EQ(law.loss(0.02), 1.5);
    EXPECT_DOUBLE_EQ(law.loss(0.08), 1.4);
    EXPECT_NEAR(law.loss(0.005), 1.4, 1e-15);
    EXPECT_DOUBLE_EQ(law.loss(0.0), 1.0);
}

TEST(KrausLaw, WithoutAmplitudeTheStrainHasNoSay) {
    const KrausLaw law{};
    EXPECT_EQ(law.loss(0.001), 1.0);
    EXPECT_EQ(law.loss(0.3), 1.0);
}

}  // namespace
}  // namespace tiretherm::physics
