// SPDX-License-Identifier: BSD-3-Clause
// What fitted parameters of the practice bench say in words: against priors, bounds and plausible ranges.
#include "diagnosis/findings/parameter_findings.hpp"
#include "diagnosis/findings/sensor_kind.hpp"
#include "diagnosis/practice_bench.hpp"
#include "input/runs/reader.hpp"
#include "post/report/remark_text.hpp"
#include "support/written.hpp"

namespace tiretherm::diagnosis {

namespace {

/// The bench fitted exactly to what was known before, with a tenth of the prior's standard deviation.
struct FittedBench {
    input::Experiment experiment = sample::practice_bench();
    std::vector<FittedParameter> fitted{};
    std::vector<double> before{};

    FittedBench() {
        for (const solver::FreeParameter& one : experiment.parameters) {
            fitted.push_back({.value = one.prior, .standard_deviation = 0.1 * one.standard_deviation});
            before.push_back(one.prior);
        }
    }
    /// Frees a number of an effect that is on, in the place of the film's scale.
    std::size_t free(std::string_view effect, std::string_view key, double prior, double deviation) {
        const solver::Problem& problem = experiment.runs.front().problem;
        const std::size_t j = sample::index_of(experiment, sample::film);
        solver::FreeParameter& number = experiment.parameters[j];
        number.effect = static_cast<std::size_t>(
            std::ranges::find_if(problem.effects, [&](const auto& active) { return active.effect->id == effect; }) -
            problem.effects.begin());
        number.parameter =
            static_cast<std::size_t>(physics::find_parameter(*problem.effects[number.effect].effect, key));
        number.name = std::string(effect) + "." + std::string(key);
        number.unit = problem.effects[number.effect].effect->parameters[number.parameter].unit;
        number.prior = before[j] = fitted[j].value = prior;
        number.standard_deviation = deviation;
        fitted[j].standard_deviation = 0.1 * deviation;
        return j;
    }
    [[nodiscard]] std::vector<std::string> findings() const {
        std::vector<std::string> sentences;
        for (const ParameterFinding& one : parameter_findings(experiment, fitted, before)) {
            sentences.push_back(post::text_of(one.remark));
        }
        return sentences;
    }
};

bool says(const std::string& sentence, std::string_view part) { return sentence.find(part) != std::string::npos; }

}  // namespace

// 3.6 from a prior of 1 +- 3 are 1.2 of its standard deviations, whatever the data leave: a fit that is hardly sharper than the
// prior, as of 2.14e15 +- 2.1e14 that ends at 1.99e15, has moved by 0.71 of them and by no more.
TEST(ParameterFindings, AMoveIsMeasuredInStandardDeviationsOfWhatWasKnown) {
    solver::FreeParameter parameter;
    parameter.prior = 1.0;
    parameter.standard_deviation = 3.0;
    EXPECT_NEAR(conflict_with_prior(parameter, {.value = 4.6, .standard_deviation = 2.4}), 1.2, 1e-12);
    EXPECT_NEAR(conflict_with_prior(parameter, {.value = 4.6, .standard_deviation = 2.99}), 1.2, 1e-12);
    parameter.prior = 2.14e15;
    parameter.standard_deviation = 2.1e14;
    EXPECT_NEAR(conflict_with_prior(parameter, {.value = 1.99e15, .standard_deviation = 2.085e14}), -0.714, 0.001);
    parameter.standard_deviation = std::numeric_limits<double>::infinity();  // nothing was known
    EXPECT_EQ(conflict_with_prior(parameter, {.value = 4.6, .standard_deviation = 2.4}), 0.0);
}

// A normal number passes 2.5 with a chance of 0.0124: four of them in one of 20. Of eight each may do so with 0.05/8 =
// 0.00625, at 2.734 (two-sided, from a table of the normal distribution).
TEST(ParameterFindings, ManyPriorsNeedALargerConflict) {
    EXPECT_EQ(least_conflict(0), 2.5);
    EXPECT_EQ(least_conflict(4), 2.5);
    EXPECT_NEAR(least_conflict(8), 2.734, 0.001);
    EXPECT_GT(least_conflict(50), least_conflict(8));
}

TEST(ParameterFindings, NothingIsSaidOfAFitAsExpected) {
    FittedBench bench;
    EXPECT_TRUE(bench.findings().empty());
    // 2.6 prior deviations, less than the 2.73 of eight parameters.
    const std::size_t film = sample::index_of(bench.experiment, sample::film);
    bench.fitted[film].value += 2.6 * bench.experiment.parameters[film].standard_deviation;
    EXPECT_TRUE(bench.findings().empty());
    // Not determined: whatever its value, nothing can be said.
    bench.fitted[film] = {.value = 9.0, .standard_deviation = std::numeric_limits<double>::infinity()};
    EXPECT_TRUE(bench.findings().empty());
}

// A start known to 3 K that is fitted 16.5 K off is 5.5 deviations off, and beyond the 15 K that are
// expected by more than its deviation of 0.3 K: one sentence.
TEST(ParameterFindings, AStartFarOffItsPriorIsOneSentenceWithWhatToDo) {
    FittedBench bench;
    const auto& parameters = bench.experiment.parameters;
    const auto start = static_cast<std::size_t>(
        std::ranges::find(parameters, solver::FreeParameter::Kind::initial, &solver::FreeParameter::kind) -
        parameters.begin());
    ASSERT_LT(start, parameters.size());
    ASSERT_EQ(parameters[start].standard_deviation, 3.0);
    bench.fitted[start].value = 16.5;
    const std::vector<std::string> findings = bench.findings();
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_TRUE(findings[0].starts_with(parameters[start].name)) << findings[0];
    EXPECT_TRUE(says(findings[0],
                     "the data pull it to 16.5 K, 5.5 standard deviations above the 0 +- 3 that were known before"))
        << findings[0];
    EXPECT_TRUE(says(findings[0], "and outside -15 to 15")) << findings[0];
    EXPECT_TRUE(says(findings[0], "began earlier than the log")) << findings[0];
}

// The averaged contact of the thesis, 500 +- 100 W/m2K, fitted to 1 400: 9 deviations.
TEST(ParameterFindings, AContactThatWantsMoreAsksForARollingOne) {
    FittedBench bench;
    bench.fitted[bench.free("road_contact", "Hc", 500.0, 100.0)].value = 1400.0;
    const std::vector<std::string> findings = bench.findings();
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_TRUE(
        says(findings[0], "road_contact.Hc: the data pull it to 1.4e+03 W m-2 K-1, 9.0 standard deviations above"))
        << findings[0];
    EXPECT_TRUE(says(findings[0], "resolved_contact")) << findings[0];
}

// Friction of half the size beside a camera that has no lag of its own among the free numbers.
TEST(ParameterFindings, TooLittleFrictionBesideACameraAsksForItsLag) {
    FittedBench bench;
    const std::size_t friction = bench.free("sliding_friction", "lambda_y", 1.0, 0.1);
    bench.fitted[friction].value = 0.5;
    const std::vector<std::string> low = bench.findings();
    ASSERT_EQ(low.size(), 1U);
    EXPECT_TRUE(says(low[0], "outside 0.7 to 1.4")) << low[0];
    EXPECT_TRUE(says(low[0], "lag or delay of surface_temperature")) << low[0];
    EXPECT_TRUE(says(low[0], "free sensor_lag.tau and clock_delay.delay")) << low[0];
    bench.fitted[friction].value = 1.5;  // too much of it is no lag
    const std::vector<std::string> high = bench.findings();
    ASSERT_EQ(high.size(), 1U);
    EXPECT_FALSE(says(high[0], "sensor_lag")) << high[0];
}

TEST(ParameterFindings, ABoundIsAFinding) {
    FittedBench bench;
    const std::size_t film = sample::index_of(bench.experiment, sample::film);
    bench.fitted[film] = {.value = 1.02, .standard_deviation = 0.01, .at_bound = true};
    const std::vector<std::string> findings = bench.findings();
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_TRUE(says(findings[0], "the data pull it to 1.02, the bound of what is allowed")) << findings[0];
}

// The range of a loss tangent's factor is that of the thesis's tire. A case of another compound, whose own number lies
// outside before anything is fitted, is not judged by it.
TEST(ParameterFindings, ARangeDoesNotJudgeACaseThatStartsOutsideIt) {
    FittedBench bench;
    const std::size_t loss = sample::index_of(bench.experiment, sample::loss);
    const solver::Problem& problem = bench.experiment.runs.front().problem;
    EXPECT_NE(plausible_range_of(problem, bench.experiment.parameters[loss], 2.14e15), nullptr);
    EXPECT_EQ(plausible_range_of(problem, bench.experiment.parameters[loss], 4e14), nullptr);
}

// Two nodes: the camera looks at the surface's node, the probe's node has no outer face.
TEST(ParameterFindings, TheBenchHasACameraAndAProbe) {
    const input::Experiment experiment = sample::practice_bench();
    const solver::Problem& problem = experiment.runs.front().problem;
    ASSERT_EQ(problem.channels[0].name, "surface_temperature");
    ASSERT_EQ(problem.channels[1].name, "bulk_temperature");
    EXPECT_EQ(sensor_kind(problem, 0), physics::SensorKind::infrared);
    EXPECT_EQ(sensor_kind(problem, 1), physics::SensorKind::probe);
    // A number that is no sensor model's has no kind.
    EXPECT_EQ(sensor_kind(problem, experiment.parameters.front()), physics::SensorKind::any);
}

// What looks at the lit face of a specimen is a camera. At its back stands either: the name decides, and where it says nothing, as
// `back` does, nobody knows. A thermocouple is one on both faces.
TEST(SensorKind, OfASpecimensBackIsKnownByTheNameAlone) {
    const auto kind_of = [](const std::string& name, const std::string& patch) {
        const input::Written written;
        const input::Reading reading = input::read_case(written.add("case.toml", R"([mesh]
kind = "axisymmetric"
radius = [{ to = "20 mm", cells = 4 }]
[[mesh.layer]]
name = "tread"
thickness = "5 mm"
cells = 4
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.5 W/mK"
[drive]
air_temperature = "23 degC"
[initial]
temperature = "23 degC"
[time]
end = "10 s"
[[sensor]]
kind = "patch"
name = ")" + name + "\"\npatch = \"" + patch + "\"\n"));
        EXPECT_TRUE(reading.problem) << render(reading);
        return reading.problem ? sensor_kind(*reading.problem, 0) : physics::SensorKind::any;
    };
    EXPECT_EQ(kind_of("back", "bottom"), physics::SensorKind::any);
    EXPECT_EQ(kind_of("ir_back", "bottom"), physics::SensorKind::infrared);
    EXPECT_EQ(kind_of("back_tc", "bottom"), physics::SensorKind::probe);
    EXPECT_EQ(kind_of("front", "top"), physics::SensorKind::infrared);
    EXPECT_EQ(kind_of("front_tc", "top"), physics::SensorKind::probe);
}

}  // namespace tiretherm::diagnosis
