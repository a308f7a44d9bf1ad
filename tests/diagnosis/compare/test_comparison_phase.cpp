// SPDX-License-Identifier: BSD-3-Clause
// Driving phases from constructed speed and slip histories whose phase at each time is known.

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "diagnosis/compare/phase.hpp"
#include "post/report/phase_text.hpp"

namespace tiretherm::diagnosis {
namespace {

using physics::find_signal;

Phase phase_at(const solver::Problem& problem, double time, bool of_car = false) {
    return diagnosis::phase_at(problem, time, problem.input_signals.at(time, solver::JumpSide::after), of_car);
}

/// 100 s at 20 m/s, to rest at 0.2 m/s2 by 200 s (0.02 g), at rest until 300 s.
solver::Problem coasting() {
    solver::Problem problem;
    problem.settings.start = 0.0;
    problem.settings.end = 300.0;
    problem.input_signals.add({.signal = find_signal("speed"), .time = {0, 100, 200, 300}, .value = {20, 20, 0, 0}});
    return problem;
}

TEST(Phase, FollowsTheSpeed) {
    // The fall counts over two seconds to either side: at 99 s it is 0.05 m/s2, at 101 s 0.15; 0.0981 is the bound.
    const solver::Problem problem = coasting();
    EXPECT_EQ(phase_at(problem, 0.0), Phase::free_rolling);
    EXPECT_EQ(phase_at(problem, 99.0), Phase::free_rolling);
    EXPECT_EQ(phase_at(problem, 101.0), Phase::slowing);
    EXPECT_EQ(phase_at(problem, 199.0), Phase::slowing);
    EXPECT_EQ(phase_at(problem, 199.6), Phase::standing);  // 0.08 m/s
    EXPECT_EQ(phase_at(problem, 300.0), Phase::standing);
}

TEST(Phase, ADriftOfTheSpeedIsNotSlowing) {
    // 5 m/s in 100 s are 0.05 m/s2, less than 0.01 g; rising is not falling.
    solver::Problem problem;
    problem.settings.end = 200.0;
    problem.input_signals.add({.signal = find_signal("speed"), .time = {0, 100, 120}, .value = {20, 15, 30}});
    EXPECT_EQ(phase_at(problem, 50.0), Phase::free_rolling);
    EXPECT_EQ(phase_at(problem, 110.0), Phase::free_rolling);
}

TEST(Phase, SlipComesBeforeSlowing) {
    for (const double degrees : {-0.31, 0.29, 0.31}) {
        solver::Problem problem = coasting();
        problem.input_signals.add(*find_signal("slip_angle"), degrees * std::numbers::pi / 180.0);
        EXPECT_EQ(phase_at(problem, 150.0), degrees == 0.29 ? Phase::slowing : Phase::slipping) << degrees;
        EXPECT_EQ(phase_at(problem, 250.0), Phase::standing);
    }
    solver::Problem problem = coasting();
    problem.input_signals.add(*find_signal("slip_ratio"), -0.006);
    EXPECT_EQ(phase_at(problem, 50.0), Phase::slipping);
}

// 4000 N of load: 15 % are 600 N. 500 N across and 331 N along make 599.6 N.
TEST(Phase, OfACarGoesByTheForces) {
    const auto phase = [](double along, double across) {
        solver::Problem problem;
        problem.settings.end = 100.0;
        for (const auto& [name, value] :
             {std::pair{"speed", 40.0}, std::pair{"vertical_load", 4000.0}, std::pair{"longitudinal_force", along},
              std::pair{"lateral_force", across}, std::pair{"slip_angle", 0.05}}) {
            problem.input_signals.add(*find_signal(name), value);
        }
        return phase_at(problem, 50.0, true);
    };
    EXPECT_EQ(phase(331.0, -500.0), Phase::straight);
    EXPECT_EQ(phase(333.0, -500.0), Phase::cornering);
    EXPECT_EQ(phase(-700.0, 500.0), Phase::braking);
    EXPECT_EQ(phase(700.0, 500.0), Phase::driving);
}

TEST(Phase, GoesByTheForcesOnlyAtACornerThatHasThem) {
    input::MeasuredRun run;
    run.corner = "FL";
    run.problem.input_signals.add(*find_signal("vertical_load"), 4000.0);
    EXPECT_FALSE(has_forces(run));
    run.problem.input_signals.add(*find_signal("lateral_force"), 0.0);
    EXPECT_TRUE(has_forces(run));
    run.corner.clear();
    EXPECT_FALSE(has_forces(run));
}

/// The phase at 50 s of a run of 100 s that has been rolling straight at this speed, or slows down at this rate.
Phase phase_of(double speed, double slip_degrees, double slip_ratio, double deceleration = 0.0) {
    solver::Problem problem;
    problem.settings.end = 100.0;
    problem.input_signals.add({.signal = find_signal("speed"),
                               .time = {0.0, 100.0},
                               .value = {speed + 50.0 * deceleration, speed - 50.0 * deceleration}});
    problem.input_signals.add(*find_signal("slip_angle"), slip_degrees * std::numbers::pi / 180.0);
    problem.input_signals.add(*find_signal("slip_ratio"), slip_ratio);
    return phase_at(problem, 50.0);
}

/// The number in a text before this unit.
double number_before(std::string_view text, std::string_view unit) {
    const std::size_t end = text.find(unit);
    const std::size_t begin = end == std::string_view::npos ? end : text.rfind(' ', end - 2) + 1;
    if (begin == std::string_view::npos) {
        ADD_FAILURE() << unit << " is not in: " << text;
        return 0.0;
    }
    return std::stod(std::string(text.substr(begin, end - begin)));
}

// Whoever reads the meaning of a phase in a report can rely on its numbers: a thousandth to either side of them the phase
// is another one.
TEST(Phase, ChangesAtTheNumbersOfItsMeaning) {
    const double speed = number_before(post::meaning_of(Phase::standing), " m/s");
    EXPECT_EQ(phase_of(0.999 * speed, 0.0, 0.0), Phase::standing);
    EXPECT_EQ(phase_of(1.001 * speed, 0.0, 0.0), Phase::free_rolling);
    const double degrees = number_before(post::meaning_of(Phase::slipping), " deg");
    EXPECT_EQ(phase_of(20.0, 0.999 * degrees, 0.0), Phase::free_rolling);
    EXPECT_EQ(phase_of(20.0, -1.001 * degrees, 0.0), Phase::slipping);
    const double ratio = 0.01 * number_before(post::meaning_of(Phase::slipping), " %");
    EXPECT_EQ(phase_of(20.0, 0.0, 0.999 * ratio), Phase::free_rolling);
    EXPECT_EQ(phase_of(20.0, 0.0, 1.001 * ratio), Phase::slipping);
    const double fall = 9.81 * number_before(post::meaning_of(Phase::slowing), " g");
    EXPECT_EQ(phase_of(20.0, 0.0, 0.0, 0.999 * fall), Phase::free_rolling);
    EXPECT_EQ(phase_of(20.0, 0.0, 0.0, 1.001 * fall), Phase::slowing);
}

// The words of the column `phase` in the files of compare.
TEST(Phase, NamesAreThoseOfTheFiles) {
    std::vector<std::string_view> names;
    for (const Phase phase : phases) {
        names.push_back(post::name_of(phase));
    }
    EXPECT_EQ(names, (std::vector<std::string_view>{"standing", "slipping", "slowing", "free rolling", "cornering",
                                                    "braking", "driving", "straight"}));
}

}  // namespace
}  // namespace tiretherm::diagnosis
