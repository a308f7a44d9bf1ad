// SPDX-License-Identifier: BSD-3-Clause
// Fits the numbers of additions: least squares over whole experiments, whitened by what their rows share.

#include "diagnosis/quoted/held_out.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr double of_interval = 3.84;  ///< rise of chi squared at the ends of a 95 % interval of one number
constexpr std::size_t most_passes = 40;
constexpr std::size_t coarse = 12;  ///< steps of the values in which the start of a fit of two numbers is sought

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
        const std::size_t n = block.rows.size();
        for (std::size_t i = 0; i < n; ++i) {
            double white = 0.0;
            for (std::size_t j = 0; j <= i; ++j) {
                const Row& row = numbers_.rows[block.rows[j]];
                white += block.whitening(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *
                         row.residual(row.value + changes[block.rows[j]]);
            }
            sum += white * white;
        }
    }
    return sum;
}

AdditionFit Judge::fit(const std::vector<Block>& blocks, const std::vector<std::size_t>& chosen,
                       const std::vector<std::size_t>& left_out, bool with_interval) const {
    const std::size_t n = chosen.size();
    const auto table = [&](std::size_t k) -> const std::vector<std::vector<double>>& { return tables_[chosen[k]]; };
    const auto nearest_absent = [&](std::size_t k) {
        const Addition& one = additions_[chosen[k]];
        const double share = one.is_fitted() ? (one.absent - one.low) / (one.high - one.low) : 0.0;
        return static_cast<std::size_t>(
            std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(table(k).size() - 1)));
    };
    const auto changes_at = [&](const std::vector<std::size_t>& at) {
        std::vector<double> sum(numbers_.rows.size(), 0.0);
        for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t r = 0; r < sum.size(); ++r) {
                sum[r] += table(k)[at[k]][r];
            }
        }
        return sum;
    };
    /// Chi squared of the rows, and what the numbers' own ranges say.
    const auto cost_at = [&](const std::vector<std::size_t>& at) {
        double sum = cost(blocks, left_out, changes_at(at));
        for (std::size_t k = 0; k < n; ++k) {
            sum += additions_[chosen[k]].penalty(additions_[chosen[k]].value(at[k]));
        }
        return sum;
    };
    /// Moves one number after the other to its best value; `held` stays.
    const auto descend = [&](std::vector<std::size_t>& at, std::size_t held) {
        double best = cost_at(at);
        for (std::size_t pass = 0; pass < most_passes; ++pass) {
            bool moved = false;
            for (std::size_t k = 0; k < n; ++k) {
                std::vector<std::size_t> trial = at;
                for (trial[k] = 0; k != held && trial[k] < table(k).size(); ++trial[k]) {
                    if (const double now = cost_at(trial); now < best * (1.0 - 1e-12)) {
                        best = now;
                        at[k] = trial[k];
                        moved = true;
                    }
                }
            }
            if (!moved || n == 1) {
                break;
            }
        }
        return best;
    };
    std::vector<std::size_t> at(n);
    for (std::size_t k = 0; k < n; ++k) {
        at[k] = nearest_absent(k);
    }
    if (n == 2) {  // two numbers that compensate each other have a valley that single steps do not follow
        double best = cost_at(at);
        for (std::size_t a = 0; a < table(0).size(); a += coarse) {
            for (std::size_t b = 0; b < table(1).size(); b += coarse) {
                if (const double now = cost_at({a, b}); now < best) {
                    best = now;
                    at = {a, b};
                }
            }
        }
    }
    AdditionFit found;
    const double lowest = descend(at, n);
    found.changes = changes_at(at);
    found.chi_squared = cost(blocks, left_out, found.changes);
    for (std::size_t k = 0; k < n; ++k) {
        const Addition& one = additions_[chosen[k]];
        found.values.push_back(one.value(at[k]));
        const bool at_end = at[k] == 0 || at[k] + 1 == table(k).size();
        found.is_bound.push_back(one.is_fitted() && at_end && at[k] != nearest_absent(k));
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
        for (std::size_t v = 0; v < table(k).size() && additions_[chosen[k]].is_fitted(); ++v) {
            std::vector<std::size_t> trial = at;
            trial[k] = v;
            if (descend(trial, k) <= lowest + rise) {
                found.low[k] = std::min(found.low[k], additions_[chosen[k]].value(v));
                found.high[k] = std::max(found.high[k], additions_[chosen[k]].value(v));
            }
        }
    }
    return found;
}

AdditionFit Judge::fit(const std::vector<std::size_t>& chosen, const std::vector<std::size_t>& left_out) const {
    return fit(blocks(chosen), chosen, left_out, true);
}

}  // namespace tiretherm::diagnosis::quoted
