// SPDX-License-Identifier: BSD-3-Clause
// Verdicts, cells and figures of a validation table against hand calculation, as text, Markdown and JSON.

#include "post/validation/validation_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

ModelValue model_value(double number) { return {.applicable = true, .value = number, .failure = {}}; }

ValidationRow row(const char* unit, double low, double high, double u, std::vector<ModelValue> models) {
    return {.id = "M1",
            .what = "a number",
            .unit = unit,
            .source = "page 1",
            .is_measured = true,
            .low = low,
            .high = high,
            .uncertainty = u,
            .parts = {{"sensor", u}},
            .models = std::move(models),
            .inputs = {}};
}

/// A temperature of 50 degC, u = 2 K, that one model gives.
std::string judged(double simulated) { return verdict(row("degC", 50.0, 50.0, 2.0, {model_value(simulated)}), 0); }

/// A table of one number.
ValidationRecord only(const ValidationRow& row) {
    ValidationRecord record;
    for (std::size_t m = 0; m < row.models.size(); ++m) {
        record.models.push_back({fmt::format("m{}", m), fmt::format("model {}", m)});
    }
    record.rows = {row};
    return record;
}

/// A cell of that number's line on the page.
std::string cell(const ValidationRow& row, const char* heading) {
    const Report report = validation_report(only(row));
    const DataTable::Row line = section(report, "Numbers").blocks().at(0).table.rows().at(0);
    const auto found =
        std::ranges::find_if(line, [&](const Field& field) { return field.on_page && field.heading == heading; });
    return found == line.end() ? "no such column" : found->cell.text;
}

/// Three temperatures, of which the first model lacks the last; an order; a failed run.
ValidationRecord record() {
    ValidationRecord made;
    made.title = "Two models";
    made.models = {{"two_node", "two nodes"}, {"section", "section"}};
    made.rows = {row("degC", 50.0, 50.0, 2.0, {model_value(58.0), model_value(51.0)}),
                 row("degC", 60.0, 70.0, 1.0, {model_value(74.0), model_value(65.0)}),
                 row("degC", 100.0, 100.0, 5.0, {{}, model_value(88.0)}),
                 row("K", -no_bound, 0.0, 0.0, {model_value(-3.0), model_value(2.5)}),
                 row("K", 15.0, 15.0, 2.0,
                     {model_value(15.5), {.applicable = true, .value = {}, .failure = "case x: it broke"}})};
    made.runs = 7;
    made.seconds = 1.25;
    made.energy_closure = 2e-13;
    made.warnings = {"case y: it was warm"};
    return made;
}

}  // namespace

TEST(Verdict, IsInUncertaintiesOfTheMeasuredNumber) {
    EXPECT_EQ(judged(50.0), "within");
    EXPECT_EQ(judged(51.4), "within (0.7 u)");
    EXPECT_EQ(judged(46.0), "within (2.0 u)");
    EXPECT_EQ(judged(56.2), "3.1 u too hot");
    EXPECT_EQ(judged(40.0), "5.0 u too cold");
}

TEST(Verdict, UsesTheWordsOfTheUnit) {
    EXPECT_EQ(verdict(row("K", 15.0, 15.0, 2.0, {model_value(5.0)}), 0), "5.0 u too small");
    EXPECT_EQ(verdict(row("s", 600.0, 600.0, 60.0, {model_value(900.0)}), 0), "5.0 u too late");
    EXPECT_EQ(verdict(row("1", 1.1, 1.1, 0.03, {model_value(1.25)}), 0), "5.0 u too large");
}

TEST(Verdict, DifferenceIsToTheNearerEndOfARange) {
    const ValidationRow range = row("degC", 40.0, 50.0, 2.0, {model_value(37.0), model_value(45.0), model_value(56.0)});
    EXPECT_EQ(difference(range, 0), -3.0);
    EXPECT_EQ(difference(range, 1), 0.0);
    EXPECT_EQ(difference(range, 2), 6.0);
    EXPECT_EQ(verdict(range, 1), "within");
}

TEST(Verdict, OpenRangeHoldsOrNotAndItsEndIsOutside) {
    const ValidationRow falls = row("K", -no_bound, 0.0, 0.0, {model_value(-0.1), model_value(0.0), model_value(2.0)});
    EXPECT_TRUE(falls.is_open());
    EXPECT_EQ(verdict(falls, 0), "holds");
    EXPECT_EQ(verdict(falls, 1), "does not hold");
    EXPECT_EQ(verdict(falls, 2), "does not hold");
    EXPECT_EQ(difference(falls, 2), 2.0);
}

TEST(Verdict, IsNotGivenWhereNothingWasMeasuredOrAsked) {
    ValidationRow shown = row("N", 0.0, 0.0, 0.0, {model_value(48.0), {}});
    shown.is_measured = false;
    EXPECT_EQ(verdict(shown, 0), "");
    EXPECT_EQ(cell(shown, "measured"), "-");
    EXPECT_EQ(cell(shown, "model 0"), "48.0");
    EXPECT_EQ(cell(shown, "model 1"), "");
}

TEST(Cells, HaveTheDecimalsOfTheirUnit) {
    EXPECT_EQ(cell(row("degC", 47.0, 48.0, 4.123, {model_value(1.0)}), "measured"), "47.0 to 48.0 +- 4.1");
    const ValidationRow ratio = row("1", 1.1, 1.1, 0.03, {model_value(1.0)});
    EXPECT_EQ(cell(ratio, "measured"), "1.100 +- 0.030");
    EXPECT_NE(validation_markdown(only(ratio)).find("| 1.100 ± 0.030  |"), std::string::npos);
    EXPECT_EQ(cell(row("s", 600.0, 600.0, 60.0, {model_value(1.0)}), "measured"), "600 +- 60");
    EXPECT_EQ(cell(row("K", 0.0, no_bound, 0.0, {model_value(1.0)}), "measured"), "> 0.0");
    EXPECT_EQ(cell(row("K", 0.0, 0.0, 1.0, {model_value(-0.04)}), "model 0"), "0.0");
    EXPECT_EQ(cell(row("K", 1.0, 1.0, 1.0, {model_value(3.0)}), "off"), "+2.0");
}

// Common to both: off 8 and 4 (two nodes), 1 and 0 (section). Bias 6, rms sqrt((64 + 16) / 2) = 6.325; variance 40 - 36
// = 4, of which the measurements explain (4 + 1) / 2 = 2.5: scatter sqrt(1.5) = 1.225.
TEST(Figures, BiasAndScatterAreThoseOfTheModelWithoutTheSensors) {
    const ModelFigures two_node = figures(record(), 0, true);
    EXPECT_EQ(two_node.temperatures, 2U);
    EXPECT_DOUBLE_EQ(two_node.bias, 6.0);
    EXPECT_DOUBLE_EQ(two_node.rms, std::sqrt(40.0));
    EXPECT_DOUBLE_EQ(two_node.scatter, std::sqrt(1.5));
    EXPECT_EQ(two_node.within, 0U);
    EXPECT_EQ(two_node.orders, 1U);
    EXPECT_EQ(two_node.holding, 1U);

    const ModelFigures section = figures(record(), 1, true);
    EXPECT_DOUBLE_EQ(section.bias, 0.5);
    EXPECT_EQ(section.scatter, 0.0);  // 0.25, less than the sensors' own
    EXPECT_EQ(section.within, 2U);
    EXPECT_EQ(section.holding, 0U);

    // With the temperature that only the section gives: 1, 0 and -12.
    const ModelFigures all = figures(record(), 1, false);
    EXPECT_EQ(all.temperatures, 3U);
    EXPECT_DOUBLE_EQ(all.bias, -11.0 / 3.0);
    EXPECT_EQ(all.within, 2U);
}

TEST(ValidationText, HasALineForEachNumberAndTellsWhatFailedOnce) {
    const std::string text = page_text(validation_report(record()), false);
    EXPECT_TRUE(text.starts_with("Two models\n\nVerdict\n  two nodes: 0 of 2 temperatures within 2 u")) << text;
    EXPECT_NE(text.find("\nNumbers\n  id  what      unit             measured  two nodes  verdict"), std::string::npos)
        << text;
    EXPECT_NE(text.find("  M1  a number  degC          50.0 +- 2.0       58.0  4.0 u too hot      51.0   +1.0  within"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("15.5  within (0.2 u)   failed         failed\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nWarnings\n  case y: it was warm\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nRuns that failed\n  case x: it broke\n"), std::string::npos) << text;
    EXPECT_NE(text.find("  7 runs in 1.2 s; energy closes to 2.0e-13 at worst\n"), std::string::npos) << text;
    EXPECT_NE(page_text(validation_report(record()), true).find("\033[1mTwo models\033[0m\n"), std::string::npos);
}

// A time is neither a temperature nor an order: no model has figures.
TEST(ValidationText, HasTheHeadingsOfFiguresThatNoModelHas) {
    const std::string text = page_text(validation_report(only(row("s", 9.0, 9.0, 1.0, {model_value(9.0)}))), false);
    const std::string headings =
        "\nModel against experiment\n  model  temperatures  bias K  rms K  scatter K  "
        "within 2 u  orders that hold  not decidable\n\n  Off: ";
    EXPECT_NE(text.find(headings), std::string::npos) << text;
}

TEST(ValidationMarkdown, HasAsManyCellsInEachLine) {
    const std::string text = validation_markdown(record());
    EXPECT_NE(text.find("| M1 | a number | 60.0 to 70.0 ± 1.0 °C | 74.0 | 4.0 u too hot | 65.0 | within |\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("| two nodes | 2 | +6.0 | 6.3 | 1.2 | 0 of 2 | 1 of 1 | 0 |\n"), std::string::npos) << text;
    EXPECT_NE(text.find("| section, all | 3 |"), std::string::npos) << text;
    EXPECT_EQ(text.find("°C |  |  |\n"), std::string::npos);
}

TEST(ValidationJson, HasNullWhereANumberIsMissing) {
    const nlohmann::json json = nlohmann::json::parse(json_text(validation_report(record()).data));
    ASSERT_EQ(json["numbers"].size(), 5U);
    EXPECT_EQ(json["numbers"][0]["models"]["two_node"]["in_uncertainties"], 4.0);
    EXPECT_EQ(json["numbers"][0]["measured"]["uncertainty_parts"]["sensor"], 2.0);
    EXPECT_TRUE(json["numbers"][2]["models"]["two_node"].is_null());
    EXPECT_TRUE(json["numbers"][3]["measured"]["low"].is_null());
    EXPECT_EQ(json["numbers"][3]["models"]["section"]["verdict"], "does not hold");
    EXPECT_TRUE(json["numbers"][4]["models"]["section"]["value"].is_null());
    EXPECT_EQ(json["numbers"][4]["models"]["section"]["error"], "case x: it broke");
    EXPECT_EQ(json["summary"]["two_node"]["common"]["bias"], 6.0);
    EXPECT_EQ(json["runs"], 7);
}

}  // namespace tiretherm::post
