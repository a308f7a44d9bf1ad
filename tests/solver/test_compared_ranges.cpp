// SPDX-License-Identifier: BSD-3-Clause
// Speeds and loads beyond those at which the laws were compared with measurements.
#include "solver/compared_ranges.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "support/tire_section.hpp"

namespace tiretherm::solver {

namespace {

std::vector<std::string> said(const std::vector<double>& kmh, double load) {
    Problem problem = support::tire_problem(1);
    problem.input_signals = {};
    std::vector<double> time;
    std::vector<double> speed;
    for (const double one : kmh) {
        time.push_back(60.0 * static_cast<double>(time.size()));
        speed.push_back(one / 3.6);
    }
    problem.settings.end = time.back();
    support::schedule(problem, "speed", time, speed);
    support::hold(problem, "vertical_load", load);
    std::vector<std::string> sentences;
    for (const BeyondCompared& law : beyond_compared(problem)) {
        sentences.push_back(std::string(law.effect) + ": " + law.text());
    }
    return sentences;
}

}  // namespace

// The loss was compared at 40 to 150 km/h and 3 to 8 kN. A test that begins at rest is judged by its highest speed.
TEST(ComparedRanges, ATestBeyondTheLawsSpeedIsTold) {
    EXPECT_TRUE(said({0.0, 150.0, 150.0}, 4000.0).empty());
    EXPECT_EQ(said({0.0, 150.0, 260.0, 0.0}, 4000.0),
              std::vector<std::string>{"strain_energy_loss: compared up to 150 km/h, this test goes to 260"});
    EXPECT_EQ(said({0.0, 100.0}, 900.0),
              std::vector<std::string>{"strain_energy_loss: compared from 3 kN on, this test stays below 0.9"});
    EXPECT_EQ(said({0.0, 20.0}, 4000.0).size(), 1U);
}

namespace {

Problem warmed_up(double speed, double load) {
    Problem problem = support::tire_problem(1);
    problem.input_signals = {};
    problem.settings.end = 60.0;
    support::hold(problem, "speed", speed);
    support::hold(problem, "vertical_load", load);
    support::hold(problem, "air_temperature", 296.15);
    return problem;
}

std::vector<std::string> said_of(const Problem& problem, const std::string& effect) {
    std::vector<std::string> sentences;
    for (const BeyondCompared& law : beyond_compared(problem)) {
        if (law.effect == effect) {
            sentences.push_back(law.text());
        }
    }
    return sentences;
}

void put(Problem& problem, const char* id) {
    const physics::Effect* effect = physics::find_effect(id);
    std::erase_if(problem.effects, [&](const physics::ActiveEffect& active) { return active.effect == effect; });
    problem.effects.push_back(physics::activate(*effect, problem.mesh));
}

}  // namespace

// Re = V L/nu with 1/L = 1/D + 1/W: the thesis's tire has L = 0.16790 m, and at 100 m/s in air of 1.5e-5 m2/s Re = 1.1193e6.
// The thesis fitted (32) from 1e4 to 1e6.
TEST(ComparedRanges, AFilmBeyondTheReynoldsNumbersOfItsFitIsTold) {
    Problem problem = warmed_up(100.0, 4000.0);
    put(problem, "air_convection");
    EXPECT_EQ(said_of(problem, "air_convection"),
              std::vector<std::string>{"fitted up to 1 million (Reynolds number), this test goes to 1.119"});
    problem.input_signals = {};
    support::hold(problem, "speed", 80.0);
    EXPECT_TRUE(said_of(problem, "air_convection").empty());
}

// A rotating disk was measured up to Re = w R0^2/nu = 7e5. The constant film knows no speed.
TEST(ComparedRanges, ADiskBeyondItsMeasurementsIsToldOnlyWhereItIsTaken) {
    Problem problem = warmed_up(50.0, 4000.0);
    put(problem, "sidewall_convection");
    EXPECT_TRUE(said_of(problem, "sidewall_convection").empty());
    physics::ActiveEffect& sidewalls = problem.effects.back();
    sidewalls.choices[static_cast<std::size_t>(physics::find_choice(*sidewalls.effect, "film"))] = 1;
    const std::vector<std::string> found = said_of(problem, "sidewall_convection");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(
        found.front().starts_with("measured up to 0.7 million (Reynolds number of the disk), this test goes to 1.0"))
        << found.front();
}

// 420 kPa over the 220 kPa at which the laws hold are 1.909; the tests of SAE J2452 go to 1.7.
TEST(ComparedRanges, APressureBeyondThoseOfTheLossIsTold) {
    Problem problem = warmed_up(25.0, 4000.0);
    support::hold(problem, "inflation_pressure", 420e3);
    EXPECT_TRUE(said_of(problem, "strain_energy_loss").empty());
    problem.tire.reference_pressure = 220e3;
    EXPECT_EQ(said_of(problem, "strain_energy_loss"),
              std::vector<std::string>{"compared up to 1.7 times its reference pressure, this test goes to 1.909"});
}

// Left and right turns count alike: 30 degrees to either side are beyond 25.
TEST(ComparedRanges, ASlipAngleIsJudgedByItsSize) {
    Problem problem = warmed_up(25.0, 4000.0);
    put(problem, "slip_input_gain");
    support::hold(problem, "slip_angle", -30.0 * std::numbers::pi / 180.0);
    EXPECT_EQ(said_of(problem, "slip_input_gain"),
              std::vector<std::string>{"stated up to 25 degrees, this test goes to 30"});
}

// 260 km/h of the second run go further than 200 of the first: one sentence for both. Loads below the range are no extrapolation
// that a headline would name.
TEST(ComparedRanges, SeveralRunsAreToldByTheFurthest) {
    Extrapolations extrapolations;
    extrapolations.add(warmed_up(200.0 / 3.6, 900.0));
    extrapolations.add(warmed_up(260.0 / 3.6, 900.0));
    EXPECT_EQ(extrapolations.phrase(), "strain energy loss compared up to 150 km/h, this test goes to 260");
    EXPECT_EQ(extrapolations.headline(),
              std::vector<std::string>{"Laws beyond what is known of them: strain energy loss compared up to 150 km/h, "
                                       "this test goes to 260."});
    EXPECT_EQ(extrapolations.warnings(),
              std::vector<std::string>{"strain_energy_loss was compared up to 150 km/h, this test goes to 260: beyond, "
                                       "its law is an extrapolation"});
    EXPECT_TRUE(Extrapolations().headline().empty());
}

}  // namespace tiretherm::solver
