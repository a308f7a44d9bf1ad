// SPDX-License-Identifier: BSD-3-Clause
// A car on a winding road whose loads and slips are known, its log, and cases that read it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/measurements/experiment.hpp"
#include "input/vehicle/corner_signals.hpp"
#include "support/written.hpp"

/// Of the tests of [vehicle].
namespace tiretherm::input::known_car {

inline constexpr double g = 9.80665;
inline constexpr std::size_t n_samples = 1201;
inline constexpr double step = 0.05;  // s

/// A car on a winding road. Its motion is given by formulas, and so are its loads and slips, which are written here once
/// more and share nothing with the model: 1200 kg, a = 1.4 m, b = 1.1 m, h = 0.5 m, tracks 1.5 m, 60 % of the roll
/// stiffness in front, I = m a b = 1848 kg m2, linear tires of 90 and 100 kN/rad and kN.
struct Truth {
    double V, ax, ay, r, dr;

    explicit Truth(double t)
        : V(30.0 + 3.0 * std::sin(0.2 * t)),
          ax(0.6 * std::cos(0.2 * t)),
          ay(V * 0.2 * std::sin(0.3 * t)),
          r(0.2 * std::sin(0.3 * t)),
          dr(0.06 * std::cos(0.3 * t)) {}

    [[nodiscard]] double load(bool front, bool left) const {
        const double axle = front ? 1200.0 * (g * 1.1 - ax * 0.5) / 2.5 : 1200.0 * (g * 1.4 + ax * 0.5) / 2.5;
        const double transfer = (front ? 0.6 : 0.4) * 1200.0 * ay * 0.5 / 1.5;
        return 0.5 * axle + (left ? -transfer : transfer);
    }
    [[nodiscard]] double axle_force(bool front) const {
        const double of_front = (1200.0 * ay * 1.1 + 1848.0 * dr) / 2.5;
        return front ? of_front : 1200.0 * ay - of_front;
    }
    /// Tires of an axle at one angle, with C in proportion to the load. In the mirror on the left.
    [[nodiscard]] double tan_slip_angle(bool front, bool left) const {
        const double per_load = front ? 90e3 / (0.5 * 1200.0 * g * 1.1 / 2.5) : 100e3 / (0.5 * 1200.0 * g * 1.4 / 2.5);
        return (left ? -1.0 : 1.0) * axle_force(front) / per_load / (load(front, true) + load(front, false));
    }
    /// sigma = kappa/(1 + kappa) of half an axle's force: the rear drives, brakes share 65 to 35.
    [[nodiscard]] double slip_ratio(bool front, bool left) const {
        const double share = ax >= 0.0 ? (front ? 0.0 : 1.0) : (front ? 0.65 : 0.35);
        const double per_load = front ? 90e3 / (0.5 * 1200.0 * g * 1.1 / 2.5) : 100e3 / (0.5 * 1200.0 * g * 1.4 / 2.5);
        const double sigma = 0.5 * share * 1200.0 * ax / per_load / load(front, left);
        return sigma / (1.0 - sigma);
    }
};

/// @param heads of the columns behind the time  @param line their values at a time
inline std::string log_of_the_truth(const std::string& heads,
                                    const std::function<std::string(const Truth&, double)>& line) {
    std::string text = "time [s]," + heads + "\n";
    for (std::size_t i = 0; i < n_samples; ++i) {
        const double t = step * static_cast<double>(i);
        text += fmt::format("{:.3f},{}\n", t, line(Truth(t), t));
    }
    return text;
}

/// @param side -1: the lateral acceleration is positive in right turns
inline std::string plain_log(double side = 1.0) {
    return log_of_the_truth("V [km/h],AccY [g],AccX [m/s2],yaw_rate [deg/s]", [side](const Truth& truth, double) {
        return fmt::format("{:.9f},{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, side * truth.ay / g, truth.ax,
                           truth.r * 180.0 / 3.14159265358979323846);
    });
}

inline const std::string columns =
    "columns = { V = \"speed\", AccY = \"lateral_acceleration\", AccX = \"longitudinal_acceleration\" }\n";

/// @param vehicle more keys of [vehicle]  @param keys of the log
inline Reading read(const std::string& log, const std::string& vehicle, const std::string& keys = columns,
                    const std::string& unset = "\"vehicle.friction\"") {
    const Written written;
    written.add("log.csv", log);
    const std::string base = (source_folder() / "tests/bad_cases/good/car.toml").string();
    return read_case(written.add("case.toml", "include = [\"" + base + "\"]\nunset = [" + unset + "]\n[vehicle]\n" +
                                                  vehicle + "\n[[drive.file]]\npath = \"log.csv\"\n" + keys));
}

inline solver::Problem problem_of(Reading reading) {
    if (!reading.problem) {
        ADD_FAILURE() << render(reading);
        return {};
    }
    return *reading.problem;
}

inline bool warns(const Reading& reading, std::string_view words) {
    return std::ranges::any_of(reading.warnings,
                               [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

/// Mean power of lateral sliding over the log. W
inline double lateral_power(const solver::Problem& problem) {
    double power = 0.0;
    for (std::size_t i = 0; i < n_samples; ++i) {
        const physics::Inputs in = problem.input_signals.at(step * static_cast<double>(i), solver::JumpSide::after);
        power += std::abs(in.lateral_force * in.speed * std::tan(in.slip_angle)) / n_samples;
    }
    return power;
}

}  // namespace tiretherm::input::known_car
