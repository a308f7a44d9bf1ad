// SPDX-License-Identifier: BSD-3-Clause
// Laws that hold for every problem, on blocks drawn by seed from the corners of what a case may ask: sound ends, closed
// ledgers, the maximum principle, mirror images, the order of effects, superposition.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/order.hpp"
#include "tests/support/random_block.hpp"

// Layers of 1e-3 to 1e3 W/mK side by side, films of 0.1 to 1e5 W/m2K, cells of 0.05 to 500 mm, laws that bend, melt and
// radiate, starts and air of -40 to 300 degC that jump or are logged, runs of 1e-6 s to a day and steady states, both
// methods, both linear solvers.
namespace tiretherm {
namespace {

using support::Block;
using support::Dice;
using support::EndedRun;
using support::Ground;
using support::run_to_its_end;

/// What a failure says first: it draws the same block again.
std::string drawn(std::uint64_t seed, const Block& block) { return fmt::format("seed {}: {}", seed, block.title()); }

/// Steps that do not follow the error, so that a last digit cannot decide how many there are; 1e-6 K is the tolerance, of
/// which Newton's iteration takes a twentieth. Solved exactly: what conjugate gradients leave grows with the ratio of the
/// conductivities, to some tolerances where it is 1e6.
void hold_steps(Dice& dice, Block& block) {
    if (!block.settings.steady) {
        block.settings.fixed_step = block.settings.end / dice.whole(1, 20);
    }
    block.settings.tolerance = 1e-6;
    block.settings.linear_solver = solver::LinearSolver::cholesky;
}

/// Counts the runs of a test, almost all of which must end well: the others prove only that they end with a sentence.
class Count {
public:
    void add(bool ended_well) {
        ++runs_;
        well_ += ended_well ? 1 : 0;
    }
    ~Count() {
        EXPECT_GE(well_, 0.95 * runs_);
        ::testing::Test::RecordProperty("runs", runs_);
        ::testing::Test::RecordProperty("ended_well", well_);
    }
    Count() = default;
    Count(const Count&) = delete;
    Count& operator=(const Count&) = delete;

private:
    int runs_ = 0;
    int well_ = 0;
};

void expect_sound_ends(std::uint64_t first, std::uint64_t last, const Ground& ground) {
    Count count;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        Dice dice(seed);
        const Block block = support::random_block(dice, ground);
        SCOPED_TRACE(drawn(seed, block));
        const solver::Problem problem = block.problem();
        count.add(expect_sound(problem, run_to_its_end(problem)));
    }
}

// Without sources heat flows downhill alone: no temperature leaves the range of the start and the air. Backward Euler keeps
// to that but for Newton's share of the tolerance; of TR-BDF2 under error control each step may be off by the tolerance, and
// what it left decays in the next ones: three tolerances, as against the exact series (RobinSlab). Fixed steps of TR-BDF2
// promise nothing: its trapezoidal stage overshoots where a step is long beside a cell.
void expect_range(std::uint64_t first, std::uint64_t last, Ground ground) {
    ground.sources = false;
    Count count;
    double worst = 0.0;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        Dice dice(seed);
        Block block = support::random_block(dice, ground);
        if (block.settings.method == solver::Method::tr_bdf2) {
            block.settings.fixed_step.reset();
        }
        SCOPED_TRACE(drawn(seed, block));
        const solver::Problem problem = block.problem();
        const EndedRun run = run_to_its_end(problem);
        count.add(expect_sound(problem, run));
        const double beyond = std::max(block.coldest() - run.coldest, run.hottest - block.hottest());
        EXPECT_LE(beyond, 3.0 * block.settings.tolerance);
        worst = std::max(worst, beyond / block.settings.tolerance);
    }
    support::expect_below("beyond the range, tolerances", worst, 3.0);
}

// A block and its image in a mirror are one problem, numbered otherwise: the fields are mirror images.
void expect_mirror_images(std::uint64_t first, std::uint64_t last, const Ground& ground) {
    Count count;
    double worst = 0.0;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        Dice dice(seed);
        Block block = support::random_block(dice, ground);
        hold_steps(dice, block);
        SCOPED_TRACE(drawn(seed, block));
        const auto axis = static_cast<std::size_t>(dice.whole(0, 2));
        const EndedRun here = run_to_its_end(block.problem());
        const EndedRun there = run_to_its_end(block.mirrored(axis).problem());
        EXPECT_EQ(here.ok(), there.ok()) << here.report.status.message << there.report.status.message;
        count.add(here.ok() && there.ok());
        double apart = 0.0;
        for (int cell = 0; cell < block.cells() && here.ok() && there.ok(); ++cell) {
            apart = std::max(apart, std::abs(here.field[static_cast<std::size_t>(cell)] -
                                             there.field[static_cast<std::size_t>(block.opposite(axis, cell))]));
        }
        EXPECT_LE(apart, block.settings.tolerance);
        worst = std::max(worst, apart);
    }
    support::expect_below("from the mirror image, K", worst, 1e-6);
}

// Effects add: whichever comes first, the sums are the same but for their last digit.
void expect_any_order(std::uint64_t first, std::uint64_t last, const Ground& ground) {
    Count count;
    double worst = 0.0;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        Dice dice(seed);
        Block block = support::random_block(dice, ground);
        hold_steps(dice, block);
        SCOPED_TRACE(drawn(seed, block));
        const solver::Problem problem = block.problem();
        const EndedRun one = run_to_its_end(problem);
        const EndedRun other = run_to_its_end(block.problem(dice.order(problem.effects.size())));
        EXPECT_EQ(one.ok(), other.ok()) << one.report.status.message << other.report.status.message;
        count.add(one.ok() && other.ok());
        if (one.ok() && other.ok()) {
            worst = std::max(worst, support::largest_difference(one.field, other.field));
            EXPECT_LE(support::largest_difference(one.field, other.field), block.settings.tolerance);
        }
    }
    support::expect_below("of another order, K", worst, 1e-6);
}

// With constant k, c and films the temperatures above 400 K are a linear function of those of the start and the air and of
// the sources: the field of the sum is the sum of the fields. Of schedules; the line through a log is held inside its
// samples, which is not linear. Some of the temperatures are far below any of a tire.
void expect_superposition(std::uint64_t first, std::uint64_t last, Ground ground) {
    constexpr double zero = 400.0;
    ground.linear = true;
    ground.logs = false;
    Count count;
    double worst = 0.0;
    for (std::uint64_t seed = first; seed <= last; ++seed) {
        Dice dice(seed);
        Block one = support::random_block(dice, ground);
        hold_steps(dice, one);
        SCOPED_TRACE(drawn(seed, one));
        Block other = one;
        Block both = one;
        other.power_density *= dice.between(0.0, 2.0);
        both.power_density = one.power_density + other.power_density;
        for (std::size_t i = 0; i < one.initial.size(); ++i) {
            other.initial[i] = dice.between(300.0, 500.0);
            both.initial[i] = one.initial[i] + other.initial[i] - zero;
        }
        for (std::size_t i = 0; i < one.air.size(); ++i) {
            other.air[i] = i > 0 && one.air[i] == one.air[i - 1] ? other.air[i - 1] : dice.between(300.0, 500.0);
            both.air[i] = one.air[i] + other.air[i] - zero;
        }
        const EndedRun a = run_to_its_end(one.problem());
        const EndedRun b = run_to_its_end(other.problem());
        const EndedRun sum = run_to_its_end(both.problem());
        count.add(a.ok() && b.ok() && sum.ok());
        double apart = 0.0;
        for (std::size_t i = 0; i < a.field.size(); ++i) {
            apart = std::max(apart, std::abs(a.field[i] + b.field[i] - zero - sum.field[i]));
        }
        EXPECT_LE(apart, one.settings.tolerance);
        worst = std::max(worst, apart);
    }
    support::expect_below("from the sum, K", worst, 1e-6);
}

}  // namespace

TEST(Extremes, EveryRunEndsWellOrWithASentence) {
    expect_sound_ends(1, 200, {});
    expect_sound_ends(201, 203, {.most_cells = 10000});
}

TEST(Extremes, NothingLeavesTheRangeOfTheStartAndTheAir) { expect_range(1001, 1120, {}); }

TEST(Extremes, MirroredBlockHasTheMirroredField) { expect_mirror_images(2001, 2150, {}); }

// Newton's method alone strays on one side of the mirror, and finds the steady state on the other.
TEST(Extremes, SteadyStateIsFoundOnEitherSide) {
    expect_mirror_images(30400, 30400, {.most_cells = 1000, .least_tolerance = 1e-5});
}

TEST(Extremes, OrderOfTheEffectsDoesNotMatter) { expect_any_order(3001, 3150, {}); }

TEST(Extremes, LinearBlocksSuperpose) { expect_superposition(4001, 4150, {}); }

// More of each, with more cells and tighter tolerances.
constexpr Ground wide{.most_cells = 1000, .least_tolerance = 1e-5};

TEST(ExtremesLong, EveryRunEndsWellOrWithASentence) { expect_sound_ends(10001, 10600, wide); }

TEST(ExtremesLong, NothingLeavesTheRangeOfTheStartAndTheAir) { expect_range(20001, 20400, wide); }

TEST(ExtremesLong, MirroredBlockHasTheMirroredField) { expect_mirror_images(30001, 30500, wide); }

TEST(ExtremesLong, OrderOfTheEffectsDoesNotMatter) { expect_any_order(40001, 40500, wide); }

TEST(ExtremesLong, LinearBlocksSuperpose) { expect_superposition(50001, 50500, wide); }

}  // namespace tiretherm
