// SPDX-License-Identifier: BSD-3-Clause
// Wording shared by the reports of a comparison: "too hot" and "too cold", probabilities to one
// figure.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/compare/comparison.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

/// What a value is that is simulated too large, and one too small: "hot" and "cold".
[[nodiscard]] std::string too(const solver::ShownUnit& unit, bool large);
/// A difference in SI as it is shown, with two decimals where these mean something.
[[nodiscard]] std::string shown(const diagnosis::ComparedChannel& channel, double difference);
[[nodiscard]] std::string shown_signed(const diagnosis::ComparedChannel& channel, double difference);
/// "surface_temperature, free rolling: all 4 tires are too hot, by 2.1 to 4.0 K"
[[nodiscard]] std::string corner_sentence(const diagnosis::ComparedChannel& channel,
                                          const diagnosis::CommonBias& common);
/// "surface: simulated 0.41 +- 0.06 K too cold in the mean of 2 runs; rms 0.75 K, 1.5 times the sensor's standard deviation of
/// 0.50 K; at most -2.30 K, at 31 s of wet."
/// @param runs names of all runs
[[nodiscard]] std::string headline(const diagnosis::ComparedChannel& channel, const std::vector<std::string>& runs);
/// "at most 0.17 K of spot": the error of grid and steps in a channel. @param error SI
[[nodiscard]] std::string grid_error_text(const std::string& channel, const solver::ShownUnit& unit, double error);
/// "4e-06", "0.03", "0.5": a chance to one figure.
[[nodiscard]] std::string chance_text(double chance);

}  // namespace tiretherm::post
