// SPDX-License-Identifier: BSD-3-Clause
// Folds by lap or recording, and the errors of their predictions by channel.

#include "diagnosis/fit/left_out.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tiretherm::diagnosis {

namespace {

constexpr double gap = 0.05;  // of the recording

const std::string& recording_of(const input::MeasuredRun& run) { return run.corner.empty() ? run.name : run.recording; }

/// Test and rest of one lap. @param recording in which it lies
Fold fold_of_lap(const Observations& observations, std::size_t recording, const input::Lap& lap) {
    const std::vector<int> noise_of = noise_of_rows(observations);
    const auto [from, to] = observations.span_of(recording);
    const double apart = gap * (to - from);
    Fold fold;
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        const Observations::Row& what = observations.rows[row];
        const double time = observations.times[what.run][what.time];
        const bool is_same = observations.recordings[what.run] == recording;
        if (noise_of[row] >= 0 && is_same && time >= lap.start && time < lap.end) {
            fold.test.push_back(static_cast<Eigen::Index>(row));
        } else if (!is_same || time < lap.start - apart || time > lap.end + apart) {  // quoted numbers too
            fold.rest.push_back(static_cast<Eigen::Index>(row));
        }
    }
    return fold;
}

std::vector<NamedFold> folds_by_lap(const input::Experiment& experiment, const Observations& observations) {
    std::vector<NamedFold> folds;
    for (std::size_t recording = 0; recording < observations.n_recordings(); ++recording) {
        const auto first = static_cast<std::size_t>(std::ranges::find(observations.recordings, recording) -
                                                    observations.recordings.begin());
        const input::MeasuredRun& run = experiment.runs[first];
        for (const input::Lap& lap : run.laps.size() > 1 ? run.laps : std::vector<input::Lap>{}) {
            NamedFold one{.name = fmt::format("lap {}", lap.number), .fold = fold_of_lap(observations, recording, lap)};
            if (observations.n_recordings() > 1) {
                one.name = fmt::format("{}, {}", recording_of(run), one.name);
            }
            folds.push_back(std::move(one));
        }
    }
    return folds;
}

/// Root mean square of some rows of one channel. @returns how many there are, and it
LeftOutChannel errors_of(const Observations& observations, const Fold& fold, std::size_t noise,
                         const Eigen::VectorXd& fitted, const Eigen::VectorXd& predicted) {
    const std::vector<int> noise_of = noise_of_rows(observations);
    LeftOutChannel found{.noise = noise};
    double of_fit = 0.0;
    double of_prediction = 0.0;
    for (const Eigen::Index row : fold.test) {
        if (noise_of[static_cast<std::size_t>(row)] == static_cast<int>(noise) && std::isfinite(predicted[row])) {
            of_fit += fitted[row] * fitted[row];
            of_prediction += predicted[row] * predicted[row];
            ++found.samples;
        }
    }
    if (found.samples > 0) {
        found.rms_fitted = std::sqrt(of_fit / static_cast<double>(found.samples));
        found.rms_predicted = std::sqrt(of_prediction / static_cast<double>(found.samples));
    }
    return found;
}

}  // namespace

std::vector<NamedFold> named_folds(const input::Experiment& experiment, const Observations& observations,
                                   LeaveOut what) {
    std::vector<NamedFold> folds;
    if (what == LeaveOut::lap) {
        folds = folds_by_lap(experiment, observations);
    } else if (what == LeaveOut::run && observations.n_recordings() > 1) {
        for (Fold& fold : folds_of(observations)) {
            const std::size_t run = fold.runs.front();
            std::erase_if(fold.rest, [&](Eigen::Index row) {  // what was quoted of it
                const std::size_t its = observations.rows[static_cast<std::size_t>(row)].run;
                return std::ranges::find(fold.runs, its) != fold.runs.end();
            });
            folds.push_back({.name = recording_of(experiment.runs[run]), .fold = std::move(fold)});
        }
    }
    std::erase_if(folds, [](const NamedFold& one) { return one.fold.test.empty() || one.fold.rest.empty(); });
    return folds;
}

std::vector<LeftOut> leave_out_in_turn(Fit& fit, const std::vector<NamedFold>& folds, long& simulations) {
    const Observations& observations = fit.observations();
    const Refit full = refit(fit, 0);
    const Eigen::VectorXd fitted = observations.measured - full.simulated;
    std::vector<LeftOut> found;
    for (const NamedFold& one : folds) {
        const HeldOutErrors errors =
            held_out(fit.experiment(), observations, fit.covariance(), fit.simulator().steps(), full, {one.fold});
        simulations += errors.simulations;
        if (!errors.ok) {
            found.push_back({.name = one.name, .channels = {}, .values = {}});
            continue;
        }
        LeftOut left{.name = one.name, .channels = {}, .values = errors.values.front()};
        for (std::size_t noise = 0; noise < observations.channels.size(); ++noise) {
            if (LeftOutChannel channel = errors_of(observations, one.fold, noise, fitted, errors.left);
                channel.samples > 0) {
                left.channels.push_back(channel);
            }
        }
        found.push_back(std::move(left));
    }
    return found;
}

}  // namespace tiretherm::diagnosis
