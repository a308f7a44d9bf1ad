// SPDX-License-Identifier: BSD-3-Clause
// Each fold: a linear step from the full fit, then refits of the rest and of the start of the run that is left out, by the slopes
// of the full fit as long as they lead there.

#include "diagnosis/fit/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "diagnosis/fit/gauss_newton.hpp"
#include "diagnosis/fit/linearised_model.hpp"
#include "diagnosis/fit/refinement.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Steps of Gauss and Newton; the first starts at the linear estimate.
constexpr int few_iterations = 4;
/// By slopes that were taken nearby each step must leave this share at most of what the last one had to gain; less than `no_step`, in
/// log likelihood twice, is not worth another.
constexpr double least_contraction = 0.25;
constexpr double no_step = 0.0025;

/// The starts of the runs that are left out. @returns indices into the model's numbers
std::vector<Eigen::Index> columns_of_own(const input::Experiment& model, const Fold& fold) {
    std::vector<Eigen::Index> columns;
    for (std::size_t j = 0; j < model.parameters.size(); ++j) {
        if (fold.alone_has(model.parameters[j])) {
            columns.push_back(static_cast<Eigen::Index>(j));
        }
    }
    return columns;
}

/// The model with the starts of the runs that are left out free and all else as it is.
input::Experiment own_numbers_free(const input::Experiment& model, const Simulator& simulator,
                                   const Eigen::VectorXd& values, const Fold& fold) {
    input::Experiment own = model;
    own.parameters.clear();
    for (std::size_t r = 0; r < own.runs.size(); ++r) {
        own.runs[r].problem = simulator.problem(r, values);
    }
    for (const Eigen::Index j : columns_of_own(model, fold)) {
        own.parameters.push_back(model.parameters[static_cast<std::size_t>(j)]);
        // A shift of temperatures counts from where the problem stands now; its prior and bounds move along.
        solver::FreeParameter& number = own.parameters.back();
        const double by = number.kind == solver::FreeParameter::Kind::initial ? values[j] : 0.0;
        number.prior -= by;
        number.low -= by;
        number.high -= by;
    }
    return own;
}

/// The full fit moved to where the rest of the data would have it, to first order and within the bounds.
Eigen::VectorXd linear_start(const LinearisedModel& linear, const Refit& full, const Fit& fit, const Fold& fold) {
    const Eigen::VectorXd step = solve(linear, fold.rest);
    Eigen::VectorXd start = full.values + step.cwiseProduct(full.scale);
    for (Eigen::Index j = 0; j < start.size(); ++j) {
        // Far from the fit the straight line says nothing: the refit goes on from a step of moderate length.
        const double reach = std::max(full.scale[j], std::abs(full.values[j]));
        start[j] = std::clamp(start[j], full.values[j] - reach, full.values[j] + reach);
        start[j] = std::clamp(start[j], fit.low()[j], fit.high()[j]);
    }
    return start;
}

/// Values that a fit has come to, and what is simulated there.
struct NearbyFit {
    Eigen::VectorXd values;
    Eigen::VectorXd simulated;
};

/// A fit by slopes that were taken nearby: its simulations carry no sensitivities, which are most of what one costs.
/// @param slopes [n_rows][n] SI per unit of each number  @param simulations counts on
/// @returns nothing where these slopes do not lead there
std::optional<NearbyFit> settle_by(const Eigen::MatrixXd& slopes, const Fit& fit,
                                   const std::vector<std::vector<double>>& steps, Eigen::VectorXd values,
                                   long& simulations) {
    const Observations& observations = fit.observations();
    Refit at;
    at.scale = fit.scale();
    at.precision = fit.precision().cwiseProduct(at.scale.cwiseAbs2());
    Eigen::MatrixXd white(slopes.rows(), slopes.cols() + 1);
    double before = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration <= few_iterations; ++iteration) {
        const input::Experiment still = frozen_at(fit.experiment(), fit.simulator(), values);
        Simulator simulator(still, observations);
        simulator.take_steps(steps);
        const ModelPrediction& now = simulator.at(simulator.start());
        simulations += simulator.simulations();
        if (!now.status.ok()) {
            return std::nullopt;
        }
        white << slopes * at.scale.asDiagonal(), observations.measured - now.simulated;
        whiten(observations.blocks, fit.covariance(), white);
        at.slopes = white.leftCols(slopes.cols());
        at.residual = white.col(slopes.cols());
        at.known = fit.precision().cwiseSqrt().cwiseProduct(fit.prior() - values);
        at.values = values;
        const auto [step, to_gain] = gauss_newton_step(fit, at);
        if (to_gain < no_step) {
            return NearbyFit{.values = std::move(values), .simulated = now.simulated};
        }
        if (!(to_gain < least_contraction * before)) {
            return std::nullopt;
        }
        before = to_gain;
        values = (values + step.cwiseProduct(at.scale)).cwiseMax(fit.low()).cwiseMin(fit.high());
    }
    return std::nullopt;
}

/// A model fitted to everything, from which the fits of all folds start.
struct FullModel {
    const input::Experiment& model;
    const Observations& observations;
    const Covariance& covariance;
    const std::vector<std::vector<double>>& steps;
    const Refit& full;
    LinearisedModel linear;
    Eigen::MatrixXd slopes;  ///< [n_rows][n_parameters] SI per unit of each number
};

/// What leaving one fold out gave.
struct FoldErrors {
    std::optional<Eigen::VectorXd> values{};  ///< that the rest gave; nothing where it was not fitted
    std::optional<Eigen::VectorXd> left{};    ///< [n_test] SI; nothing where a fit failed
    long simulations = 0;
};

FoldErrors leave_out(const Fold& fold, const FullModel& all, bool fitted) {
    FoldErrors found;
    Eigen::VectorXd values = all.full.values;
    if (fitted && values.size() > 0) {
        const Observations rest = subset(all.observations, fold.rest);
        Fit fit(all.model, rest);
        fit.simulator().take_steps(all.steps);
        fit.take_covariance(subset(all.covariance, fold.rest));
        const Eigen::VectorXd start = linear_start(all.linear, all.full, fit, fold);
        if (std::optional<NearbyFit> there =
                settle_by(all.slopes(fold.rest, Eigen::all), fit, all.steps, start, found.simulations)) {
            values = std::move(there->values);
        } else if (fit.move_to(start) || fit.move_to(Eigen::VectorXd(all.full.values))) {
            values = refit(fit, few_iterations).values;
        } else {
            found.simulations += fit.simulator().simulations();
            return found;
        }
        found.simulations += fit.simulator().simulations();
        found.values = values;
    }
    // The runs that are left out, or the whole of those of which a part is.
    const Observations test = subset(all.observations, fold.test);
    const Simulator numbers(all.model, test);
    const input::Experiment own = own_numbers_free(all.model, numbers, values, fold);
    Fit fit(own, test);
    fit.simulator().take_steps(all.steps);
    fit.take_covariance(subset(all.covariance, fold.test));
    const std::vector<Eigen::Index> own_columns = columns_of_own(all.model, fold);
    const std::optional<NearbyFit> there =
        settle_by(all.slopes(fold.test, own_columns), fit, all.steps, fit.simulator().start(), found.simulations);
    if (there) {
        found.left = test.measured - there->simulated;
    } else if (fit.move_to(fit.simulator().start())) {
        found.left =
            test.measured - (own.parameters.empty() ? fit.now().simulated : refit(fit, few_iterations).simulated);
    }
    found.simulations += fit.simulator().simulations();
    return found;
}

/// Where a recording is divided: into quarters, each moved to the end of a lap that lies within half a quarter of it.
std::vector<double> cuts_of(const Observations& observations, std::size_t recording) {
    constexpr std::size_t quarters = 4;
    const auto [from, to] = observations.span_of(recording);
    const std::vector<double>& laps = observations.lap_ends;
    std::vector<double> cuts{from};
    for (std::size_t f = 1; f < quarters; ++f) {
        const double quarter = from + (to - from) * static_cast<double>(f) / quarters;
        const auto nearest = std::ranges::min_element(laps, {}, [&](double end) { return std::abs(end - quarter); });
        const bool by_lap = nearest != laps.end() && std::abs(*nearest - quarter) < 0.5 * (to - from) / quarters;
        cuts.push_back(by_lap ? *nearest : quarter);
    }
    cuts.push_back(to);
    return cuts;
}

}  // namespace

std::vector<int> noise_of_rows(const Observations& observations) {
    std::vector<int> noise(observations.rows.size(), -1);
    for (const NoiseBlock& block : observations.blocks) {
        std::fill_n(noise.begin() + block.first, block.rows(), block.channel);
    }
    return noise;
}

double HeldOutErrors::mean_square(const Observations& observations, std::size_t noise) const {
    const std::vector<int> noise_of = noise_of_rows(observations);
    double sum = 0.0;
    long count = 0;
    for (std::size_t row = 0; row < noise_of.size(); ++row) {
        const double one = left[static_cast<Eigen::Index>(row)];
        if (noise_of[row] == static_cast<int>(noise) && std::isfinite(one)) {
            sum += one * one;
            ++count;
        }
    }
    return count > 0 ? sum / static_cast<double>(count) : none;
}

std::vector<Fold> folds_within_recordings(const Observations& observations) {
    constexpr double gap = 0.05;
    const std::vector<int> noise_of = noise_of_rows(observations);
    std::vector<Fold> folds;
    for (std::size_t recording = 0; recording < observations.n_recordings(); ++recording) {
        const std::vector<double> cuts = cuts_of(observations, recording);
        const double apart = gap * (cuts.back() - cuts.front());
        for (std::size_t f = 0; f + 1 < cuts.size(); ++f) {
            Fold& fold = folds.emplace_back();
            for (std::size_t row = 0; row < observations.rows.size(); ++row) {
                const Observations::Row& what = observations.rows[row];
                const double time = observations.times[what.run][what.time];
                const bool is_same = observations.recordings[what.run] == recording;
                const bool is_last = f + 2 == cuts.size();
                if (noise_of[row] >= 0 && is_same && time >= cuts[f] && (time < cuts[f + 1] || is_last)) {
                    fold.test.push_back(static_cast<Eigen::Index>(row));
                } else if (noise_of[row] < 0 || !is_same || time < cuts[f] - apart || time > cuts[f + 1] + apart) {
                    fold.rest.push_back(static_cast<Eigen::Index>(row));
                }
            }
        }
    }
    std::erase_if(folds, [](const Fold& fold) { return fold.test.empty() || fold.rest.empty(); });
    return folds;
}

std::vector<Fold> folds_of(const Observations& observations) {
    if (observations.n_recordings() == 1) {
        return folds_within_recordings(observations);
    }
    const std::vector<int> noise_of = noise_of_rows(observations);
    std::vector<Fold> folds(observations.n_recordings());
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        for (std::size_t f = 0; f < folds.size(); ++f) {
            const bool is_test = observations.recordings[observations.rows[row].run] == f && noise_of[row] >= 0;
            (is_test ? folds[f].test : folds[f].rest).push_back(static_cast<Eigen::Index>(row));
        }
    }
    for (std::size_t run = 0; run < observations.recordings.size(); ++run) {
        folds[observations.recordings[run]].runs.push_back(run);
    }
    std::erase_if(folds, [](const Fold& fold) { return fold.test.empty() || fold.rest.empty(); });
    return folds;
}

HeldOutErrors held_out(const input::Experiment& model, const Observations& observations, const Covariance& covariance,
                       const std::vector<std::vector<double>>& steps, const Refit& full, bool fitted) {
    return held_out(model, observations, covariance, steps, full, folds_of(observations), fitted);
}

HeldOutErrors held_out(const input::Experiment& model, const Observations& observations, const Covariance& covariance,
                       const std::vector<std::vector<double>>& steps, const Refit& full, const std::vector<Fold>& folds,
                       bool fitted) {
    HeldOutErrors found{.left = Eigen::VectorXd::Constant(observations.measured.size(), none), .ok = !folds.empty()};
    const FullModel all{.model = model,
                        .observations = observations,
                        .covariance = covariance,
                        .steps = steps,
                        .full = full,
                        .linear = linearise(full, observations),
                        .slopes = full.raw * full.scale.cwiseInverse().asDiagonal()};
    std::vector<FoldErrors> of_fold(folds.size());
    in_parallel(folds.size(), [&](std::size_t f) { of_fold[f] = leave_out(folds[f], all, fitted); });
    for (std::size_t f = 0; f < folds.size(); ++f) {
        FoldErrors& one = of_fold[f];
        found.simulations += one.simulations;
        found.ok = found.ok && one.left.has_value();
        if (one.values) {
            found.values.push_back(std::move(*one.values));
        }
        if (one.left) {
            found.left(folds[f].test) = *one.left;
        }
    }
    return found;
}

}  // namespace tiretherm::diagnosis
