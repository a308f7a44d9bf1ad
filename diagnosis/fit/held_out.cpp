// SPDX-License-Identifier: BSD-3-Clause
// Each fold: a linear step from the full fit, then refits of the rest and of the start of the run that is left out.

#include "diagnosis/fit/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/fit/linearised_model.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
/// Steps of Gauss and Newton; the first starts at the linear estimate.
constexpr int few_iterations = 4;

/// The model with the starts of the runs that are left out free and all else as it is.
input::Experiment own_numbers_free(const input::Experiment& model, const Simulator& simulator,
                                   const Eigen::VectorXd& values, const Fold& fold) {
    input::Experiment own = model;
    own.parameters.clear();
    for (std::size_t r = 0; r < own.runs.size(); ++r) {
        own.runs[r].problem = simulator.problem(r, values);
    }
    for (std::size_t j = 0; j < model.parameters.size(); ++j) {
        if (fold.alone_has(model.parameters[j])) {
            own.parameters.push_back(model.parameters[j]);
            // A shift of temperatures counts from where the problem stands now; its prior and bounds move along.
            solver::FreeParameter& start = own.parameters.back();
            const bool is_shift = start.kind == solver::FreeParameter::Kind::initial;
            const double by = is_shift ? values[static_cast<Eigen::Index>(j)] : 0.0;
            start.prior -= by;
            start.low -= by;
            start.high -= by;
        }
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
    HeldOutErrors found{.left = Eigen::VectorXd::Constant(observations.measured.size(), none)};
    const LinearisedModel linear = linearise(full, observations);
    found.ok = !folds.empty();
    for (const Fold& fold : folds) {
        Eigen::VectorXd values = full.values;
        if (fitted && values.size() > 0) {
            const Observations rest = subset(observations, fold.rest);
            Fit fit(model, rest);
            fit.simulator().take_steps(steps);
            fit.take_covariance(subset(covariance, fold.rest));
            const bool moved =
                fit.move_to(linear_start(linear, full, fit, fold)) || fit.move_to(Eigen::VectorXd(full.values));
            if (!moved) {
                found.ok = false;
                continue;
            }
            values = refit(fit, few_iterations).values;
            found.simulations += fit.simulator().simulations();
            found.values.push_back(values);
        }
        // The runs that are left out, or the whole of those of which a part is.
        const Observations test = subset(observations, fold.test);
        const Simulator numbers(model, test);
        const input::Experiment own = own_numbers_free(model, numbers, values, fold);
        Fit fit(own, test);
        fit.simulator().take_steps(steps);
        fit.take_covariance(subset(covariance, fold.test));
        if (!fit.move_to(fit.simulator().start())) {
            found.ok = false;
            continue;
        }
        const Eigen::VectorXd simulated =
            own.parameters.empty() ? fit.now().simulated : refit(fit, few_iterations).simulated;
        found.simulations += fit.simulator().simulations();
        for (std::size_t i = 0; i < fold.test.size(); ++i) {
            const auto k = static_cast<Eigen::Index>(i);
            found.left[fold.test[i]] = test.measured[k] - simulated[k];
        }
    }
    return found;
}

}  // namespace tiretherm::diagnosis
