// SPDX-License-Identifier: BSD-3-Clause
// What a load that may be logged wrong leaves in doubt of a number that it looks like.

#include "diagnosis/assess/instrument_doubt.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {

namespace {

/// A load over the logged one, plausibly 0.9 to 1.1, likeliest 1: its mean square distance from 1 is 2 int_0^0.1 x^2 (0.1 - x) / 0.1^2 dx = 0.01 / 6.
Candidate load_gain() {
    Candidate candidate;
    candidate.effect = physics::find_effect("load_input_gain");
    candidate.absent = candidate.trial = 1.0;
    candidate.high = 10.0;
    return candidate;
}
const double plausible = std::sqrt(0.01 / 6.0);

/// One number, 3, whose unit moves the first of two readings by ten standard deviations of its noise, and a load that does as much as two
/// units of the number there, and `alone` standard deviations in the second, which the number does not move.
struct TwoReadings {
    explicit TwoReadings(double alone) {
        experiment.parameters.push_back({.name = "loss",
                                         .unit = "1",
                                         .layers = {},
                                         .knots = {},
                                         .nodes = {},
                                         .runs = {},
                                         .low = 2.95,
                                         .high = 100.0});
        observations.measured = Eigen::Vector2d::Zero();
        one.candidates = {};
        one.fit.values = Eigen::VectorXd::Constant(1, 3.0);
        one.fit.scale = Eigen::VectorXd::Ones(1);
        one.fit.raw = Eigen::Vector2d(10.0, 0.0);
        one.fit.precision = Eigen::VectorXd::Zero(1);
        one.fit.simulated = Eigen::Vector2d::Zero();
        one.fit.at_bound = {false};
        state.score_data.experiment = &experiment;
        state.score_data.observations = &observations;
        state.score_data.candidates = {load_gain()};
        state.score_data.signatures = Eigen::Vector2d(20.0, alone);
        state.set = {&one};
    }
    [[nodiscard]] double deviation(const std::vector<std::size_t>& on = {}) const {
        return deviations_by_instruments(state.score_data, one.fit, on)[0];
    }

    input::Experiment experiment;
    Observations observations;
    FittedHypothesis one;
    DiagnosisState state;
};

}  // namespace

// A load that is off by x moves the number by 2 x, and the readings say nothing of x: 2 sqrt(0.01 / 6) = 0.0816. Where the second
// reading tells x to 1 / alone, what is left open of it is 1 / sqrt(alone^2 + 600).
TEST(InstrumentDoubt, IsWhatTheDataLeaveOpenOfWhatIsPlausible) {
    EXPECT_NEAR(TwoReadings(0.0).deviation(), 2.0 * plausible, 1e-9);
    EXPECT_NEAR(TwoReadings(1000.0).deviation(), 2.0 / std::sqrt(1e6 + 600.0), 1e-9);
}

TEST(InstrumentDoubt, IsNoneOfWhatIsInTheModelOrHeldAtABound) {
    TwoReadings readings(0.0);
    EXPECT_EQ(readings.deviation({0}), 0.0);
    readings.one.fit.at_bound = {true};
    EXPECT_EQ(readings.deviation(), 0.0);
}

// Where the model is in doubt 3 +- 0.3 becomes 3 +- sqrt(0.3^2 + (1.96 x 0.0816)^2) = 3 +- 0.3400, but not below the least
// that the case allows. Where nothing is in doubt, or nothing is missing, the interval stays.
TEST(InstrumentDoubt, WidensIntervalsWhereTheModelIsInDoubt) {
    TwoReadings readings(0.0);
    Diagnosis found;
    found.verdict = Verdict::partial;
    found.free_numbers = {{.name = "loss", .unit = "1", .value = 3.0, .low = 2.7, .high = 3.3}};
    found.causes = {
        {.id = "wind", .numbers = {{.key = "speed", .unit = "m s-1", .value = 3.0, .low = 2.7, .high = 3.3}}}};
    widen_by_instruments(readings.state, found);
    EXPECT_DOUBLE_EQ(found.free_numbers.front().high, 3.3);
    readings.state.something_left = true;
    found.verdict = Verdict::consistent;
    widen_by_instruments(readings.state, found);
    EXPECT_DOUBLE_EQ(found.free_numbers.front().high, 3.3);
    found.verdict = Verdict::partial;
    widen_by_instruments(readings.state, found);
    EXPECT_NEAR(found.free_numbers.front().high, 3.0 + std::hypot(0.3, 1.959964 * 2.0 * plausible), 1e-9);
    EXPECT_DOUBLE_EQ(found.free_numbers.front().low, 2.95);
    EXPECT_DOUBLE_EQ(found.causes.front().numbers.front().high, 3.3);  // not of the model
}

// A speed is found to be wrong beside the load, which stays as doubtful as it was: the same 3 +- 0.3400.
TEST(InstrumentDoubt, WidensIntervalsWhereAnInstrumentIsFoundToBeWrong) {
    TwoReadings readings(0.0);
    readings.state.score_data.candidates.push_back(load_gain());
    readings.state.score_data.candidates.back().effect = physics::find_effect("speed_input_gain");
    readings.state.score_data.candidates.back().cause = 1;
    readings.state.score_data.signatures = Eigen::MatrixXd{{20.0, 0.0}, {0.0, 0.0}};
    readings.one.candidates = {1};
    Diagnosis found;
    found.verdict = Verdict::named;
    found.free_numbers = {{.name = "loss", .unit = "1", .value = 3.0, .low = 2.7, .high = 3.3}};
    widen_by_instruments(readings.state, found);
    EXPECT_NEAR(found.free_numbers.front().high, 3.0 + std::hypot(0.3, 1.959964 * 2.0 * plausible), 1e-9);
}

}  // namespace tiretherm::diagnosis
