// SPDX-License-Identifier: BSD-3-Clause
// Factors for several step lengths: which one serves, when one is worn out, which one gives way.

#include "solver/time_integration/kept_factors.hpp"

#include <gtest/gtest.h>

#include "tests/solver/linear/diffusion_matrix.hpp"

namespace tiretherm::solver {
namespace {

class KeptFactorsTest : public testing::Test {
protected:
    mesh::Mesh mesh_ = cube(3);
    Pattern pattern_ = pattern_of(mesh_);
    Matrix A_ = diffusion(mesh_, pattern_, 0.5);
    std::vector<double> compliance_ = std::vector<double>(static_cast<std::size_t>(pattern_.n), 2.0);
    KeptFactors factors_{pattern_, LinearSolver::cholesky};

    void renew(double s) { ASSERT_EQ(factors_.renew(A_, s, compliance_), ""); }
};

TEST_F(KeptFactorsTest, NoneServesBeforeTheFirst) {
    EXPECT_FALSE(factors_.has_current());
    EXPECT_FALSE(factors_.select(1.0));
}

TEST_F(KeptFactorsTest, TheNearestServesWithinReach) {
    renew(1.0);
    renew(3.0);
    EXPECT_TRUE(factors_.select(1.0));
    renew(9.0);
    EXPECT_TRUE(factors_.select(1.4));
    EXPECT_EQ(factors_.s(), 1.0);
    EXPECT_TRUE(factors_.select(2.0));  // 3 is 1.5 times it, 1 half of it and out of reach
    EXPECT_EQ(factors_.s(), 3.0);
    EXPECT_TRUE(factors_.select(8.0));
    EXPECT_EQ(factors_.s(), 9.0);
    EXPECT_FALSE(factors_.select(20.0));
    EXPECT_FALSE(factors_.select(0.4));
    factors_.set_reach(3.0);
    EXPECT_TRUE(factors_.select(20.0));
}

TEST_F(KeptFactorsTest, OneWearsOutByItsSolvesBeyondTheLeast) {
    renew(1.0);
    factors_.count_solves(2);
    EXPECT_FALSE(factors_.is_worn_out());
    for (int i = 0; i < 1000 && !factors_.is_worn_out(); ++i) {
        factors_.count_solves(2);
    }
    EXPECT_FALSE(factors_.is_worn_out());  // never more than the first
    for (int i = 0; i < 1000 && !factors_.is_worn_out(); ++i) {
        factors_.count_solves(3);
    }
    EXPECT_TRUE(factors_.is_worn_out());
    renew(1.0);
    EXPECT_FALSE(factors_.is_worn_out());
}

TEST_F(KeptFactorsTest, TheOneLongestOutOfUseGivesWayToTheFifth) {
    renew(1.0);
    renew(3.0);
    ASSERT_TRUE(factors_.select(1.0));  // steps do not only grow
    ASSERT_TRUE(factors_.select(3.0));
    renew(9.0);
    renew(27.0);
    ASSERT_TRUE(factors_.select(1.0));
    renew(81.0);
    EXPECT_TRUE(factors_.select(1.0));
    EXPECT_FALSE(factors_.select(3.0));  // it was longest out of use
    EXPECT_TRUE(factors_.select(9.0));
    EXPECT_TRUE(factors_.select(27.0));
    EXPECT_TRUE(factors_.select(81.0));
}

TEST_F(KeptFactorsTest, WhileStepsOnlyGrowTwoTakeTurns) {
    for (const double s : {1.0, 3.0, 9.0}) {
        renew(s);
        ASSERT_TRUE(factors_.select(s));
    }
    EXPECT_FALSE(factors_.select(1.0));  // its memory has become that of 9
    EXPECT_TRUE(factors_.select(3.0));
    EXPECT_TRUE(factors_.select(9.0));
}

TEST_F(KeptFactorsTest, AStepTwiceAsLongHasAFactorOfItsOwn) {
    renew(1.0);
    EXPECT_FALSE(factors_.select(2.0 * (1.0 - 1e-12)));
    EXPECT_FALSE(factors_.select(0.5 * (1.0 + 1e-12)));
}

TEST_F(KeptFactorsTest, ANewOneOfAboutTheSameLengthTakesThePlaceOfTheOld) {
    renew(1.0);
    renew(1.2);
    EXPECT_TRUE(factors_.select(1.0));
    EXPECT_EQ(factors_.s(), 1.2);
}

}  // namespace
}  // namespace tiretherm::solver
