// SPDX-License-Identifier: BSD-3-Clause
// Load indices and speed symbols against ISO 4000-1, and the load at lower pressures by hand.
#include "physics/tire_laws/load_capacity.hpp"

#include <gtest/gtest.h>

namespace tiretherm::physics {

// 670 kg = 6570.5 N, 210 km/h = 58.333 m/s.
TEST(LoadCapacity, ReadsTheServiceDescription) {
    const ServiceDescription h{.load_index = 94, .speed_symbol = 'H'};
    EXPECT_NEAR(*h.load(), 6570.46, 0.01);
    EXPECT_NEAR(*h.speed(), 58.3333, 1e-4);
    EXPECT_NEAR(*(ServiceDescription{.load_index = 60}.load()), 250.0 * 9.80665, 1e-9);
    EXPECT_NEAR(*(ServiceDescription{.load_index = 100}.load()), 800.0 * 9.80665, 1e-9);
    EXPECT_NEAR(*(ServiceDescription{.load_index = 126}.load()), 1700.0 * 9.80665, 1e-9);
    EXPECT_FALSE(ServiceDescription{.load_index = 49}.load());
    EXPECT_FALSE(ServiceDescription{.load_index = 161}.load());
    EXPECT_FALSE(ServiceDescription{.load_index = 94}.speed());
    EXPECT_NEAR(*(ServiceDescription{.load_index = 94, .speed_symbol = 'Y'}.speed()), 300.0 / 3.6, 1e-9);
}

// (140/250)^0.8 = 0.62885, (250/290)^0.8 = 0.88804; above the reference it carries no more.
TEST(LoadCapacity, FallsWithThePressure) {
    EXPECT_NEAR(load_capacity(6570.0, 140e3), 0.62885 * 6570.0, 0.1);
    EXPECT_EQ(load_capacity(6570.0, 280e3), 6570.0);
    EXPECT_NEAR(load_capacity(6570.0, 250e3, 290e3), 6570.0 * 0.88804, 0.1);
    EXPECT_EQ(load_capacity(6570.0, 0.0), 0.0);
}

}  // namespace tiretherm::physics
