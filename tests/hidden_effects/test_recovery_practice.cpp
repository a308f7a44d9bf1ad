// SPDX-License-Identifier: BSD-3-Clause
// What the practice benches' own runs hold is found again: the tables of cases/practice/section_bench.md and laser_bench.md.
// The runs are fixed, so that these fits are as well; how often intervals hold the truth at all is asked elsewhere
// (BenchRecoveryLong).
#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/fit/identification.hpp"
#include "hidden_effects/section_bench_case.hpp"
#include "numerics/random_truth.hpp"

namespace hidden_effects {

namespace {

namespace input = tiretherm::input;
namespace diagnosis = tiretherm::diagnosis;

/// Fits a case of cases/practice to its own runs. @param truth [n_parameters] in their order and units
void expect_recovered(const std::string& name, const std::vector<double>& truth) {
    SCOPED_TRACE(name);
    const input::ExperimentReading reading =
        input::read_experiment(input::source_folder() / "cases/practice" / (name + ".toml"));
    ASSERT_TRUE(reading.experiment) << input::error_report(reading);
    const input::Experiment& experiment = *reading.experiment;
    const diagnosis::Identification fit = diagnosis::identify(experiment, diagnosis::observe(experiment));
    ASSERT_TRUE(fit.status.ok()) << fit.status.message;
    EXPECT_TRUE(fit.converged);
    ASSERT_EQ(fit.fitted.size(), truth.size());
    for (std::size_t j = 0; j < truth.size(); ++j) {
        const diagnosis::Fitted& one = fit.fitted[j];
        EXPECT_EQ(one.identifiability, diagnosis::Identifiability::determined) << experiment.parameters[j].name;
        EXPECT_LT(one.low, truth[j]) << experiment.parameters[j].name;
        EXPECT_GT(one.high, truth[j]) << experiment.parameters[j].name;
    }
}

/// Laps of 50 s, a sample a second: three corners of 4 to 6 s, each braked into and driven out of.
SectionProgramme timing_laps(std::size_t n, double first_speed) {
    SectionProgramme laps = first_of(draw_section_programme(406, 1.0), n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t s = i % 50;
        const bool left = s >= 10 && s < 14;
        const bool right = (s >= 24 && s < 30) || (s >= 40 && s < 45);
        const double turn = left ? 1.0 : (right ? -0.8 : 0.0);
        laps.speed[i] = std::round(10.0 * (turn != 0.0 ? 0.5 * first_speed : first_speed)) / 10.0;
        laps.vertical_load[i] = 3500.0 + 1000.0 * turn;
        laps.slip_angle[i] = 0.05 * turn;
        laps.lateral_force[i] = -3000.0 * turn;
        laps.camber[i] = 0.0;
    }
    return laps;
}

/// A signal some samples late.
void delay(std::vector<double>& signal, std::size_t samples) {
    signal.insert(signal.begin(), samples, signal.front());
    signal.resize(signal.size() - samples);
}

/// What comes late in a log of a sample a second, s.
struct Late {
    std::size_t camera = 0;
    std::size_t handling = 0;
};

/// The log of a run with noise of 0.5 and 0.3 K.
std::vector<Column> late_log(SectionProgramme laps, const std::vector<Cause>& causes, Late late, Random& random) {
    SectionTrace trace = drive_layers({.start = laps.air_temperature.front(), .causes = causes}, laps);
    delay(trace.channel.front(), late.camera);
    delay(laps.slip_angle, late.handling);
    delay(laps.lateral_force, late.handling);
    for (std::size_t c = 0; c < trace.channel.size(); ++c) {
        const std::vector<double> noise = draw_noise({.standard_deviation = c == 0 ? 0.5 : 0.3}, laps.time, random);
        for (std::size_t i = 0; i < noise.size(); ++i) {
            trace.channel[c][i] += noise[i];
        }
    }
    std::vector<Column> log = section_columns(laps, trace, layers_channels);
    std::erase_if(log, [](const Column& column) { return column.heading.starts_with("camber"); });
    return log;
}

/// Two runs of laps at speeds of their own. @param candidates empty: the whole catalogue
diagnosis::Diagnosis diagnosed_laps(const std::vector<Cause>& causes, Late late,
                                    const std::vector<std::string>& candidates, Random& random) {
    const std::vector<std::vector<Column>> logs{late_log(timing_laps(300, 55.0), causes, late, random),
                                                late_log(timing_laps(300, 47.0), causes, late, random)};
    auto experiment = read_with(input::source_folder() / "cases/practice/layers_bench.toml", logs);
    experiment.candidates = candidates;
    return diagnosis::diagnose(experiment, diagnosis::observe(experiment), {.only_verdict = true});
}

}  // namespace

TEST(PracticeRecovery, TheCrownInLayersGivesItsNumbersBack) {
    expect_recovered("layers_bench", {0.96, 1.05 * 2.14e15, -0.877, -3.431, -2.680});
}

TEST(PracticeRecovery, TheSectionGivesItsNumbersBack) {
    expect_recovered("section_bench", {1.04, 0.95 * 2.14e15, -0.028, -3.738, 1.381});
}

TEST(PracticeRecovery, TheLasersBenchGivesItsNumbersBack) {
    expect_recovered("laser_bench", {0.95, 11.5, 8.5, 1.703, -0.609, 0.884});
}

// Slip angle and lateral force 2 s late, as one estimate of both is: one delay for both, and not a delay of the camera to either side.
TEST(TimingRecovery, InputsOfOneLoggerHaveOneDelay) {
    Random random(11);
    const diagnosis::Diagnosis found =
        diagnosed_laps({}, {.handling = 2},
                       {"input_delay", "clock_delay", "sensor_lag", "slip_input_gain", "layer_conductivity"}, random);
    ASSERT_TRUE(found.status.ok()) << found.status.message;
    ASSERT_FALSE(found.hypotheses.empty());
    ASSERT_EQ(found.hypotheses.front().size(), 1U);
    const diagnosis::Cause& cause = found.causes[found.hypotheses.front().front()];
    EXPECT_EQ(cause.id, "input_delay");
    ASSERT_EQ(cause.numbers.size(), 2U);
    EXPECT_EQ(cause.numbers[0].key, "slip_angle");
    EXPECT_EQ(cause.numbers[1].key, "lateral_force");
    for (const diagnosis::CauseNumber& number : cause.numbers) {
        EXPECT_NEAR(number.value, 2.0, 0.3) << number.key;
    }
    EXPECT_TRUE(found.gain.confirmed);
}

}  // namespace hidden_effects
