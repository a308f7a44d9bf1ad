// SPDX-License-Identifier: BSD-3-Clause
// What a sensor shows over a stretch of a run, and what goes into the tire in it: of a lap, or of the whole run.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "input/laps/laps.hpp"
#include "solver/problem.hpp"

namespace tiretherm::diagnosis {

/// Mean, maximum and last value of a channel over a stretch. SI; NaN where nothing was read.
struct StretchValues {
    double mean = std::numeric_limits<double>::quiet_NaN();
    double highest = std::numeric_limits<double>::quiet_NaN();
    double end = std::numeric_limits<double>::quiet_NaN();
};
/// Of samples, each of which counts alike.
[[nodiscard]] StretchValues values_of(std::span<const double> samples);
/// Of a curve between two times, by time; straight lines between its points. @param time s, ascending, at least one
[[nodiscard]] StretchValues values_between(std::span<const double> time, std::span<const double> value, double from,
                                           double to);

/// Energies since the start of a run against time.
struct EnergyCourse {
    std::vector<std::string> names;
    std::vector<double> time;    ///< s, ascending
    std::vector<double> joules;  ///< [times][names]

    /// Straight lines between the times, constant beyond them. @returns J
    [[nodiscard]] double between(std::size_t name, double from, double to) const;
};

/// The friction power of the contact, whole: what drive and brakes make (along) and what cornering makes (across), before
/// the road takes its share. By the inputs of the case alone; no names where no effect has a law of sliding.
[[nodiscard]] EnergyCourse friction_energy(const solver::Problem& problem);

/// Heat and friction of one run, of the whole tire.
struct RunHeat {
    std::string run;
    std::string corner{};  ///< FL, FR, RL or RR; empty: the case has no [[corner]]
    std::vector<input::Lap> laps{};
    double start = 0.0;       ///< s
    double end = 0.0;         ///< s
    EnergyCourse heat{};      ///< into it, of each effect
    EnergyCourse friction{};  ///< along and across
};

}  // namespace tiretherm::diagnosis
