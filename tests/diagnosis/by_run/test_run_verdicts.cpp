// SPDX-License-Identifier: BSD-3-Clause
// Runs that hide different causes, diagnosed alone: each names its own. What a single run keeps of an experiment.

#include "diagnosis/by_run/run_verdicts.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "diagnosis/noise/noise_sample.hpp"
#include "diagnosis/practice_bench.hpp"
#include "post/diagnosis/run_verdicts.hpp"
#include "solver/sensitivity/prediction.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

/// The practice bench on its first two runs. @param more tables of the case
input::Experiment bench(const std::string& more) {
    std::string text = sample::practice_text();
    const std::size_t candidates = text.find("candidates = [");
    text = text.substr(0, candidates) + "candidates = [\"sensor_lag\", \"sidewall_convection\"]\n" + more;
    const input::Written written;
    return sample::read_bench(written.add("bench.toml", text),
                              {sample::practice() / "run1.csv", sample::practice() / "run2.csv"});
}

/// Puts what another model of a run says, with the sensors' white noise, in the place of what was measured.
void hide(input::MeasuredRun& run, const solver::Problem& truth) {
    const solver::Prediction read = solver::predict(truth, {.times = run.time});
    ASSERT_TRUE(read.status.ok()) << read.status.message;
    for (input::MeasuredSeries& series : run.series) {
        const double sigma = *run.problem.channels[series.channel].standard_deviation;
        const std::vector<double> noise = sample::draw({.sigma = sigma}, run.time, 5 + series.channel);
        for (std::size_t i = 0; i < run.time.size(); ++i) {
            series.value[i] = read.at(i, series.channel) + noise[i];
        }
    }
}

/// A late probe in the first run, heat through the sidewalls in the second.
input::Experiment with_different_causes() {
    input::Experiment experiment = bench("");
    const input::Experiment late = bench("[effects.sensor_lag]\ntau = \"60 s\"\nchannels = [\"bulk_temperature\"]\n");
    const input::Experiment lossy = bench("[effects.sidewall_convection]\nconductance = \"3 W/K\"\n");
    hide(experiment.runs[0], late.runs[0].problem);
    hide(experiment.runs[1], lossy.runs[1].problem);
    return experiment;
}

}  // namespace

// The bulk changes by tens of kelvin within minutes: 60 s late are several kelvin in noise of 0.3 K, and no flow through
// the sidewalls comes and goes with the change. 3 W/K times some 40 K are 120 W of about 1 kW, steadily, where a lag has no
// effect at all. So each run has one explanation of the two, and the set of the other must not hold it.
TEST(RunVerdicts, EachRunNamesItsOwnCause) {
    const input::Experiment experiment = with_different_causes();
    std::vector<std::string> told;  // of which run, in the order in which it was told
    const RunVerdicts found = diagnose_by_run(
        experiment,
        {.progress = [&](const Activity& activity, long /*simulations*/) { told.push_back(activity.run); }});
    ASSERT_EQ(found.runs.size(), 2U);
    EXPECT_EQ(told.front(), "run1");
    EXPECT_TRUE(std::ranges::is_sorted(told));  // the runs are diagnosed side by side, and told of one after another
    EXPECT_EQ(found.left_out, LeftOutRuns::none);
    EXPECT_EQ(found.runs[0].name, "run1");
    EXPECT_EQ(found.runs[1].name, "run2");
    for (const RunVerdict& run : found.runs) {
        ASSERT_TRUE(run.is_judged()) << run.name;
        ASSERT_EQ(run.hypotheses.size(), 1U) << run.name;
        ASSERT_EQ(run.hypotheses.front().size(), 1U) << run.name;
    }
    const Cause& lag = found.runs[0].hypotheses.front().front();
    EXPECT_EQ(lag.id, "sensor_lag");
    EXPECT_EQ(lag.channel, "bulk_temperature");
    EXPECT_LT(lag.numbers.front().low, 60.0);
    EXPECT_GT(lag.numbers.front().high, 60.0);
    const Cause& loss = found.runs[1].hypotheses.front().front();
    EXPECT_EQ(loss.id, "sidewall_convection");
    EXPECT_LT(loss.numbers.front().low, 3.0);
    EXPECT_GT(loss.numbers.front().high, 3.0);

    const Observations observations = observe(experiment);
    const Diagnosis all;
    const post::DiagnosisRecord record{.experiment = experiment,
                                       .observations = observations,
                                       .result = all,
                                       .case_file = "",
                                       .data = {},
                                       .warnings = {},
                                       .findings = {},
                                       .by_run = found};
    EXPECT_EQ(post::agreement_of(record),
              "run1 alone shows sensor_lag of bulk_temperature. run2 alone shows sidewall_convection.");
}

// Time that is up before the first run leaves out all of them, and says so.
TEST(RunVerdicts, NoRunBeginsWhenTimeIsUp) {
    const input::Experiment experiment = bench("");
    solver::stop_after(0.0);
    const RunVerdicts found = diagnose_by_run(experiment, {});
    solver::stop_after(std::numeric_limits<double>::infinity());
    EXPECT_TRUE(found.runs.empty());
    EXPECT_EQ(found.left_out, LeftOutRuns::stopped_after);
    EXPECT_FALSE(found.are_cut_short());  // none was begun: the answer of all together stands
    RunVerdicts some{.runs = {{.name = "run1"}}, .left_out = LeftOutRuns::stopped_after};
    EXPECT_TRUE(some.are_cut_short());
    some.left_out = LeftOutRuns::none;
    EXPECT_FALSE(some.are_cut_short());
    some.runs.front().stopped = Part::causes;
    EXPECT_TRUE(some.are_cut_short());
}

// Two shared numbers, and a start of two nodes for each of the two runs: a run alone has 4 of the 6, its own starts as those
// of run 0.
TEST(RunVerdicts, ASingleRunKeepsTheSharedNumbersAndItsOwn) {
    input::Experiment experiment = bench("");
    ASSERT_EQ(experiment.parameters.size(), 6U);
    experiment.instruments = {{.name = "logger", .channels = {0, 1}}};
    const input::Experiment one = single_run(experiment, 1);
    ASSERT_EQ(one.runs.size(), 1U);
    EXPECT_EQ(one.runs.front().name, "run2");
    ASSERT_EQ(one.parameters.size(), 4U);
    for (const solver::FreeParameter& parameter : one.parameters) {
        const bool is_start = parameter.kind == solver::FreeParameter::Kind::initial;
        EXPECT_EQ(parameter.runs, is_start ? std::vector<std::size_t>{0} : std::vector<std::size_t>{})
            << parameter.name;
    }
    EXPECT_EQ(one.candidates, experiment.candidates);
    EXPECT_EQ(one.instruments.size(), 1U);
    experiment.runs[1].series.pop_back();  // a run that lacks a sensor of it says nothing of what they share
    EXPECT_TRUE(single_run(experiment, 1).instruments.empty());
}

}  // namespace tiretherm::diagnosis
