// SPDX-License-Identifier: BSD-3-Clause
// The course of a column over all runs: correlations with others, with time and distance, and with sensors earlier or later.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tiretherm::input {

/// Values at chosen samples of all runs, one run after the other; NaN where one is missing.
struct Course {
    std::vector<double> value;       ///< [n]
    std::vector<std::size_t> first;  ///< [n_runs + 1] where each run begins, and the end
};

/// How many different values there are, counted up to `most`.
[[nodiscard]] std::size_t n_levels(const Course& course, std::size_t most);
[[nodiscard]] bool is_constant(const Course& course);

/// Correlation of two courses where both have values; 0 with fewer than 20 such samples or where one is constant.
[[nodiscard]] double correlation(const std::vector<double>& a, const std::vector<double>& b);
/// Each run's mean and slope along its samples taken away.
[[nodiscard]] Course detrended(const Course& course);
/// Whether the correlation is beyond 0.9999, up or down: found without reading both to the end where it is not.
/// @param a, b as `standardised` leaves them
[[nodiscard]] bool is_copy(const std::vector<double>& a, const std::vector<double>& b);
/// Mean 0 and standard deviation 1.
[[nodiscard]] std::vector<double> standardised(const std::vector<double>& value);

/// The best correlation of a column with a sensor that is shifted against it.
struct Lead {
    double correlation = 0.0;  ///< at the best shift
    double together = 0.0;     ///< without a shift
    int samples = 0;           ///< that the column comes before the sensor; negative: after it
};
/// Of detrended courses, over shifts up to a tenth of the shortest run.
[[nodiscard]] Lead lead_of(const Course& column, const Course& sensor);

/// Mean square of the steps between neighbouring samples over twice the variance: 1 for white noise, near 0 for what moves
/// slowly.
[[nodiscard]] double roughness(const Course& course);

/// Whether a column counts: it never turns round, or turns round only to jump back to where it began, and it goes evenly with
/// the measure, or in steps of one.
/// @param value [n_runs][n] all samples  @param measure [n_runs][n] the time or the distance
[[nodiscard]] bool counts(const std::vector<std::span<const double>>& value,
                          const std::vector<std::span<const double>>& measure);

/// Whether a column is a function of an input that comes back to its values, as what is computed from it.
[[nodiscard]] bool is_function(const std::vector<double>& column, const std::vector<double>& input);

}  // namespace tiretherm::input
