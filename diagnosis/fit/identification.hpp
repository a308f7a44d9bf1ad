// SPDX-License-Identifier: BSD-3-Clause
// Result of a parameter identification: fitted values with 95 % intervals, identifiability, determined combinations,
// and the fit of each channel.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/fit/left_out.hpp"
#include "diagnosis/noise/noise_estimate.hpp"
#include "diagnosis/observations/observations.hpp"
#include "diagnosis/remarks/remark.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// What the data say of a number.
enum class Identifiability : std::uint8_t {
    determined,      ///< its interval comes from the data
    doubtful,        ///< likewise, but the model may lack something that has moved it
    with_prior,      ///< from the data and from what was known before, both
    prior_only,      ///< the data do not see it: the interval is the one known before
    not_determined,  ///< the data do not see it and nothing was known before: there is no interval
    at_bound         ///< the fit ended at a bound: what lies beyond was not tried
};
[[nodiscard]] std::string_view word_of(Identifiability identifiability);

/// A number after the fit, in its own unit.
struct Fitted {
    double value = 0.0;
    double before = 0.0;              ///< of the case
    double standard_deviation = 0.0;  ///< infinite when not determined
    double low = 0.0;                 ///< 95 %; NaN when not determined
    double high = 0.0;
    bool profiled = false;     ///< the interval is that of the profile likelihood, not the symmetric one (Wald)
    bool low_is_open = false;  ///< the interval reaches the bound to that side, or has no end
    bool high_is_open = false;
    double by_grid = 0.0;  ///< by how much the correction for the discretisation error of the grid has moved it
    Identifiability identifiability = Identifiability::determined;
};

/// A combination of the numbers, and how well the data see it.
struct Direction {
    /// Standard deviations known before (or, where nothing was, values) over those from the data: below 1 the data say
    /// less than was known.
    double strength = 0.0;
    Eigen::VectorXd share;  ///< [n_parameters] of length 1, in those units
};

/// How a channel fits.
struct ChannelFit {
    std::size_t channel = 0;  ///< index into Problem::channels
    std::string name;         ///< the sensor's, or of a camera with its band
    double stated = 0.0;      ///< the data sheet's standard deviation, SI; 0: none
    Eigen::Index samples = 0;
    double rmse_before = 0.0;  ///< SI
    double rmse_after = 0.0;
    Noise noise;
    ChannelNoise found;
    Remarks cautions;
    double grid_error = 0.0;   ///< SI, the largest that was corrected; 0 where nothing was, and of cameras
    bool is_in_doubt = false;  ///< its noise may be an error of the model: see is_in_doubt

    /// Whether it is farther off than its sensor can be, however few samples say so.
    [[nodiscard]] bool is_missed() const { return stated > 0.0 && rmse_after > far_above_data_sheet * stated; }
};

/// A single number's fit.
struct NumberFit {
    std::size_t row = 0;    ///< of the observations
    double measured = 0.0;  ///< SI
    double before = 0.0;    ///< SI, simulated
    double after = 0.0;
    double standard_deviation = 0.0;

    /// Simulated - measured after the fit, in standard uncertainties.
    [[nodiscard]] double off() const { return (after - measured) / standard_deviation; }
};

struct Identification {
    solver::Status status;       ///< of the run that failed; then nothing else holds
    std::vector<Fitted> fitted;  ///< [n_parameters]
    Eigen::VectorXd values;      ///< [n_parameters]
    Eigen::MatrixXd correlation;
    std::vector<Direction> directions;  ///< the best seen first
    std::vector<ChannelFit> channels;
    std::vector<NumberFit> numbers;
    std::vector<std::string> non_smooth_parameters;  ///< numbers at a switch or a clamp
    Remarks findings;                                ///< what the fitted parameters say of the model
    /// Relative fall of the rms on data that were left out, where white noise predicts better and its fit was kept; otherwise 0.
    double white_noise_gain = 0.0;
    double widened = 1.0;           ///< factor on all intervals, where the noise of a channel is in doubt
    Eigen::VectorXd before;         ///< [n_rows] SI, simulated with the case's values
    Eigen::VectorXd after;          ///< [n_rows] SI
    double misfit = 0.0;            ///< sum of the squared whitened residuals
    double freedom = 0.0;           ///< rows less what the numbers take of them
    std::vector<LeftOut> left_out;  ///< laps or recordings, each predicted from the rest; where it was asked for
    bool converged = false;
    int iterations = 0;
    long simulations = 0;
    double seconds = 0.0;

    /// Root mean square of the single numbers' NumberFit::off; 0 without any.
    [[nodiscard]] double numbers_off() const;
};

struct IdentificationOptions {
    bool profile = false;  ///< intervals by profile likelihood
    /// The same experiment on a grid of half the spacing (read_experiment with finer = 2): the data are corrected for the
    /// discretisation error of the grid, which thousands of pixels see and a probe in a steep field as well, and what may be
    /// left of it widens the intervals.
    const input::Experiment* finer = nullptr;
    std::vector<NamedFold> leave_out{};                ///< each is predicted by a fit without it
    std::function<void(long simulations)> progress{};  ///< called after each prediction
};

/// Fits the experiment's parameters to all of its runs at once: least squares of the whitened residuals and the priors
/// within the bounds (Levenberg-Marquardt by Ceres), in turn with the noise of each channel (estimate_noise) until
/// neither moves the other.
[[nodiscard]] Identification identify(const input::Experiment& experiment, const Observations& observations,
                                      const IdentificationOptions& choice = {});

/// What the fit would say of data that are yet to be measured: the intervals at the case's values, to first order.
/// @param noise [Observations::channels] assumed
[[nodiscard]] Identification plan(const input::Experiment& experiment, const Observations& observations,
                                  const std::vector<Noise>& noise);

/// An experiment as it is going to be: every sensor with a standard deviation gives a reading at every time of each
/// run's file, or where there is none at the case's output times (every hundredth of the run when it has none).
[[nodiscard]] input::Experiment planned(input::Experiment experiment);
/// Noise as the sensors' standard deviations say, of which this share is new in every sample.
/// @param correlation_time s, of the rest
[[nodiscard]] std::vector<Noise> stated_noise(const input::Experiment& experiment, const Observations& observations,
                                              double correlation_time, double white_share);

}  // namespace tiretherm::diagnosis
