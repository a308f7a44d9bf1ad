// SPDX-License-Identifier: BSD-3-Clause
// Words for heat in a window of one run, and for faults that a free number hides.

#include "diagnosis/assess/window_names.hpp"

#include <gtest/gtest.h>

#include "diagnosis/assess/lookalikes.hpp"
#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Heat at a place from 600 s to 660 s of run1, with its neighbours: windows of 60 s, of which those before 540 s have none.
Diagnosis heat_in_window(const std::string& place, double watts) {
    Diagnosis found;
    found.unknown = UnknownSource{.place = place, .watts = watts, .from = 600.0, .to = 660.0, .run = "run1"};
    for (int window = 0; window < 20; ++window) {
        const bool is_there = window >= 9 && window < 12;
        found.missing_heat.push_back({.run = 0,
                                      .place = place,
                                      .from = 60.0 * window,
                                      .to = 60.0 * (window + 1),
                                      .watts = is_there ? watts : 0.0,
                                      .deviation = 10.0});
    }
    return found;
}

}  // namespace

// 300 W less at the surface of a tire that turns, for three windows, 540 s to 720 s.
TEST(WindowNames, HeatTakenFromTheTreadWhileItMovesIsRain) {
    const input::Experiment bench = sample::practice_bench();
    Diagnosis found = heat_in_window("surface", -300.0);
    name_window(bench, found);
    ASSERT_EQ(found.remarks.size(), 1U);
    EXPECT_EQ(found.remarks.front(), remark::rain_would_do_this("run1", 540.0, 720.0));
}

// Heat that comes, or in the bulk, has no name while the tire turns.
TEST(WindowNames, OtherHeatHasNone) {
    const input::Experiment bench = sample::practice_bench();
    for (Diagnosis found : {heat_in_window("surface", 300.0), heat_in_window("bulk", -300.0), Diagnosis{}}) {
        name_window(bench, found);
        EXPECT_TRUE(found.remarks.empty());
    }
}

// One free number, a loss of 2.14e15 +- 2.14e14 that is fitted as 0.8 of that. A signature that is ten times the loss's, per unit of a gain,
// is that of a gain in proportion: 1 more of it is 10 standard deviations of the prior, all of the loss, and 0.8 makes the loss what
// was known. One at a right angle to it is not the loss.
TEST(Lookalikes, AnInputThatIsWrongHidesInANumber) {
    input::Experiment bench = sample::practice_bench();
    bench.parameters = {bench.parameters[sample::index_of(bench, sample::loss)]};
    const std::vector<Candidate> candidates = candidates_of(bench, {"load_input_gain", "speed_input_gain"});
    ASSERT_EQ(candidates.size(), 2U);
    ScoreTestData score_data;
    score_data.experiment = &bench;
    score_data.candidates = candidates;
    score_data.base.values = Eigen::VectorXd::Constant(1, 0.8 * 2.14e15);
    score_data.base.scale = Eigen::VectorXd::Constant(1, 2.14e14);
    score_data.base.slopes.resize(3, 1);
    score_data.base.slopes << 30.0, 40.0, 0.0;
    score_data.columns.resize(3, 2);
    score_data.columns << 300.0, 40.0, 400.0, -30.0, 0.0, 100.0;
    const std::vector<Lookalike> found = lookalikes_of(score_data);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().cause, "load_input_gain");
    EXPECT_EQ(found.front().number, sample::loss);
    EXPECT_NEAR(found.front().value, 0.8, 1e-9);
    EXPECT_NEAR(found.front().correlation, 1.0, 1e-9);
    EXPECT_TRUE(found.front().is_input);
    EXPECT_TRUE(found.front().is_far);
}

// Two sentences at most, of inputs alone, where nothing is missing and the number is far from what was known.
TEST(Lookalikes, FewSentencesAreSaid) {
    Diagnosis found;
    found.cannot_see = {{.cause = "load_input_gain", .key = "gain", .is_input = true, .is_far = true},
                        {.cause = "speed_input_gain", .key = "gain", .is_input = true, .is_far = false},
                        {.cause = "slip_input_gain", .key = "gain", .is_input = true, .is_far = true},
                        {.cause = "input_delay", .key = "speed", .is_input = true, .is_far = true},
                        {.cause = "sensor_gain", .key = "excess", .is_far = true}};
    found.verdict = Verdict::partial;
    remark_on_lookalikes(found);
    EXPECT_TRUE(found.remarks.empty());
    found.verdict = Verdict::consistent;
    remark_on_lookalikes(found);
    ASSERT_EQ(found.remarks.size(), 2U);
    EXPECT_EQ(std::get<std::string>(found.remarks.back().about.front()), "slip_input_gain");
}

}  // namespace tiretherm::diagnosis
