// SPDX-License-Identifier: BSD-3-Clause
// Greedy choice of additions by the error on experiments left out, the set that cannot be told apart, and the verdict.

#include "diagnosis/quoted/quoted_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnosis/quoted/next_measurement.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr double alarm = 2.33;        ///< standard deviations: one in a hundred by chance
constexpr double single_alarm = 3.5;  ///< u: one number of twenty passes it once in a hundred tables by chance
constexpr double as_good = 9.0;       ///< rise of chi squared up to which an explanation is kept: 3 standard deviations
constexpr std::size_t enough = 3;     ///< experiments that must show something before a rule can be tested on others
constexpr std::size_t on_fine_mesh = 6;  ///< additions that are tried on top of a finer mesh, for its runs are long

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
    Analyst(const Numbers& numbers, const std::vector<Addition>& alone, Trials& trials, std::size_t most_steps)
        : numbers_(numbers), alone_(alone), trials_(trials), most_steps_(most_steps) {}

    [[nodiscard]] Analysis analyse(std::vector<bool> counts) {
        Analysis result{.counts = std::move(counts)};
        const Judge judge(numbers_, result.counts, alone_);
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
            add_steps(result);
        }
        conclude(judge, result, is_off);
        return result;
    }

private:
    void try_each(const Judge& judge, Analysis& result) {
        const HeldOut base = judge.held_out({});
        result.rms = base.rms_before;
        result.kelvin = base.kelvin_before;
        for (std::size_t a = 0; a < alone_.size(); ++a) {
            if (!judge.matters(a)) {
                ++result.without_effect;
                continue;
            }
            SingleAddition attempt{.addition = alone_[a], .fit = judge.fit({a}, {}), .held_out = judge.held_out({a})};
            const std::vector<double> scores = judge.scores(attempt.fit.changes);
            attempt.rms_fitted = judge.rms(attempt.fit.changes);
            attempt.fits =
                judge.off(attempt.fit.changes).empty() &&
                significance_of(attempt.fit.chi_squared, freedom(numbers_, result.counts, scores) - 1.0) < alarm;
            result.attempts.push_back(std::move(attempt));
        }
        // By whole per cent; what removes alike much stands by how well it fits.
        std::ranges::stable_sort(result.attempts, [](const SingleAddition& a, const SingleAddition& b) {
            const long more = std::lround(100.0 * a.held_out.removed.value);
            const long less = std::lround(100.0 * b.held_out.removed.value);
            return more != less ? more > less : a.rms_fitted < b.rms_fitted;
        });
    }

    [[nodiscard]] std::vector<Applied> accepted(const Analysis& result) const {
        std::vector<Applied> applied;
        for (std::size_t k = 0; k < chosen_.size(); ++k) {
            applied.push_back({.addition = &chosen_[k], .value = result.fit.values[k]});
        }
        return applied;
    }
    [[nodiscard]] std::vector<std::size_t> indices_of_chosen() const {
        std::vector<std::size_t> all(chosen_.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        return all;
    }

    /// The additions of a step: those accepted as they are alone, then all others on top of them.
    [[nodiscard]] std::vector<Addition> on_top(const Analysis& result) {
        std::vector<Addition> all = chosen_;
        const std::vector<Applied> applied = accepted(result);
        const bool is_fine =
            std::ranges::any_of(chosen_, [](const Addition& one) { return one.kind == AdditionKind::mesh; });
        std::size_t tried = 0;
        for (const SingleAddition& attempt : result.attempts) {
            const bool is_known =
                std::ranges::any_of(chosen_, [&](const Addition& one) { return one.is_same_cause(attempt.addition); });
            if (is_known || solver::stop_requested()) {
                continue;
            }
            Addition next = attempt.addition;
            const bool simulates = next.kind == AdditionKind::effect || next.kind == AdditionKind::number ||
                                   next.kind == AdditionKind::mesh;
            if (is_fine && simulates && ++tried > on_fine_mesh) {
                continue;
            }
            trials_.simulate(next, numbers_, applied);
            if (next.is_simulated) {
                all.push_back(std::move(next));
            }
        }
        return all;
    }

    void add_steps(Analysis& result) {
        std::vector<double> reference;
        chosen_.clear();
        result.fit = {};
        while (chosen_.size() < most_steps_ && !solver::stop_requested()) {
            const std::vector<Addition> all = chosen_.empty() ? alone_ : on_top(result);
            const Judge judge(numbers_, result.counts, all);
            const std::vector<std::size_t> before = indices_of_chosen();
            std::optional<std::size_t> best;
            HeldOut of_best;
            for (std::size_t a = before.size(); a < all.size(); ++a) {
                std::vector<std::size_t> trial = before;
                trial.push_back(a);
                HeldOut now = judge.matters(a) ? judge.held_out(trial, reference) : HeldOut{};
                if (judge.matters(a) && (!best || now.rms_after < of_best.rms_after)) {
                    best = a;
                    of_best = std::move(now);
                }
            }
            if (!best || of_best.removed.low <= 0.0) {
                return;
            }
            HeldOut choice = judge.held_out_choice(before, reference);
            if (choice.removed.low <= 0.0) {
                return;
            }
            std::vector<std::size_t> now = before;
            now.push_back(*best);
            result.fit = judge.fit(now, {});
            result.steps.push_back({.addition = all[*best],
                                    .held_out = judge.held_out(now),
                                    .further = of_best,
                                    .choice = std::move(choice)});
            reference = of_best.changes;
            chosen_.push_back(all[*best]);
        }
    }

    void conclude(const Judge& judge, Analysis& result, bool is_off) {
        if (!is_off) {
            result.verdict = result.n_rows < enough ? Verdict::cannot_tell : Verdict::consistent;
            return;
        }
        if (result.steps.empty()) {
            result.verdict = result.off.size() < enough || result.experiments.size() < enough ? Verdict::cannot_tell
                                                                                              : Verdict::unknown;
            return;
        }
        const std::vector<double> simulated = trials_.together(accepted(result), numbers_);
        result.after = simulated.empty() ? result.fit.changes : simulated;
        for (std::size_t r = 0; r < result.after.size(); ++r) {
            result.surrogate_error = std::max(
                result.surrogate_error,
                result.counts[r] ? std::abs(result.after[r] - result.fit.changes[r]) / numbers_.rows[r].total() : 0.0);
        }
        result.off_after = judge.off(result.after);
        result.significance_after = significance_of(
            judge.chi_squared(result.after),
            freedom(numbers_, result.counts, judge.scores(result.after)) - static_cast<double>(chosen_.size()));
        find_set(result);
        const bool is_left = result.significance_after > alarm;
        result.verdict = is_left ? Verdict::partial : result.set.size() == 1 ? Verdict::named : Verdict::confounded;
    }

    /// All that fit the rows nearly as well as what was accepted, each member exchanged for another addition in turn.
    void find_set(Analysis& result) {
        std::vector<Addition> all = chosen_;
        for (const SingleAddition& attempt : result.attempts) {
            all.push_back(attempt.addition);
        }
        const Judge judge(numbers_, result.counts, all);
        const std::size_t n = chosen_.size();
        const double dof = std::max(1.0, static_cast<double>(result.n_rows) - static_cast<double>(n));
        const double limit = result.fit.chi_squared + as_good * std::max(1.0, result.fit.chi_squared / dof);
        const auto names = [&](const std::vector<std::size_t>& chosen) {
            std::vector<std::string> found;
            for (const std::size_t one : chosen) {
                found.push_back(all[one].name());
            }
            return found;
        };
        const std::vector<std::size_t> before = indices_of_chosen();
        result.set.push_back(names(before));
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t a = n; a < all.size(); ++a) {
                const bool is_known =
                    std::ranges::any_of(before, [&](std::size_t one) { return all[one].is_same_cause(all[a]); });
                std::vector<std::size_t> trial = before;
                trial[k] = a;
                if (!is_known && judge.fit(trial, {}).chi_squared <= limit) {
                    result.set.push_back(names(trial));
                    result.attempts[a - n].in_set = true;
                }
            }
        }
        for (SingleAddition& attempt : result.attempts) {
            attempt.in_set = attempt.in_set || std::ranges::any_of(chosen_, [&](const Addition& one) {
                                 return one.name() == attempt.addition.name();
                             });
        }
    }

    const Numbers& numbers_;
    const std::vector<Addition>& alone_;
    Trials& trials_;
    std::size_t most_steps_;
    std::vector<Addition> chosen_{};
};

}  // namespace

QuotedDiagnosis diagnose_quoted(const input::Validation& validation, Trials& trials, const QuotedRequest& request) {
    QuotedDiagnosis result{.numbers = quoted_numbers(validation, trials.table(), request.model)};
    std::vector<Addition> alone;
    for (Addition& addition : trials.additions(result.numbers)) {
        trials.simulate(addition, result.numbers, {});
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
    Analyst analyst(result.numbers, alone, trials, request.most_steps);
    result.decidable = analyst.analyse(decidable);
    result.all = analyst.analyse(std::vector<bool>(decidable.size(), true));
    result.next = next_measurement(result.numbers, result.decidable, result.all, trials);
    result.simulations = trials.simulations();
    result.stopped = solver::stop_requested();
    return result;
}

}  // namespace tiretherm::diagnosis::quoted
