// SPDX-License-Identifier: BSD-3-Clause
// A report becomes text, JSON and CSV by rules that hold for every result.
#include "post/report/report.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "post/report/csv.hpp"
#include "post/report/file.hpp"

namespace tiretherm::post {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

DataTable two_layers() {
    DataTable table;
    table.add({{"layer", "name", "K1"},
               {"hottest degC", "hottest", shown("{:.1f}", 81.25)},
               {"cells", "cells", count(4800)},
               data_only("share", 0.5)});
    table.add({{"layer", "name", "belt"}, {"hottest degC", "hottest", shown("{:.1f}", nothing)}});
    return table;
}

TEST(Report, ATableHasNumbersToTheRightAndADashWhereThereIsNone) {
    Report report{.title = "Two layers"};
    report.add(ReportSection("Layers", two_layers()));
    EXPECT_EQ(page_text(report, false),
              "Two layers\n"
              "\n"
              "Layers\n"
              "  layer  hottest degC  cells\n"
              "  K1             81.2  4 800\n"
              "  belt              -\n");
}

TEST(Report, DataHaveTheNumbersThatThePageRounds) {
    EXPECT_EQ(json_text(two_layers().data()),
              "[\n"
              "  {\n"
              "    \"name\": \"K1\",\n"
              "    \"hottest\": 81.25,\n"
              "    \"cells\": 4800,\n"
              "    \"share\": 0.5\n"
              "  },\n"
              "  {\n"
              "    \"name\": \"belt\",\n"
              "    \"hottest\": null\n"
              "  }\n"
              "]\n");
}

TEST(Report, ARowOfThePageAloneIsNoData) {
    DataTable table = two_layers();
    table.add_to_page({{"layer", "name", "both"}, {"hottest degC", "hottest", shown("{:.1f}", 81.25)}});
    EXPECT_EQ(table.rows().size(), 3u);
    EXPECT_EQ(json_text(table.data()), json_text(two_layers().data()));
}

TEST(Report, HeadingsStandWhereThereIsSomethingBelowThem) {
    Report report{.title = "Nothing"};
    report.add("Warnings", "warnings", {});
    report.add(ReportSection("TextTable", DataTable()));
    EXPECT_EQ(page_text(report, true), "\033[1mNothing\033[0m\n");
    EXPECT_EQ(json_text(report.data), "{\n  \"warnings\": []\n}\n");
}

TEST(Report, ASectionWithoutHeadingFollowsTheTitleOrAnEmptyLine) {
    Report report{.title = "A page"};
    report.add(ReportSection("", {"at once"}));
    report.add(ReportSection("", {"apart"}));
    EXPECT_EQ(page_text(report, false), "A page\n  at once\n\n  apart\n");
}

TEST(Report, ATableWithColumnsStandsWithoutRows) {
    Report report{.title = "A page"};
    report.add(ReportSection("Layers", DataTable({page_only("layer", ""), page_only("cells", count(0))})));
    EXPECT_EQ(page_text(report, false), "A page\n\nLayers\n  layer  cells\n");
}

TEST(Report, ATableInMarkdownHasTheColumnsOfThePage) {
    EXPECT_EQ(markdown_text(two_layers()),
              "| layer | hottest degC | cells |\n| --- | --- | --- |\n| K1 | 81.2 | 4 800 |\n| belt | - |\n");
}

TEST(Report, PartsAndItemsAreIndented) {
    ReportSection part("surface");
    part.item("too hot");
    ReportSection section("Interpretation", {"In words:"});
    section.gap();
    section.add(part);
    Report report{.title = "A page"};
    report.add(section);
    report.add(std::vector<std::filesystem::path>{"out/a.csv"});
    EXPECT_EQ(page_text(report, false),
              "A page\n\nInterpretation\n  In words:\n\n  surface\n    - too hot\n\nFiles\n  out/a.csv\n");
    EXPECT_EQ(json_text(report.data["outputs"]), "[\n  \"out/a.csv\"\n]\n");
}

TEST(Report, FurtherLinesOfAnItemBeginBelowItsFirstWord) {
    ReportSection section("List");
    section.item("one two three");
    Report report{.title = "A page"};
    report.add(section);
    EXPECT_EQ(page_text(report, false, {.prose = 11}), "A page\n\nList\n  - one two\n    three\n");
}

// "layer  hottest degC  cells" with its indent takes 28 columns. At 22 the last column goes to a block of its own beside the
// names; belt has nothing there.
TEST(Report, ATableThatIsWiderThanTheTerminalGoesOnInAFurtherBlock) {
    Report report{.title = "Two layers"};
    report.add(ReportSection("Layers", two_layers()));
    EXPECT_EQ(page_text(report, false, {.tables = 22}),
              "Two layers\n\nLayers\n"
              "  layer  hottest degC\n"
              "  K1             81.2\n"
              "  belt              -\n"
              "\n"
              "  layer  cells\n"
              "  K1     4 800\n");
    EXPECT_EQ(page_text(report, false, {.tables = 28}), page_text(report, false));
}

// A number that is shown as zero has no minus: -0.004 rounds to it, -0.006 does not. Where all numbers of a column have a
// sign it has one, too.
TEST(Report, ANumberThatIsShownAsZeroHasNoMinus) {
    EXPECT_EQ(shown("{:.2f}", -0.004).text, "0.00");
    EXPECT_EQ(shown("{:.2f}", -0.006).text, "-0.01");
    EXPECT_EQ(shown("{:+.2f}", -0.004).text, "+0.00");
}

// JSON knows neither infinity nor text that is not UTF-8; neither may end the program.
TEST(Report, WhatJsonCannotHoldIsReplaced) {
    EXPECT_EQ(json_text(Value(std::numeric_limits<double>::infinity())), "null\n");
    EXPECT_EQ(json_text(Value("\xff")), "\"\xEF\xBF\xBD\"\n");
    EXPECT_EQ(json_text(where(false, 1.0)), "null\n");
    EXPECT_EQ(json_text(Value(std::optional<double>())), "null\n");
}

TEST(CsvText, TextIsQuotedAndWhatIsMissingIsAnEmptyCell) {
    Csv csv({"time [s]", "name, unit", "n"});
    csv.row(Digits{1.0 / 3.0, 4}, "say \"hot\"", 3);
    csv.row(Decimals{2.0, 2}, Digits{nothing, 3}, -1);
    EXPECT_EQ(csv.text(), "time [s],\"name, unit\",n\n0.3333,\"say \"\"hot\"\"\",3\n2.00,,-1\n");
}

// Names of runs come from names of files, which may hold anything.
TEST(CsvText, ControlCharactersAreBlanks) {
    Csv csv({"a\033[31m\nb", "c"});
    csv.add(std::string_view("d\te,\"f\r"));
    csv.end_row();
    EXPECT_EQ(csv.text(), "a [31m b,c\n\"d e,\"\"f \"\n");
}

}  // namespace
}  // namespace tiretherm::post
