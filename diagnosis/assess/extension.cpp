// SPDX-License-Identifier: BSD-3-Clause
// Builds the model of the causes, starts it at the values of the hypothesis before, and fits it.

#include "diagnosis/assess/extension.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "diagnosis/fit/held_out.hpp"
#include "diagnosis/fit/linearised_model.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Standard deviations by which a cause that is added must differ from none.
constexpr double least_sigma = 2.0;

/// Values of a model's numbers by what they are, to be put together for another model.
struct Values {
    Eigen::VectorXd base;                   ///< of the experiment's own numbers
    std::vector<double> cause;              ///< [n_causes]
    std::vector<std::vector<double>> held;  ///< [n_causes][numbers held on trial]
};

Values values_of(const ScoreTestData& score_data, const FittedHypothesis& hypothesis) {
    Values values;
    const auto n = static_cast<Eigen::Index>(score_data.experiment->parameters.size());
    values.base = hypothesis.fit.values.head(n);
    Eigen::Index held = hypothesis.fit.values.size() - hypothesis.n_held;
    for (std::size_t i = 0; i < hypothesis.candidates.size(); ++i) {
        values.cause.push_back(hypothesis.fit.values[hypothesis.number_of(i)]);
        std::vector<double>& own = values.held.emplace_back();
        for (std::size_t k = 0; k < score_data.candidates[hypothesis.candidates[i]].held.size(); ++k) {
            own.push_back(hypothesis.fit.values[held++]);
        }
    }
    return values;
}

Eigen::VectorXd joined(const Values& values) {
    std::vector<double> all(values.base.begin(), values.base.end());
    all.insert(all.end(), values.cause.begin(), values.cause.end());
    for (const std::vector<double>& own : values.held) {
        all.insert(all.end(), own.begin(), own.end());
    }
    return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Sizes stay within what is plausible.
void bound(const ScoreTestData& score_data, FittedHypothesis& one) {
    const std::size_t first = score_data.experiment->parameters.size();
    for (std::size_t i = 0; i < one.candidates.size(); ++i) {
        solver::FreeParameter& number = one.model.parameters[first + i];
        std::tie(number.low, number.high) = plausible_bounds(score_data.candidates[one.candidates[i]]);
    }
}

/// @param turns of Gauss and Newton at most
void fit_from(ScoreTestData& score_data, const Values& from, const Covariance& noise, int turns,
              FittedHypothesis& one) {
    bound(score_data, one);
    Fit fit(one.model, *score_data.observations);
    fit.simulator().take_steps(score_data.steps);
    fit.take_covariance(noise);
    if (fit.move_to(joined(from))) {
        one.fit = refit(fit, turns);
    } else {
        one.fit.status = fit.now().status;
    }
    score_data.count(fit.simulator().simulations());
    one.sound = one.fit.status.ok() && one.fit.values.size() > 0;
}

constexpr int few_turns = 6;
constexpr int many_turns = 12;

}  // namespace

FittedHypothesis extended(ScoreTestData& score_data, const FittedHypothesis& from, std::size_t candidate,
                          const Covariance& noise) {
    std::vector<std::size_t> causes = from.candidates;
    causes.push_back(candidate);
    FittedHypothesis one = unfitted(score_data, causes);
    Values values = values_of(score_data, from);
    const Candidate& added = score_data.candidates[candidate];
    const Scores scores = scores_beside(score_data, from, noise);
    const auto [low, high] = plausible_bounds(added);
    values.cause.push_back(
        std::clamp(added.absent + scores.amplitude(static_cast<Eigen::Index>(candidate)), low, high));
    std::vector<double>& held = values.held.emplace_back();
    for (const Candidate::Held& number : added.held) {
        held.push_back(number.value);
    }
    fit_from(score_data, values, noise, few_turns, one);
    if (!one.sound) {
        return one;
    }
    one.gain = 0.5 * (from.fit.cost - one.fit.cost);
    const Eigen::VectorXd deviation = one.fit.deviations();
    const Eigen::Index j = one.number_of(one.candidates.size() - 1);
    one.admissible = !one.fit.at_bound[static_cast<std::size_t>(j)] &&
                     std::abs(one.fit.values[j] - added.absent) > least_sigma * deviation[j];
    for (std::size_t i = 0; i < one.candidates.size(); ++i) {
        one.admissible = one.admissible && !one.fit.at_bound[static_cast<std::size_t>(one.number_of(i))];
    }
    return one;
}

FittedHypothesis reduced(ScoreTestData& score_data, const FittedHypothesis& from, std::size_t cause,
                         const Covariance& noise) {
    Values values = values_of(score_data, from);
    std::vector<std::size_t> causes = from.candidates;
    const auto i = static_cast<std::ptrdiff_t>(cause);
    causes.erase(causes.begin() + i);
    values.cause.erase(values.cause.begin() + i);
    values.held.erase(values.held.begin() + i);
    FittedHypothesis one = unfitted(score_data, causes);
    fit_from(score_data, values, noise, few_turns, one);
    one.admissible = one.sound;
    return one;
}

FittedHypothesis refitted(ScoreTestData& score_data, const FittedHypothesis& from, const Covariance& noise) {
    FittedHypothesis one = unfitted(score_data, from.candidates);
    fit_from(score_data, values_of(score_data, from), noise, many_turns, one);
    one.admissible = one.sound;
    return one;
}

FittedHypothesis as_it_stands(ScoreTestData& score_data, const Covariance& noise) {
    FittedHypothesis one = unfitted(score_data, {});
    const Simulator simulator(one.model, *score_data.observations);
    Values values;
    values.base = simulator.start();
    fit_from(score_data, values, noise, 0, one);
    one.admissible = one.sound;
    return one;
}

Covariance noise_beside(ScoreTestData& score_data, const FittedHypothesis& hypothesis) {
    Fit fit(hypothesis.model, *score_data.observations);
    fit.simulator().take_steps(score_data.steps);
    fit.take_covariance(score_data.noise);
    if (!fit.move_to(hypothesis.fit.values)) {
        return score_data.noise;
    }
    fit.find_noise(score_data.principal_signatures(hypothesis.fit));
    score_data.count(fit.simulator().simulations());
    return fit.covariance();
}

Scores scores_beside(const ScoreTestData& score_data, const FittedHypothesis& hypothesis, const Covariance& noise) {
    const Observations& observations = *score_data.observations;
    const auto white = [&](Eigen::MatrixXd columns) {
        whiten(observations.blocks, noise, columns);
        return columns;
    };
    const Eigen::MatrixXd columns = white(score_data.signatures);
    const Eigen::MatrixXd left = white(observations.measured - hypothesis.fit.simulated);
    const NuisanceProjector projector(white(hypothesis.fit.raw), hypothesis.fit.precision);
    return score(projector.project(columns), projector.project(left.col(0), hypothesis.fit.known),
                 columns.colwise().norm());
}

double linear_gain(const ScoreTestData& score_data, const FittedHypothesis& before, const FittedHypothesis& after) {
    const Observations& observations = *score_data.observations;
    const auto predicted = [&](const FittedHypothesis& hypothesis) {
        HeldOutErrors out{.left = Eigen::VectorXd::Constant(observations.measured.size(), std::nan(""))};
        const LinearisedModel model = linearise(hypothesis.fit, observations);
        for (const Fold& fold : folds_of(observations)) {
            std::vector<bool> own(hypothesis.model.parameters.size(), false);
            for (std::size_t j = 0; j < own.size(); ++j) {
                own[j] = fold.alone_has(hypothesis.model.parameters[j]);
            }
            out.left(fold.test) = left_of(model, solve(model, fold.rest), fold.test, own);
        }
        return out;
    };
    const HeldOutErrors one = predicted(before);
    const HeldOutErrors other = predicted(after);
    double removed = 0.0;
    double counted = 0.0;
    for (std::size_t c = 0; c < observations.channels.size(); ++c) {
        const double square = one.mean_square(observations, c);
        if (square > 0.0) {
            removed += 1.0 - other.mean_square(observations, c) / square;
            counted += 1.0;
        }
    }
    return counted > 0.0 ? removed / counted : 0.0;
}

}  // namespace tiretherm::diagnosis
