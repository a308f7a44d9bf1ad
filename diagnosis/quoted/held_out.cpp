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

}  // namespace

Judge::Judge(const Numbers& numbers, std::vector<bool> counts, const std::vector<Addition>& additions)
    : numbers_(numbers), counts_(std::move(counts)), additions_(additions) {
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
        const Row& row = numbers_.rows[r];
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
    const std::vector<double> all = scores(changes);
    double sum = 0.0;
    double n = 0.0;
    for (std::size_t r = 0; r < all.size(); ++r) {
        if (counts_[r] && numbers_.rows[r].experiment != without) {
            sum += all[r] * all[r];
            n += 1.0;
        }
    }
    return n > 0.0 ? sum / n : 0.0;
}

std::vector<double> Judge::or_nothing(const std::vector<double>& reference) const {
    return reference.empty() ? std::vector<double>(counts_.size(), 0.0) : reference;
}

HeldOut Judge::summary(std::vector<double> changes, const std::vector<double>& reference) const {
    HeldOut found{.changes = std::move(changes)};
    const std::vector<double> before = scores(or_nothing(reference));
    const std::vector<double> after = scores(found.changes);
    std::vector<std::array<double, 2>> sums(experiments_.size(), {0.0, 0.0});
    std::vector<double> n(experiments_.size(), 0.0);
    double temperatures = 0.0;
    for (std::size_t r = 0; r < counts_.size(); ++r) {
        if (!counts_[r]) {
            continue;
        }
        const Row& row = numbers_.rows[r];
        const auto e = static_cast<std::size_t>(std::ranges::find(experiments_, row.experiment) - experiments_.begin());
        sums[e][0] += before[r] * before[r];
        sums[e][1] += after[r] * after[r];
        n[e] += 1.0;
        if (row.is_temperature() && !row.is_open) {
            found.kelvin_before += std::pow(before[r] * row.total(), 2);
            found.kelvin_after += std::pow(after[r] * row.total(), 2);
            temperatures += 1.0;
        }
    }
    found.kelvin_before = std::sqrt(found.kelvin_before / std::max(temperatures, 1.0));
    found.kelvin_after = std::sqrt(found.kelvin_after / std::max(temperatures, 1.0));
    double total_before = 0.0;
    double total_after = 0.0;
    double total = 0.0;
    for (std::size_t e = 0; e < experiments_.size(); ++e) {
        total_before += sums[e][0];
        total_after += sums[e][1];
        total += n[e];
        if (std::sqrt(sums[e][0] / n[e]) - std::sqrt(sums[e][1] / n[e]) > little) {
            found.better.push_back(experiments_[e]);
        }
    }
    const auto share = [](double was, double is) { return was > 0.0 ? 1.0 - std::sqrt(is / was) : 0.0; };
    found.rms_before = std::sqrt(total_before / std::max(total, 1.0));
    found.rms_after = std::sqrt(total_after / std::max(total, 1.0));
    found.removed.value = share(total_before, total_after);
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

HeldOut Judge::held_out(const std::vector<std::size_t>& chosen, const std::vector<double>& reference) const {
    const std::vector<Block> all = blocks(chosen);
    std::vector<double> changes(counts_.size(), 0.0);
    for (const std::size_t experiment : experiments_) {
        const AdditionFit others = fit(all, chosen, {experiment}, false);
        for (std::size_t r = 0; r < counts_.size(); ++r) {
            changes[r] = numbers_.rows[r].experiment == experiment ? others.changes[r] : changes[r];
        }
    }
    return summary(std::move(changes), reference);
}

HeldOut Judge::held_out_choice(const std::vector<std::size_t>& chosen, const std::vector<double>& reference) const {
    std::vector<double> changes(counts_.size(), 0.0);
    std::vector<std::vector<std::size_t>> trials;
    std::vector<std::vector<Block>> of_trials;
    for (std::size_t a = 0; a < additions_.size(); ++a) {
        const bool is_known =
            std::ranges::any_of(chosen, [&](std::size_t one) { return additions_[one].is_same_cause(additions_[a]); });
        if (!is_known && matters(a)) {
            trials.push_back(chosen);
            trials.back().push_back(a);
            of_trials.push_back(blocks(trials.back()));
        }
    }
    for (const std::size_t experiment : experiments_) {
        std::vector<double> prediction = or_nothing(reference);
        double best = mean_square(prediction, experiment);
        for (std::size_t t = 0; t < trials.size(); ++t) {
            std::vector<double> inner(counts_.size(), 0.0);
            for (const std::size_t other : experiments_) {
                if (other == experiment) {
                    continue;
                }
                const AdditionFit rest = fit(of_trials[t], trials[t], {experiment, other}, false);
                for (std::size_t r = 0; r < counts_.size(); ++r) {
                    inner[r] = numbers_.rows[r].experiment == other ? rest.changes[r] : inner[r];
                }
            }
            if (const double now = mean_square(inner, experiment); now < best) {
                best = now;
                prediction = fit(of_trials[t], trials[t], {experiment}, false).changes;
            }
        }
        for (std::size_t r = 0; r < counts_.size(); ++r) {
            changes[r] = numbers_.rows[r].experiment == experiment ? prediction[r] : changes[r];
        }
    }
    return summary(std::move(changes), reference);
}

}  // namespace tiretherm::diagnosis::quoted
