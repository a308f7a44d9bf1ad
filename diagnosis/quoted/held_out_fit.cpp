// SPDX-License-Identifier: BSD-3-Clause
// Fits the numbers of additions: least squares over whole experiments, whitened by what their rows share.

#include "diagnosis/quoted/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <Eigen/Cholesky>

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr double of_interval = 3.84;  ///< rise of chi squared at the ends of a 95 % interval of one number
constexpr std::size_t most_passes = 40;
constexpr std::size_t coarse = 12;  ///< steps of the values in which the start of a fit of two numbers is sought

/// An addition with its changes at all of its values.
struct Chosen {
    const Addition* addition;
    const std::vector<std::vector<double>>* table;
    std::vector<const std::vector<double>*>
        with;  ///< [chosen] its interactions with the others; empty ones change nothing

    [[nodiscard]] std::size_t nearest_absent() const {
        const double share =
            addition->is_fitted() ? (addition->absent - addition->low) / (addition->high - addition->low) : 0.0;
        return static_cast<std::size_t>(
            std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(table->size() - 1)));
    }
    /// How far a value is from absent, 1 where interactions were simulated.
    [[nodiscard]] double share(std::size_t i) const {
        return (addition->value(i) - addition->absent) / (addition->reference() - addition->absent);
    }
};

/// Indices of the values of some additions at which chi squared, and what their own ranges say, is least.
class ValueSearch {
public:
    using Indices = std::vector<std::size_t>;

    /// @param cost chi squared of changes [rows]
    ValueSearch(std::vector<Chosen> chosen, std::size_t n_rows,
                std::function<double(const std::vector<double>& changes)> cost)
        : chosen_(std::move(chosen)), n_rows_(n_rows), cost_(std::move(cost)) {}

    [[nodiscard]] std::vector<double> changes(const Indices& at) const {
        std::vector<double> sum(n_rows_, 0.0);
        for (std::size_t k = 0; k < at.size(); ++k) {
            add((*chosen_[k].table)[at[k]], 1.0, sum);
            for (std::size_t j = 0; j < k; ++j) {
                add(*chosen_[k].with[j], chosen_[k].share(at[k]) * chosen_[j].share(at[j]), sum);
            }
        }
        return sum;
    }
    [[nodiscard]] double cost(const Indices& at) const { return cost_(changes(at)) + penalties(at); }
    /// Where nothing is changed; of two numbers the best of a coarse grid, for two that compensate each other have a valley
    /// that single steps do not follow.
    [[nodiscard]] Indices start() const {
        Indices at;
        std::ranges::transform(chosen_, std::back_inserter(at), &Chosen::nearest_absent);
        if (at.size() == 2) {
            double best = cost(at);
            for (std::size_t a = 0; a < chosen_[0].table->size(); a += coarse) {
                for (std::size_t b = 0; b < chosen_[1].table->size(); b += coarse) {
                    if (const double now = cost({a, b}); now < best) {
                        best = now;
                        at = {a, b};
                    }
                }
            }
        }
        return at;
    }
    /// Moves one number after the other to its best value; `held` stays. @returns the cost there
    double descend(Indices& at, std::size_t held) const {
        double best = cost(at);
        for (std::size_t pass = 0; pass < most_passes; ++pass) {
            const Indices before = at;
            for (std::size_t k = 0; k < at.size(); ++k) {
                if (k != held) {
                    best = descend_along(at, k, best);
                }
            }
            if (at == before || at.size() == 1) {
                break;
            }
        }
        return best;
    }

private:
    static void add(const std::vector<double>& changes, double factor, std::vector<double>& sum) {
        for (std::size_t r = 0; r < changes.size(); ++r) {
            sum[r] += factor * changes[r];
        }
    }
    [[nodiscard]] double penalties(const Indices& at) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < at.size(); ++k) {
            sum += chosen_[k].addition->penalty(chosen_[k].addition->value(at[k]));
        }
        return sum;
    }
    /// Moves one number to its best value: in coarse steps, then in finer ones about the best. @returns the cost there
    double descend_along(Indices& at, std::size_t k, double best) const {
        const std::vector<std::vector<double>>& table = *chosen_[k].table;
        Indices absent = at;
        absent[k] = chosen_[k].nearest_absent();
        std::vector<double> others(n_rows_, 0.0);  // at any value of this number
        std::vector<double> with(n_rows_, 0.0);    // their interactions with it, at its reference value
        for (std::size_t j = 0; j < at.size(); ++j) {
            if (j == k) {
                continue;
            }
            add((*chosen_[j].table)[at[j]], 1.0, others);
            add(*chosen_[k].with[j], chosen_[j].share(at[j]), with);
            for (std::size_t i = 0; i < j; ++i) {
                if (i != k) {
                    add(*chosen_[j].with[i], chosen_[j].share(at[j]) * chosen_[i].share(at[i]), others);
                }
            }
        }
        const double of_others =
            penalties(absent) - chosen_[k].addition->penalty(chosen_[k].addition->value(absent[k]));
        std::vector<double> sum;
        const auto look = [&](std::size_t v) {
            sum = others;
            add(table[v], 1.0, sum);
            add(with, chosen_[k].share(v), sum);
            const double now = cost_(sum) + of_others + chosen_[k].addition->penalty(chosen_[k].addition->value(v));
            if (now < best * (1.0 - 1e-12)) {
                best = now;
                at[k] = v;
            }
        };
        for (std::size_t v = 0; v < table.size(); v += coarse) {
            look(v);
        }
        for (std::size_t step = coarse / 4, reach = coarse; step > 0; reach = step, step /= 3) {
            const std::size_t middle = at[k];
            for (std::size_t v = middle > reach ? middle - reach : 0; v < table.size() && v <= middle + reach;
                 v += step) {
                look(v);
            }
        }
        return best;
    }

    std::vector<Chosen> chosen_;
    std::size_t n_rows_;
    std::function<double(const std::vector<double>& changes)> cost_;
};

}  // namespace

std::vector<Judge::Block> Judge::blocks(const std::vector<std::size_t>& chosen) const {
    std::vector<int> free;
    for (const std::size_t addition : chosen) {
        if (additions_[addition].input >= 0) {
            free.push_back(additions_[addition].input);
        }
    }
    std::vector<Block> all;
    for (const std::size_t experiment : experiments_) {
        Block block{.experiment = experiment, .rows = {}, .whitening = {}};
        for (std::size_t r = 0; r < counts_.size(); ++r) {
            if (counts_[r] && numbers_.rows[r].experiment == experiment) {
                block.rows.push_back(r);
            }
        }
        const Eigen::MatrixXd covariance = numbers_.covariance(block.rows, free);
        const Eigen::Index n = covariance.rows();
        block.whitening = covariance.llt().matrixL().solve(Eigen::MatrixXd::Identity(n, n));
        all.push_back(std::move(block));
    }
    return all;
}

double Judge::cost(const std::vector<Block>& blocks, const std::vector<std::size_t>& left_out,
                   const std::vector<double>& changes) const {
    double sum = 0.0;
    for (const Block& block : blocks) {
        if (std::ranges::count(left_out, block.experiment) > 0) {
            continue;
        }
        Eigen::VectorXd residuals(static_cast<Eigen::Index>(block.rows.size()));
        std::ranges::transform(block.rows, residuals.begin(), [&](std::size_t r) {
            return numbers_.rows[r].residual(numbers_.rows[r].value + changes[r]);
        });
        sum += (block.whitening * residuals).squaredNorm();
    }
    return sum;
}

AdditionFit Judge::fit(const std::vector<Block>& blocks, const AdditionSet& chosen,
                       const std::vector<std::size_t>& left_out, bool with_interval) const {
    static const std::vector<double> nothing;
    std::vector<Chosen> all;
    for (const std::size_t one : chosen) {
        all.push_back({.addition = &additions_[one], .table = &tables_[one], .with = {}});
        for (const std::size_t other : chosen) {
            all.back().with.push_back(interactions_ == nullptr || one == other ? &nothing
                                                                               : &interactions_->of(one, other));
        }
    }
    const std::size_t n = all.size();
    const ValueSearch search(all, numbers_.rows.size(),
                             [&](const std::vector<double>& changes) { return cost(blocks, left_out, changes); });
    AdditionFit found;
    ValueSearch::Indices at = search.start();
    const double lowest = search.descend(at, n);
    found.changes = search.changes(at);
    found.chi_squared = cost(blocks, left_out, found.changes);
    found.cost = lowest;
    for (std::size_t k = 0; k < n; ++k) {
        const bool at_end = at[k] == 0 || at[k] + 1 == all[k].table->size();
        found.values.push_back(all[k].addition->value(at[k]));
        found.is_bound.push_back(all[k].addition->is_fitted() && at_end && at[k] != all[k].nearest_absent());
    }
    found.low = found.high = found.values;
    if (!with_interval) {
        return found;
    }
    std::size_t n_fitted = 0;
    for (const Block& block : blocks) {
        n_fitted += std::ranges::count(left_out, block.experiment) > 0 ? 0 : block.rows.size();
    }
    const double freedom = std::max(1.0, static_cast<double>(n_fitted) - static_cast<double>(n));
    const double rise = of_interval * std::max(1.0, found.chi_squared / freedom);
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t v = 0; v < all[k].table->size() && all[k].addition->is_fitted(); ++v) {
            ValueSearch::Indices trial = at;
            trial[k] = v;
            if (search.descend(trial, k) <= lowest + rise) {
                found.low[k] = std::min(found.low[k], all[k].addition->value(v));
                found.high[k] = std::max(found.high[k], all[k].addition->value(v));
            }
        }
    }
    return found;
}

AdditionFit Judge::fit(const AdditionSet& chosen, const std::vector<std::size_t>& left_out) const {
    return fit(blocks(chosen), chosen, left_out, true);
}

AdditionFit Judge::fit_alone(const AdditionSet& chosen) const { return fit(blocks(chosen), chosen, {}, false); }

}  // namespace tiretherm::diagnosis::quoted
