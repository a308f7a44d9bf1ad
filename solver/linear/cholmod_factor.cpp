// SPDX-License-Identifier: BSD-3-Clause
// Sparse Cholesky factor by CHOLMOD with a solve of eight columns side by side; chooses between it and incomplete
// Cholesky by the predicted fill.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <cholmod.h>
#include <fmt/format.h>

#include "solver/linear/factor.hpp"

namespace tiretherm::solver {

namespace {

/// Above this many entries per row of the factor, CG with an incomplete factor wins (a 2-D mesh of 27 000 cells has
/// about 20, a 3-D one of 5 800 about 60, of 20 400 110 to 150).
constexpr double fill_for_iteration = 40.0;

/// METIS looks a dozen times longer for an order than minimum degree does (AMD), and leaves at least half of the fill: measured on
/// grids of 5 800 to 770 000 cells.
constexpr double least_left_by_metis = 0.5;

/// Flops per entry of the factor above which dense blocks pay. CHOLMOD's own 40 takes them for 2-D meshes, where they
/// cost six times more than a plain factor.
constexpr double flops_per_entry_for_blocks = 200.0;

/// Owns everything of CHOLMOD: one workspace, the lower triangle of the matrix, the factor and the solve's buffers.
class CholeskyFactor final : public Factor {
public:
    /// In the order of minimum degree. The other constructor has made a whole object, so that the destructor frees everything when
    /// this one throws.
    explicit CholeskyFactor(const Pattern& pattern) : CholeskyFactor() {
        const auto n = static_cast<std::size_t>(pattern.n);
        std::size_t lower = 0;
        for (int i = 0; i < pattern.n; ++i) {
            lower += static_cast<std::size_t>(pattern.start[static_cast<std::size_t>(i) + 1] -
                                              pattern.diagonal[static_cast<std::size_t>(i)]);
        }
        matrix_ = cholmod_allocate_sparse(n, n, lower, 1, 1, -1, CHOLMOD_REAL, &common_);
        if (matrix_ == nullptr) {
            throw std::bad_alloc();
        }
        // Row i from the diagonal on is, by symmetry, column i of the lower triangle.
        auto* start = static_cast<int*>(matrix_->p);
        auto* row = static_cast<int*>(matrix_->i);
        int count = 0;
        for (int i = 0; i < pattern.n; ++i) {
            start[i] = count;
            const auto at = static_cast<std::size_t>(i);
            for (int e = pattern.diagonal[at]; e < pattern.start[at + 1]; ++e) {
                row[count++] = pattern.column[static_cast<std::size_t>(e)];
                source_.push_back(e);
            }
        }
        start[pattern.n] = count;
        double* value = static_cast<double*>(matrix_->x);
        std::fill(value, value + count, 0.0);
        common_.nmethods = 1;
        common_.method[0].ordering = CHOLMOD_AMD;
        analyse();
    }

    /// Lets METIS look for a better order where CHOLMOD would: its rule, by which AMD has done well enough.
    void improve_order() {
        if (flops_ >= 500.0 * entries_ && entries_ >= 5.0 * static_cast<double>(source_.size())) {
            common_.nmethods = 0;  // both, of which the better one is taken
            analyse();
        }
        if (analysis_ == nullptr) {
            throw no_analysis();
        }
    }

    /// Takes the analysis of another over.
    CholeskyFactor(const CholeskyFactor& other) : CholeskyFactor() {
        source_ = other.source_;
        entries_ = other.entries_;
        flops_ = other.flops_;
        matrix_ = cholmod_copy_sparse(other.matrix_, &common_);
        if (matrix_ == nullptr) {
            throw std::bad_alloc();
        }
        analysis_ = copy_of(other.analysis_);
        factor_ = copy_of(analysis_);
    }

    ~CholeskyFactor() override {
        cholmod_free_sparse(&matrix_, &common_);
        cholmod_free_factor(&analysis_, &common_);
        cholmod_free_factor(&factor_, &common_);
        for (cholmod_dense** buffer : {&solution_, &y_, &e_}) {
            cholmod_free_dense(buffer, &common_);
        }
        cholmod_finish(&common_);
    }

    std::string factorise(const Matrix& matrix) override {
        auto* value = static_cast<double*>(matrix_->x);
        for (std::size_t e = 0; e < source_.size(); ++e) {
            value[e] = matrix.value[static_cast<std::size_t>(source_[e])];
        }
        return factorise_values();
    }

    [[nodiscard]] std::span<const double> values() const override {
        return {static_cast<const double*>(matrix_->x), source_.size()};
    }

    std::string factorise_again(std::span<const double> values) override {
        std::ranges::copy(values, static_cast<double*>(matrix_->x));
        return factorise_values();
    }

    /// CHOLMOD copies the right-hand side and the result of a simplicial solve several times; a small factor needs less
    /// time itself.
    void solve(std::span<const double> b, std::span<double> x) override {
        if (!is_simplicial()) {
            solve_supernodal(b, x);
            return;
        }
        solve_one(b, x);
    }

    /// CHOLMOD takes four columns at a time through a simplicial factor; eight side by side fetch each entry half as often
    /// and keep the processor's vectors full.
    void solve_panel(ConstPanel B, Panel X) override {
        if (!is_simplicial()) {
            Factor::solve_panel(B, X);
            return;
        }
        panel_.resize(matrix_->nrow);
        in_wide_vectors([&] { solve_side_by_side(B, X); });
    }

    [[nodiscard]] std::unique_ptr<Factor> alike() const override { return std::make_unique<CholeskyFactor>(*this); }

    [[nodiscard]] double factor_cost() const override {
        // Solving streams the factor twice. A supernodal factor works in cache and does about three times the flops a
        // second; a simplicial one walks its pattern as the solve does.
        return std::max(2.0, flops_ / ((factor_->is_super != 0 ? 12.0 : 4.0) * entries_));
    }

    [[nodiscard]] bool is_exact() const override { return true; }
    [[nodiscard]] std::string description() const override {
        return fmt::format("CHOLMOD, {}, {:.0f} entries in the factor",
                           factor_->is_super != 0 ? "supernodal" : "simplicial", entries_);
    }

    [[nodiscard]] double entries_per_row() const { return entries_ / static_cast<double>(matrix_->nrow); }

private:
    [[nodiscard]] std::runtime_error no_analysis() const {
        return std::runtime_error("CHOLMOD could not analyse the matrix: " + status());
    }

    /// Of a factor that would be too large there is nothing but that its entries are without number.
    void analyse() {
        cholmod_free_factor(&analysis_, &common_);
        cholmod_free_factor(&factor_, &common_);
        analysis_ = cholmod_analyze(matrix_, &common_);
        if (analysis_ == nullptr &&
            common_.status == CHOLMOD_NOT_INSTALLED) {  // a CHOLMOD without blocks, as in an FMU
            common_.supernodal = CHOLMOD_SIMPLICIAL;
            analysis_ = cholmod_analyze(matrix_, &common_);
        }
        if (analysis_ == nullptr) {
            if (common_.status != CHOLMOD_TOO_LARGE) {
                throw no_analysis();
            }
            entries_ = flops_ = std::numeric_limits<double>::infinity();
            return;
        }
        factor_ = copy_of(analysis_);
        entries_ = common_.lnz;
        flops_ = common_.fl;
    }

    CholeskyFactor() {
        cholmod_start(&common_);
        common_.print = 0;
        common_.supernodal = CHOLMOD_AUTO;
        common_.supernodal_switch = flops_per_entry_for_blocks;
        common_.final_ll = 1;
        common_.grow0 = common_.grow1 = 1.0;  // columns never outgrow what the analysis found
        common_.grow2 = 0;
    }

    [[nodiscard]] cholmod_factor* copy_of(cholmod_factor* other) {
        cholmod_factor* copy = cholmod_copy_factor(other, &common_);
        return copy != nullptr ? copy : throw std::bad_alloc();
    }

    std::string factorise_values() {
        cholmod_factorize(matrix_, factor_, &common_);
        if (common_.status != CHOLMOD_OK) {
            return status();
        }
        if (is_simplicial()) {
            const auto* start = static_cast<const int*>(factor_->p);
            const auto* value = static_cast<const double*>(factor_->x);
            inverse_.resize(matrix_->nrow);
            for (std::size_t j = 0; j < inverse_.size(); ++j) {
                inverse_[j] = 1.0 / value[start[j]];
            }
        }
        return {};
    }

    [[nodiscard]] bool is_simplicial() const { return factor_->is_super == 0 && factor_->is_ll != 0; }

    /// L L' x = b in the factor's order.
    void solve_one(std::span<const double> b, std::span<double> x) {
        assert(factor_->xtype == CHOLMOD_REAL);  // it has been factorised
        const std::size_t n = matrix_->nrow;
        const auto* order = static_cast<const int*>(factor_->Perm);
        const auto* start = static_cast<const int*>(factor_->p);
        const auto* count = static_cast<const int*>(factor_->nz);
        const auto* row = static_cast<const int*>(factor_->i);
        const auto* value = static_cast<const double*>(factor_->x);
        ordered_.resize(n);
        double* const y = ordered_.data();
        for (std::size_t k = 0; k < n; ++k) {
            y[k] = b[static_cast<std::size_t>(order[k])];
        }
        for (std::size_t j = 0; j < n; ++j) {
            const double here = y[j] *= inverse_[j];
            const int first = start[j];
            for (int e = first + 1; e < first + count[j]; ++e) {
                y[row[e]] -= value[e] * here;
            }
        }
        for (std::size_t j = n; j-- > 0;) {
            // Four sums side by side: one alone would wait for each addition.
            std::array<double, 4> sums{};
            int e = start[j] + 1;
            const int end = start[j] + count[j];
            for (; e + 4 <= end; e += 4) {
                for (int k = 0; k < 4; ++k) {
                    sums[static_cast<std::size_t>(k)] += value[e + k] * y[row[e + k]];
                }
            }
            for (; e < end; ++e) {
                sums[0] += value[e] * y[row[e]];
            }
            y[j] = (y[j] - ((sums[0] + sums[1]) + (sums[2] + sums[3]))) * inverse_[j];
        }
        for (std::size_t k = 0; k < n; ++k) {
            x[static_cast<std::size_t>(order[k])] = y[k];
        }
    }

    void solve_supernodal(std::span<const double> b, std::span<double> x) {
        cholmod_dense right{};
        right.nrow = right.d = right.nzmax = b.size();
        right.ncol = 1;
        right.x = const_cast<double*>(b.data());  // CHOLMOD only reads it
        right.xtype = CHOLMOD_REAL;
        right.dtype = CHOLMOD_DOUBLE;
        if (cholmod_solve2(CHOLMOD_A, factor_, &right, nullptr, &solution_, nullptr, &y_, &e_, &common_) == 0) {
            throw std::runtime_error("CHOLMOD could not solve: " + status());
        }
        std::copy_n(static_cast<const double*>(solution_->x), x.size(), x.begin());
    }

    /// L L' X = B in the factor's order, row by row with its columns next to each other.
    void solve_side_by_side(ConstPanel B, Panel X) {
        assert(factor_->xtype == CHOLMOD_REAL);  // it has been factorised
        const std::size_t n = matrix_->nrow;
        const auto* order = static_cast<const int*>(factor_->Perm);
        const auto* start = static_cast<const int*>(factor_->p);
        const auto* count = static_cast<const int*>(factor_->nz);
        const auto* row = static_cast<const int*>(factor_->i);
        const auto* value = static_cast<const double*>(factor_->x);
        PanelRow* const y = panel_.data();
        for (std::size_t k = 0; k < n; ++k) {
            y[k] = B[static_cast<std::size_t>(order[k])];
        }
        for (std::size_t j = 0; j < n; ++j) {
            const PanelRow here = y[j] = inverse_[j] * y[j];
            for (int e = start[j] + 1; e < start[j] + count[j]; ++e) {
                y[row[e]] -= value[e] * here;
            }
        }
        for (std::size_t j = n; j-- > 0;) {
            // Two sums side by side: one alone would wait for each subtraction.
            PanelRow here = y[j];
            PanelRow other{};
            int e = start[j] + 1;
            const int end = start[j] + count[j];
            for (; e + 2 <= end; e += 2) {
                here -= value[e] * y[row[e]];
                other -= value[e + 1] * y[row[e + 1]];
            }
            if (e < end) {
                here -= value[e] * y[row[e]];
            }
            y[j] = inverse_[j] * (here += other);
        }
        for (std::size_t k = 0; k < n; ++k) {
            X[static_cast<std::size_t>(order[k])] = y[k];
        }
    }

    [[nodiscard]] std::string status() const {
        switch (common_.status) {
            case CHOLMOD_NOT_POSDEF:
                return "the matrix is not positive definite: a part of the mesh exchanges heat with nothing, or a "
                       "conductance or heat capacity is not positive";
            case CHOLMOD_OUT_OF_MEMORY:
                return "there is too little memory";
            case CHOLMOD_TOO_LARGE:
                return "the factor is too large for 32-bit indices";
            case CHOLMOD_INVALID:
                return "the matrix is invalid or has not been factorised";
            default:
                return fmt::format("CHOLMOD status {}", common_.status);
        }
    }

    cholmod_common common_{};
    cholmod_sparse* matrix_ = nullptr;
    cholmod_factor* analysis_ = nullptr;  ///< without numbers, to be copied
    cholmod_factor* factor_ = nullptr;
    cholmod_dense* solution_ = nullptr;  ///< this and the next two: what a supernodal solve works in
    cholmod_dense* y_ = nullptr;
    cholmod_dense* e_ = nullptr;
    std::vector<double> inverse_;  ///< [n] of the factor's diagonal
    std::vector<double> ordered_;  ///< [n]
    std::vector<PanelRow> panel_;  ///< [n] once a panel was solved
    std::vector<int> source_;      ///< place in the pattern of each entry of the lower triangle
    double entries_ = 0.0;
    double flops_ = 0.0;
};

}  // namespace

std::unique_ptr<Factor> make_cholesky(const Pattern& pattern) {
    auto factor = std::make_unique<CholeskyFactor>(pattern);
    factor->improve_order();
    return factor;
}

std::unique_ptr<Factor> make_factor(const Pattern& pattern, LinearSolver wanted) {
    switch (wanted) {
        case LinearSolver::conjugate_gradient:
            return make_incomplete_cholesky(pattern);
        case LinearSolver::cholesky:
            return make_cholesky(pattern);
        case LinearSolver::automatic:
            break;
    }
    auto direct = std::make_unique<CholeskyFactor>(pattern);
    if (direct->entries_per_row() <= fill_for_iteration / least_left_by_metis) {
        direct->improve_order();
        if (direct->entries_per_row() <= fill_for_iteration) {
            return direct;
        }
    }
    return make_incomplete_cholesky(pattern);
}

}  // namespace tiretherm::solver
