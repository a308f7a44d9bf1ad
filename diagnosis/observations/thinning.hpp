// SPDX-License-Identifier: BSD-3-Clause
// Dense logs as means over blocks of samples, so that a diagnosis has no more values than the tire's time constants need.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// What became of one run.
struct ThinnedRun {
    std::size_t samples = 1;  ///< of the log, whose mean is one value; 1: the run is as it was
    double interval = 0.0;    ///< s between samples of the log, the median
};

/// An experiment with fewer values that say the same.
struct Thinned {
    input::Experiment experiment;
    std::vector<ThinnedRun> runs;  ///< [n_runs]
    Remarks remarks;               ///< what was thinned and how far, one for each run
};

/// Values that a channel keeps in a run, about.
inline constexpr std::size_t most_values = 1500;
/// Blocks of this length (5 Hz) are always short enough: infrared sensors and loggers are late by this much and more.
inline constexpr double always_short_enough = 0.2;  // s
/// Longer blocks are for runs longer than this, which have twice `most_values` at 5 Hz.
inline constexpr double long_run = 600.0;  // s
/// Share that blocks longer than 0.2 s keep of what the samples say about a delay, in every channel: its standard deviation
/// grows by 5 % at most. The variance of a delay's estimate in white noise is sigma^2 / sum T'^2, and what T' does within a
/// block is lost to its mean. Of T' = exp(-t/tau) blocks of length b keep tanh(b/2tau) / (b/2tau), 99.5 % of
/// b = tau/4 and 92 % of b = tau. A sinusoid keeps the square of sin(pi b/P) / (pi b/P), 90 % of b = 0.18 P.
inline constexpr double least_timing = 0.9;

/// Puts block means in the place of the samples of runs that have many more than `most_values`. All channels of a run have
/// the same blocks. A value is the mean of the samples that are there, and missing where more than half are; its time is
/// the mean of the block's times. The mean of what the model says over these samples differs from what it says at that
/// time, by T'' b^2 / 24 where T is smooth; the difference at the case's values is taken off. A sensor that is logged
/// more slowly than half a block stays as it is, at its own times.
///
/// The inputs stay as they are. Friction and loss are products of inputs, of which means of each would lose the
/// covariances; the solver's steps average the products themselves over as many samples as they span.
///
/// The sensors' stated standard deviations stay, too: the noise is estimated from the means, and how much less they
/// scatter depends on how much of it is white.
[[nodiscard]] Thinned thinned(const input::Experiment& experiment);

/// Gives the same runs on another mesh the values of the thinned ones.
void take_values(const Thinned& from, input::Experiment& to);

}  // namespace tiretherm::diagnosis
