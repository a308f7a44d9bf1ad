// SPDX-License-Identifier: BSD-3-Clause
// Remarks of caution about an estimated noise: far above the data sheet, as slow as the tire, at the bound, or not
// estimated.

#include <cmath>
#include <string>
#include <vector>

#include "diagnosis/noise/noise_estimate.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double alike = 2.0;  ///< ratio of two times that are as good as the same
/// Samples from which a noise far above the data sheet is no accident of the estimate.
constexpr Eigen::Index many = 100;

bool is_at_longest_correlation(const Noise& noise, const ChannelNoise& found) {
    return noise.correlation_time > 0.99 * found.longest_correlation;
}

}  // namespace

bool is_in_doubt(const Noise& noise, const ChannelNoise& found, double data_sheet) {
    if (found.source != NoiseSource::estimated || (data_sheet > 0.0 && noise.sigma <= data_sheet)) {
        return false;
    }
    const bool is_slowest = noise.correlation_time > 0.0 && is_at_longest_correlation(noise, found);
    const double most =
        noise.correlation_time > 0.0 && noise.white_share < 1.0 ? correlated_above_data_sheet : far_above_data_sheet;
    const bool is_too_large = data_sheet > 0.0 && found.samples > many && noise.sigma > most * data_sheet;
    return is_slowest || is_too_large;
}

Remarks cautions(const std::string& channel, const std::string& unit, const Noise& noise, const ChannelNoise& found,
                 double data_sheet, const std::vector<double>& thermal_times) {
    if (found.source == NoiseSource::data_sheet) {
        return {remark::noise_of_data_sheet(channel, found.samples, noise.sigma, unit)};
    }
    if (found.source == NoiseSource::assumed) {
        return {remark::noise_assumed(channel, found.samples, noise.sigma, unit)};
    }
    Remarks all;
    if (data_sheet > 0.0 && noise.sigma > far_above_data_sheet * data_sheet) {
        all.push_back(remark::noise_above_data_sheet(channel, noise.sigma, unit, noise.sigma / data_sheet, data_sheet));
    }
    if (noise.correlation_time <= 0.0) {
        return all;
    }
    const Seconds correlation_time(noise.correlation_time);
    for (const double time : thermal_times) {
        if (std::abs(std::log(noise.correlation_time / time)) < std::log(alike)) {
            all.push_back(remark::noise_as_slow_as_tire(channel, correlation_time, Seconds(time)));
            break;
        }
    }
    if (is_at_longest_correlation(noise, found)) {
        all.push_back(remark::noise_as_slow_as_allowed(channel, Seconds(found.longest_correlation)));
    }
    return all;
}

}  // namespace tiretherm::diagnosis
