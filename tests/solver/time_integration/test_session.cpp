// SPDX-License-Identifier: BSD-3-Clause
// Stepping from outside gives the numbers of a whole run, leaves the state after a refused step, and allocates nothing
// in a step.

#include "solver/time_integration/session.hpp"

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/time_integration/march.hpp"

// Counts every allocation of this executable, those of C libraries too. The sanitizers bring their own allocator.
#if !defined(__SANITIZE_ADDRESS__)
namespace {
std::atomic<long> allocations{0};
}
extern "C" {
void* __libc_malloc(std::size_t size);              // NOLINT: the name is glibc's
void* __libc_calloc(std::size_t n, std::size_t s);  // NOLINT
void* malloc(std::size_t size) {
    ++allocations;
    return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t s) {
    ++allocations;
    return __libc_calloc(n, s);
}
}
#endif

namespace tiretherm::solver {

namespace {

physics::Inputs inputs_at(double t) {
    return {.speed = 30.0 + 5.0 * std::sin(0.5 * t),
            .vertical_load = 4000.0 + 300.0 * std::sin(t),
            .slip_angle = 0.02 * std::sin(0.7 * t),
            .lateral_force = 2000.0 * std::sin(0.7 * t),
            .air_temperature = 296.15,
            .road_temperature = 303.15};
}

}  // namespace

TEST(Session, GivesTheNumbersOfTheBatchRunAtTheSameSteps) {
    // Inputs straight between multiples of 0.5 s, stepped by 0.5 s both ways.
    constexpr double dt = 0.5;
    constexpr int steps = 120;
    Problem problem = two_node_tire();
    problem.input_signals = {};
    for (const physics::Signal& signal : physics::signals()) {
        std::vector<double> time;
        std::vector<double> value;
        for (int i = 0; i <= steps; ++i) {
            time.push_back(dt * i);
            value.push_back(inputs_at(dt * i).*signal.member);
        }
        problem.input_signals.add(Series{.signal = &signal, .time = std::move(time), .value = std::move(value)});
    }
    problem.settings.end = dt * steps;
    problem.settings.fixed_step = dt;
    const MarchReport batch = run(problem, [](const Snapshot&) { return true; });
    ASSERT_TRUE(batch.status.ok());
    ASSERT_EQ(batch.steps, steps);

    Session session(problem, inputs_at(0.0));
    for (int i = 1; i <= steps; ++i) {
        ASSERT_TRUE(session.advance(dt, inputs_at(dt * i)).ok());
    }
    // The same arithmetic but for the interpolation of inputs inside a step and for the heat budget, which a session does
    // not close at each step: Newton's corrections end at 5 % of the tolerance.
    EXPECT_NEAR(session.channel(0), batch.channel_final[0], 0.05 * problem.settings.tolerance);
    EXPECT_NEAR(session.channel(1), batch.channel_final[1], 0.05 * problem.settings.tolerance);
    EXPECT_LT(session.energy_closure(), 1e-12);
}

TEST(Session, LeavesTheStateUntouchedWhenAStepIsRefused) {
    Session session(two_node_tire(), inputs_at(0.0));
    ASSERT_TRUE(session.advance(1.0, inputs_at(1.0)).ok());
    const double before = session.channel(1);
    EXPECT_FALSE(session.advance(-1.0, inputs_at(2.0)).ok());
    EXPECT_FALSE(session.advance(std::nan(""), inputs_at(2.0)).ok());
    physics::Inputs broken = inputs_at(2.0);
    broken.air_temperature = std::nan("");
    const Status status = session.advance(1.0, broken);
    EXPECT_EQ(status.outcome, Outcome::not_finite);
    EXPECT_EQ(session.channel(1), before);
    EXPECT_EQ(session.time(), 1.0);
    EXPECT_TRUE(session.advance(1.0, inputs_at(2.0)).ok());
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Session, AllocatesNothingInAStep) {
    // Two nodes, and 100 cells: the first steps size CHOLMOD's buffers, the thousand after them must not allocate.
    Problem layered = heated_strip(100);
    for (const Problem& problem : {two_node_tire(), layered}) {
        Session session(problem, inputs_at(0.0));
        for (int i = 1; i <= 10; ++i) {
            ASSERT_TRUE(session.advance(0.01, inputs_at(0.01 * i)).ok());
        }
        const long before = allocations;
        for (int i = 11; i <= 1010; ++i) {
            ASSERT_TRUE(session.advance(0.01, inputs_at(0.01 * i)).ok());
        }
        EXPECT_EQ(allocations - before, 0) << problem.mesh.kind;
    }
}
#endif

}  // namespace tiretherm::solver
