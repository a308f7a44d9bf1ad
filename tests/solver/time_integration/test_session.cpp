// SPDX-License-Identifier: BSD-3-Clause
// Stepping from outside gives the numbers of a whole run, leaves the state after a refused step, and allocates nothing
// in a step.

#include "solver/time_integration/session.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/time_integration/march.hpp"

// Counts every allocation of this executable, those of C libraries too. The sanitizers bring their own allocator.
#ifndef TIRETHERM_SANITIZED
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

TEST(Session, AStateGoesOnWithTheSameDigits) {
    // Also with steps of several lengths, whose factors are part of it; in a new session, and in one that was elsewhere.
    for (const Problem& problem : {two_node_tire(), heated_strip(100)}) {
        const auto step = [](Session& session, int i) {
            return session.advance(i % 4 == 0 ? 0.5 : i % 4 == 1 ? 0.11 : 1.0, inputs_at(0.3 * i)).ok();
        };
        Session session(problem, inputs_at(0.0));
        for (int i = 0; i < 23; ++i) {
            ASSERT_TRUE(step(session, i));
        }
        const std::vector<double> state = session.state();
        EXPECT_EQ(session.state(), state) << "to keep it changes nothing";
        Session other(problem, inputs_at(7.0));
        ASSERT_TRUE(other.restore(state));
        EXPECT_EQ(other.channel(0), session.channel(0));
        EXPECT_EQ(other.time(), session.time());
        std::vector<double> straight_on;
        for (int i = 23; i < 60; ++i) {
            ASSERT_TRUE(step(session, i));
            ASSERT_TRUE(step(other, i));
            straight_on.push_back(session.channel(0));
            ASSERT_EQ(other.channel(0), session.channel(0)) << problem.mesh.kind << " step " << i;
        }
        ASSERT_TRUE(session.restore(state));
        for (int i = 23; i < 60; ++i) {
            ASSERT_TRUE(step(session, i));
            ASSERT_EQ(session.channel(0), straight_on[static_cast<std::size_t>(i - 23)]);
        }
        const double before = session.channel(0);
        EXPECT_FALSE(session.restore(std::span(state).first(state.size() - 1)));
        EXPECT_FALSE(session.restore({}));
        EXPECT_EQ(session.channel(0), before);
    }
}

TEST(Session, GoesOnWithOtherNumbersFromItsTemperatures) {
    // At once nothing has moved; a second session that has had them all along comes to the same steady state.
    Problem problem = two_node_tire();
    Problem warmer = problem;
    for (physics::ActiveEffect& active : warmer.effects) {
        if (active.effect->id == "air_convection") {
            active.parameters[0] *= 0.5;
        }
    }
    Session moved(problem, inputs_at(0.0));
    Session always(warmer, inputs_at(0.0));
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(moved.advance(1.0, inputs_at(0.0)).ok());
        ASSERT_TRUE(always.advance(1.0, inputs_at(0.0)).ok());
    }
    const std::vector<double> before(moved.temperature().begin(), moved.temperature().end());
    moved.exchange(warmer);
    EXPECT_TRUE(std::ranges::equal(moved.temperature(), before));
    EXPECT_EQ(moved.time(), 20.0);
    EXPECT_LT(moved.channel(1), always.channel(1) - 1e-3);
    for (int i = 0; i < 400; ++i) {
        ASSERT_TRUE(moved.advance(100.0, inputs_at(0.0)).ok());
        ASSERT_TRUE(always.advance(100.0, inputs_at(0.0)).ok());
    }
    EXPECT_NEAR(moved.channel(1), always.channel(1), 0.05 * problem.settings.tolerance);
}

#ifndef TIRETHERM_SANITIZED
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
