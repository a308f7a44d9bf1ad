// SPDX-License-Identifier: BSD-3-Clause
// Numbers of a cause with their 95 % intervals, what they are at their bounds and beside what is plausible.

#include "diagnosis/assess/cause_description.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "input/text/word_lists.hpp"
#include "physics/plausible_ranges.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double of_95_percent = 1.959964;  // of a normal distribution

}  // namespace

Cause describe_cause(const ScoreTestData& score_data, const FittedHypothesis& one, std::size_t i) {
    const solver::Problem& problem = score_data.experiment->runs.front().problem;
    const Candidate& candidate = score_data.candidates[one.candidates[i]];
    Cause cause{.id = std::string(candidate.effect->id)};
    if (candidate.on >= 0) {
        cause.instead_of = candidate.absent;
    }
    cause.channel = sensors_of(candidate, problem);
    if (candidate.layer >= 0) {
        cause.place = problem.mesh.layers[static_cast<std::size_t>(candidate.layer)];
    }
    const Eigen::VectorXd deviation = one.fit.deviations();
    const auto add = [&](Eigen::Index j, std::size_t parameter, double factor) {
        const physics::ParameterSpec& number = candidate.effect->parameters[parameter];
        const double value = one.fit.values[j];
        const auto [low, high] = std::minmax({factor * std::max(number.low, value - of_95_percent * deviation[j]),
                                              factor * std::min(number.high, value + of_95_percent * deviation[j])});
        cause.numbers.push_back({.key = std::string(number.key),
                                 .unit = std::string(number.unit),
                                 .value = factor * value,
                                 .low = low,
                                 .high = high,
                                 .fitted = static_cast<std::size_t>(j),
                                 .factor = factor});
    };
    const Eigen::Index j = one.number_of(i);
    add(j, candidate.parameter, 1.0);
    cause.numbers.back().absent = candidate.absent;
    for (const solver::FreeParameter::Companion& companion : candidate.companions) {
        add(j, companion.parameter, companion.factor);
    }
    Eigen::Index held = one.fit.values.size() - one.n_held;
    for (std::size_t before = 0; before < i; ++before) {
        held += static_cast<Eigen::Index>(score_data.candidates[one.candidates[before]].held.size());
    }
    for (const Candidate::Held& number : candidate.held) {
        add(held++, number.parameter, 1.0);
    }
    // What the likelihood says where the number is alone; a number that is nearly free makes its own deviation a poor guide. A search by
    // prediction does not weigh likelihoods.
    cause.sigma = one.candidates.size() == 1 && one.gain > 0.0
                      ? std::sqrt(2.0 * std::max(0.0, one.gain))
                      : (deviation[j] > 0.0 ? std::abs(one.fit.values[j] - candidate.absent) / deviation[j] : 0.0);
    cause.gain = one.gain;
    if (one.fit.at_bound[static_cast<std::size_t>(j)]) {
        cause.at_bound = true;
    } else if (const physics::PlausibleRange* range = physics::plausible_range(*candidate.effect, candidate.parameter);
               range != nullptr && !physics::is_plausible(*range, one.fit.values[j])) {
        cause.implausible = range;
    }
    return cause;
}

std::size_t n_causes(const ScoreTestData& score_data) {
    std::set<std::size_t> causes;
    for (const Candidate& candidate : score_data.candidates) {
        causes.insert(candidate.cause);
    }
    return causes.size();
}

void Cause::widen(const std::vector<double>& half) {
    for (CauseNumber& number : numbers) {
        const double reach = std::abs(number.factor) * half[number.fitted];
        number.low = std::min(number.low, number.value - reach);
        number.high = std::max(number.high, number.value + reach);
    }
}

bool Cause::may_be_absent() const {
    return std::ranges::any_of(numbers, [](const CauseNumber& number) {
        return number.absent && number.low <= *number.absent && *number.absent <= number.high;
    });
}

bool withdraw_what_may_be_absent(Diagnosis& diagnosis) {
    // A mesh has no number: beside causes that may all be absent it proves nothing either.
    const auto may_be_absent = [&](const std::vector<std::size_t>& member) {
        const auto has_number = [&](std::size_t cause) { return !diagnosis.causes[cause].numbers.empty(); };
        return std::ranges::any_of(member, has_number) && std::ranges::all_of(member, [&](std::size_t cause) {
                   return !has_number(cause) || diagnosis.causes[cause].may_be_absent();
               });
    };
    if (diagnosis.hypotheses.empty() || !diagnosis.gain.measured ||
        !std::ranges::all_of(diagnosis.hypotheses, may_be_absent)) {
        return false;
    }
    // Blocks of a single recording have predicted each other, and no other recording.
    diagnosis.gain.confirmed = diagnosis.gain.confirmed && !diagnosis.gain.within_run;
    if (diagnosis.gain.confirmed) {
        return false;
    }
    std::vector<std::string> names;
    for (const std::size_t cause : diagnosis.hypotheses.front()) {
        names.push_back(diagnosis.causes[cause].id);
    }
    diagnosis.reason = remark::may_be_absent(input::listed(names), 100.0 * diagnosis.gain.removed);
    diagnosis.verdict = Verdict::cannot_tell;
    diagnosis.hypotheses.clear();
    diagnosis.held_out_gains.clear();
    diagnosis.gain = {};
    for (Cause& cause : diagnosis.causes) {
        cause.in_set = false;
    }
    diagnosis.extended_model.reset();
    diagnosis.extended = diagnosis.base;
    diagnosis.free_numbers.clear();
    diagnosis.model_error.clear();
    for (ChannelGain& channel : diagnosis.channels) {
        channel.rmse_after = channel.rmse_before;
    }
    return true;
}

}  // namespace tiretherm::diagnosis
