// SPDX-License-Identifier: BSD-3-Clause
// How much better one model predicts data that were left out than another, with its interval.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "diagnosis/fit/held_out.hpp"

namespace tiretherm::diagnosis {

/// What a cause that is confirmed removes at least of a sensor's error. A cause that leaves the greater part of an error may stand for what
/// nobody has named, and then it holds where that acts as it did in these runs.
inline constexpr double greater_part = 0.5;

/// Share of a sensor's error beyond its noise that is removed, of the mean square; nothing where that error is smaller than the noise, or
/// no noise is known. @param before, after rms  @param noise standard deviation; 0: none is known
[[nodiscard]] std::optional<double> share_explained(double before, double after, double noise);

/// Whether a number of this unit is a temperature's drift in the course of a run.
[[nodiscard]] inline bool is_drift(std::string_view unit) { return unit == "K h-1"; }

/// What a model gains over another on data that took no part in either fit. Every channel counts alike, whatever its size
/// or its samples: shares are means over the channels.
struct PredictionGain {
    double removed = 0.0;  ///< 1 - mean square after / before
    double low = 0.0;      ///< 95 % of `removed`, by drawing blocks of time
    double high = 0.0;
    double removable = 0.0;        ///< share of the error before that is no noise of the sensors
    double worst = 1.0;            ///< largest ratio of a channel's rms, after over before
    double least_explained = 1.0;  ///< share_explained of the sensor of which it is least
    bool in_every_fold = false;    ///< the error rises in no run, or quarter of a run, by more than 2 %
    /// Log likelihood ratio of the two predictions with as many independent samples as the noise leaves: half of
    /// n ln(before / after), summed over the channels. It has the sign of what the prediction gains.
    double log_odds = 0.0;
    /// What the rms of a channel falls by. SI
    struct Fall {
        double before = 0.0;
        double after = 0.0;
        double low = 0.0;  ///< 95 % of before - after, by the same draws
        double high = 0.0;
    };
    std::vector<Fall> channels{};  ///< [n_noises]; zeros of one without errors before
};

/// Compares two predictions of the same rows by a bootstrap over blocks of time (Kuensch, Ann. Statist. 17 (1989) 1217).
/// @param noise [n_noises] whose correlation times say how long a block has to be and how many samples are independent
/// @param floor [n_noises] standard deviation that no model can remove; 0: none is known
[[nodiscard]] PredictionGain compare_predictions(const HeldOutErrors& before, const HeldOutErrors& after,
                                                 const Observations& observations, const std::vector<Noise>& noise,
                                                 const std::vector<double>& floor);

}  // namespace tiretherm::diagnosis
