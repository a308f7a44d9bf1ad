// SPDX-License-Identifier: BSD-3-Clause
// Loads and forces of a car against numbers by hand, and the sums that hold at all times.

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "physics/vehicle/wheel_loads.hpp"
#include "tests/physics/vehicle/cars.hpp"

namespace tiretherm::physics {

namespace {

constexpr double gravity = standard_gravity;
constexpr double round_off = 1e-9;  // N, of numbers of 1e4 N

double sum(const std::array<double, n_corners>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST(WheelLoads, StandingTheyFollowFromTheCentreOfGravity) {
    // m g b / (2 L) = 1200 x 9.80665 x 1.1 / 5 = 2588.9556 N in front, m g a / (2 L) = 3295.0344 N behind.
    const VehicleForces forces = vehicle_forces(round_car(), {});
    EXPECT_NEAR(forces.vertical[0], 2588.9556, 1e-4);
    EXPECT_NEAR(forces.vertical[1], 2588.9556, 1e-4);
    EXPECT_NEAR(forces.vertical[2], 3295.0344, 1e-4);
    EXPECT_NEAR(forces.vertical[3], 3295.0344, 1e-4);
    EXPECT_EQ(sum(forces.longitudinal), 0.0);
}

TEST(WheelLoads, SteadyLeftTurnOfOneG) {
    // Roll centres on the road: M = m g h = 5883.99 N m; dF = 0.6 M / 1.5 = 2353.596 N in front, 1569.064 N behind. The
    // outer, right wheels carry 2588.9556 + 2353.596 = 4942.5516 N and 3295.0344 + 1569.064 = 4864.0984 N.
    // Fy_f = m a_y b/L = 5177.9112 N, Fy_r = 6590.0688 N.
    const VehicleForces forces = vehicle_forces(round_car(), {.speed = 30.0, .lateral_acceleration = gravity});
    EXPECT_NEAR(forces.vertical[0], 235.3596, 1e-4);
    EXPECT_NEAR(forces.vertical[1], 4942.5516, 1e-4);
    EXPECT_NEAR(forces.vertical[2], 1725.9704, 1e-4);
    EXPECT_NEAR(forces.vertical[3], 4864.0984, 1e-4);
    EXPECT_NEAR(forces.lateral_of_axle[0], 5177.9112, 1e-4);
    EXPECT_NEAR(forces.lateral_of_axle[1], 6590.0688, 1e-4);
}

// A bank of 37 degrees under a car whose accelerometer reads 0.3 g to the inside: the turn has (0.3 + sin 37)/cos 37 = 1.12919 g,
// and a_z = cos 37 + 1.12919 sin 37 = 1.47820 g. The wheels carry 1.47820 times the weight, less nothing: 17395.5 N.
TEST(WheelLoads, ABankPressesTheCarDown) {
    const RoadPlane oval{.bank = 37.0 / 180.0 * std::numbers::pi};
    EXPECT_NEAR(oval.across() / gravity, 0.601815, 1e-6);
    const double a_z = oval.vertical_acceleration(0.3 * gravity);
    EXPECT_NEAR(a_z / gravity, 1.47820, 1e-5);
    const VehicleForces forces = vehicle_forces(
        round_car(), {.speed = 50.0, .lateral_acceleration = 0.3 * gravity, .vertical_acceleration = a_z});
    EXPECT_NEAR(sum(forces.vertical), 17395.5, 0.5);
    EXPECT_NEAR(forces.lateral_of_axle[0] + forces.lateral_of_axle[1], 0.3 * 1200.0 * gravity, 1e-6);
    // Level, gravity alone; over a crest that takes 2 m/s2 of it.
    EXPECT_EQ(RoadPlane{}.vertical_acceleration(5.0), gravity);
    EXPECT_EQ(RoadPlane{.gravity = gravity - 2.0}.vertical_acceleration(5.0), gravity - 2.0);
}

TEST(WheelLoads, RollCentresTakeTheirPartPastTheSprings) {
    // d_f = 0.1 m, d_r = 0.2 m: M = 5883.99 - 517.79112 - 1318.01376 = 4048.18512 N m;
    // dF_f = (517.79112 + 0.6 M) / 1.5 = 1964.468128 N, dF_r = (1318.01376 + 0.4 M) / 1.5 = 1958.191872 N.
    Vehicle car = round_car();
    car.axles[0].roll_centre_height = 0.1;
    car.axles[1].roll_centre_height = 0.2;
    const VehicleForces forces = vehicle_forces(car, {.speed = 30.0, .lateral_acceleration = gravity});
    EXPECT_NEAR(0.5 * (forces.vertical[1] - forces.vertical[0]), 1964.468128, 1e-5);
    EXPECT_NEAR(0.5 * (forces.vertical[3] - forces.vertical[2]), 1958.191872, 1e-5);
}

TEST(WheelLoads, BrakingWithOneG) {
    // m g h / L = 2353.596 N from behind to the front: 2588.9556 + 1176.798 = 3765.7536 N each in front, 2118.2364 N
    // behind. Brakes 65 to 35: -0.65 x 11767.98 / 2 = -3824.5935 N and -2059.3965 N a wheel.
    const VehicleForces forces = vehicle_forces(round_car(), {.speed = 30.0, .longitudinal_acceleration = -gravity});
    EXPECT_NEAR(forces.vertical[0], 3765.7536, 1e-4);
    EXPECT_NEAR(forces.vertical[3], 2118.2364, 1e-4);
    EXPECT_NEAR(forces.longitudinal[1], -3824.5935, 1e-4);
    EXPECT_NEAR(forces.longitudinal[2], -2059.3965, 1e-4);
}

TEST(WheelLoads, ReleasedBrakesLeaveTheSlowingDownToTheDrivenAxle) {
    // m a_x = -1200 N behind, -600 N a wheel, none in front.
    const VehicleForces forces =
        vehicle_forces(round_car(), {.longitudinal_acceleration = -1.0, .brakes_released = true});
    EXPECT_EQ(forces.longitudinal[0], 0.0);
    EXPECT_NEAR(forces.longitudinal[2], -600.0, round_off);
}

TEST(WheelLoads, DownforceAndDragGrowWithTheSquareOfTheSpeed) {
    // 60 m/s, 1.2 kg/m3: q = 2160 Pa; downforce 0.8 m2 in front and 1.2 m2 behind: 1728 N and 2592 N; the drag of 0.9 m2
    // is 1944 N, which the driven rear wheels make at a steady speed: 972 N each.
    Vehicle car = round_car();
    car.drag_area = 0.9;
    car.axles[0].downforce_area = 0.8;
    car.axles[1].downforce_area = 1.2;
    const VehicleForces forces = vehicle_forces(car, {.speed = 60.0});
    EXPECT_NEAR(forces.vertical[0], 2588.9556 + 864.0, 1e-4);
    EXPECT_NEAR(forces.vertical[2], 3295.0344 + 1296.0, 1e-4);
    EXPECT_NEAR(forces.longitudinal[3], 972.0, round_off);
    EXPECT_EQ(forces.longitudinal[0], 0.0);
}

TEST(WheelLoads, SumsHoldWhateverTheCarDoes) {
    // Vertical: m g and the downforce, where it does not lift the car off the road. Lateral: m a_y, with the moment I r'.
    // Longitudinal: m a_x and the drag. 2000 drawn moments up to 3 g, far beyond what lifts wheels.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    Vehicle car = round_car();
    car.drag_area = 1.1;
    car.axles[0].downforce_area = 0.9;
    car.axles[1].downforce_area = 1.3;
    int lifted = 0;
    for (int i = 0; i < 2000; ++i) {
        const VehicleMotion motion{.speed = 40.0 + 40.0 * any(random),
                                   .longitudinal_acceleration = 3.0 * gravity * any(random),
                                   .lateral_acceleration = 3.0 * gravity * any(random),
                                   .yaw_acceleration = 2.0 * any(random)};
        const double q = 0.6 * motion.speed * motion.speed;
        const VehicleForces forces = vehicle_forces(car, motion);
        EXPECT_NEAR(sum(forces.vertical), 1200.0 * gravity + 2.2 * q, 1e-7);
        EXPECT_NEAR(sum(forces.longitudinal), 1200.0 * motion.longitudinal_acceleration + 1.1 * q, 1e-7);
        EXPECT_NEAR(forces.lateral_of_axle[0] + forces.lateral_of_axle[1], 1200.0 * motion.lateral_acceleration, 1e-7);
        EXPECT_NEAR(1.4 * forces.lateral_of_axle[0] - 1.1 * forces.lateral_of_axle[1], 1800.0 * motion.yaw_acceleration,
                    1e-7);
        for (std::size_t corner = 0; corner < n_corners; ++corner) {
            EXPECT_GE(forces.vertical[corner], 0.0);
            lifted += forces.lifted[corner] ? 1 : 0;
        }
    }
    EXPECT_GT(lifted, 100);
}

TEST(WheelLoads, TheMomentsOfAxlesMakeTheRollMomentUntilTheCarRollsOver) {
    // t (dF_f + dF_r) = m a_y h, whether or not a wheel is in the air: at 1.3 g the front inner one is, since its axle
    // would need 0.6 x 7649.187 / 1.5 = 3059.67 N of its 2588.96 N; the rear one takes the rest, 5099.458 - 2588.956 =
    // 2510.502 N of 3295.034 N.
    const VehicleForces forces = vehicle_forces(round_car(), {.lateral_acceleration = 1.3 * gravity});
    EXPECT_TRUE(forces.lifted[0]);
    EXPECT_FALSE(forces.lifted[2]);
    EXPECT_FALSE(forces.rolls_over);
    EXPECT_NEAR(forces.vertical[0], 0.0, round_off);
    EXPECT_NEAR(forces.vertical[1], 5177.9112, 1e-4);
    EXPECT_NEAR(0.5 * (forces.vertical[3] - forces.vertical[2]), 2510.502, 1e-3);
    // It rolls over beyond t/(2 h) = 1.5 g.
    EXPECT_FALSE(vehicle_forces(round_car(), {.lateral_acceleration = 1.49 * gravity}).rolls_over);
    EXPECT_TRUE(vehicle_forces(round_car(), {.lateral_acceleration = -1.51 * gravity}).rolls_over);
}

TEST(WheelLoads, AnAxleThatLiftsLeavesAllToTheOther) {
    // The front lifts beyond a_x = g b/h = 2.2 g; at 3 g all 11767.98 N and the force are behind.
    const VehicleForces forces = vehicle_forces(round_car(), {.longitudinal_acceleration = 3.0 * gravity});
    EXPECT_TRUE(forces.lifted[0] && forces.lifted[1]);
    EXPECT_NEAR(forces.vertical[2], 5883.99, 1e-4);
    EXPECT_NEAR(forces.longitudinal[2], 1.5 * 11767.98, 1e-4);
}

TEST(WheelLoads, UndersteerGradientIsThatOfTheAxles) {
    // m_f = 528 kg on 2 x 80 kN/rad, m_r = 672 kg on as much: (528 - 672) / 160e3 = -9e-4 rad/(m/s2).
    EXPECT_NEAR(round_car().understeer_gradient(), -9e-4, 1e-15);
}

}  // namespace tiretherm::physics
