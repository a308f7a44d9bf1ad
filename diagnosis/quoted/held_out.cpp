// SPDX-License-Identifier: BSD-3-Clause
// Leaves out experiments, judges what is predicted of them, and draws intervals by a bootstrap over experiments.

#include "diagnosis/quoted/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr double significant = 2.0;  ///< total uncertainties, as in the verdicts of `validate`
constexpr double little = 0.1;       ///< total uncertainties
constexpr std::size_t n_resamples = 4000;

bool contains(const std::vector<std::size_t>& all, std::size_t one) { return std::ranges::find(all, one) != all.end(); }

/// Mean square over the rows that count; 0 of none.
template <typename Counts>
double square_of(const std::vector<double>& values, const Counts& counts) {
    double sum = 0.0;
    double n = 0.0;
    for (std::size_t r = 0; r < values.size(); ++r) {
        sum += counts(r) ? values[r] * values[r] : 0.0;
        n += counts(r) ? 1.0 : 0.0;
    }
    return n > 0.0 ? sum / n : 0.0;
}

}  // namespace

Judge::Judge(const Numbers& numbers, std::vector<bool> counts, const std::vector<Addition>& additions,
             const Interactions* interactions)
    : numbers_(numbers), counts_(std::move(counts)), additions_(additions), interactions_(interactions) {
    for (const Addition& addition : additions_) {
        tables_.push_back(addition.table());
    }
    for (std::size_t r = 0; r < numbers_.rows.size(); ++r) {
        if (counts_[r] && !contains(experiments_, numbers_.rows[r].experiment)) {
            experiments_.push_back(numbers_.rows[r].experiment);
        }
    }
}

std::size_t Judge::n_rows() const { return static_cast<std::size_t>(std::ranges::count(counts_, true)); }

bool Judge::matters(std::size_t addition) const {
    for (std::size_t r = 0; r < counts_.size(); ++r) {
        const double enough = little * numbers_.rows[r].total();
        if (counts_[r] && std::ranges::any_of(additions_[addition].changes, [&](const std::vector<double>& node) {
                return std::abs(node[r]) > enough;
            })) {
            return true;
        }
    }
    return false;
}

std::vector<double> Judge::scores(const std::vector<double>& changes) const {
    std::vector<double> found(counts_.size(), 0.0);
    for (std::size_t r = 0; r < counts_.size(); ++r) {
        const QuotedResult& row = numbers_.rows[r];
        found[r] = counts_[r] ? row.residual(row.value + changes[r]) / row.total() : 0.0;
    }
    return found;
}

double Judge::chi_squared(const std::vector<double>& changes) const { return cost(blocks({}), {}, changes); }

std::vector<std::size_t> Judge::off(const std::vector<double>& changes) const {
    const std::vector<double> all = scores(changes);
    std::vector<std::size_t> found;
    for (const std::size_t experiment : experiments_) {
        for (std::size_t r = 0; r < all.size(); ++r) {
            if (numbers_.rows[r].experiment == experiment && std::abs(all[r]) > significant &&
                !contains(found, experiment)) {
                found.push_back(experiment);
            }
        }
    }
    return found;
}

double Judge::mean_square(const std::vector<double>& changes, std::size_t without) const {
    return square_of(scores(changes),
                     [&](std::size_t r) { return counts_[r] && numbers_.rows[r].experiment != without; });
}

double Judge::rms(const std::vector<double>& changes) const {
    return std::sqrt(square_of(scores(changes), [&](std::size_t r) -> bool { return counts_[r]; }));
}

std::vector<double> Judge::or_nothing(const std::vector<double>& reference) const {
    return reference.empty() ? std::vector<double>(counts_.size(), 0.0) : reference;
}

HeldOut Judge::summary(std::vector<double> changes, const std::vector<double>& reference) const {
    HeldOut found{.changes = std::move(changes)};
    std::vector<double> before = scores(or_nothing(reference));
    std::vector<double> after = scores(found.changes);
    found.rms_before = rms(or_nothing(reference));
    found.rms_after = rms(found.changes);
    const auto share = [](double was, double is) { return was > 0.0 ? 1.0 - std::sqrt(is / was) : 0.0; };
    found.removed.value = found.rms_before > 0.0 ? 1.0 - found.rms_after / found.rms_before : 0.0;
    std::vector<std::array<double, 2>> sums;
    for (const std::size_t experiment : experiments_) {
        const auto its = [&](std::size_t r) { return counts_[r] && numbers_.rows[r].experiment == experiment; };
        double n = 0.0;
        for (std::size_t r = 0; r < counts_.size(); ++r) {
            n += its(r) ? 1.0 : 0.0;
        }
        const double was = square_of(before, its);
        const double is = square_of(after, its);
        sums.push_back({n * was, n * is});
        if (std::sqrt(was) - std::sqrt(is) > little) {
            found.better.push_back(experiment);
        }
    }
    const auto temperatures = [&](std::size_t r) {
        return counts_[r] && numbers_.rows[r].is_temperature() && !numbers_.rows[r].is_open;
    };
    for (std::size_t r = 0; r < counts_.size(); ++r) {
        before[r] *= numbers_.rows[r].total();
        after[r] *= numbers_.rows[r].total();
    }
    found.kelvin_before = std::sqrt(square_of(before, temperatures));
    found.kelvin_after = std::sqrt(square_of(after, temperatures));
    // Experiments are drawn, not rows: those of one experiment share its faults.
    std::mt19937_64 engine(2014);
    std::vector<double> drawn(n_resamples);
    for (double& one : drawn) {
        double was = 0.0;
        double is = 0.0;
        for (std::size_t k = 0; k < experiments_.size(); ++k) {
            const std::array<double, 2>& sum = sums[engine() % experiments_.size()];
            was += sum[0];
            is += sum[1];
        }
        one = share(was, is);
    }
    std::ranges::sort(drawn);
    found.removed.low = drawn[n_resamples / 40];
    found.removed.high = drawn[n_resamples - 1 - n_resamples / 40];
    return found;
}

std::vector<double> Judge::leave_out_each(
    const std::function<std::vector<double>(std::size_t experiment)>& changes_without, std::size_t but) const {
    std::vector<double> changes(counts_.size(), 0.0);
    for (const std::size_t experiment : experiments_) {
        if (experiment == but) {
            continue;
        }
        const std::vector<double> predicted = changes_without(experiment);
        for (std::size_t r = 0; r < counts_.size(); ++r) {
            changes[r] = numbers_.rows[r].experiment == experiment ? predicted[r] : changes[r];
        }
    }
    return changes;
}

HeldOut Judge::held_out(const AdditionSet& chosen, const std::vector<double>& reference) const {
    return held_out_choice([&](std::size_t) { return chosen; }, reference);
}

HeldOut Judge::held_out_choice(const std::function<AdditionSet(std::size_t without)>& choose,
                               const std::vector<double>& reference) const {
    return summary(leave_out_each([&](std::size_t experiment) {
                       const AdditionSet chosen = choose(experiment);
                       return fit(blocks(chosen), chosen, {experiment}, false).changes;
                   }),
                   reference);
}

double Judge::left_out_error(const AdditionSet& chosen, std::size_t without) const {
    const std::vector<Block> all = blocks(chosen);
    const auto changes_without = [&](std::size_t experiment) {
        return fit(all, chosen, {experiment, without}, false).changes;
    };
    return std::sqrt(mean_square(leave_out_each(changes_without, without), without));
}

}  // namespace tiretherm::diagnosis::quoted
