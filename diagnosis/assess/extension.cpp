// SPDX-License-Identifier: BSD-3-Clause
// Builds the model of the causes, starts it at the values of the hypothesis before, and fits it.

#include "diagnosis/assess/extension.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace tiretherm::diagnosis {

namespace {

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
void fit_from(const ScoreTestData& score_data, const Values& from, const Covariance& noise, int turns,
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
    one.simulations += fit.simulator().simulations();
    one.sound = one.fit.status.ok() && one.fit.values.size() > 0;
}

constexpr int few_turns = 6;
constexpr int many_turns = 12;

/// Of the causes from `first` on one that ended where it changes nothing, or else at the end of what is plausible.
std::optional<std::size_t> to_be_left_out(const ScoreTestData& score_data, const FittedHypothesis& one,
                                          std::size_t first) {
    std::optional<std::size_t> at_end;
    for (std::size_t i = first; i < one.candidates.size(); ++i) {
        const Eigen::Index j = one.number_of(i);
        if (one.fit.values[j] == score_data.candidates[one.candidates[i]].absent) {
            return i;
        }
        if (!at_end && one.fit.at_bound[static_cast<std::size_t>(j)]) {
            at_end = i;
        }
    }
    return at_end;
}

}  // namespace

FittedHypothesis extended(const ScoreTestData& score_data, const FittedHypothesis& from,
                          const std::vector<std::size_t>& added, const std::vector<double>& amplitudes,
                          const Covariance& noise) {
    std::vector<std::size_t> causes = from.candidates;
    Values values = values_of(score_data, from);
    const std::vector<double> from_absent = with_timing_shared(score_data, added, amplitudes);
    for (std::size_t i = 0; i < added.size(); ++i) {
        const Candidate& candidate = score_data.candidates[added[i]];
        const auto [low, high] = plausible_bounds(candidate);
        causes.push_back(added[i]);
        values.cause.push_back(std::clamp(candidate.absent + from_absent[i], low, high));
        std::vector<double>& held = values.held.emplace_back();
        for (const Candidate::Held& number : candidate.held) {
            held.push_back(number.value);
        }
    }
    FittedHypothesis one = unfitted(score_data, causes);
    fit_from(score_data, values, noise, few_turns, one);
    // What is added together need not be wrong together: the rest is fitted without the part that does not fit in.
    std::optional<std::size_t> misfit;
    while (one.sound && (misfit = to_be_left_out(score_data, one, from.candidates.size())) &&
           one.candidates.size() > from.candidates.size() + 1) {
        const long before = one.simulations;
        one = reduced(score_data, one, *misfit, noise);
        one.simulations += before;
    }
    if (!one.sound) {
        return one;
    }
    one.gain = 0.5 * (from.fit.cost - one.fit.cost);
    one.admissible = !misfit;
    for (std::size_t i = 0; i < from.candidates.size(); ++i) {
        one.admissible = one.admissible && !one.fit.at_bound[static_cast<std::size_t>(one.number_of(i))];
    }
    return one;
}

FittedHypothesis reduced(const ScoreTestData& score_data, const FittedHypothesis& from, std::size_t cause,
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

FittedHypothesis refitted(const ScoreTestData& score_data, const FittedHypothesis& from, const Covariance& noise) {
    FittedHypothesis one = unfitted(score_data, from.candidates);
    fit_from(score_data, values_of(score_data, from), noise, many_turns, one);
    one.admissible = one.sound;
    return one;
}

FittedHypothesis as_it_stands(const ScoreTestData& score_data, const Covariance& noise) {
    FittedHypothesis one = unfitted(score_data, {});
    const Simulator simulator(one.model, *score_data.observations);
    Values values;
    values.base = simulator.start();
    fit_from(score_data, values, noise, 0, one);
    one.admissible = one.sound;
    return one;
}

}  // namespace tiretherm::diagnosis
