// SPDX-License-Identifier: BSD-3-Clause
// Noise of all channels by restricted maximum likelihood, REML (Patterson and Thompson, Biometrika 58 (1971) 545;
// Harville, JASA 72 (1977) 320).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/noise/noise.hpp"
#include "diagnosis/remarks/remark.hpp"

namespace tiretherm::diagnosis {

enum class NoiseModel : std::uint8_t { correlated, white };

/// Residuals whose noise is to be estimated, and all that may hide in them beside noise.
struct NoiseProblem {
    const std::vector<NoiseBlock>& blocks;
    const Eigen::VectorXd& residual;  ///< [n_rows] measured - simulated, or the other way round
    const Eigen::MatrixXd& span;  ///< [n_rows][n_columns] sensitivities to parameters and to all effects in question
    const Eigen::VectorXd& precision;  ///< [n_columns] 1 / prior variance of each column's factor around 0; 0: unknown
    std::vector<double> data_sheet;    ///< [n_channels] the sensors' stated standard deviation; 0: not stated
    NoiseModel model = NoiseModel::correlated;
    bool robust = false;         ///< outliers count less
    std::vector<Noise> start{};  ///< [n_channels] where the search of slow noise begins; empty: anywhere
};

/// Where a channel's noise comes from.
enum class NoiseSource : std::uint8_t {
    estimated,
    data_sheet,  ///< too few samples, or no residual to estimate from
    assumed      ///< neither samples nor data sheet: a sigma of 1
};

struct ChannelNoise {
    NoiseSource source = NoiseSource::estimated;
    Eigen::Index samples = 0;
    double freedom = 0.0;              ///< samples less what the span's columns take of them
    double sigma_deviation = 0.0;      ///< standard deviation of sigma; NaN: not determined
    double rho_1s_deviation = 0.0;     ///< of rho_1s; NaN: not determined
    double longest_correlation = 0.0;  ///< s, a tenth of the longest run: what noise is allowed
    double gain = 0.0;                 ///< in -2 log likelihood, of correlated over white noise
};

struct NoiseEstimate {
    Covariance covariance;
    std::vector<ChannelNoise> channels;  ///< [n_channels]
    std::vector<Eigen::Index> left_out;  ///< columns of the span that earlier columns make up, without a prior
    double criterion = 0.0;              ///< see estimate_noise, up to a constant of the span
    int passes = 0;                      ///< over all channels
};

/// Restricted maximum likelihood (Patterson and Thompson, Biometrika 58 (1971) 545; Harville, JASA 72 (1977) 320): the
/// noise of all channels that minimises
///     log |V| + log |X' V^-1 X + Pi| + r' (V^-1 - V^-1 X (X' V^-1 X + Pi)^-1 X' V^-1) r
/// with the residuals r, the span X and its prior precision Pi. What lies in the span can neither inflate the noise nor
/// deflate it by being fitted. Noise counts as white unless correlation gains more than it does in 96 of 100 white series.
///
/// Correlation times stay between a fifth of the median sample interval, below which nothing tells them from white
/// noise, and a tenth of the longest run, above which nothing tells them from the model's own slow errors.
[[nodiscard]] NoiseEstimate estimate_noise(const NoiseProblem& problem);

/// Noise beyond so many times the data sheet's standard deviation is not the sensor's alone.
inline constexpr double far_above_data_sheet = 3.0;
/// The same of noise that is correlated, as errors of the model are.
inline constexpr double correlated_above_data_sheet = 1.5;

/// Whether an estimated noise may be an error of the model: its correlation time ended at the upper limit, or it is far
/// above the data sheet in a channel of more than 100 samples, 1.5 times where it is correlated. Noise that was not estimated is not
/// in doubt, nor is noise within the data sheet.
/// @param data_sheet standard deviation, in the channel's unit; 0: not stated
[[nodiscard]] bool is_in_doubt(const Noise& noise, const ChannelNoise& found, double data_sheet);

/// What is to be said about a channel's noise, a sentence each: far above the data sheet, as slow as the tire, as slow
/// as is allowed, or not estimated at all.
/// @param thermal_times s, time constants of the tire that the channel sees
[[nodiscard]] Remarks cautions(const std::string& channel, const std::string& unit, const Noise& noise,
                               const ChannelNoise& found, double data_sheet, const std::vector<double>& thermal_times);

}  // namespace tiretherm::diagnosis
