// SPDX-License-Identifier: BSD-3-Clause
// What drives the hottest temperature of a study: linear regression on the drawn quantities, and the probability that
// follows from it.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/study/study_record.hpp"

namespace tiretherm::diagnosis {

/// What one of the drawn quantities does to the hottest temperature of a study's samples.
struct StudyDriver {
    std::string key;
    std::string unit;
    double mean = 0.0;                ///< of the samples, in `unit`
    double standard_deviation = 0.0;  ///< of the samples, in `unit`
    double kelvin = 0.0;              ///< K for one standard deviation more, all others held
    double uncertainty = 0.0;         ///< K, half of the 95 % interval
    double share = 0.0;               ///< of the variance that the linear function explains, together 1
};

/// The hottest temperature as a linear function of all quantities that were drawn, by least squares.
struct StudyRegression {
    std::vector<StudyDriver> drivers;  ///< the strongest first; empty where there are too few samples
    double mean = 0.0;                 ///< K, of the hottest temperatures
    double standard_deviation = 0.0;   ///< K, of the linear function over the spreads of the samples
    double residual = 0.0;             ///< K, standard deviation of what the line leaves over
    double r_squared = 0.0;            ///< share of the samples' variance that the line explains

    [[nodiscard]] bool exists() const { return !drivers.empty(); }
    /// Probability that the hottest temperature is above another, if it is normal with what the line and its residual
    /// have: what first order says of the same samples. @param temperature K
    [[nodiscard]] double chance_above(double temperature) const;
};

/// The samples at a point of the grid that came to their end. At least five for each number that is fitted; a quantity
/// that is the same in all samples is left out.
[[nodiscard]] StudyRegression regression(const StudyRecord& study, std::size_t point);

}  // namespace tiretherm::diagnosis
