// SPDX-License-Identifier: BSD-3-Clause
// A car as the quasi-static double-track model sees it: masses and lengths, aerodynamics, how drive, brakes and roll
// stiffness are shared, and its tires.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "physics/tire_laws/magic_formula.hpp"

namespace tiretherm::physics {

inline constexpr double standard_gravity = 9.80665;  ///< m/s2

/// The four wheels, in the order of every array of four.
enum class Corner : std::uint8_t { front_left, front_right, rear_left, rear_right };
inline constexpr std::size_t n_corners = 4;
inline constexpr std::array<std::string_view, n_corners> corner_names{"FL", "FR", "RL", "RR"};

[[nodiscard]] constexpr std::size_t axle_of(std::size_t corner) { return corner / 2; }  ///< 0 front, 1 rear
[[nodiscard]] constexpr bool is_left(std::size_t corner) { return corner % 2 == 0; }

/// What is known of a tire's forces against slip: a Magic Formula, or two stiffnesses and a friction coefficient, which
/// make a brush under a parabolic pressure. Stiffnesses are in proportion to the load: C = C_static Fz / Fz_static.
struct VehicleTire {
    std::optional<MagicFormula> magic_formula{};  ///< of a tire on the right; on the left its mirror image
    double cornering_stiffness = 0.0;             ///< N/rad, of one tire at its static load
    double slip_stiffness = 0.0;                  ///< N, of one tire at its static load
    double friction = std::numeric_limits<double>::infinity();  ///< infinite: the force is linear in the slip
};

struct Axle {
    double distance = 0.0;              ///< m, from the centre of gravity, > 0
    double track = 0.0;                 ///< m
    double roll_centre_height = 0.0;    ///< m, above the road
    double roll_stiffness_share = 0.5;  ///< of both axles
    double drive_share = 0.0;           ///< of the driving force
    double brake_share = 0.5;           ///< of the braking force
    double downforce_area = 0.0;        ///< m2, -C_L A of this axle; negative: it lifts
    double toe_in = 0.0;                ///< rad, of each wheel
    VehicleTire tire{};
};

struct Vehicle {
    double mass = 0.0;         ///< kg
    double cg_height = 0.0;    ///< m, of the centre of gravity above the road
    double yaw_inertia = 0.0;  ///< kg m2
    double drag_area = 0.0;    ///< m2, C_D A
    double air_density = 1.2;  ///< kg/m3
    std::array<Axle, 2> axles{};

    [[nodiscard]] double wheelbase() const { return axles[0].distance + axles[1].distance; }
    /// m g times the other axle's distance over the wheelbase. @param axle 0 front, 1 rear  @returns N
    [[nodiscard]] double static_axle_load(std::size_t axle) const {
        return mass * standard_gravity * axles[1 - axle].distance / wheelbase();
    }
    /// Steering angle per lateral acceleration beyond L/R: m_f/C_f - m_r/C_r.      Gillespie 1992, (6-15)
    /// @returns rad/(m/s2), from the cornering stiffnesses at static load
    [[nodiscard]] double understeer_gradient() const;
};

/// Cornering stiffness of one tire. @param load N  @param static_load N, where the stiffness of a brush holds
/// @returns N/rad, >= 0
[[nodiscard]] double cornering_stiffness_of(const VehicleTire& tire, double load, double static_load);

/// How a car moves at one moment, in the axes of ISO 8855 on the plane of the road: x forwards, y to the left, z up. Accelerations
/// are what accelerometers in the car read, gravity apart from motion: forces of road and air over the mass.
struct VehicleMotion {
    double speed = 0.0;                               ///< m/s, of the centre of gravity
    double longitudinal_acceleration = 0.0;           ///< m/s2, positive when it speeds up, and uphill
    double lateral_acceleration = 0.0;                ///< m/s2, positive in a left turn
    double vertical_acceleration = standard_gravity;  ///< m/s2, g on a level road
    double yaw_rate = 0.0;                            ///< rad/s, positive in a left turn
    double yaw_acceleration = 0.0;                    ///< rad/s2
    bool brakes_released = false;                     ///< a force against the motion then acts at the driven wheels
};

}  // namespace tiretherm::physics
