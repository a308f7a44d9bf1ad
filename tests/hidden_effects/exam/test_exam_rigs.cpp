// SPDX-License-Identifier: BSD-3-Clause
// The benches to which an exam is set: does each say of itself what its case says, does its truth know what may be hidden,
// and is a data set of layers what it is asked to be?
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "exam/exam_hiding_truth.hpp"
#include "exam/exam_signals_truth.hpp"
#include "hidden_effects/exam/exam_evaluation.hpp"
#include "laser/laser_causes_truth.hpp"
#include "section/section_causes_truth.hpp"

namespace hidden_effects {

namespace {

const std::vector<const Rig*> every_rig{&two_node_rig(), &layers_rig(), &section_rig(), &laser_rig()};

/// One run of a bench with a sample every so many seconds, at the numbers that its case expects.
BenchRuns one_run(const Rig& rig, double interval) {
    BenchRuns runs{.rig = &rig};
    for (const FreeNumber& number : rig.of_bench) {
        runs.of_bench.push_back(number.expected);
    }
    runs.programmes.push_back(rig.draw(77, interval));
    runs.of_run.emplace_back(rig.of_run.size(), runs.programmes.front().air_temperature.front());
    return runs;
}

}  // namespace

// What the oracle takes for unknown, and the noise it whitens with, are the case's own: as many numbers, in its order, with
// the same priors (the loss's scale in shares of tan_delta_a), the same channels with the same deviations.
TEST(ExamRigs, SayWhatTheirCasesSay) {
    for (const Rig* rig : every_rig) {
        ExamDataSet data_set{.runs = {.rig = rig}, .hidden = {}, .oracle = {}};
        const BenchRuns runs = one_run(*rig, 8.0);
        data_set.logs = {rig->log(runs.programmes.front(), readings_of_run(runs, 0, {}, 1e-2))};
        const tiretherm::input::Experiment experiment = read_data_set(data_set);
        std::vector<FreeNumber> free = rig->of_bench;
        free.insert(free.end(), rig->of_run.begin(), rig->of_run.end());
        ASSERT_EQ(experiment.parameters.size(), free.size()) << rig->name;
        for (std::size_t i = 0; i < free.size(); ++i) {
            const auto& parameter = experiment.parameters[i];
            const double unit = parameter.name.ends_with("tan_delta_a") ? 2.14e15 : 1.0;
            EXPECT_EQ(!parameter.runs.empty(), i >= rig->of_bench.size()) << rig->name << " " << parameter.name;
            EXPECT_DOUBLE_EQ(parameter.prior / unit, free[i].expected) << rig->name << " " << parameter.name;
            EXPECT_DOUBLE_EQ(parameter.standard_deviation / unit, free[i].prior) << rig->name << " " << parameter.name;
        }
        const auto& channels = experiment.runs.front().problem.channels;
        ASSERT_EQ(channels.size(), rig->channels.size()) << rig->name;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            EXPECT_EQ(channels[c].name, rig->channels[c].name);
            EXPECT_DOUBLE_EQ(channels[c].standard_deviation.value_or(0.0), rig->channels[c].noise.standard_deviation);
        }
    }
}

// No name stands twice but for a conductivity's two numbers on the laser's layers, every number may be absent and is
// physical a typical step from there, and the truths know every one: they throw at what they do not.
TEST(ExamRigs, TheirTruthsKnowEveryCause) {
    for (const Rig* rig : every_rig) {
        std::set<std::string> names;
        for (const Variant& variant : *rig->variants) {
            EXPECT_TRUE(names.insert(variant.name() + "." + variant.key).second) << variant.name();
            const double typical = variant.absent + variant.typical;
            EXPECT_TRUE(variant.low <= variant.absent && variant.absent <= variant.high) << variant.name();
            EXPECT_TRUE(variant.low <= typical && typical <= variant.high) << variant.name();
        }
    }
    for (const Variant& variant : layers_variants()) {
        EXPECT_NO_THROW((void)gather_section({}, layers_channels, {cause_of(variant, variant.typical, 0.0)}));
    }
    for (const Variant& variant : section_variants()) {
        EXPECT_NO_THROW((void)gather_section({}, section_channels, {cause_of(variant, variant.typical, 0.0)}));
    }
    for (const Variant& variant : laser_variants()) {
        EXPECT_NO_THROW((void)gather_laser({cause_of(variant, variant.typical, 0.0)}));
    }
    EXPECT_THROW((void)rig_of("threads"), std::invalid_argument);
    EXPECT_THROW((void)draw_data_set(Kind::decoy, 0.0, 1, 0.0, layers_rig()), std::invalid_argument);
}

// The search for a size begins at a typical step and may go tenfold at once: what shows at 0.05 to 50 standard deviations
// in one run is found within eight steps. A cause that the truth left out would show nothing.
TEST(ExamRigs, EveryCauseOfLayersShows) {
    const Oracle oracle(one_run(layers_rig(), 8.0));
    for (const Variant& variant : layers_variants()) {
        const double shown = oracle.left_by({cause_of(variant, variant.absent + variant.typical, 0.0)}).norm();
        EXPECT_GT(shown, 0.05) << variant.name();
        EXPECT_LT(shown, 50.0) << variant.name();
    }
}

TEST(ExamRigs, APaperOfLayersHidesWhatItsKindSays) {
    const ExamDataSet single = draw_data_set(Kind::single, 10.0, 3, 8.0, layers_rig());
    ASSERT_EQ(single.hidden.size(), 1U);
    EXPECT_NEAR(single.oracle.front(), 10.0, 0.05);
    EXPECT_TRUE(single.alike.empty());
    const auto hidden = std::ranges::find(layers_variants(), answer_of(single), &Variant::name);
    ASSERT_NE(hidden, layers_variants().end());
    EXPECT_GT(std::abs(likeness(single, *hidden).correlation), 0.97);  // typical, not true size: nearly linear
}

// Every cause of the bench is tried on a source, which takes five seconds.
TEST(ExamRigsLong, ASourceOfLayersLooksLikeNoCause) {
    const ExamDataSet unknown = draw_data_set(Kind::unknown, 10.0, 3, 8.0, layers_rig());
    EXPECT_NEAR(unknown.oracle.front(), 10.0, 0.05);
    EXPECT_LT(std::abs(unknown.alike.front().correlation), 0.9);
    EXPECT_TRUE(unknown.source.id == "unknown_surface" || unknown.source.id == "unknown_crown") << unknown.source.id;
}

// Another hypothesis than the truth; and never further away than one of the two alone, which misses at most what the
// other shows: 10 standard deviations.
TEST(ExamRigs, ATwinIsAnotherExplanationThatComesNear) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
        const ExamDataSet data_set = draw_data_set(Kind::pair, 10.0, seed, 8.0);
        ASSERT_TRUE(data_set.confounded.has_value());
        EXPECT_NE(data_set.confounded->name, answer_of(data_set));
        EXPECT_LT(data_set.confounded->apart, 10.05) << answer_of(data_set);
        EXPECT_GT(data_set.confounded->apart, 0.0);
    }
}

// The laser's lamp takes the throttle's place: a source after it, or after the time, 1 at its largest.
TEST(ExamRigs, ASourceOfTheLaserFollowsItsLampOrTheTime) {
    const std::vector<RigProgramme> logged{laser_rig().draw(5, 0.0)};
    const RigProgramme after_lamp = driven_by({.place = "bottom", .signals = {"lamp"}}, logged).front();
    const RigProgramme after_time = driven_by({.place = "bottom", .signals = {"time"}}, logged).front();
    EXPECT_DOUBLE_EQ(*std::ranges::max_element(after_lamp.throttle), 1.0);
    EXPECT_DOUBLE_EQ(after_lamp.throttle[7] * *std::ranges::max_element(logged.front().throttle),
                     logged.front().throttle[7]);
    EXPECT_DOUBLE_EQ(after_time.throttle[12], 60.0 / 1200.0);  // a sample every 5 s for twenty minutes
}

}  // namespace hidden_effects
