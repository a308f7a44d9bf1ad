// SPDX-License-Identifier: BSD-3-Clause
// Regresses what the best hypothesis leaves on each signature alone; the deviation is that of the noise or, where it is larger, of the
// scatter of the score between blocks of time.

#include "diagnosis/assess/upper_limits.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/block_deviations.hpp"
#include "diagnosis/fit/linearised_model.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double wide_of_limit = 1.959964;  // of a normal distribution

/// The best hypothesis, or the base model, with the noise that it was fitted by.
struct JudgedModel {
    const Refit& fit;
    const Covariance& noise;
    bool has_errors;  ///< of its own
};

JudgedModel judged_model(const DiagnosisState& state) {
    const FittedHypothesis* best = state.best();
    if (state.search) {
        return {state.search->best().hypothesis.fit, state.search->best().noise, true};
    }
    const bool has_errors = state.something_left || state.verdict == Verdict::partial;
    return {best != nullptr ? best->fit : state.score_data.base, state.score_data.noise, has_errors};
}

/// Standard deviation of a score that is summed over blocks of time, with Student's t of as many: half of its 95 % interval.
/// @param products [n_rows] of the signature and what it leaves
double half_by_blocks(const Eigen::VectorXd& products, const std::vector<std::size_t>& blocks) {
    const std::size_t n = *std::ranges::max_element(blocks) + 1;
    if (n < 2) {
        return 0.0;
    }
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
    for (std::size_t row = 0; row < blocks.size(); ++row) {
        sums[static_cast<Eigen::Index>(blocks[row])] += products[static_cast<Eigen::Index>(row)];
    }
    const double count = static_cast<double>(n);
    const double square = (sums.array() - sums.mean()).square().sum() * count / (count - 1.0);
    return student(static_cast<int>(n) - 1) * std::sqrt(square);
}

}  // namespace

std::vector<UpperLimit> upper_limits(const DiagnosisState& state) {
    const ScoreTestData& score_data = state.score_data;
    if (score_data.signatures.size() == 0) {
        return {};  // stopped before the first one was found
    }
    const Observations& observations = *score_data.observations;
    const JudgedModel judged = judged_model(state);
    const auto white = [&](Eigen::MatrixXd columns) {
        whiten(observations.blocks, judged.noise, columns);
        return columns;
    };
    const LinearisedModel model = linearise(judged.fit, observations);
    const NuisanceProjector projector(white(model.raw), model.precision);
    const Eigen::MatrixXd columns = white(score_data.signatures);
    const Eigen::MatrixXd signatures = projector.project(columns);
    const Eigen::VectorXd residual = projector.project(white(model.left).col(0), model.known);
    const Scores scores = score(signatures, residual, columns.colwise().norm());
    const bool by_blocks = judged.has_errors && !observations.channels.empty();
    const std::vector<std::size_t> blocks =
        by_blocks ? blocks_of_rows(observations, length_of_blocks(observations, score_data.noise.channels))
                  : std::vector<std::size_t>{};
    std::vector<UpperLimit> limits;
    const FittedHypothesis* best = state.best();
    const auto is_in_answer = [&](const Candidate& candidate) {
        return best != nullptr && std::ranges::any_of(best->candidates, [&](std::size_t k) {
                   return score_data.candidates[k].cause == candidate.cause;
               });
    };
    std::vector<std::size_t> causes;
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
        const Candidate& candidate = score_data.candidates[k];
        const auto i = static_cast<Eigen::Index>(k);
        const double length = scores.length[i];
        if (length == 0.0 || is_in_answer(candidate) || is_common_delay(candidate)) {
            continue;
        }
        const double amplitude = scores.amplitude(i);
        double half = wide_of_limit / length;
        if (by_blocks) {
            const auto n = static_cast<Eigen::Index>(blocks.size());
            const Eigen::VectorXd left = (residual - amplitude * signatures.col(i)).head(n);
            half = std::max(half,
                            half_by_blocks(left.cwiseProduct(signatures.col(i).head(n)), blocks) / (length * length));
        }
        const solver::Problem& problem = score_data.experiment->runs.front().problem;
        const double middle = candidate.absent + amplitude;
        UpperLimit limit{
            .id = std::string(candidate.effect->id),
            .channel = sensors_of(candidate, problem),
            .place = candidate.layer >= 0 ? problem.mesh.layers[static_cast<std::size_t>(candidate.layer)] : "",
            .key = std::string(candidate.number().key),
            .unit = std::string(candidate.number().unit),
            // Data may ask for more than is allowed: both ends are then the bound.
            .low = std::clamp(middle - half, candidate.low, candidate.high),
            .high = std::clamp(middle + half, candidate.low, candidate.high),
            .absent = candidate.absent};
        // Of a cause that was tried at several sizes the widest: its signature changes its shape with its size.
        if (causes.empty() || causes.back() != candidate.cause) {
            causes.push_back(candidate.cause);
            limits.push_back(std::move(limit));
        } else if (limit.high - limit.low > limits.back().high - limits.back().low) {
            limits.back() = std::move(limit);
        }
    }
    return limits;
}

}  // namespace tiretherm::diagnosis
