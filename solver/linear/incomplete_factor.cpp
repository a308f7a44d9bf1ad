// SPDX-License-Identifier: BSD-3-Clause
// Incomplete Cholesky preconditioner without fill that keeps row sums (MIC(0)), in the order of blocks that do
// not touch, and conjugate gradients on it that need no product with the matrix (Eisenstat).

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"
#include "solver/linear/block_order.hpp"
#include "solver/linear/factor.hpp"

namespace tiretherm::solver {

namespace {

/// A pivot this small beside its diagonal means that the factor has broken down.
constexpr double smallest_pivot = 1e-12;
/// Share of the fill that is taken off the diagonal instead of being kept: a little less than all of it, so that a matrix
/// whose rows sum to nearly nothing keeps its pivots.
constexpr double fill_to_diagonal = 0.98;
constexpr int most_iterations = 2000;

/// M = (D + L) D^-1 (D + L'), L being the lower triangle of the matrix, with D such that M has the matrix' diagonal and
/// nearly its row sums: Gustafsson, BIT 18 (1978) 142-156. Kept scaled by D^-1/2 on both sides, M is (I + L)(I + L').
/// In that scale conjugate gradients need one backward and one forward sweep an iteration, and no product with the
/// matrix: Eisenstat, SIAM J. Sci. Stat. Comput. 2 (1981) 1-4. All is kept in the order of the blocks, of which those of a
/// phase are swept side by side; what an iteration does to a node before and after a sweep, it does as the sweep passes.
class IncompleteFactor final : public Factor {
public:
    explicit IncompleteFactor(const Pattern& pattern) : order_(block_order_of(pattern)), start_(1, 0) {
        const std::vector<int> place = places_in(order_);
        own_end_.reserve(place.size());
        start_.reserve(place.size() + 1);
        diagonal_of_.reserve(place.size());
        column_.reserve((pattern.nonzeros() - place.size()) / 2);
        source_.reserve(column_.capacity());
        for (std::size_t b = 0; b < blocks(); ++b) {
            for (std::size_t i = begin_of(b); i < begin_of(b + 1); ++i) {
                add_row(pattern, place, i, begin_of(b));
            }
        }
        find_crossings();
        of_block_.resize(blocks());
        values_.resize(column_.size() + place.size());
        lower_.resize(column_.size());
        for (std::vector<double>* v : {&scale_, &excess_, &x_, &r_, &p_, &t_, &w_}) {
            v->resize(place.size());
        }
    }

    std::string factorise(const Matrix& matrix) override {
        const std::size_t n_lower = source_.size();
        over_nodes(n_lower, [&](std::size_t e) { values_[e] = matrix.value[at(source_[e])]; });
        over_nodes(scale_.size(), [&](std::size_t i) { values_[n_lower + i] = matrix.value[at(diagonal_of_[i])]; });
        return factorise_values();
    }

    [[nodiscard]] std::span<const double> values() const override { return values_; }

    std::string factorise_again(std::span<const double> values) override {
        copy_nodes(values, values_);
        return factorise_values();
    }

    void solve(std::span<const double> b, std::span<double> x) override {
        sweep_forward(
            t_, [&](std::size_t i) { return scale_[i] * b[at(order_.node[i])]; }, nothing);
        sweep_backward(
            t_, [&](std::size_t i) { return t_[i]; },
            [&](std::size_t i, double value) { x[at(order_.node[i])] = scale_[i] * value; });
    }

    /// Conjugate gradients on (I + L)^-1 A (I + L')^-1.
    int solve_to(double accuracy, std::span<const double> b, std::span<double> x) override {
        double length2 = sweep_forward(
            r_, [&](std::size_t i) { return scale_[i] * b[at(order_.node[i])]; },
            [&](std::size_t i, double value) {
                p_[i] = x_[i] = 0.0;
                return value * value;
            });
        const double wanted2 = accuracy * accuracy * length2;
        double share = 0.0;
        int iterations = 0;
        while (length2 > wanted2 && iterations < most_iterations) {
            ++iterations;
            const double energy = turn_direction(share);
            const double step = length2 / energy;
            const double next = sum_over_nodes(r_.size(), [&](std::size_t i) {
                x_[i] += step * p_[i];
                r_[i] -= step * (w_[i] + t_[i]);
                return r_[i] * r_[i];
            });
            if (!std::isfinite(next) || !(energy > 0.0)) {
                return -1;
            }
            share = next / length2;
            length2 = next;
        }
        sweep_backward(
            x_, [&](std::size_t i) { return x_[i]; },
            [&](std::size_t i, double value) { x[at(order_.node[i])] = scale_[i] * value; });
        return length2 <= wanted2 ? iterations : -1;
    }

    [[nodiscard]] double factor_cost() const override { return 1.0; }
    [[nodiscard]] bool is_exact() const override { return false; }
    [[nodiscard]] std::string description() const override {
        return "conjugate gradients, modified incomplete Cholesky";
    }

private:
    /// An entry of L between two blocks.
    struct Crossing {
        int to = 0;     ///< its column, in the earlier block
        int entry = 0;  ///< place in L
        int from = 0;   ///< its row
    };

    [[nodiscard]] std::size_t blocks() const { return order_.block.size() - 1; }
    [[nodiscard]] std::size_t begin_of(std::size_t block) const { return at(order_.block[block]); }

    /// The row of L at a place of the order, what lies in its own block first.
    void add_row(const Pattern& pattern, const std::vector<int>& place, std::size_t row, std::size_t block_begin) {
        const std::size_t i = at(order_.node[row]);
        const auto add = [&](bool own) {
            for (int e = pattern.start[i]; e < pattern.start[i + 1]; ++e) {
                const std::size_t column = at(place[at(pattern.column[at(e)])]);
                if (column < row && (column >= block_begin) == own) {
                    column_.push_back(static_cast<int>(column));
                    source_.push_back(e);
                }
            }
        };
        add(true);
        own_end_.push_back(static_cast<int>(column_.size()));
        add(false);
        start_.push_back(static_cast<int>(column_.size()));
        diagonal_of_.push_back(pattern.diagonal[i]);
    }

    /// By the block of their column, so that a backward sweep gathers what crosses and no two threads write to one place.
    void find_crossings() {
        for (std::size_t row = 0; row < own_end_.size(); ++row) {
            for (int e = own_end_[row]; e < start_[row + 1]; ++e) {
                crossings_.push_back({.to = column_[at(e)], .entry = e, .from = static_cast<int>(row)});
            }
        }
        std::ranges::stable_sort(crossings_, {}, &Crossing::to);
        for (const int place : order_.block) {
            const auto first = std::ranges::lower_bound(crossings_, place, {}, &Crossing::to);
            first_crossing_.push_back(static_cast<std::size_t>(first - crossings_.begin()));
        }
    }

    /// Calls sweep(block) for the blocks of a phase, side by side.
    template <typename Sweep>
    void in_phase(std::size_t phase, const Sweep& sweep) const {
        split_loop(at(order_.phase[phase]), at(order_.phase[phase + 1]), true, sweep);
    }
    [[nodiscard]] std::size_t phases() const { return order_.phase.size() - 1; }

    std::string factorise_values() {
        const double* const diagonal = values_.data() + source_.size();
        std::vector<double>& after = w_;
        add_up_columns(after);
        std::atomic<bool> broken = false;
        for (std::size_t phase = 0; phase < phases() && !broken; ++phase) {
            in_phase(phase, [&](std::size_t b) {
                for (std::size_t i = begin_of(b); i < begin_of(b + 1); ++i) {
                    double pivot = diagonal[i];
                    for (std::size_t e = at(start_[i]); e < at(start_[i + 1]); ++e) {
                        const std::size_t j = at(column_[e]);
                        const double value = values_[e];
                        // scale_ holds 1 / D up to here
                        pivot -= value * scale_[j] * (value + fill_to_diagonal * (after[j] - value));
                    }
                    if (!(pivot > smallest_pivot * diagonal[i]) || !std::isfinite(pivot)) {
                        broken = true;
                        return;
                    }
                    scale_[i] = 1.0 / pivot;
                }
            });
        }
        if (broken) {
            return "the incomplete Cholesky factor broke down: the matrix is not positive definite";
        }
        over_nodes(scale_.size(), [&](std::size_t i) { scale_[i] = std::sqrt(scale_[i]); });
        over_nodes(scale_.size(), [&](std::size_t i) {
            for (std::size_t e = at(start_[i]); e < at(start_[i + 1]); ++e) {
                lower_[e] = values_[e] * scale_[i] * scale_[at(column_[e])];
            }
            excess_[i] = diagonal[i] * scale_[i] * scale_[i] - 2.0;
        });
        return {};
    }

    /// What each column of the lower triangle sums to: the entries of a row beyond its diagonal.
    void add_up_columns(std::span<double> sum) const {
        split_loop(0, blocks(), true, [&](std::size_t b) {
            std::fill(sum.begin() + order_.block[b], sum.begin() + order_.block[b + 1], 0.0);
            for (std::size_t i = begin_of(b); i < begin_of(b + 1); ++i) {
                for (std::size_t e = at(start_[i]); e < at(own_end_[i]); ++e) {
                    sum[at(column_[e])] += values_[e];
                }
            }
            for (std::size_t c = first_crossing_[b]; c < first_crossing_[b + 1]; ++c) {
                sum[at(crossings_[c].to)] += values_[at(crossings_[c].entry)];
            }
        });
    }

    /// x <- (I + L)^-1 (what begin(i) gives). @returns the sum of what done(i, x_i) gives
    template <typename Begin, typename Done>
    double sweep_forward(std::span<double> x, const Begin& begin, const Done& done) {
        const int* const column = column_.data();
        const double* const lower = lower_.data();
        for (std::size_t phase = 0; phase < phases(); ++phase) {
            in_phase(phase, [&](std::size_t b) {
                double all = 0.0;
                for (std::size_t i = begin_of(b); i < begin_of(b + 1); ++i) {
                    double sum = begin(i);
                    for (int e = start_[i]; e < start_[i + 1]; ++e) {
                        sum -= lower[e] * x[at(column[e])];
                    }
                    x[i] = sum;
                    all += done(i, sum);
                }
                of_block_[b] = all;
            });
        }
        return std::accumulate(of_block_.begin(), of_block_.end(), 0.0);
    }
    static double nothing(std::size_t /*i*/, double /*value*/) { return 0.0; }

    /// x <- (I + L')^-1 (what begin(i) gives), of which done(i, x_i) is told.
    template <typename Begin, typename Done>
    void sweep_backward(std::span<double> x, const Begin& begin, const Done& done) const {
        const int* const column = column_.data();
        const double* const lower = lower_.data();
        for (std::size_t phase = phases(); phase-- > 0;) {
            in_phase(phase, [&](std::size_t b) {
                for (std::size_t i = begin_of(b); i < begin_of(b + 1); ++i) {
                    x[i] = begin(i);
                }
                for (std::size_t c = first_crossing_[b]; c < first_crossing_[b + 1]; ++c) {
                    const Crossing& crossing = crossings_[c];
                    x[at(crossing.to)] -= lower[crossing.entry] * x[at(crossing.from)];
                }
                for (std::size_t i = begin_of(b + 1); i-- > begin_of(b);) {
                    const double here = x[i];
                    for (int e = start_[i]; e < own_end_[i]; ++e) {
                        x[at(column[e])] -= lower[e] * here;
                    }
                    done(i, here);
                }
            });
        }
    }

    /// The next direction, p <- r + share p, and what the matrix makes of it in two parts: t = (I + L')^-1 p and
    /// w = (I + L)^-1 (p + (diag A - 2) t), as (I + L)^-1 A (I + L')^-1 p = t + w. @returns p' (t + w)
    double turn_direction(double share) {
        sweep_backward(
            t_, [&](std::size_t i) { return p_[i] = r_[i] + share * p_[i]; }, [](std::size_t, double) {});
        return sweep_forward(
            w_, [&](std::size_t i) { return p_[i] + excess_[i] * t_[i]; },
            [&](std::size_t i, double value) { return p_[i] * (value + t_[i]); });
    }

    BlockOrder order_;
    std::vector<int> start_;    ///< [n + 1] of the rows of the lower triangle, without the diagonal
    std::vector<int> own_end_;  ///< [n] end of what a row has in its own block
    std::vector<int> column_;   ///< [n_lower]
    std::vector<int> source_;   ///< [n_lower] place in the pattern
    std::vector<Crossing> crossings_;
    std::vector<std::size_t> first_crossing_;  ///< [n_blocks + 1]
    std::vector<int> diagonal_of_;             ///< [n] place in the pattern
    std::vector<double> values_;               ///< [n_lower + n] of the matrix, its diagonal last
    std::vector<double> lower_;                ///< [n_lower] L, scaled
    std::vector<double> scale_;                ///< [n] D^-1/2
    std::vector<double> excess_;               ///< [n] scaled diagonal of the matrix less 2
    std::vector<double> of_block_;             ///< [n_blocks] parts of a sum
    std::vector<double> x_, r_, p_, t_, w_;
};

}  // namespace

std::unique_ptr<Factor> make_incomplete_cholesky(const Pattern& pattern) {
    return std::make_unique<IncompleteFactor>(pattern);
}

}  // namespace tiretherm::solver
