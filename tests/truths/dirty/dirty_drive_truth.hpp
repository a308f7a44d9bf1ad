// SPDX-License-Identifier: BSD-3-Clause
// What a tire is driven through in the exam of dirty data: laps of a track or steps on a bench, every tenth of a second.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hidden_effects {

/// Interval of all signals and steps of these truths, s.
inline constexpr double dirty_step = 0.1;

/// True signals at 0, dirty_step, 2 dirty_step ...; straight between them.
struct DirtyDrive {
    std::vector<double> speed;             ///< m/s
    std::vector<double> vertical_load;     ///< N
    std::vector<double> slip_angle;        ///< rad
    std::vector<double> lateral_force;     ///< N
    std::vector<double> brake_power;       ///< W, of this wheel's brake
    std::vector<double> air_temperature;   ///< K
    std::vector<double> road_temperature;  ///< K
    std::vector<double> throttle;          ///< 0 to 1
    std::vector<double> gear;
    std::vector<double> lap_distance;  ///< m

    [[nodiscard]] std::size_t size() const { return speed.size(); }
};

/// A track, or a kind of programme: all runs of a set share it.
struct DirtyTrack {
    struct Corner {
        double top_speed = 0.0;  ///< m/s, at the end of the straight before it
        double speed = 0.0;      ///< m/s, in it
        double duration = 0.0;   ///< s
        double slip = 0.0;       ///< rad
        double load = 0.0;       ///< N
    };
    std::vector<Corner> corners;    ///< none: steps
    double straight_load = 4000.0;  ///< N
    double top_speed = 0.0;         ///< m/s, of the steps
    double grip = 1.05;
    double stiffness = 60e3;     ///< N/rad
    double air = 293.15;         ///< K
    double road_over_air = 5.0;  ///< K
};

[[nodiscard]] DirtyTrack draw_dirty_track(std::uint64_t seed, bool laps);
/// @param minutes of driving, after some seconds at rest
[[nodiscard]] DirtyDrive draw_dirty_drive(const DirtyTrack& track, double minutes, std::uint64_t seed);
/// A signal at any time, s; held beyond its ends.
[[nodiscard]] double dirty_value(const std::vector<double>& signal, double time);

}  // namespace hidden_effects
