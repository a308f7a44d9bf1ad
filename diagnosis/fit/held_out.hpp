// SPDX-License-Identifier: BSD-3-Clause
// Cross-validation of a fitted model by refits: every recording, or every part of a single one, is left out in turn and predicted
// from the rest. The tires of a car are of one recording: they share what is wrong with it.
#pragma once

#include <cmath>
#include <vector>

#include "diagnosis/fit/refit.hpp"
#include "diagnosis/observations/observation_subset.hpp"

namespace tiretherm::diagnosis {

/// What takes no part in a fit, and what the rest is.
struct Fold {
    RowIndices test;
    RowIndices rest;
    std::vector<std::size_t> runs{};  ///< whose start is fitted to the test itself; none: to the rest

    /// Whether a parameter is one of which the rest says nothing, and that is no coefficient of which anything was known before: that is
    /// predicted as it was known.
    [[nodiscard]] bool alone_has(const solver::FreeParameter& parameter) const {
        const bool is_known =
            parameter.kind != solver::FreeParameter::Kind::initial && std::isfinite(parameter.standard_deviation);
        return !is_known && !parameter.runs.empty() && std::ranges::all_of(parameter.runs, [&](std::size_t run) {
            return std::ranges::find(runs, run) != runs.end();
        });
    }
};

/// Each recording once. Of a single one each of its quarters, cut at the nearest ends of laps, with a gap of a twentieth of
/// the recording between it and the rest. Quoted numbers are always in the rest. A fold with nothing to test or to fit is left out.
[[nodiscard]] std::vector<Fold> folds_of(const Observations& observations);
/// The quarters of every recording, each predicted from the others and from all other recordings.
[[nodiscard]] std::vector<Fold> folds_within_recordings(const Observations& observations);

/// What a model gets wrong of data that took no part in its fit.
struct HeldOutErrors {
    Eigen::VectorXd left;                   ///< [n_rows] SI, measured - predicted; NaN of rows that were in no test
    std::vector<Eigen::VectorXd> values{};  ///< [n_folds][n_parameters] that the rest of each fold gave
    long simulations = 0;
    bool ok = false;  ///< every fold could be fitted

    /// Mean square of a channel's error. @param noise index into Observations::channels  @returns NaN without any
    [[nodiscard]] double mean_square(const Observations& observations, std::size_t noise) const;
};

/// The index into Observations::channels of every row; -1 of quoted numbers. @returns [n_rows]
[[nodiscard]] std::vector<int> noise_of_rows(const Observations& observations);

/// Leaves out each fold, several at a time. The shared numbers are fitted to the rest in full, by steps of Gauss and Newton within
/// their bounds, and how the run that is left out started to itself; what is left of it is simulated, not extrapolated.
/// @param full the model fitted to everything, where each fold starts  @param steps [n_runs] s, of every run
/// @param fitted false: the shared numbers keep the values of `full`, only starts are fitted
[[nodiscard]] HeldOutErrors held_out(const input::Experiment& model, const Observations& observations,
                                     const Covariance& covariance, const std::vector<std::vector<double>>& steps,
                                     const Refit& full, bool fitted = true);
/// The same of some folds.
[[nodiscard]] HeldOutErrors held_out(const input::Experiment& model, const Observations& observations,
                                     const Covariance& covariance, const std::vector<std::vector<double>>& steps,
                                     const Refit& full, const std::vector<Fold>& folds, bool fitted = true);

}  // namespace tiretherm::diagnosis
