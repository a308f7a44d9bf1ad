// SPDX-License-Identifier: BSD-3-Clause
// Adds the candidates of sensors and inputs to the normal equations of a fit, and looks at what that does to its numbers.

#include "diagnosis/assess/instrument_doubt.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Cholesky>

#include "diagnosis/noise/white_equivalent.hpp"

namespace tiretherm::diagnosis {

namespace {

bool is_instrument(const Candidate& candidate) {
    return candidate.effect->sensor_model() != nullptr || candidate.effect->input_correction() != nullptr;
}

/// Whether a sensor or an input is wrong whichever member of the set is right: then instruments are not what the case says, and others
/// may be wrong, too.
bool names_instrument(const DiagnosisState& state) {
    return !state.set.empty() && std::ranges::all_of(state.set, [&](const FittedHypothesis* member) {
        return std::ranges::any_of(member->candidates, [&](std::size_t candidate) {
            return is_instrument(state.score_data.candidates[candidate]);
        });
    });
}

/// Sensors and inputs that may be wrong beside a model, each once. @returns indices into ScoreTestData::candidates
std::vector<Eigen::Index> instruments_beside(const ScoreTestData& score_data, const std::vector<std::size_t>& on) {
    std::vector<Eigen::Index> found;
    std::set<std::size_t> causes;
    for (std::size_t k = 0; k < static_cast<std::size_t>(score_data.signatures.cols()); ++k) {
        const Candidate& candidate = score_data.candidates[k];
        const bool fits_in = std::ranges::all_of(
            on, [&](std::size_t other) { return can_stand_beside(candidate, score_data.candidates[other]); });
        if (is_instrument(candidate) && fits_in && causes.insert(candidate.cause).second) {
            found.push_back(static_cast<Eigen::Index>(k));
        }
    }
    return found;
}

/// Mean square of the distance of a candidate's number to where it changes nothing: there it is likeliest, and towards the ends of its
/// plausible range ever less likely, so that the density is a triangle.
double mean_square_of(const Candidate& candidate) {
    const auto [low, high] = plausible_bounds(candidate);
    const double below = low - candidate.absent;
    const double above = high - candidate.absent;
    return (below * below + below * above + above * above) / 6.0;
}

}  // namespace

Eigen::VectorXd deviations_by_instruments(const ScoreTestData& score_data, const Refit& fit,
                                          const std::vector<std::size_t>& on) {
    Eigen::VectorXd found = Eigen::VectorXd::Zero(fit.values.size());
    std::vector<Eigen::Index> free;
    for (Eigen::Index j = 0; j < fit.values.size(); ++j) {
        if (fit.at_bound.empty() || !fit.at_bound[static_cast<std::size_t>(j)]) {
            free.push_back(j);
        }
    }
    const std::vector<Eigen::Index> instruments = instruments_beside(score_data, on);
    if (free.empty() || instruments.empty()) {
        return found;
    }
    const Observations& observations = *score_data.observations;
    const auto n = static_cast<Eigen::Index>(free.size());
    const auto m = static_cast<Eigen::Index>(instruments.size());
    Eigen::MatrixXd white(fit.raw.rows(), n + m);
    white << fit.raw(Eigen::all, free), score_data.signatures(Eigen::all, instruments);
    whiten(observations.blocks,
           white_noise_of(observations.measured - fit.simulated, observations.blocks, observations.channels.size()),
           white);
    for (Eigen::Index k = 0; k < m; ++k) {  // in units of what is plausible
        const Eigen::Index candidate = instruments[static_cast<std::size_t>(k)];
        white.col(n + k) *= std::sqrt(mean_square_of(score_data.candidates[static_cast<std::size_t>(candidate)]));
    }
    Eigen::MatrixXd information = white.transpose() * white;
    information.topLeftCorner(n, n).diagonal() += fit.precision(free).cwiseMax(1e-12);
    information.bottomRightCorner(m, m).diagonal().array() += 1.0;
    const Eigen::MatrixXd moves = information.topLeftCorner(n, n).ldlt().solve(information.topRightCorner(n, m));
    const Eigen::MatrixXd left_open = information.bottomRightCorner(m, m) - information.bottomLeftCorner(m, n) * moves;
    const Eigen::VectorXd variance = (moves * left_open.ldlt().solve(moves.transpose())).diagonal();
    for (Eigen::Index j = 0; j < n; ++j) {
        found[free[static_cast<std::size_t>(j)]] =
            std::sqrt(std::max(0.0, variance[j])) * fit.scale[free[static_cast<std::size_t>(j)]];
    }
    return found;
}

void widen_by_instruments(const DiagnosisState& state, Diagnosis& into) {
    const bool is_missing = into.verdict != Verdict::consistent && is_doubted(state);
    if (!is_missing && !names_instrument(state)) {
        return;
    }
    const FittedHypothesis* best = state.best();
    const std::vector<std::size_t> on = best != nullptr ? best->candidates : std::vector<std::size_t>{};
    const Eigen::VectorXd deviations =
        deviations_by_instruments(state.score_data, best != nullptr ? best->fit : state.score_data.base, on);
    const auto widen = [&](auto& number, std::size_t j, double factor) {
        const double by = 1.959964 * std::abs(factor) * deviations[static_cast<Eigen::Index>(j)];
        number.low = number.value - std::hypot(number.value - number.low, by);
        number.high = number.value + std::hypot(number.high - number.value, by);
    };
    for (std::size_t j = 0; j < into.free_numbers.size(); ++j) {
        FreeNumber& number = into.free_numbers[j];
        const solver::FreeParameter& parameter = state.score_data.experiment->parameters[j];
        widen(number, j, 1.0);
        number.low = std::max(parameter.low, number.low);
        number.high = std::min(parameter.high, number.high);
    }
    std::size_t members = on.size();
    for (Cause& cause : into.causes) {
        if (cause.kind == CauseKind::effect && members > 0) {
            for (CauseNumber& number : cause.numbers) {
                widen(number, number.fitted, number.factor);
            }
            --members;
        }
    }
}

}  // namespace tiretherm::diagnosis
