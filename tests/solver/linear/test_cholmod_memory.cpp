// SPDX-License-Identifier: BSD-3-Clause
// What the CHOLMOD factor does when memory runs out: CHOLMOD takes its memory from functions that can be exchanged, so that
// each of its allocations can be made to fail in turn.
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <SuiteSparse_config.h>
#include <gtest/gtest.h>

#include "solver/linear/factor.hpp"
#include "tests/solver/linear/diffusion_matrix.hpp"

namespace tiretherm::solver {

namespace {

int allocations = 0;       ///< since the last reset
int outstanding = 0;       ///< blocks not freed yet
int first_to_fail = 1000;  ///< this allocation and all after it fail

bool fails() { return allocations++ >= first_to_fail; }

void* counted(void* block) {
    outstanding += block != nullptr ? 1 : 0;
    return block;
}

void* allocate(std::size_t size) { return fails() ? nullptr : counted(std::malloc(size)); }
void* allocate_zeros(std::size_t n, std::size_t size) { return fails() ? nullptr : counted(std::calloc(n, size)); }
void* reallocate(void* block, std::size_t size) {
    if (fails()) {
        return nullptr;  // the old block stays
    }
    outstanding -= block != nullptr ? 1 : 0;
    return counted(std::realloc(block, size));
}
void release(void* block) {
    outstanding -= block != nullptr ? 1 : 0;
    std::free(block);
}

/// While it lives, CHOLMOD's memory comes from the functions above.
class CountedMemory {
public:
    CountedMemory() : before_(SuiteSparse_config) {
        SuiteSparse_config.malloc_func = allocate;
        SuiteSparse_config.calloc_func = allocate_zeros;
        SuiteSparse_config.realloc_func = reallocate;
        SuiteSparse_config.free_func = release;
        outstanding = 0;
        fail_from(never);
    }
    CountedMemory(const CountedMemory&) = delete;
    CountedMemory& operator=(const CountedMemory&) = delete;
    ~CountedMemory() { SuiteSparse_config = before_; }

    /// @param first number of the first allocation from now on that fails
    void fail_from(int first) {
        allocations = 0;
        first_to_fail = first;
    }

    static constexpr int never = 1 << 30;

private:
    SuiteSparse_config_struct before_;
};

/// 16 x 16 x 16 cells are enough for CHOLMOD's supernodal factor; 4 x 4 x 4 take its simplicial one.
const int sizes[] = {4, 16};

}  // namespace

TEST(CholeskyMemory, AnalysisThatRunsOutOfItThrowsAndFreesEverything) {
    CountedMemory memory;
    for (const int size : sizes) {
        const Pattern pattern = pattern_of(cube(size));
        memory.fail_from(CountedMemory::never);
        { const auto factor = make_cholesky(pattern); }
        const int needed = allocations;
        ASSERT_GT(needed, 10);
        ASSERT_EQ(outstanding, 0);
        for (int first = 0; first < needed; ++first) {
            memory.fail_from(first);
            EXPECT_ANY_THROW(static_cast<void>(make_cholesky(pattern))) << first;
            ASSERT_EQ(outstanding, 0) << "allocation " << first << " of " << needed;
        }
    }
}

// A simplicial factor is solved without CHOLMOD and takes none of its memory.
TEST(CholeskyMemory, SolveThatRunsOutOfItSaysSoAndWorksOnceThereIsSome) {
    CountedMemory memory;
    for (const int size : sizes) {
        const mesh::Mesh mesh = cube(size);
        const Pattern pattern = pattern_of(mesh);
        const Matrix A = diffusion(mesh, pattern, 0.5);
        const std::vector<double> exact = random_vector(pattern.n);
        std::vector<double> b(exact.size());
        std::vector<double> x(exact.size());
        A.multiply(exact, b);
        {
            const auto factor = make_cholesky(pattern);
            ASSERT_EQ(factor->factorise(A), "");
            memory.fail_from(0);
            if (factor->description().find("supernodal") != std::string::npos) {
                try {
                    factor->solve(b, x);
                    FAIL() << "a first solve needs memory";
                } catch (const std::runtime_error& error) {
                    EXPECT_STREQ(error.what(), "CHOLMOD could not solve: there is too little memory");
                }
            }
            memory.fail_from(CountedMemory::never);
            factor->solve(b, x);
            for (std::size_t i = 0; i < x.size(); ++i) {
                EXPECT_NEAR(x[i], exact[i], 1e-12);  // condition number about 100
            }
        }
        EXPECT_EQ(outstanding, 0);
        memory.fail_from(CountedMemory::never);
    }
}

TEST(CholeskyMemory, SolvesAfterTheFirstTakeNone) {
    CountedMemory memory;
    for (const int size : sizes) {
        const mesh::Mesh mesh = cube(size);
        const Pattern pattern = pattern_of(mesh);
        const auto factor = make_cholesky(pattern);
        ASSERT_EQ(factor->factorise(diffusion(mesh, pattern, 0.5)), "");
        const std::vector<double> b = random_vector(pattern.n);
        std::vector<double> x(b.size());
        factor->solve(b, x);
        memory.fail_from(CountedMemory::never);
        for (int i = 0; i < 3; ++i) {
            factor->solve(b, x);
        }
        EXPECT_EQ(allocations, 0) << factor->description();
        EXPECT_NE(factor->description().find(size == 4 ? "simplicial" : "supernodal"), std::string::npos);
    }
}

TEST(Cholesky, SolveBeforeTheFirstFactorisationIsAnError) {
    const Pattern pattern = pattern_of(cube(4));
    const std::vector<double> b = random_vector(pattern.n);
    std::vector<double> x(b.size());
    const auto factor = make_cholesky(pattern);
    EXPECT_THROW(factor->solve(b, x), std::runtime_error);
}

}  // namespace tiretherm::solver
