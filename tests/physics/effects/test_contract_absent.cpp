// SPDX-License-Identifier: BSD-3-Clause
// Every effect that may be missing from a model changes nothing at the value where it is absent, and something elsewhere.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "physics/effects/effect_contract.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::physics {

namespace {

/// All that an effect can change, as numbers: inputs, initial state, capacities, heat flow, rolling and at rest, into the
/// nodes that are there without it, and readings.
std::vector<double> evaluated(const Bench& bench, const std::vector<Part>& parts) {
    Whole whole(bench, parts);
    std::vector<double> T = whole.problem().initial;
    for (std::size_t own = bench.T.size(); own < T.size(); ++own) {
        T[own] += 4.0;  // nodes of effects, no longer at what surrounds them
    }
    whole.ask(lively(), T);
    const solver::System& system = whole.system();
    std::vector<double> numbers;
    const Inputs inputs = system.transformed(lively());
    for (const Signal& signal : signals()) {
        numbers.push_back(inputs.*signal.member);
    }
    const std::vector<double> initial = system.initial();
    for (std::size_t node = 0; node < bench.T.size(); ++node) {
        numbers.push_back(initial[node]);
        numbers.push_back(system.capacity(node, 310.0));
        numbers.push_back(system.heat_flow()[node]);
    }
    Inputs rest = lively();
    rest.speed = 0.0;
    whole.ask(rest, T);
    for (std::size_t node = 0; node < bench.T.size(); ++node) {
        numbers.push_back(system.heat_flow()[node]);
    }
    double value = 330.0;
    double lag = 0.0;
    double delay = 0.0;
    double clock_rate = 0.0;
    double depth_offset = 0.0;
    for (const ActiveEffect& active : system.effects()) {
        const SensorModel* model = active.effect->sensor_model();
        if (model == nullptr) {
            continue;
        }
        value = model->read != nullptr ? model->read(active, 0, value, lively()) : value;
        lag += model->lag != nullptr ? model->lag(active, 0) : 0.0;
        delay += model->delay != nullptr ? model->delay(active, 0) : 0.0;
        clock_rate += model->clock_rate != nullptr ? model->clock_rate(active, 0) : 0.0;
        depth_offset += model->depth_offset != nullptr ? model->depth_offset(active, 0) : 0.0;
    }
    numbers.insert(numbers.end(), {value, lag, delay, clock_rate, depth_offset});
    return numbers;
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
    double largest = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        largest = std::max(largest, std::abs(one[i] - other[i]) / (1.0 + std::abs(other[i])));
    }
    return largest;
}

solver::MarchReport run_for_a_minute(const Bench& bench, const std::vector<Part>& parts) {
    solver::Problem problem = Whole::problem_of(bench, parts);
    for (const Signal& signal : signals()) {
        problem.input_signals.add(signal, lively().*signal.member);
    }
    problem.settings.end = 60.0;
    problem.settings.fixed_step = 5.0;
    problem.settings.tolerance = 1e-6;  // Newton's iteration ends below a twentieth of it
    return solver::run(problem, [](const solver::Snapshot&) { return true; });
}

}  // namespace

TEST_P(EveryCandidate, DoesNothingWhereItIsAbsent) {
    for (const Bench& bench : benches()) {
        const std::vector<double> without = evaluated(bench, thesis(bench));
        EXPECT_LT(largest_difference(evaluated(bench, with(thesis(bench), silent(*GetParam()))), without), 1e-13);
    }
}

TEST_P(EveryCandidate, DoesSomethingWhereItIsNot) {
    const InputCorrection* correction = GetParam()->input_correction();
    if (correction != nullptr && correction->delay != nullptr) {
        // A moment does not show a delay, a run does: tests/solver/sensitivity/test_input_delay.cpp.
        EXPECT_EQ(correction->delay(physics::activate(*GetParam(), benches().front().mesh), signals().front()), 0.0);
        return;
    }
    double largest = 0.0;
    for (const Bench& bench : benches()) {
        largest = std::max(largest, largest_difference(evaluated(bench, with(thesis(bench), part())),
                                                       evaluated(bench, thesis(bench))));
    }
    EXPECT_GT(largest, 1e-4);
}

TEST_P(EveryCandidate, LeavesARunAsItIsWhereItIsAbsent) {
    // A minute in fixed steps: the same channels to the tolerance of Newton's iteration, the same joules of the others,
    // the balance closed with all lumped nodes.
    for (const Bench& bench : benches()) {
        const solver::MarchReport without = run_for_a_minute(bench, thesis(bench));
        const solver::MarchReport silenced = run_for_a_minute(bench, with(thesis(bench), silent(*GetParam())));
        ASSERT_TRUE(without.status.ok() && silenced.status.ok()) << silenced.status.message;
        EXPECT_LT(silenced.energy_closure, 1e-9);
        for (std::size_t c = 0; c < without.channel_final.size(); ++c) {
            EXPECT_NEAR(silenced.channel_final[c], without.channel_final[c], 1e-6);
        }
        for (std::size_t e = 0; e < without.joules.size(); ++e) {
            EXPECT_NEAR(silenced.joules[e], without.joules[e], 1e-6 * (1.0 + std::abs(without.joules[e])));
        }
    }
}

TEST_P(EveryCandidate, ClosesTheBalanceOfARun) {
    for (const Bench& bench : benches()) {
        const solver::MarchReport report = run_for_a_minute(bench, with(thesis(bench), part()));
        ASSERT_TRUE(report.status.ok()) << report.status.message;
        EXPECT_LT(report.energy_closure, 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryCandidate,
                         testing::ValuesIn(effects_that([](const Effect* e) { return has_absent(*e); })), id_of);

}  // namespace tiretherm::physics
