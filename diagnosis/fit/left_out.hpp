// SPDX-License-Identifier: BSD-3-Clause
// A fit without each lap, or each recording, in turn: how well the rest predicts it, and how far the parameters move.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnosis/fit/held_out.hpp"

namespace tiretherm::diagnosis {

/// What a fit leaves out in turn.
enum class LeaveOut : std::uint8_t { nothing, lap, run };

/// A channel of what was left out.
struct LeftOutChannel {
    std::size_t noise = 0;  ///< index into Observations::channels
    long samples = 0;
    double rms_fitted = 0.0;     ///< SI, by the fit to everything
    double rms_predicted = 0.0;  ///< SI, by the fit to the rest
    /// SI, of the prediction if the model is right: what the fit leaves of the rest, and what the rest does not know of the parameters,
    /// by the noise of the fit to everything, which a part that is wrong makes larger.
    double rms_expected = 0.0;
};

/// A lap or a recording that took no part in a fit.
struct LeftOut {
    std::string name;  ///< "lap 3", "session, lap 3" of several recordings, or the recording
    std::vector<LeftOutChannel> channels;
    Eigen::VectorXd values;  ///< [n_parameters] of the fit to the rest
    /// [n_parameters] how far each has moved from the fit to everything, in standard deviations of that move if the model is
    /// right: the fit to everything contains the rest, so that the variances are subtracted; 0 of starts, of which the rest may know nothing.
    Eigen::VectorXd moves;
};

/// A move of a parameter is beyond chance from so many standard deviations on: 2.5, and more where so many moves are looked at.
[[nodiscard]] double least_move(const std::vector<LeftOut>& all);

/// What may be left out, the numbers quoted of it included. Between a lap and the rest of its recording lies a twentieth of it that is in neither.
struct NamedFold {
    std::string name;
    Fold fold;
};
/// @returns one for each lap of each recording whose laps are known, or for each of several recordings; empty where there is nothing
/// to leave out
[[nodiscard]] std::vector<NamedFold> named_folds(const input::Experiment& experiment, const Observations& observations,
                                                 LeaveOut what);

/// Fits the rest of each and predicts it. @param fit at the values of the fit to everything, with its noise taken
/// @param simulations out: added  @returns all; without channels where the rest could not be fitted
[[nodiscard]] std::vector<LeftOut> leave_out_in_turn(Fit& fit, const std::vector<NamedFold>& folds, long& simulations);

}  // namespace tiretherm::diagnosis
