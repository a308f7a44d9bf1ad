// SPDX-License-Identifier: BSD-3-Clause
// A made-up car on a made-up circuit: laps, what each wheel carries and how it slips, and the temperatures of its tires.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "car/circuit_truth.hpp"
#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

enum Wheel : std::size_t { front_left, front_right, rear_left, rear_right, n_wheels };
inline constexpr std::array<const char*, n_wheels> wheel_names{"FL", "FR", "RL", "RR"};

/// The car. x forwards, y to the left, z up; rear wheels drive, all brake.
struct Car {
    double mass = 1180.0;            ///< kg with driver and half a tank
    double yaw_inertia = 1650.0;     ///< kg m2
    double wheelbase = 2.57;         ///< m
    double to_front = 1.18;          ///< m, from the centre of gravity to the front axle
    double height = 0.46;            ///< m, of the centre of gravity
    double track_front = 1.52;       ///< m
    double track_rear = 1.54;        ///< m
    double roll_share_front = 0.57;  ///< of the load that goes from left to right
    double drag_area = 0.64;         ///< m2, coefficient times frontal area
    double lift_area = -0.45;        ///< m2; negative: pressed down
    double lift_share_front = 0.42;
    double brake_share_front = 0.66;
    double steering_ratio = 13.1;
    double roll_lag = 0.12;        ///< s, of the load behind the accelerations
    double grip = 1.30;            ///< of a tire at its nominal load
    double stiffness = 19.0;       ///< 1/rad, cornering stiffness over the load
    double slip_stiffness = 24.0;  ///< longitudinal, over the load
};

/// What a wheel carries and does. [n_times]
struct WheelCourse {
    std::vector<double> load;          ///< N
    std::vector<double> lateral;       ///< N, to the left
    std::vector<double> longitudinal;  ///< N, forwards
    std::vector<double> slip_angle;    ///< rad, positive where the lateral force is
    std::vector<double> slip_ratio;
    std::vector<double> surface;  ///< K
    std::vector<double> bulk;     ///< K
    std::vector<double> disc;     ///< K, of the brake
};

/// A session on the circuit. [n_times] each
struct Session {
    std::vector<double> time;       ///< s
    std::vector<double> place;      ///< m driven
    std::vector<double> speed;      ///< m/s
    std::vector<double> forwards;   ///< m/s2
    std::vector<double> leftwards;  ///< m/s2
    std::vector<double> yaw_rate;   ///< rad/s
    std::vector<double> steering;   ///< rad at the steering wheel, positive to the left
    std::vector<double> throttle;   ///< 0 to 1
    std::vector<double> brake;      ///< bar in the front circuit
    std::vector<double> beacons;    ///< s, passages of the start line
    double air = 296.15;            ///< K
    double road = 307.15;           ///< K
    std::array<WheelCourse, n_wheels> wheels;
};

/// What is not as the user's model has it.
struct HiddenInCar {
    double lambda_h = 0.86;      ///< the film to the air is weaker on all four
    double brake_watts = 260.0;  ///< into the bulk of a front tire at full brake pressure, through the rim
    double lambda_sel = 1.0;
    double brake_conductance = 0.0;  ///< W/K, from the disc of each brake into the bulk of its tire
};

/// Laps at the limit that the grip, the engine and the brakes leave, from a standing start in the pits to the last passage of
/// the line. @param interval s, between samples
[[nodiscard]] Session drive_session(const Circuit& circuit, const Car& car, int laps, double interval,
                                    const HiddenInCar& hidden = {});

}  // namespace hidden_effects
