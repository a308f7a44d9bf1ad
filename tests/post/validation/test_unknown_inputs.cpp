// SPDX-License-Identifier: BSD-3-Clause
// Verdicts where inputs of an experiment are unknown: reach, total uncertainty, what is decided over the whole range and
// what is not, against hand calculation.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/validation/validation_report.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ModelValue value(double number) { return {.applicable = true, .value = number, .failure = {}}; }

/// An input whose ends give these numbers in the only model.
InputEffect unknown(const char* name, std::vector<std::optional<double>> at_ends) {
    return {.name = name,
            .meaning = "an input",
            .standing = "assumed",
            .inferred_from_it = false,
            .value = "30 s",
            .ends = {"30 s", "300 s"},
            .unit = "s",
            .numbers = {30.0, 300.0},
            .at_ends = {std::move(at_ends)}};
}

ValidationRow row(const char* unit, double low, double high, double u, double simulated,
                  std::vector<InputEffect> inputs) {
    return {.id = "M1",
            .what = "a number",
            .unit = unit,
            .source = "page 1",
            .is_measured = true,
            .low = low,
            .high = high,
            .uncertainty = u,
            .parts = {{"sensor", u}},
            .models = {value(simulated)},
            .inputs = std::move(inputs)};
}

/// 50 degC measured with u = 2 K: the limits are 46 and 54 degC.
ValidationRow warm(double simulated, std::vector<InputEffect> inputs) {
    return row("degC", 50.0, 50.0, 2.0, simulated, std::move(inputs));
}

ValidationRecord record_of(std::vector<ValidationRow> rows) {
    ValidationRecord record;
    record.title = "One model";
    record.models = {{"one", "one model"}};
    record.rows = std::move(rows);
    return record;
}

}  // namespace

// Downwards 3 K and 4 K: 5 K together; upwards 3 K and nothing. Each input even over its larger change: (3^2 + 4^2)/3 =
// 8.333 K2, with u = 2 K sqrt(12.333) = 3.512 K.
TEST(UnknownInputs, ChangesAddAsRootSumSquareForEachDirection) {
    const ValidationRow two = warm(50.0, {unknown("air", {47.0, 53.0}), unknown("film", {46.0, 50.0})});
    const Reach found = reach(two, 0);
    EXPECT_DOUBLE_EQ(found.down, 5.0);
    EXPECT_DOUBLE_EQ(found.up, 3.0);
    EXPECT_NEAR(found.spread, std::sqrt(25.0 / 3.0), 1e-12);
    EXPECT_EQ(found.widest, "film");
    EXPECT_NEAR(total_uncertainty(two, 0), std::sqrt(37.0 / 3.0), 1e-12);
}

TEST(UnknownInputs, WithoutThemTheUncertaintyIsThatOfTheMeasurement) {
    EXPECT_DOUBLE_EQ(total_uncertainty(warm(51.0, {}), 0), 2.0);
    EXPECT_EQ(judge(warm(54.0, {}), 0), Judgement::passes);
    EXPECT_EQ(judge(warm(54.1, {}), 0), Judgement::fails);
}

// 50 to 52 degC is within 46 to 54. u = sqrt(4 + 1/3) = 2.08 K: 1 K is 0.48 u.
TEST(UnknownInputs, NumberPassesThatIsWithinTheLimitsOverTheWholeRange) {
    EXPECT_EQ(verdict(warm(51.0, {unknown("air", {50.0, 52.0})}), 0), "within (0.5 u)");
}

// 53 degC is within, 56 degC is not; the same the other way round: 57 degC is outside, 53 degC is not.
TEST(UnknownInputs, NumberIsNotDecidableWhoseRangePassesALimit) {
    EXPECT_EQ(verdict(warm(53.0, {unknown("ramp", {52.0, 56.0})}), 0), "not decidable (ramp)");
    EXPECT_EQ(verdict(warm(57.0, {unknown("ramp", {53.0, 58.0})}), 0), "not decidable (ramp)");
}

// 57 to 60 degC is above 54 everywhere. u = sqrt(4 + 9/3) = 2.646 K: 10 K is 3.78 u.
TEST(UnknownInputs, NumberFailsThatIsOutsideOnOneSideOverTheWholeRange) {
    EXPECT_EQ(verdict(warm(60.0, {unknown("air", {57.0, 60.0})}), 0), "3.8 u too hot");
}

// From 40 degC, below 46, to 60 degC, above 54: wrong at both ends, right between them.
TEST(UnknownInputs, NumberOutsideAtBothEndsOnDifferentSidesIsNotDecidable) {
    EXPECT_EQ(judge(warm(50.0, {unknown("air", {40.0, 60.0})}), 0), Judgement::not_decidable);
}

// Measured to 0.1 K: the limit is 50.2 degC, and 50.5 degC at the lower end is outside. But u = sqrt(0.01 + 9.5^2/3) =
// 5.486 K, and 10 K are only 1.82 of it.
TEST(UnknownInputs, NumberWithinTheTotalUncertaintyDoesNotFail) {
    EXPECT_EQ(judge(row("degC", 50.0, 50.0, 0.1, 60.0, {unknown("air", {50.5, 60.0})}), 0), Judgement::not_decidable);
}

// Below 0: -1.2 rises to -0.2 at most, then to +1; +3 falls to +2 at least.
TEST(UnknownInputs, OrderHoldsOrNotOverTheWholeRange) {
    const auto falls = [](double simulated, double low, double high) {
        return verdict(row("K", -infinity, 0.0, 0.0, simulated, {unknown("wait", {low, high})}), 0);
    };
    EXPECT_EQ(falls(-1.2, -2.0, -0.2), "holds");
    EXPECT_EQ(falls(-1.2, -2.0, 1.0), "not decidable (wait)");
    EXPECT_EQ(falls(3.0, 2.0, 3.0), "does not hold");
}

// 50 degC is exactly what was measured: the input was made so.
TEST(UnknownInputs, NumberJudgesNothingThatAnInputWasInferredFrom) {
    InputEffect load = unknown("load", {49.9, 50.1});
    load.standing = "inferred";
    load.inferred_from_it = true;
    EXPECT_EQ(verdict(warm(50.0, {load}), 0), "not decidable (load inferred from it)");
    EXPECT_EQ(verdict(warm(90.0, {load}), 0), "not decidable (load inferred from it)");
}

TEST(UnknownInputs, NumberFailsToBeReadWhereARunAtAnEndFailed) {
    EXPECT_EQ(verdict(warm(50.0, {unknown("air", {50.0, std::nullopt})}), 0), "failed");
}

// (16.5 - 2.8) K over (300 - 30) s = 0.05074 K/s; words have no distance from each other.
TEST(UnknownInputs, SensitivityIsTheChangeBetweenTheEndsOverTheRange) {
    InputEffect ramp = unknown("ramp", {2.8, 16.5});
    EXPECT_NEAR(sensitivity(ramp, 0).value(), 13.7 / 270.0, 1e-12);
    ramp.numbers.clear();
    EXPECT_FALSE(sensitivity(ramp, 0).has_value());
}

// Decided: off +10 K (fails) and +1 K (passes): bias 5.5 K, 1 of 2. The third and the order are not decidable.
TEST(UnknownInputs, FiguresCountOnlyWhatIsDecided) {
    const ValidationRecord record =
        record_of({warm(60.0, {unknown("air", {57.0, 60.0})}), warm(51.0, {unknown("air", {50.0, 52.0})}),
                   warm(80.0, {unknown("air", {50.0, 90.0})}),
                   row("K", -infinity, 0.0, 0.0, -1.2, {unknown("wait", {-2.0, 1.0})})});
    const ModelFigures found = figures(record, 0, false);
    EXPECT_EQ(found.temperatures, 2U);
    EXPECT_DOUBLE_EQ(found.bias, 5.5);
    EXPECT_EQ(found.within, 1U);
    EXPECT_EQ(found.orders, 0U);
    EXPECT_EQ(found.not_decidable, 2U);
}

TEST(UnknownInputs, PageHasTheRangeBesideTheNumberAndTheInputsWhereTheyAreAskedFor) {
    const ValidationRecord record = record_of({row("K", 15.0, 15.0, 2.0, 2.8, {unknown("ramp", {2.8, 16.5})})});
    const std::string page = page_text(validation_report(record), false);
    EXPECT_NE(page.find("15.0 +- 2.0  2.8 (2.8 to 16.5)  -12.2  not decidable (ramp)\n"), std::string::npos) << page;
    EXPECT_EQ(page.find("Inputs of the experiments"), std::string::npos);
    const std::string with_inputs = page_text(validation_report(record, true), false);
    EXPECT_NE(with_inputs.find("  ramp   assumed   30 s   30 s, 300 s  an input\n"), std::string::npos) << with_inputs;
    EXPECT_NE(with_inputs.find("  - M1 a number, one model: ramp 0.0 to +13.7 (0.051 for 1 s)\n"), std::string::npos)
        << with_inputs;
    EXPECT_NE(validation_inputs_markdown(record).find("| M1 | a number |  |  | ramp | ramp 0.0 to +13.7"),
              std::string::npos)
        << validation_inputs_markdown(record);
}

// A sensitivity of 1e-9 would be round-off in words.
TEST(UnknownInputs, InputThatChangesNothingHasNoSensitivityOnThePage) {
    const ValidationRecord record = record_of({row("K", 15.0, 15.0, 2.0, 2.8, {unknown("start", {2.8, 2.8 + 1e-7})})});
    EXPECT_NE(page_text(validation_report(record, true), false).find("one model: start 0\n"), std::string::npos);
}

TEST(UnknownInputs, DataHaveEveryEndAndWhetherTheNumberIsDecidable) {
    const nlohmann::json json = nlohmann::json::parse(
        json_text(validation_report(record_of({row("K", 15.0, 15.0, 2.0, 2.8, {unknown("ramp", {2.8, 16.5})})})).data));
    const nlohmann::json& number = json["numbers"][0];
    EXPECT_EQ(number["models"]["one"]["decidable"], false);
    EXPECT_EQ(number["models"]["one"]["low"], 2.8);
    EXPECT_NEAR(number["models"]["one"]["high"].get<double>(), 16.5, 1e-12);
    EXPECT_EQ(number["inputs"][0]["standing"], "assumed");
    EXPECT_EQ(number["inputs"][0]["models"]["one"]["at_ends"], nlohmann::json({2.8, 16.5}));
    EXPECT_EQ(json["summary"]["one"]["all"]["not_decidable"], 1);
}

}  // namespace tiretherm::post
