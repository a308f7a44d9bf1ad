// SPDX-License-Identifier: BSD-3-Clause
// Validation tables: differences, ratios and times against hand calculation, and the shipped table holds every
// experiment.

#include "input/validation/validation.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "support/written.hpp"

namespace tiretherm::input {

namespace {

constexpr double zero = 273.15;

std::string numbered(std::string_view body) {
    return "[[number]]\nid = \"A\"\nwhat = \"a number\"\nsource = \"page 1\"\n" + std::string(body);
}

/// A folder with the cases warm_two_node, warm_section and cold_section, and a table of numbers.
class ValidationTable : public testing::Test {
protected:
    ValidationTable() {
        for (const char* name : {"warm_two_node.toml", "warm_section.toml", "cold_section.toml"}) {
            written_.add(name,
                         std::string(slab) + "[[sensor]]\nname = \"inside\"\nkind = \"point\"\ndepth = \"8 mm\"\n");
        }
    }
    Validation read(const std::string& table) const {
        ValidationReading reading = read_validation(written_.add("table.toml", table));
        EXPECT_TRUE(reading.table.has_value()) << render(CaseFindings{.errors = reading.errors, .warnings = {}});
        return reading.table ? std::move(*reading.table) : Validation{};
    }
    Written written_;
};

/// Rows at 0 and 60 s.
Trace course(std::array<double, 2> top, std::array<double, 2> inside) {
    Trace trace;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::array channels{top[i], inside[i]};
        solver::Snapshot snapshot;
        snapshot.time = 60.0 * static_cast<double>(i);
        snapshot.channels = channels;
        trace.take(snapshot);
    }
    return trace;
}

}  // namespace

TEST_F(ValidationTable, CaseIsReadForBothModelsAndOnlyOnce) {
    const std::string both =
        "case = \"warm\"\nchannel = \"top\"\nat = \"30 s\"\nvalue = \"85 degC\"\nuncertainty = \"2 K\"\n";
    const Validation table = read("title = \"Two numbers\"\n" + numbered(both) + numbered(both));
    EXPECT_EQ(table.title, "Two numbers");
    ASSERT_EQ(table.numbers.size(), 2U);
    ASSERT_EQ(table.runs.size(), 2U);
    const ValidationNumber& number = table.numbers[1];
    EXPECT_EQ(number.meaning, Meaning::value);
    EXPECT_DOUBLE_EQ(number.low, zero + 85.0);
    EXPECT_DOUBLE_EQ(number.high, zero + 85.0);
    EXPECT_DOUBLE_EQ(number.total_uncertainty(), 2.0);
    ASSERT_TRUE(number.models[0] && number.models[1]);
    const std::vector<Trace> traces{course({290.0, 300.0}, {0.0, 0.0}), course({290.0, 310.0}, {0.0, 0.0})};
    EXPECT_DOUBLE_EQ(number.models[0]->value(traces), 295.0);
    EXPECT_DOUBLE_EQ(number.models[1]->value(traces), 300.0);
}

// The third model has no cases of its own: those of the section, 600 s long, with a file beside them that starts them at 50 degC
// and ends them at 60 s. A case of its own wins.
TEST_F(ValidationTable, AModelMayLayAFileOverTheCasesOfAnother) {
    written_.add("hotter.toml", "[initial]\ntemperature = \"50 degC\"\n");
    const std::string models =
        "[[model]]\nkey = \"two_node\"\n[[model]]\nkey = \"section\"\n"
        "[[model]]\nkey = \"hot\"\nof = \"section\"\nwith = \"hotter.toml\"\n";
    const std::string number = "case = \"warm\"\nchannel = \"top\"\n";
    const Validation table = read(models + numbered(number));
    ASSERT_EQ(table.runs.size(), 3U);
    EXPECT_EQ(table.runs[2].problem.name, "warm_hot");
    EXPECT_NEAR(table.runs[2].problem.initial.front(), zero + 50.0, 1e-9);
    EXPECT_LT(table.runs[1].problem.initial.front(), zero + 49.0);
    written_.add("warm_hot.toml", "include = [\"warm_section.toml\"]\ntitle = \"its own\"\n");
    const Validation own = read(models + numbered(number));
    EXPECT_EQ(own.runs[2].problem.initial, own.runs[1].problem.initial);
}

// One model, whose cases end in _section; the page calls it "a shell". Without its own models a table has two.
TEST_F(ValidationTable, SaysItselfWhichModelsItJudges) {
    const Validation table = read("[[model]]\nkey = \"section\"\nname = \"a shell\"\n[[model]]\nkey = \"other\"\n" +
                                  numbered("case = \"warm\"\nmodels = [\"section\"]\nchannel = \"top\"\n") +
                                  numbered("files = { other = \"cold_section.toml\" }\nchannel = \"top\"\n"));
    ASSERT_EQ(table.models.size(), 2U);
    EXPECT_EQ(table.models[0].name, "a shell");
    EXPECT_EQ(table.models[1].name, "other");
    ASSERT_EQ(table.numbers.at(0).models.size(), 2U);
    EXPECT_TRUE(table.numbers[0].models[0] && !table.numbers[0].models[1]);
    EXPECT_TRUE(!table.numbers[1].models[0] && table.numbers[1].models[1]);
    EXPECT_EQ(table.runs.size(), 2U);
}

// sqrt(3^2 + 4^2) = 5. A difference of temperatures has no offset.
TEST_F(ValidationTable, DifferenceTakesOverWhatItDoesNotChange) {
    const Validation table =
        read(numbered("case = \"warm\"\nmodels = [\"section\"]\nchannel = \"top\"\ntake = \"max\"\nfrom = \"10 s\"\n"
                      "minus = { channel = \"inside\" }\nrange = [\"4 degC\", \"5 K\"]\nuncertainty = { sensor = \"3 "
                      "K\", dwell = \"4 K\" }\n"));
    ASSERT_EQ(table.runs.size(), 1U);
    const ValidationNumber& number = table.numbers.at(0);
    EXPECT_EQ(number.meaning, Meaning::difference);
    EXPECT_DOUBLE_EQ(number.low, 4.0);
    EXPECT_DOUBLE_EQ(number.high, 5.0);
    EXPECT_DOUBLE_EQ(number.total_uncertainty(), 5.0);
    EXPECT_FALSE(number.models[0].has_value());
    const Difference& of = number.models[1].value().of;
    EXPECT_EQ(of.minus.value().channel, 1U);
    EXPECT_EQ(of.minus->window.take, Window::Take::max);
    EXPECT_DOUBLE_EQ(of.minus->window.from, 10.0);
    EXPECT_DOUBLE_EQ(of.minus->window.to, 60.0);
    EXPECT_DOUBLE_EQ(number.models[1]->value({course({300.0, 310.0}, {290.0, 302.0})}), 8.0);
}

// (330 - 300) / (320 - 305) = 2.
TEST_F(ValidationTable, RatioOfTwoRises) {
    const Validation table =
        read(numbered("files = { section = \"warm_section.toml\" }\nchannel = \"top\"\nminus = { at = \"0 s\" }\n"
                      "over = { files = { section = \"cold_section.toml\" }, minus = { at = \"0 s\" } }\nabove = 1\n"));
    const ValidationNumber& number = table.numbers.at(0);
    EXPECT_EQ(number.meaning, Meaning::ratio);
    EXPECT_DOUBLE_EQ(number.low, 1.0);
    EXPECT_TRUE(std::isinf(number.high));
    EXPECT_EQ(number.total_uncertainty(), 0.0);
    EXPECT_EQ(number.models[1].value().runs(), (std::vector<std::size_t>{0, 0, 1, 1}));
    const std::vector<Trace> traces{course({300.0, 330.0}, {}), course({305.0, 320.0}, {})};
    EXPECT_DOUBLE_EQ(number.models[1]->value(traces), 2.0);
}

TEST_F(ValidationTable, TimesAreInSecondsAndMayBeShownWithoutAMeasuredValue) {
    const Validation table = read(numbered("case = \"warm\"\nchannel = \"top\"\ntime_to = \"50 %\"\n"));
    EXPECT_EQ(table.numbers.at(0).meaning, Meaning::time);
    EXPECT_FALSE(table.numbers.at(0).is_measured);
    EXPECT_DOUBLE_EQ(table.numbers[0].models[0].value().value({course({300.0, 330.0}, {}), {}}), 30.0);
}

TEST_F(ValidationTable, EndIsAMomentThatASpanAboveDoesNotHide) {
    const Validation table = read(
        numbered("case = \"warm\"\nchannel = \"top\"\ntake = \"max\"\nminus = { at = \"end\" }\nabove = \"0 K\"\n"));
    EXPECT_DOUBLE_EQ(table.numbers.at(0).models[0].value().value({course({330.0, 300.0}, {}), {}}), 30.0);
}

TEST_F(ValidationTable, ExperimentsThatAreNotWantedTakeTheirRunsWithThem) {
    const std::string other =
        "[[number]]\nid = \"B\"\nwhat = \"b\"\nfiles = { section = \"cold_section.toml\" }\nchannel = \"top\"\n";
    Validation table = read(numbered("case = \"warm\"\nchannel = \"top\"\n") + other);
    EXPECT_EQ(table.ids(), (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(table.keep({"B", "C"}), std::vector<std::string>{"C"});
    ASSERT_EQ(table.runs.size(), 1U);
    EXPECT_EQ(table.runs[0].file.filename(), "cold_section.toml");
    EXPECT_EQ(table.numbers.at(0).models[1].value().of.of.run, 0U);
}

// Thesis-notes section 3; M3 are the conductivities themselves, which are inputs.
TEST(ShippedValidation, HasANumberOfEveryExperiment) {
    const ValidationReading reading = read_validation(source_folder() / "cases" / "validation.toml");
    ASSERT_TRUE(reading.table.has_value())
        << render(CaseFindings{.errors = reading.errors, .warnings = reading.warnings});
    EXPECT_TRUE(reading.warnings.empty());
    EXPECT_EQ(reading.table->ids(), (std::vector<std::string>{"M1", "M2", "M4", "M5", "M6", "M7", "M8", "M9", "M10",
                                                              "M11", "M12", "M13", "M14", "M15", "M16"}));
}

// The example of the page that users copy from, with its case where it is.
TEST(ShippedValidation, ExampleOfTheReadmeIsSound) {
    std::ostringstream page;
    page << std::ifstream(source_folder() / "cases" / "README.md").rdbuf();
    const std::string text = page.str();
    const std::size_t start = text.find("```toml\n", text.find("## The table of measured numbers")) + 8;
    std::string table = text.substr(start, text.find("```", start) - start);
    const std::string_view name = "handling/steering_pad";
    table.replace(table.find(name), name.size(), (source_folder() / "cases" / name).generic_string());
    const Written written;
    const ValidationReading reading = read_validation(written.add("table.toml", table));
    ASSERT_TRUE(reading.table.has_value())
        << render(CaseFindings{.errors = reading.errors, .warnings = reading.warnings});
    EXPECT_NEAR(reading.table->numbers.at(0).total_uncertainty(), std::sqrt(5.0), 1e-12);
    // Both models: as they are, and with two lengths of the ramp.
    EXPECT_EQ(reading.table->runs.size(), 6U);
}

}  // namespace tiretherm::input
