// SPDX-License-Identifier: BSD-3-Clause
// Sets of additions by the error on experiments left out, those that cannot be told apart, and the verdict.

#include "diagnosis/quoted/quoted_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagnosis/detect/work_ahead.hpp"
#include "diagnosis/quoted/next_measurement.hpp"
#include "diagnosis/quoted/set_search.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr double alarm = 2.33;        ///< standard deviations: one in a hundred by chance
constexpr double single_alarm = 3.5;  ///< u: one number of twenty passes it once in a hundred tables by chance
constexpr double as_good = 9.0;       ///< rise of chi squared up to which an explanation is kept: 3 standard deviations
constexpr std::size_t enough = 3;     ///< experiments that must show something before a rule can be tested on others
constexpr std::size_t most_in_pool = 20;  ///< additions of which sets are made: those that fit best alone
constexpr std::size_t most_kept = 6;      ///< sets that agree
constexpr double worth_one_more =
    0.01;  ///< share of the error on experiments left out that one more addition must remove

/// How much too large chi squared is, in standard deviations (Wilson and Hilferty, PNAS 17, 1931, 684).
double significance_of(double chi_squared, double n) {
    if (n <= 0.0) {
        return 0.0;
    }
    const double variance = 2.0 / (9.0 * n);
    return (std::cbrt(chi_squared / n) - (1.0 - variance)) / std::sqrt(variance);
}

/// Rows that can deviate by chance: a number inside of a measured range, or an order that holds, cannot.
double freedom(const Numbers& numbers, const std::vector<bool>& counts, const std::vector<double>& scores) {
    double n = 0.0;
    for (std::size_t r = 0; r < counts.size(); ++r) {
        const QuotedResult& row = numbers.rows[r];
        n += counts[r] && (row.low == row.high || scores[r] != 0.0) ? 1.0 : 0.0;
    }
    return n;
}

/// Works out one analysis from additions that have been simulated alone.
class Analyst {
public:
    Analyst(const Numbers& numbers, const std::vector<Addition>& alone, Interactions& interactions, Trials& trials)
        : numbers_(numbers), alone_(alone), interactions_(interactions), trials_(trials) {}

    [[nodiscard]] Analysis analyse(std::vector<bool> counts) {
        Analysis result{.counts = std::move(counts)};
        const Judge judge(numbers_, result.counts, alone_, &interactions_);
        const std::vector<double> nothing(numbers_.rows.size(), 0.0);
        result.n_rows = judge.n_rows();
        result.experiments = judge.experiments();
        result.off = judge.off(nothing);
        result.after = nothing;
        result.chi_squared = judge.chi_squared(nothing);
        result.significance =
            significance_of(judge.chi_squared(nothing), freedom(numbers_, result.counts, judge.scores(nothing)));
        try_each(judge, result);
        const std::vector<double> scores = judge.scores(nothing);
        const bool is_off = result.significance > alarm ||
                            std::ranges::any_of(scores, [](double score) { return std::abs(score) > single_alarm; });
        if (is_off && result.experiments.size() >= enough) {
            try_sets(judge, result);
        }
        conclude(judge, result, is_off);
        return result;
    }

private:
    /// Whether nothing significant is left where additions are fitted.
    [[nodiscard]] bool fits(const Judge& judge, const Analysis& result, const AdditionFit& fit) const {
        const double n = freedom(numbers_, result.counts, judge.scores(fit.changes));
        return judge.off(fit.changes).empty() &&
               significance_of(fit.chi_squared, n - static_cast<double>(fit.values.size())) < alarm;
    }

    void try_each(const Judge& judge, Analysis& result) {
        const HeldOut base = judge.held_out({});
        result.rms = base.rms_before;
        result.kelvin = base.kelvin_before;
        pool_.clear();
        std::vector<double> costs(alone_.size(), 0.0);
        for (std::size_t a = 0; a < alone_.size(); ++a) {
            if (!judge.matters(a)) {
                ++result.without_effect;
                continue;
            }
            SingleAddition attempt{.addition = alone_[a], .fit = judge.fit({a}, {}), .held_out = judge.held_out({a})};
            attempt.rms_fitted = judge.rms(attempt.fit.changes);
            attempt.fits = fits(judge, result, attempt.fit);
            costs[a] = attempt.fit.cost;
            if (alone_[a].is_fitted()) {  // another mesh stands for itself: it has causes of its own
                pool_.push_back(a);
            }
            result.attempts.push_back(std::move(attempt));
        }
        std::ranges::stable_sort(pool_, {}, [&](std::size_t a) { return costs[a]; });
        pool_.resize(std::min(pool_.size(), most_in_pool));
        // By whole per cent; what removes alike much stands by how well it fits.
        std::ranges::stable_sort(result.attempts, [](const SingleAddition& a, const SingleAddition& b) {
            const long more = std::lround(100.0 * a.held_out.removed.value);
            const long less = std::lround(100.0 * b.held_out.removed.value);
            return more != less ? more > less : a.rms_fitted < b.rms_fitted;
        });
    }

    /// A search of which the cost is still to be said.
    [[nodiscard]] SetSearch search() const {
        return {.pool = pool_,
                .most = most_additions,
                .are_one_cause = [&](std::size_t a, std::size_t b) { return alone_[a].is_same_cause(alone_[b]); },
                .prepare = [&](const AdditionSet& set) { interactions_.know(set); },
                .cost = {}};
    }
    [[nodiscard]] SetOfAdditions described(const Judge& judge, const Analysis& result, const AdditionSet& set) const {
        SetOfAdditions found{.fit = judge.fit(set, {}), .held_out = judge.held_out(set)};
        for (const std::size_t one : set) {
            found.additions.push_back(alone_[one]);
        }
        found.rms_fitted = judge.rms(found.fit.changes);
        found.fits = fits(judge, result, found.fit);
        return found;
    }

    void try_sets(const Judge& judge, Analysis& result) {
        const auto is_enough = [&](const AdditionSet& set) {
            return !set.empty() && fits(judge, result, judge.fit_alone(set));
        };
        SetSearch by_prediction = search();
        by_prediction.cost = [&](const AdditionSet& set) { return judge.left_out_error(set); };
        by_prediction.is_enough = is_enough;
        by_prediction.least_gain = worth_one_more;
        std::vector<double> reference;
        for (const AdditionSet& set : best_sets(by_prediction)) {
            if (set.empty()) {
                continue;
            }
            SetOfAdditions found = described(judge, result, set);
            found.further = judge.held_out(set, reference);
            if (found.further.removed.low > 0.0) {
                found.choice = judge.held_out_choice(
                    [&](std::size_t without) { return chosen_without(judge, without, set.size()); }, reference);
            }
            result.sizes.push_back(found);
            if (found.further.removed.low > 0.0 && found.choice.removed.low > 0.0) {
                reference = found.held_out.changes;
                result.accepted = std::move(found);
                accepted_ = set;
            }
        }
        if (result.accepted && result.accepted->fits) {
            return;
        }
        SetSearch by_fit = search();
        by_fit.cost = [&](const AdditionSet& set) { return judge.fit_alone(set).cost; };
        by_fit.is_enough = is_enough;
        const AdditionSet last = best_sets(by_fit).back();
        if (is_enough(last)) {
            find_agreeing(judge, result, last);
        }
    }

    /// The set that would be chosen if one experiment were not known.
    [[nodiscard]] AdditionSet chosen_without(const Judge& judge, std::size_t experiment, std::size_t size) const {
        SetSearch blind = search();
        blind.most = size;
        blind.cost = [&](const AdditionSet& set) { return judge.left_out_error(set, experiment); };
        blind.looks_back = false;
        return best_sets(blind).back();
    }

    /// Sets with one addition exchanged, or the set itself, that cost little more than it. @returns the set itself first, then
    /// by chi squared
    [[nodiscard]] std::vector<AdditionSet> about_as_good(const Judge& judge, const Analysis& result,
                                                         const AdditionSet& best,
                                                         const std::vector<std::size_t>& among) const {
        const AdditionFit of_best = judge.fit_alone(best);
        const double dof = std::max(1.0, static_cast<double>(result.n_rows) - static_cast<double>(best.size()));
        const double rise = as_good * std::max(1.0, of_best.chi_squared / dof);
        std::vector<std::pair<double, AdditionSet>> found;
        for (std::size_t place = 0; place < best.size(); ++place) {
            for (const std::size_t other : among) {
                AdditionSet trial = best;
                const bool is_known = std::ranges::any_of(
                    best, [&](std::size_t one) { return alone_[one].is_same_cause(alone_[other]); });
                trial[place] = other;
                if (is_known) {
                    continue;
                }
                interactions_.know(trial);
                if (const AdditionFit fit = judge.fit_alone(trial); fit.chi_squared <= of_best.chi_squared + rise) {
                    found.emplace_back(fit.chi_squared, std::move(trial));
                }
            }
        }
        std::ranges::stable_sort(found, {}, &std::pair<double, AdditionSet>::first);
        std::vector<AdditionSet> all{best};
        std::ranges::transform(found, std::back_inserter(all), &std::pair<double, AdditionSet>::second);
        return all;
    }

    void find_agreeing(const Judge& judge, Analysis& result, const AdditionSet& best) {
        for (const AdditionSet& set : about_as_good(judge, result, best, pool_)) {
            if (!fits(judge, result, judge.fit_alone(set))) {
                continue;
            }
            ++result.n_agreeing;
            if (result.agreeing.size() < most_kept) {
                result.agreeing.push_back(described(judge, result, set));
            }
        }
    }

    void simulate(const Judge& judge, Analysis& result, const SetOfAdditions& set) {
        const std::vector<double> simulated = trials_.together(set.applied(), numbers_);
        result.after = simulated.empty() ? set.fit.changes : simulated;
        for (std::size_t r = 0; r < result.after.size(); ++r) {
            result.surrogate_error = std::max(
                result.surrogate_error,
                result.counts[r] ? std::abs(result.after[r] - set.fit.changes[r]) / numbers_.rows[r].total() : 0.0);
        }
        result.off_after = judge.off(result.after);
        result.rms_after = judge.rms(result.after);
        result.significance_after = significance_of(
            judge.chi_squared(result.after),
            freedom(numbers_, result.counts, judge.scores(result.after)) - static_cast<double>(set.additions.size()));
    }

    void conclude(const Judge& judge, Analysis& result, bool is_off) {
        if (!is_off) {
            result.verdict = result.n_rows < enough ? Verdict::cannot_tell : Verdict::consistent;
            return;
        }
        if (!result.accepted) {
            if (!result.agreeing.empty()) {
                simulate(judge, result, result.agreeing.front());
            }
            result.verdict = result.off.size() < enough || result.experiments.size() < enough ? Verdict::cannot_tell
                                                                                              : Verdict::unknown;
            return;
        }
        simulate(judge, result, *result.accepted);
        find_set(judge, result);
        const bool is_left = result.significance_after > alarm;
        result.verdict = is_left ? Verdict::partial : result.set.size() == 1 ? Verdict::named : Verdict::confounded;
    }

    /// All that fit the rows nearly as well as what was accepted, each member exchanged for another addition in turn.
    void find_set(const Judge& judge, Analysis& result) {
        std::vector<std::size_t> among = pool_;
        for (std::size_t a = 0; accepted_.size() == 1 && a < alone_.size(); ++a) {
            if (judge.matters(a) && std::ranges::find(pool_, a) == pool_.end()) {
                among.push_back(a);
            }
        }
        for (const AdditionSet& set : about_as_good(judge, result, accepted_, among)) {
            std::vector<std::string> names;
            for (const std::size_t one : set) {
                names.push_back(alone_[one].name());
            }
            for (SingleAddition& attempt : result.attempts) {
                attempt.in_set = attempt.in_set || std::ranges::find(names, attempt.addition.name()) != names.end();
            }
            result.set.push_back(std::move(names));
        }
    }

    const Numbers& numbers_;
    const std::vector<Addition>& alone_;
    Interactions& interactions_;
    Trials& trials_;
    std::vector<std::size_t> pool_{};
    AdditionSet accepted_{};
};

}  // namespace

std::string SetOfAdditions::name() const {
    std::string text;
    for (const Addition& one : additions) {
        text += (text.empty() ? "" : " + ") + one.name();
    }
    return text;
}

std::vector<Applied> SetOfAdditions::applied() const {
    std::vector<Applied> all;
    for (std::size_t k = 0; k < additions.size(); ++k) {
        all.push_back({.addition = &additions[k], .value = fit.values[k]});
    }
    return all;
}

QuotedDiagnosis diagnose_quoted(const input::Validation& validation, Trials& trials, std::size_t model) {
    QuotedDiagnosis result{.numbers = quoted_numbers(validation, trials.table(), model)};
    std::vector<Addition> alone;
    for (Addition& addition : trials.additions(result.numbers)) {
        trials.simulate(addition, result.numbers);
        if (solver::stop_requested()) {
            result.stopped = true;
            return result;
        }
        if (addition.is_simulated) {
            alone.push_back(std::move(addition));
        } else {
            result.not_simulated.push_back(addition.name());
        }
    }
    std::vector<bool> decidable;
    for (const QuotedResult& row : result.numbers.rows) {
        decidable.push_back(row.decidable);
    }
    Interactions interactions(alone, result.numbers, trials);
    Analyst analyst(result.numbers, alone, interactions, trials);
    result.decidable = analyst.analyse(decidable);
    result.all = analyst.analyse(std::vector<bool>(decidable.size(), true));
    result.next = next_measurement(result.numbers, result.decidable, result.all, trials);
    result.simulations = trials.simulations();
    result.stopped = solver::stop_requested();
    return result;
}

}  // namespace tiretherm::diagnosis::quoted
