// SPDX-License-Identifier: BSD-3-Clause
// Steps that span logged samples keep the exact energy, mean and first moment of the inputs and of their products.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>
#include <vector>

#include "solver/system.hpp"
#include "solver/time_integration/step_forcing.hpp"
#include "tests/support/laser_strip.hpp"
#include "tests/support/order.hpp"
#include "tests/support/two_node_case.hpp"

namespace tiretherm {
namespace {

double sawtooth(double t) { return 0.2 * (t - std::floor(t)); }
double swelling_sine(double t) { return 0.1 + t / 6000.0 + 0.09 * std::sin(2.0 * std::numbers::pi * t); }

TEST(LoggedSeries, LaserEnergyIsTheIntegralOfItsSamples) {
    // 600 s of a 1 Hz sawtooth and of a swelling 1 Hz sine, logged at 16 Hz. Steps that span many samples must give the
    // exact integral of the line through them: 1e-9 relative is round-off of some 1e4 sums with room. Asked of steps of
    // the error control and of fixed steps that share no sample.
    for (const support::Samples& power :
         {support::sampled(600.0, 1.0 / 16.0, sawtooth), support::sampled(600.0, 1.0 / 16.0, swelling_sine)}) {
        for (const double fixed : {0.0, 7.3}) {
            solver::Problem problem = support::laser_strip();
            support::log(problem, "laser_power", power.time, power.value);
            // 1 kW/m2 to and fro at 1 Hz move the surface by half a kelvin: at 2 K the error control lets steps span
            // it.
            problem.settings.tolerance = 2.0;
            if (fixed > 0.0) {
                problem.settings.fixed_step = fixed;
            }
            const solver::MarchReport report = support::run_closed(problem);
            support::expect_below(fixed > 0.0 ? "fixed" : "controlled",
                                  report.joules[support::strip::laser] / power.integral() - 1.0, 1e-9);
            EXPECT_LT(report.steps, 300) << "steps do not span the samples, the test says nothing";
            testing::Test::RecordProperty(fixed > 0.0 ? "steps_fixed" : "steps_controlled",
                                          static_cast<int>(report.steps));
        }
    }
}

TEST(LoggedSeries, ProductOfTwoLoggedInputsIsIntegratedExactly) {
    // Friction power 0.6 |Fy V tan(alpha)| with Fy and V both logged: a parabola between samples, which Simpson's rule
    // integrates exactly. The reference does so here, from the products at the samples and in the middle.
    const support::Samples force =
        support::sampled(300.0, 0.5, [](double t) { return 3000.0 + 1000.0 * std::sin(0.7 * t); });
    const support::Samples speed =
        support::sampled(300.0, 0.5, [](double t) { return 30.0 + 5.0 * std::cos(1.1 * t); });
    solver::Problem problem = support::two_node_problem({});
    support::log(problem, "lateral_force", force.time, force.value);
    support::log(problem, "speed", speed.time, speed.value);
    support::hold(problem, "vertical_load", 4000.0);
    support::hold(problem, "slip_angle", 0.02);
    support::hold(problem, "air_temperature", 296.15);
    support::hold(problem, "road_temperature", 296.15);
    support::start_at(problem, 296.15);
    problem.settings.end = 300.0;
    problem.settings.fixed_step = 25.0;
    const solver::MarchReport report = support::run_closed(problem);
    double integral = 0.0;
    for (std::size_t i = 0; i + 1 < force.time.size(); ++i) {
        const double middle = 0.25 * (force.value[i] + force.value[i + 1]) * (speed.value[i] + speed.value[i + 1]);
        integral += (force.time[i + 1] - force.time[i]) / 6.0 *
                    (force.value[i] * speed.value[i] + 4.0 * middle + force.value[i + 1] * speed.value[i + 1]);
    }
    integral *= 0.6 * std::tan(0.02);
    support::expect_below("relative_error", report.joules[2] / integral - 1.0, 1e-9);  // sliding_friction
}

TEST(LoggedSeries, StagesOfAStepCarryTheMeanAndTheFirstMoment) {
    // A step that spans samples sees the straight line with the same mean and first moment. Its value is mean + slope
    // (x - 1/2) at x = 0 and 1 of the step, and the moment of that about the middle is slope dt^2/12. The noise is
    // wider than the trend, so that the line stays inside the extremes of the samples; steps begin on samples and
    // between them.
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> noise(-3.0, 3.0);
    const support::Samples walk =
        support::sampled(100.0, 1.0, [&](double t) { return 5.0 + 0.03 * t + noise(engine); });
    solver::Problem problem = support::laser_strip();
    support::log(problem, "laser_power", walk.time, walk.value);
    const solver::System system(problem);
    for (const solver::Method method : {solver::Method::tr_bdf2, solver::Method::backward_euler}) {
        const solver::Tableau& tableau = solver::tableau(method);
        solver::StepForcing forcing(system, problem.input_signals, tableau);
        for (const auto& [from, to] :
             {std::pair{10.0, 50.0}, std::pair{10.4, 49.7}, std::pair{0.0, 100.0}, std::pair{63.2, 75.0}}) {
            support::Samples piece;
            piece.time.push_back(from);
            std::copy_if(walk.time.begin(), walk.time.end(), std::back_inserter(piece.time),
                         [begin = from, end = to](double t) { return t > begin && t < end; });
            piece.time.push_back(to);
            for (const double t : piece.time) {
                piece.value.push_back(problem.input_signals.series()[0].at(t, solver::JumpSide::before));
            }
            forcing.open(from, to);
            const double dt = to - from;
            const double first = forcing.stage(0)[0];
            const double last = forcing.stage(tableau.stages - 1)[0];
            const double round_off = 1e-13 * piece.integral();
            EXPECT_NEAR(0.5 * (first + last) * dt, piece.integral(), round_off);
            EXPECT_NEAR((last - first) * dt * dt / 12.0, piece.moment(0.5 * (from + to)), dt * round_off);
        }
    }
}

TEST(LoggedSeries, LineOfAStepStaysInsideTheSamples) {
    // Off for most of the step and on at its end: the line with the same moment would begin below zero, a laser that
    // cools. Its slope is cut, its mean is not: 1 W for a tenth of the time.
    solver::Problem problem = support::laser_strip();
    support::log(problem, "laser_power", {0.0, 50.0, 90.0, 90.5, 100.0}, {0.0, 0.0, 0.0, 1.0, 1.0});
    const solver::System system(problem);
    solver::StepForcing forcing(system, problem.input_signals, solver::tr_bdf2);
    forcing.open(0.0, 100.0);
    EXPECT_NEAR(0.5 * (forcing.stage(0)[0] + forcing.stage(2)[0]), (0.25 + 9.5) / 100.0, 1e-15);
    for (int i = 0; i < 3; ++i) {
        EXPECT_GE(forcing.stage(i)[0], -1e-15);
        EXPECT_LE(forcing.stage(i)[0], 1.0);
    }
}

TEST(LoggedSeries, AStepBesideAnotherFindsTheSameFromTheInputsOfThat) {
    // Another exponent of the film changes the film's coefficients alone: found beside the step of the case they are, to the last bit, those
    // that are found alone, in a step that spans samples as in one between two of them. The other forcing is asked of nothing but the film.
    const support::Samples speed = support::sampled(60.0, 0.5, [](double t) { return 30.0 + 5.0 * std::cos(1.1 * t); });
    solver::Problem problem = support::two_node_problem({});
    support::log(problem, "speed", speed.time, speed.value);
    support::hold(problem, "vertical_load", 4000.0);
    support::hold(problem, "air_temperature", 296.15);
    support::hold(problem, "road_temperature", 296.15);
    solver::Problem other = problem;
    std::vector<std::size_t> film;
    for (std::size_t e = 0; e < other.effects.size(); ++e) {
        physics::ActiveEffect& active = other.effects[e];
        if (active.effect->id == "air_convection") {
            active.parameters[static_cast<std::size_t>(physics::find_parameter(*active.effect, "exponent"))] *= 1.01;
            film.push_back(e);
        }
    }
    ASSERT_EQ(film.size(), 1U);
    const solver::System system(problem);
    const solver::System changed(other);
    solver::StepForcing base(system, problem.input_signals, solver::tr_bdf2);
    solver::StepForcing alone(changed, other.input_signals, solver::tr_bdf2);
    solver::StepForcing beside(changed, other.input_signals, solver::tr_bdf2);
    for (const auto& [from, to] : {std::pair{10.0, 17.2}, std::pair{17.2, 17.4}}) {
        base.open(from, to);
        alone.open(from, to);
        beside.open_beside(base, film);
        EXPECT_EQ(beside.averaged(), alone.averaged());
        for (int i = 0; i < solver::tr_bdf2.stages; ++i) {
            EXPECT_FALSE(std::ranges::equal(beside.stage(i), base.stage(i)));
            EXPECT_TRUE(std::ranges::equal(beside.stage(i), alone.stage(i)));
        }
    }
}

TEST(LoggedSeries, TemperaturesOfLongStepsAreThoseOfTheSamples) {
    // Truth: the same samples as a schedule, whose every point is a step, to 1e-5 K. Logged, the run makes far fewer
    // steps than there are samples and stays within three tolerances, in front and behind, every minute.
    const support::Samples load =
        support::sampled(600.0, 1.0, [](double t) { return 0.5 + 0.02 * std::sin(2.0 * std::numbers::pi * t / 5.0); });
    solver::Problem logged = support::laser_strip();
    support::log(logged, "laser_power", load.time, load.value);
    logged.settings.tolerance = 0.5;
    solver::Problem scheduled = support::laser_strip();
    support::schedule(scheduled, "laser_power", load.time, load.value);
    scheduled.settings.tolerance = 1e-5;
    for (solver::Problem* problem : {&logged, &scheduled}) {
        problem->settings.output_interval = 60.0;
    }
    const support::History a = support::record(logged);
    const support::History b = support::record(scheduled);
    ASSERT_EQ(a.time.size(), b.time.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < a.time.size(); ++i) {
        for (std::size_t c = 0; c < 2; ++c) {
            worst = std::max(worst, std::abs(a.channels[i][c] - b.channels[i][c]));
        }
    }
    support::expect_below("largest_difference", worst, 3.0 * logged.settings.tolerance);
    testing::Test::RecordProperty("steps", static_cast<int>(a.report.steps));
    EXPECT_GE(b.report.steps, 600);
    EXPECT_LT(a.report.steps, 200);
}

}  // namespace
}  // namespace tiretherm
