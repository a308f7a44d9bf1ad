// SPDX-License-Identifier: BSD-3-Clause
// Folds by lap or recording, and the errors of their predictions by channel.

#include "diagnosis/fit/left_out.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "diagnosis/findings/parameter_findings.hpp"
#include "diagnosis/fit/linearised_model.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double gap = 0.05;  // of the recording
/// A part that the parameters hardly follow moves them by rounding alone: a move counts against no less than this share of a variance.
constexpr double least_spread = 0.01;

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
            NamedFold one{.name = lap.kind == input::LapKind::out  ? "out-lap"
                                  : lap.kind == input::LapKind::in ? "in-lap"
                                                                   : fmt::format("lap {}", lap.number),
                          .fold = fold_of_lap(observations, recording, lap)};
            if (observations.n_recordings() > 1) {
                one.name = fmt::format("{}, {}", recording_of(run), one.name);
            }
            folds.push_back(std::move(one));
        }
    }
    return folds;
}

/// What the fit to everything says of a fold.
struct Expectation {
    const LinearisedModel& model;
    Eigen::MatrixXd
        of_rest;  ///< [n][n] covariance by the rest, in scales; nothing of starts that are fitted to the fold itself

    /// Variance of a prediction by what the rest does not know. @returns SI squared
    [[nodiscard]] double variance(Eigen::Index row) const {
        return model.raw.row(row) * of_rest * model.raw.row(row).transpose();
    }
};

/// Mean square of some rows of one channel. @returns how many there are, and it
std::pair<long, double> mean_square(const std::vector<int>& noise_of, std::size_t noise, const RowIndices& rows,
                                    const Eigen::VectorXd& left) {
    double sum = 0.0;
    long count = 0;
    for (const Eigen::Index row : rows) {
        if (noise_of[static_cast<std::size_t>(row)] == static_cast<int>(noise) && std::isfinite(left[row])) {
            sum += left[row] * left[row];
            ++count;
        }
    }
    return {count, count > 0 ? sum / static_cast<double>(count) : 0.0};
}

/// One channel of a fold. @returns no samples where it has none
LeftOutChannel errors_of(const Observations& observations, const Fold& fold, std::size_t noise,
                         const Eigen::VectorXd& fitted, const Eigen::VectorXd& predicted,
                         const Expectation& expectation) {
    const std::vector<int> noise_of = noise_of_rows(observations);
    const auto [samples, of_prediction] = mean_square(noise_of, noise, fold.test, predicted);
    double unknown = 0.0;
    for (const Eigen::Index row : fold.test) {
        if (noise_of[static_cast<std::size_t>(row)] == static_cast<int>(noise) && std::isfinite(predicted[row])) {
            unknown += expectation.variance(row) / static_cast<double>(samples);
        }
    }
    return {.noise = noise,
            .samples = samples,
            .rms_fitted = std::sqrt(mean_square(noise_of, noise, fold.test, fitted).second),
            .rms_predicted = std::sqrt(of_prediction),
            .rms_expected = std::sqrt(mean_square(noise_of, noise, fold.rest, fitted).second + unknown)};
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

double least_move(const std::vector<LeftOut>& all) {
    Eigen::Index n = 0;
    for (const LeftOut& one : all) {
        n += (one.moves.array() != 0.0).count();
    }
    return least_conflict(static_cast<std::size_t>(n));
}

std::vector<LeftOut> leave_out_in_turn(Fit& fit, const std::vector<NamedFold>& folds, long& simulations) {
    const Observations& observations = fit.observations();
    const Refit full = refit(fit, 0);
    const Eigen::VectorXd fitted = observations.measured - full.simulated;
    const LinearisedModel linear = linearise(full, observations);
    RowIndices everything(observations.rows.size());
    std::iota(everything.begin(), everything.end(), 0);
    const Eigen::VectorXd variance = covariance(linear, everything).diagonal();
    std::vector<HeldOutErrors> of_fold(folds.size());
    in_parallel(folds.size(), [&](std::size_t i) {
        of_fold[i] =
            held_out(fit.experiment(), observations, fit.covariance(), fit.simulator().steps(), full, {folds[i].fold});
    });
    std::vector<LeftOut> found;
    for (std::size_t i = 0; i < folds.size(); ++i) {
        const NamedFold& one = folds[i];
        const HeldOutErrors& errors = of_fold[i];
        simulations += errors.simulations;
        if (!errors.ok) {
            found.push_back({.name = one.name, .channels = {}, .values = {}, .moves = {}});
            continue;
        }
        Expectation expectation{linear, covariance(linear, one.fold.rest)};
        LeftOut left{.name = one.name,
                     .channels = {},
                     .values = errors.values.front(),
                     .moves = Eigen::VectorXd::Zero(full.values.size())};
        for (Eigen::Index j = 0; j < left.moves.size(); ++j) {
            const solver::FreeParameter& parameter = fit.experiment().parameters[static_cast<std::size_t>(j)];
            if (parameter.kind != solver::FreeParameter::Kind::initial) {
                const double of_move = std::max(expectation.of_rest(j, j) - variance[j], least_spread * variance[j]);
                left.moves[j] = (left.values[j] - full.values[j]) / (full.scale[j] * std::sqrt(of_move));
            } else if (one.fold.alone_has(parameter)) {
                expectation.of_rest.row(j).setZero();
                expectation.of_rest.col(j).setZero();
            }
        }
        for (std::size_t noise = 0; noise < observations.channels.size(); ++noise) {
            if (LeftOutChannel channel = errors_of(observations, one.fold, noise, fitted, errors.left, expectation);
                channel.samples > 0) {
                left.channels.push_back(channel);
            }
        }
        found.push_back(std::move(left));
    }
    return found;
}

}  // namespace tiretherm::diagnosis
