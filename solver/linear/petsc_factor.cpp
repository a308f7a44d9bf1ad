// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients by PETSc with algebraic multigrid by hypre. The first rank sends the others what to do; each rank holds a range
// of rows. The only source that includes PETSc.

#include "solver/linear/petsc_factor.hpp"

#include "solver/linear/factor.hpp"

#ifdef TIRETHERM_PETSC

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <petscksp.h>

namespace tiretherm::solver {

namespace {

void check(PetscErrorCode error, const char* what) {
    if (error != 0) {
        const char* text = nullptr;
        PetscErrorMessage(error, &text, nullptr);
        throw std::runtime_error(
            fmt::format("PETSc could not {}: {}", what, text != nullptr ? text : "unknown reason"));
    }
}

int rank() {
    int number = 0;
    MPI_Comm_rank(PETSC_COMM_WORLD, &number);
    return number;
}

int ranks() {
    int number = 1;
    MPI_Comm_size(PETSC_COMM_WORLD, &number);
    return number;
}

/// What the first rank asks of the others.
enum class Task : int { end, make, remove, factorise, precondition, solve };

struct Order {
    Task task = Task::end;
    int system = 0;         ///< which matrix
    int size = 0;           ///< its rows
    double accuracy = 0.0;  ///< of a solution
};

void broadcast(Order& order) {
    std::array<double, 4> numbers{static_cast<double>(static_cast<int>(order.task)), static_cast<double>(order.system),
                                  static_cast<double>(order.size), order.accuracy};
    MPI_Bcast(numbers.data(), 4, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
    order = {.task = static_cast<Task>(static_cast<int>(numbers[0])),
             .system = static_cast<int>(numbers[1]),
             .size = static_cast<int>(numbers[2]),
             .accuracy = numbers[3]};
}

/// A rank's rows of a matrix with vectors and the iteration. All members are called on all ranks together; what only the
/// first rank has is null on the others.
class Rows {
public:
    /// @param pattern on the first rank
    Rows(const Pattern* pattern, int n) : n_(n) {
        const int all = ranks();
        for (int r = 0; r <= all; ++r) {
            first_.push_back(static_cast<int>(static_cast<long>(n) * r / all));
        }
        for (int r = 0; r < all; ++r) {
            row_counts_.push_back(first_[static_cast<std::size_t>(r) + 1] - first_[static_cast<std::size_t>(r)]);
        }
        const auto mine = static_cast<std::size_t>(rank());
        const int own = row_counts_[mine];
        // Lengths of the rows, then columns: each rank gets its own.
        std::vector<int> lengths(pattern != nullptr ? static_cast<std::size_t>(n) : 0);
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            lengths[i] = pattern->start[i + 1] - pattern->start[i];
        }
        std::vector<int> my_lengths(static_cast<std::size_t>(own));
        MPI_Scatterv(lengths.data(), row_counts_.data(), first_.data(), MPI_INT, my_lengths.data(), own, MPI_INT, 0,
                     PETSC_COMM_WORLD);
        start_.push_back(0);
        for (const int length : my_lengths) {
            start_.push_back(start_.back() + length);
        }
        value_counts_.resize(row_counts_.size());
        MPI_Allgather(&start_.back(), 1, MPI_INT, value_counts_.data(), 1, MPI_INT, PETSC_COMM_WORLD);
        first_value_.push_back(0);
        for (const int count : value_counts_) {
            first_value_.push_back(first_value_.back() + count);
        }
        column_.resize(static_cast<std::size_t>(start_.back()));
        MPI_Scatterv(pattern != nullptr ? pattern->column.data() : nullptr, value_counts_.data(), first_value_.data(),
                     MPI_INT, column_.data(), start_.back(), MPI_INT, 0, PETSC_COMM_WORLD);
        value_.resize(column_.size());
        check(VecCreateMPI(PETSC_COMM_WORLD, own, n, &right_), "make a vector");
        check(VecDuplicate(right_, &solution_), "make a vector");
    }
    ~Rows() {
        KSPDestroy(&iteration_);
        MatDestroy(&matrix_);
        VecDestroy(&right_);
        VecDestroy(&solution_);
    }
    Rows(const Rows&) = delete;
    Rows& operator=(const Rows&) = delete;

    /// @param values of all rows, on the first rank
    void factorise(const double* values) {
        MPI_Scatterv(values, value_counts_.data(), first_value_.data(), MPI_DOUBLE, value_.data(), start_.back(),
                     MPI_DOUBLE, 0, PETSC_COMM_WORLD);
        const auto own = static_cast<PetscInt>(start_.size()) - 1;
        if (matrix_ == nullptr) {
            check(MatCreateMPIAIJWithArrays(PETSC_COMM_WORLD, own, own, n_, n_, start_.data(), column_.data(),
                                            value_.data(), &matrix_),
                  "make a matrix");
            check(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE), "mark a matrix");
            prepare_iteration();
        } else {
            check(MatUpdateMPIAIJWithArray(matrix_, value_.data()), "renew a matrix");
            check(KSPSetOperators(iteration_, matrix_, matrix_), "renew a matrix");
        }
        check(KSPSetUp(iteration_), "make the levels of the multigrid");
    }

    /// @param b, x [n] on the first rank  @returns iterations; -1: did not converge
    int solve(const double* b, double* x, Task task, double accuracy) {
        double* local = nullptr;
        const int own = row_counts_[static_cast<std::size_t>(rank())];
        check(VecGetArrayWrite(right_, &local), "open a vector");
        MPI_Scatterv(b, row_counts_.data(), first_.data(), MPI_DOUBLE, local, own, MPI_DOUBLE, 0, PETSC_COMM_WORLD);
        check(VecRestoreArrayWrite(right_, &local), "close a vector");
        PetscInt iterations = 1;
        if (task == Task::precondition) {
            PC multigrid = nullptr;
            check(KSPGetPC(iteration_, &multigrid), "find the multigrid");
            check(PCApply(multigrid, right_, solution_), "apply the multigrid");
        } else {
            check(KSPSetTolerances(iteration_, accuracy, 1e-300, PETSC_DEFAULT, 500), "set the accuracy");
            check(KSPSolve(iteration_, right_, solution_), "solve");
            check(KSPGetIterationNumber(iteration_, &iterations), "count");
            KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
            check(KSPGetConvergedReason(iteration_, &reason), "ask how it ended");
            iterations = reason > 0 ? iterations : -1;
        }
        const double* found = nullptr;
        check(VecGetArrayRead(solution_, &found), "open a vector");
        MPI_Gatherv(found, own, MPI_DOUBLE, x, row_counts_.data(), first_.data(), MPI_DOUBLE, 0, PETSC_COMM_WORLD);
        check(VecRestoreArrayRead(solution_, &found), "close a vector");
        return static_cast<int>(iterations);
    }

private:
    void prepare_iteration() {
        check(KSPCreate(PETSC_COMM_WORLD, &iteration_), "make an iteration");
        check(KSPSetOperators(iteration_, matrix_, matrix_), "set a matrix");
        check(KSPSetType(iteration_, KSPCG), "choose conjugate gradients");
        check(KSPSetNormType(iteration_, KSP_NORM_NATURAL), "choose a norm");
        PC multigrid = nullptr;
        check(KSPGetPC(iteration_, &multigrid), "find the multigrid");
        check(PCSetType(multigrid, PCHYPRE), "choose multigrid");
        check(PCHYPRESetType(multigrid, "boomeramg"), "choose BoomerAMG");
        check(KSPSetFromOptions(iteration_), "read PETSC_OPTIONS");
    }

    int n_;
    std::vector<int> first_;         ///< [ranks + 1] rows
    std::vector<int> row_counts_;    ///< [ranks]
    std::vector<int> first_value_;   ///< [ranks + 1]
    std::vector<int> value_counts_;  ///< [ranks]
    std::vector<int> start_;         ///< [own rows + 1]
    std::vector<int> column_;
    std::vector<double> value_;
    Mat matrix_ = nullptr;
    Vec right_ = nullptr;
    Vec solution_ = nullptr;
    KSP iteration_ = nullptr;
};

/// The matrices of this process by their numbers.
std::vector<std::unique_ptr<Rows>>& systems() {
    static std::vector<std::unique_ptr<Rows>> all;
    return all;
}

void end_petsc() {
    if (rank() == 0) {
        Order order{};
        broadcast(order);
    }
    systems().clear();
    PetscFinalize();
}

/// Where the user's PETSC_OPTIONS say nothing of it.
void set_option(const char* name, const char* value) {
    PetscBool is_set = PETSC_FALSE;
    check(PetscOptionsHasName(nullptr, nullptr, name, &is_set), "look for an option");
    if (is_set == PETSC_FALSE) {
        check(PetscOptionsSetValue(nullptr, name, value), "set an option");
    }
}

void begin_petsc() {
    static bool begun = false;
    if (!std::exchange(begun, true)) {
        check(PetscInitializeNoArguments(), "begin");
        systems();                // made before the end is registered, and so there when it comes
        PetscPopSignalHandler();  // Ctrl-C is the program's own business
        // A symmetric smoother, without which conjugate gradients fail; the threshold is the one for three dimensions.
        set_option("-pc_hypre_boomeramg_relax_type_all", "symmetric-SOR/Jacobi");
        set_option("-pc_hypre_boomeramg_strong_threshold", "0.5");
        std::atexit(end_petsc);
    }
}

void serve() {
    for (;;) {
        Order order;
        broadcast(order);
        const auto at = static_cast<std::size_t>(order.system);
        switch (order.task) {
            case Task::end:
                return;
            case Task::make:
                systems().resize(std::max(systems().size(), at + 1));
                systems()[at] = std::make_unique<Rows>(nullptr, order.size);
                break;
            case Task::remove:
                systems()[at].reset();
                break;
            case Task::factorise:
                systems()[at]->factorise(nullptr);
                break;
            case Task::precondition:
            case Task::solve:
                systems()[at]->solve(nullptr, nullptr, order.task, order.accuracy);
                break;
        }
    }
}

class PetscFactor final : public Factor {
public:
    explicit PetscFactor(const Pattern& pattern) : pattern_(&pattern), values_(pattern.nonzeros()) {
        begin_petsc();
        number_ = static_cast<int>(systems().size());
        Order order{.task = Task::make, .system = number_, .size = pattern.n};
        broadcast(order);
        systems().push_back(std::make_unique<Rows>(&pattern, pattern.n));
    }
    ~PetscFactor() override {
        Order order{.task = Task::remove, .system = number_};
        broadcast(order);
        systems()[static_cast<std::size_t>(number_)].reset();
    }

    std::string factorise(const Matrix& matrix) override {
        values_ = matrix.value;
        return factorise_values();
    }
    [[nodiscard]] std::span<const double> values() const override { return values_; }
    std::string factorise_again(std::span<const double> values) override {
        values_.assign(values.begin(), values.end());
        return factorise_values();
    }

    void solve(std::span<const double> b, std::span<double> x) override {
        Order order{.task = Task::precondition, .system = number_};
        broadcast(order);
        rows().solve(b.data(), x.data(), Task::precondition, 0.0);
    }

    int solve_to(double accuracy, std::span<const double> b, std::span<double> x) override {
        Order order{.task = Task::solve, .system = number_, .accuracy = accuracy};
        broadcast(order);
        return rows().solve(b.data(), x.data(), Task::solve, accuracy);
    }

    [[nodiscard]] double factor_cost() const override { return 10.0; }
    [[nodiscard]] bool is_exact() const override { return false; }
    [[nodiscard]] std::string description() const override {
        return fmt::format("conjugate gradients, algebraic multigrid (PETSc and hypre, {} rank{})", ranks(),
                           ranks() == 1 ? "" : "s");
    }

private:
    Rows& rows() { return *systems()[static_cast<std::size_t>(number_)]; }

    std::string factorise_values() {
        for (const int place : pattern_->diagonal) {
            if (!(values_[static_cast<std::size_t>(place)] > 0.0)) {
                return "the matrix is not positive definite";
            }
        }
        Order order{.task = Task::factorise, .system = number_};
        broadcast(order);
        rows().factorise(values_.data());
        return {};
    }

    const Pattern* pattern_;
    std::vector<double> values_;
    int number_ = 0;
};

}  // namespace

bool has_petsc() { return true; }

bool is_first_rank() {
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMI_SIZE") == nullptr) {
        return true;  // not begun by mpirun
    }
    begin_petsc();
    if (rank() == 0) {
        return true;
    }
    serve();
    return false;
}

std::unique_ptr<Factor> make_petsc(const Pattern& pattern) { return std::make_unique<PetscFactor>(pattern); }

}  // namespace tiretherm::solver

#else

#include <stdexcept>

namespace tiretherm::solver {

bool has_petsc() { return false; }

bool is_first_rank() { return true; }

std::unique_ptr<Factor> make_petsc(const Pattern& /*pattern*/) {
    throw std::runtime_error("this program was built without PETSc; configure it with -DTIRETHERM_PETSC=ON");
}

}  // namespace tiretherm::solver

#endif
