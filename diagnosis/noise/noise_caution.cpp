// SPDX-License-Identifier: BSD-3-Clause
// Sentences of caution about an estimated noise: far above the data sheet, as slow as the tire, at the bound, or not
// estimated.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "diagnosis/noise/noise_estimate.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double alike = 2.0;  ///< ratio of two times that are as good as the same
/// Samples from which a noise far above the data sheet is no accident of the estimate.
constexpr Eigen::Index many = 100;

bool is_at_longest_correlation(const Noise& noise, const ChannelNoise& found) {
    return noise.correlation_time > 0.99 * found.longest_correlation;
}

/// 12 s, 3.4 min, 1.2 h
std::string duration(double seconds) {
    if (seconds < 120.0) {
        return fmt::format("{:.2g} s", seconds);
    }
    return seconds < 7200.0 ? fmt::format("{:.2g} min", seconds / 60.0) : fmt::format("{:.2g} h", seconds / 3600.0);
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

std::vector<std::string> cautions(const std::string& channel, const std::string& unit, const Noise& noise,
                                  const ChannelNoise& found, double data_sheet,
                                  const std::vector<double>& thermal_times) {
    std::vector<std::string> said;
    if (found.source == NoiseSource::data_sheet) {
        said.push_back(
            fmt::format("{}: its {} samples leave nothing to estimate noise from, the data sheet's {:.3g} {} is taken",
                        channel, found.samples, noise.sigma, unit));
        return said;
    }
    if (found.source == NoiseSource::assumed) {
        said.push_back(
            fmt::format("{}: its {} samples leave nothing to estimate noise from and no standard deviation is stated, "
                        "{:.3g} {} is assumed; state it with the sensor",
                        channel, found.samples, noise.sigma, unit));
        return said;
    }
    if (data_sheet > 0.0 && noise.sigma > far_above_data_sheet * data_sheet) {
        said.push_back(
            fmt::format("{}: the noise of {:.3g} {} is {:.1f} times what the data sheet says ({:.3g} {}): either the "
                        "sensor is worse than that, or an error of the model is counted as noise",
                        channel, noise.sigma, unit, noise.sigma / data_sheet, data_sheet, unit));
    }
    if (noise.correlation_time <= 0.0) {
        return said;
    }
    for (const double time : thermal_times) {
        if (std::abs(std::log(noise.correlation_time / time)) < std::log(alike)) {
            said.push_back(
                fmt::format("{}: the noise's correlation time of {} is close to the tire's time constant of {}: an "
                            "error of the model may be counted as noise",
                            channel, duration(noise.correlation_time), duration(time)));
            break;
        }
    }
    if (is_at_longest_correlation(noise, found)) {
        said.push_back(
            fmt::format("{}: the noise's correlation time reached its upper limit, {} or a tenth of the longest run: a "
                        "drift of the sensor or an error of the model is taken for noise",
                        channel, duration(found.longest_correlation)));
    }
    return said;
}

}  // namespace tiretherm::diagnosis
