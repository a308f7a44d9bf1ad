// SPDX-License-Identifier: BSD-3-Clause
// Compares the best explanations in every temperature of every test, and in the quoted numbers with each input known.

#include "diagnosis/quoted/next_measurement.hpp"

#include <algorithm>
#include <cmath>

#include "solver/order_statistics.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr std::size_t most_rivals = 4;
constexpr double little_left = 0.7;  ///< of the rms that a rival may leave where it is fitted

/// An explanation that is compared with others.
struct Rival {
    std::string name;
    std::vector<Applied> applied;
    const std::vector<double>* changes;  ///< [rows]
};

/// The explanations that are compared: those that cannot be told apart, or else the sets that agree, or else the additions that fit
/// best alone.
std::vector<Rival> rivals_of(const Analysis& analysis) {
    std::vector<Rival> found;
    // The members of a set that was accepted are one explanation.
    const bool is_one = !analysis.accepted || analysis.accepted->additions.size() == 1;
    const bool any_set = is_one && std::ranges::count_if(analysis.attempts, &SingleAddition::in_set) > 1;
    for (const SetOfAdditions& set : analysis.agreeing) {
        if (!any_set && found.size() < most_rivals) {
            found.push_back({.name = set.name(), .applied = set.applied(), .changes = &set.fit.changes});
        }
    }
    if (found.size() > 1 || !is_one) {
        return found;
    }
    found.clear();
    std::vector<const SingleAddition*> all;
    for (const SingleAddition& attempt : analysis.attempts) {
        if (any_set ? attempt.in_set : attempt.rms_fitted < little_left * analysis.rms) {
            all.push_back(&attempt);
        }
    }
    std::ranges::stable_sort(
        all, [](const SingleAddition* a, const SingleAddition* b) { return a->rms_fitted < b->rms_fitted; });
    for (const SingleAddition* attempt : all) {
        const bool is_new = std::ranges::none_of(
            found, [&](const Rival& one) { return one.applied.front().addition->is_same_cause(attempt->addition); });
        if (is_new && found.size() < most_rivals) {
            found.push_back({.name = attempt->addition.name(),
                             .applied = {{.addition = &attempt->addition, .value = attempt->fit.values.front()}},
                             .changes = &attempt->fit.changes});
        }
    }
    return found;
}

/// The median of the uncertainties of temperatures, K.
double achievable(const Numbers& numbers) {
    std::vector<double> all;
    for (const QuotedResult& row : numbers.rows) {
        if (row.is_temperature() && !row.is_open) {
            all.push_back(row.uncertainty);
        }
    }
    return all.empty() ? 1.0 : solver::median(std::move(all));
}

/// The input whose knowledge adds most to chi squared between two explanations.
void find_input(const Numbers& numbers, const Rival& one, const Rival& other, NextMeasurement& next) {
    for (const UnknownInput& input : numbers.inputs) {
        double gain = 0.0;
        for (std::size_t r = 0; r < numbers.rows.size(); ++r) {
            const QuotedResult& row = numbers.rows[r];
            const double variance = row.total() * row.total();
            const double without = std::max(row.uncertainty * row.uncertainty, variance - input.covariance(r, r));
            const double apart =
                row.residual(row.value + (*one.changes)[r]) - row.residual(row.value + (*other.changes)[r]);
            gain += apart * apart * (1.0 / without - 1.0 / variance);
        }
        if (gain > next.input_gain) {
            next.input_gain = gain;
            next.input = input.name;
        }
    }
}

}  // namespace

std::optional<NextMeasurement> next_measurement(const Numbers& numbers, const Analysis& decidable, const Analysis& all,
                                                Trials& trials) {
    std::vector<Rival> rivals = rivals_of(decidable);
    rivals = rivals.size() < 2 ? rivals_of(all) : rivals;
    if (rivals.size() < 2) {
        return std::nullopt;
    }
    // Where the model is off a measurement settles most; elsewhere the explanations may all be wrong.
    const std::vector<std::size_t>& off = decidable.off.empty() ? all.off : decidable.off;
    std::vector<std::size_t> of;
    for (const QuotedResult& row : numbers.rows) {
        if (off.empty() || std::ranges::find(off, row.experiment) != off.end()) {
            of.push_back(row.number);
        }
    }
    std::vector<std::vector<ChannelEnd>> ends;
    for (const Rival& rival : rivals) {
        ends.push_back(trials.ends(rival.applied, of));
    }
    NextMeasurement next{.uncertainty = achievable(numbers)};
    const Rival* one = nullptr;
    const Rival* other = nullptr;
    double widest = 0.0;
    for (std::size_t a = 0; a < rivals.size(); ++a) {
        for (std::size_t b = a + 1; b < rivals.size(); ++b) {
            for (const ChannelEnd& end : ends[a]) {
                const auto same = std::ranges::find_if(ends[b], [&](const ChannelEnd& candidate) {
                    return candidate.run == end.run && candidate.channel == end.channel;
                });
                if (same != ends[b].end() && std::abs(same->value - end.value) > widest) {
                    widest = std::abs(same->value - end.value);
                    one = &rivals[a];
                    other = &rivals[b];
                    next.run = end.run;
                    next.channel = end.channel;
                    next.value_of_one = end.value;
                    next.value_of_other = same->value;
                }
            }
        }
    }
    if (one == nullptr) {
        return std::nullopt;
    }
    next.one = one->name;
    next.other = other->name;
    find_input(numbers, *one, *other, next);
    return next;
}

}  // namespace tiretherm::diagnosis::quoted
