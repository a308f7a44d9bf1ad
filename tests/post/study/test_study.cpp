// SPDX-License-Identifier: BSD-3-Clause
// Statistics and outputs of a hand-made study: Wilson's interval against Newcombe, Stat. Med. 17 (1998), tables, files
// and pictures.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <nlohmann/json.hpp>

#include "diagnosis/study/study_statistics.hpp"
#include "post/report/file.hpp"
#include "post/report/remark_text.hpp"
#include "post/study/study_axis.hpp"
#include "post/study/study_chart.hpp"
#include "post/study/study_names.hpp"
#include "post/study/study_report.hpp"
#include "post/study/study_tables.hpp"
#include "tests/post/scratch.hpp"

// What is made of a study's runs, without running any.
namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered
namespace {

constexpr double zero = 273.15;

StudyOutcome run_at(double celsius) {
    return {.failure = {},
            .hottest = zero + celsius,
            .hottest_time = 3600.0,
            .hottest_layer = "bulk",
            .hottest_zone = {},
            .channel_final = {zero + celsius - 1.0},
            .channel_min = {zero + 20.0},
            .channel_max = {zero + celsius},
            .energy_closure = 1e-13,
            .steps = 30};
}

StudyColumn column(std::string key, std::string unit, std::vector<double> numbers) {
    StudyColumn made{.key = std::move(key), .unit = unit, .udunits = unit, .texts = {}, .numbers = std::move(numbers)};
    for (const double number : made.numbers) {
        made.texts.push_back(fmt::format("{:g} {}", number, unit));
    }
    return made;
}

/// Two speeds by three loads; the hottest temperature is speed + load, the last run has failed.
StudyRecord grid() {
    StudyRecord study{.title = "A grid",
                      .study_file = "grid.toml",
                      .study_text = "title = \"A grid\"\n",
                      .case_file = "tire.toml",
                      .case_name = "tire",
                      .version = "9.9",
                      .critical = zero + 62.0,
                      .columns = {column("drive.speed", "km/h", {50, 50, 50, 60, 60, 60}),
                                  column("drive.vertical_load", "kN", {1, 2, 3, 1, 2, 3})},
                      .sides = {2, 3},
                      .channels = {{.name = "inside", .meaning = "mean of the bulk", .where = {}}},
                      .outcomes = {},
                      .warnings = {}};
    for (std::size_t r = 0; r < 6; ++r) {
        study.outcomes.push_back(run_at(study.columns[0].numbers[r] + study.columns[1].numbers[r]));
    }
    study.outcomes[5] = StudyOutcome{.failure = "t = 3 s: it burns, \"badly\""};
    return study;
}

/// 20 samples from 41 to 60 degC at one point.
StudyRecord samples() {
    StudyRecord study = grid();
    study.title = "Samples";
    study.sides = {};
    study.samples = 20;
    study.is_sampled = true;
    study.critical = zero + 58.0;
    study.outcomes.clear();
    std::vector<double> numbers;
    for (int i = 0; i < 20; ++i) {
        study.outcomes.push_back(run_at(41.0 + i));
        numbers.push_back(0.1 * i);
    }
    study.columns = {column("effects.air_convection.lambda_h", "", numbers)};
    study.columns[0].is_drawn = true;
    return study;
}

std::size_t charts_of(const StudyRecord& study) { return study_chart_section(study).blocks().size(); }

nlohmann::json chart_of(const StudyRecord& study, std::size_t i) {
    const ReportSection section = study_chart_section(study);
    return nlohmann::json::parse(json_text(section.blocks().at(i).chart));
}

const StudyCall made{.kept = 2, .seconds = 1.0, .run_seconds = 1.0, .files = {}};

}  // namespace

// R. G. Newcombe, Stat. Med. 17 (1998), table I: 81 of 263 gives 0.2553 to 0.3662, 15 of 148 gives 0.0624 to 0.1605, and 0
// of 20 gives 0 to 0.1611.
TEST(Chance, HasWilsonsInterval) {
    EXPECT_NEAR(chance(81, 263).low, 0.2553, 5e-5);
    EXPECT_NEAR(chance(81, 263).high, 0.3662, 5e-5);
    EXPECT_NEAR(chance(15, 148).low, 0.0624, 5e-5);
    EXPECT_NEAR(chance(15, 148).high, 0.1605, 5e-5);
    EXPECT_EQ(chance(0, 20).low, 0.0);
    EXPECT_NEAR(chance(0, 20).high, 0.1611, 5e-5);
    EXPECT_EQ(chance(0, 0).high, 1.0);
}

// 41 to 60 in steps of 1: the median is 50.5; 59 and 60 pass 58, and 58 itself does not.
TEST(StudyStatistics, CountWhatPassesTheCriticalTemperature) {
    const StudyRecord study = samples();
    EXPECT_NEAR(quantile(hottest_at(study, 0), 0.5), 50.5, 1e-12);
    const Chance passing = passes_critical(study, 0);
    EXPECT_EQ(passing.times, 2U);
    EXPECT_EQ(passing.of, 20U);
}

TEST(StudyStatistics, RunThatFailedIsNeitherBelowNorAbove) {
    StudyRecord study = samples();
    study.outcomes[19] = StudyOutcome{.failure = "it burns"};
    EXPECT_EQ(passes_critical(study, 0).times, 1U);
    EXPECT_EQ(passes_critical(study, 0).of, 19U);
}

TEST(StudyRecord, KeyThatChangesNothingIsFound) {
    StudyRecord study = grid();
    EXPECT_TRUE(study.without_effect().empty());
    for (std::size_t r = 0; r < 6; ++r) {
        study.outcomes[r] = run_at(study.columns[0].numbers[r]);
    }
    EXPECT_EQ(study.without_effect(), std::vector<std::string>{"drive.vertical_load"});
}

TEST(StudyCsv, HasARowForEachRunAndUnitsInItsHeadings) {
    const std::string text = study_csv(grid());
    EXPECT_TRUE(text.starts_with(
        "run,drive.speed [km/h],drive.vertical_load [kN],outcome,hottest [degC],hottest_time [s],hottest_layer,"
        "hottest_zone,inside_final [degC],inside_min [degC],inside_max [degC],energy_closure [-],steps [-]\n"
        "1,50,1,ok,51.0000,3600,bulk,,50.0000,20.0000,51.0000,1.00e-13,30\n"))
        << text;
    // As many cells as headings: 12 commas outside of the quotes.
    EXPECT_TRUE(text.ends_with("\n6,60,3,\"t = 3 s: it burns, \"\"badly\"\"\",,,,,,,,,\n")) << text;
}

TEST(StudyHdf5, HasTheSameRunsInSiAndSaysWhatTheyAre) {
    const sample::Scratch scratch;
    write_study_hdf5(scratch / "study.h5", grid());
    const hid_t file = H5Fopen((scratch / "study.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    const auto read = [&](const char* path) {
        std::vector<double> values(6);
        const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT);
        EXPECT_GE(dataset, 0) << path;
        EXPECT_GE(H5Aexists(dataset, "units"), 1) << path;
        EXPECT_GE(H5Aexists(dataset, "long_name"), 1) << path;
        EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << path;
        H5Dclose(dataset);
        return values;
    };
    EXPECT_DOUBLE_EQ(read("/hottest/temperature")[1], zero + 52.0);
    EXPECT_TRUE(std::isnan(read("/hottest/temperature")[5]));
    EXPECT_DOUBLE_EQ(read("/inputs/drive.vertical_load")[2], 3.0);
    EXPECT_DOUBLE_EQ(read("/channels/inside/final")[0], zero + 50.0);
    EXPECT_DOUBLE_EQ(read("/run")[5], 6.0);
    H5Fclose(file);
}

TEST(StudyHdf5, EqualStudiesAreEqualFiles) {
    const sample::Scratch scratch;
    write_study_hdf5(scratch / "a.h5", grid());
    write_study_hdf5(scratch / "b.h5", grid());
    EXPECT_EQ(read_text(scratch / "a.h5"), read_text(scratch / "b.h5"));
}

// 2 of 20 pass 58 degC; Wilson's interval is 0.0279 to 0.3010. The median of 41 to 60 in steps of 1 is 50.5.
TEST(StudyText, TheHeadlineIsTheAnswerWithItsDoubt) {
    const Report report = study_report(samples(), made);
    ASSERT_EQ(report.verdict.size(), 1u);
    EXPECT_TRUE(
        report.verdict[0].starts_with("10 % of 20 samples pass 58 degC (2.8 to 30 %); median 50.5, nine tenths 4"))
        << report.verdict[0];
    EXPECT_EQ(study_report(grid(), made).verdict,
              (std::vector<std::string>{
                  "0 of 5 runs pass 62 degC. Hottest: 62.0 degC at drive.speed = 60 km/h, drive.vertical_load = 2 kN; "
                  "coldest: 51.0 degC at drive.speed = 50 km/h, drive.vertical_load = 1 kN.",
                  "1 of 6 runs failed and is not counted."}));
}

// What was drawn has as many digits as the computer has; four of them are read.
TEST(StudyText, DrawnNumbersAreShownWithFourDigits) {
    StudyRecord study = samples();
    study.columns[0].numbers[19] = 1.94444444;
    study.columns[0].texts[19] = "1.94444444";
    const std::string text = page_text(study_report(study, made), false);
    EXPECT_NE(text.find("run 20: effects.air_convection.lambda_h = 1.944\n"), std::string::npos) << text;
}

TEST(StudyText, ShowsTheGridAndWhatFailed) {
    const std::string text = page_text(study_report(grid(), made), false);
    EXPECT_NE(text.find("  50  51.0  52.0    53.0\n  60  61.0  62.0  failed\n"), std::string::npos) << text;
    EXPECT_NE(text.find("0 of 5 runs pass 62 degC"), std::string::npos) << text;
    EXPECT_NE(text.find("run 6 (drive.speed = 60 km/h, drive.vertical_load = 3 kN): t = 3 s: it burns"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("2 kept, 4 made now in 1.0 s (0.250 s a run, 1 at a time)"), std::string::npos) << text;
}

// 2 of 20: (0.1 + 1.9207/20 -+ 1.95996 sqrt(0.09/20 + 0.96036/400)) / (1 + 3.8415/20) = 0.0279 and 0.3010.
// Two runs of 63 degC, the hottest: the third and the fourth. The page and the data name the same one, the first.
TEST(StudyText, OfEquallyHotRunsPageAndDataNameTheFirst) {
    StudyRecord study = grid();
    study.outcomes = {run_at(40.0), run_at(40.0), run_at(63.0), run_at(63.0), run_at(50.0), run_at(50.0)};
    const Report report = study_report(study, made);
    EXPECT_NE(page_text(report, false).find("at 3600 s; run 3:"), std::string::npos) << page_text(report, false);
    const nlohmann::json data = nlohmann::json::parse(json_text(report.data));
    EXPECT_EQ(data["hottest"]["run"], 3);
    EXPECT_EQ(data["coldest"]["run"], 1);
}

TEST(StudyText, TellsOfLinesOfItsJournalThatWereDropped) {
    StudyCall call = made;
    call.damaged = 2;
    const std::string page = page_text(study_report(grid(), call), false);
    EXPECT_NE(page.find("2 damaged lines of runs.jsonl could not be read and were dropped; what they stood for was run "
                        "anew"),
              std::string::npos)
        << page;
}

TEST(StudyJson, GivesTheChanceOfPassingWithItsInterval) {
    const auto json = nlohmann::json::parse(json_text(study_report(samples(), made).data));
    EXPECT_EQ(json["points"][0]["passes_critical"]["times"], 2);
    EXPECT_EQ(json["points"][0]["passes_critical"]["of"], 20);
    EXPECT_DOUBLE_EQ(json["points"][0]["passes_critical"]["share"].get<double>(), 0.1);
    EXPECT_NEAR(json["points"][0]["passes_critical"]["low"].get<double>(), 0.0279, 5e-5);
    EXPECT_NEAR(json["points"][0]["passes_critical"]["high"].get<double>(), 0.3010, 5e-5);
    EXPECT_EQ(json["points"][0]["hottest"]["median"], 50.5);
}

// The cells of the grid of 50 and 60 km/h by 1, 2 and 3 kN reach halfway to their neighbours: from 45 to 55 and from 0.5 to 1.5 for
// the first, which is at 50 + 1 degC; the last run has failed and has none. Of 51 to 53 and 61 to 62 degC none is above the critical 62.
TEST(StudyMap, HasACellForEachRunThatEnded) {
    const auto map = chart_of(grid(), 1);
    EXPECT_EQ(map["kind"], "cells");
    ASSERT_EQ(map["cells"].size(), 5U);
    EXPECT_EQ(map["cells"][0]["at"], nlohmann::json::parse("[45, 55, 0.5, 1.5, 51]"));
    for (const auto& cell : map["cells"]) {
        EXPECT_FALSE(cell.value("marked", false));
    }
}

TEST(StudyMap, OtherSidesMakeMapsWhileTheyAreFew) {
    StudyRecord study = grid();
    study.columns.insert(study.columns.begin(), column("drive.camber", "deg", std::vector<double>(6, 0.0)));
    study.sides = {1, 2, 3};
    EXPECT_EQ(charts_of(study), 2U);  // curves and one map
    study.columns.push_back(column("drive.toe", "deg", std::vector<double>(12, 0.0)));
    for (StudyColumn& one : study.columns) {
        one.numbers.insert(one.numbers.end(), one.numbers.begin(), one.numbers.end());
        one.texts.insert(one.texts.end(), one.texts.begin(), one.texts.end());
    }
    study.outcomes.insert(study.outcomes.end(), study.outcomes.begin(), study.outcomes.end());
    study.sides = {2, 3, 1, 2};
    EXPECT_EQ(charts_of(study), 3U);  // a map for each of two
}

// Words stand side by side, in the order in which they were written.
TEST(StudyChart, WordsAreNamedPlaces) {
    StudyRecord words = grid();
    words.sides = {1, 3};
    words.columns[1].is_number = false;
    words.outcomes.resize(3);
    const auto chart = chart_of(words, 0);
    EXPECT_EQ(chart["x"]["labels"], nlohmann::json::parse(R"(["1 kN", "2 kN", "3 kN"])"));
    EXPECT_EQ(chart["panels"][0]["series"][0]["points"][2], nlohmann::json::parse("[2, 53]")) << chart["panels"][0];
}

// 41 to 60 degC in steps of 1: the counts of the bins are those of all 20, whatever their width.
TEST(StudyChart, HistogramCountsEverySample) {
    const auto chart = chart_of(samples(), 0);
    double sum = 0.0;
    const auto& points = chart["panels"][0]["series"][0]["points"];
    for (std::size_t i = 0; i < points.size(); i += 2) {
        sum += points[i][2].get<double>();
    }
    EXPECT_DOUBLE_EQ(sum, 20.0);
    EXPECT_EQ(chart["panels"][0]["series"][1]["name"], "critical 58 °C");
}

TEST(StudyAxis, LongAndUnevenNumbersStayReadable) {
    StudyRecord study = grid();
    study.columns[1].numbers = {1.0, 2.0, 1e12, 1.0, 2.0, 1e12};
    EXPECT_FALSE(study_axis(study, 1).is_number);
    EXPECT_EQ(study_axis(study, 1).in_steps().at, (std::vector<double>{0.0, 1.0, 2.0}));
    study.columns[1].numbers = {3e15, 1e15, 2e15, 3e15, 1e15, 2e15};
    const StudyAxis axis = study_axis(study, 1);
    EXPECT_TRUE(axis.is_number);
    EXPECT_EQ(axis.order(), (std::vector<std::size_t>{1, 2, 0}));
}

TEST(StudyChart, IsNotDrawnOfNothing) {
    StudyRecord one = samples();
    one.samples = 1;
    one.outcomes.resize(1);
    EXPECT_EQ(charts_of(one), 0U);
}

// Of the samples of 41 to 60 degC a part is 5 K colder and has 52 degC as its limit: 53, 54 and 55 pass it, of 58 to 60.
TEST(StudyStatistics, CountPartsThatPassTheirOwnCriticalTemperature) {
    StudyRecord study = samples();
    study.parts = {"belt edge"};
    for (StudyOutcome& outcome : study.outcomes) {
        outcome.parts = {{.hottest = outcome.hottest - 5.0, .critical = zero + 52.0}};
    }
    EXPECT_EQ(part_passes(study, 0, 0).times, 3U);
    EXPECT_EQ(part_passes(study, 0, 0).of, 20U);
    EXPECT_EQ(part_text(study, 0), "belt edge above 52 degC");
    const std::string csv = study_csv(study);
    EXPECT_NE(csv.find(",belt edge_hottest [degC],belt edge_critical [degC],energy_closure"), std::string::npos) << csv;
    EXPECT_NE(csv.find(",55.0000,52.0000,1.00e-13,30\n"), std::string::npos) << csv;
    const Report page = study_report(study, made);
    EXPECT_NE(page_text(page, false).find("belt edge above 52 degC in 15 % of 20 samples ("), std::string::npos);
    const nlohmann::json data = nlohmann::json::parse(json_text(page.data));
    EXPECT_EQ(data["points"][0]["critical_parts"][0]["name"], "belt edge");
    EXPECT_EQ(data["points"][0]["critical_parts"][0]["passes"]["times"], 3);
    study.outcomes[0].parts[0].critical = zero + 30.0;  // a study may vary it
    EXPECT_EQ(part_passes(study, 0, 0).times, 4U);
    EXPECT_EQ(part_text(study, 0), "belt edge above its critical temperature");
}

// Two of twenty runs left the range of one law, to 141 degC at most, and one of them that of another.
TEST(StudyRecord, ALawsRangeIsToldOnceForAllRunsThatLeftIt) {
    StudyRecord study = samples();
    study.outcomes[3].warnings = {
        {.law = "k is known up to 120 degC", .coldest = zero + 25.0, .hottest = zero + 130.0}};
    study.outcomes[7].warnings = {
        {.law = "k is known up to 120 degC", .coldest = zero + 20.0, .hottest = zero + 141.0},
        {.law = "c is known up to 140 degC", .coldest = zero + 20.0, .hottest = zero + 141.0}};
    EXPECT_EQ(
        texts_of(study.left_ranges()),
        (std::vector<std::string>{"k is known up to 120 degC; it was between 20.0 and 141.0 degC in 2 of 20 runs",
                                  "c is known up to 140 degC; it was between 20.0 and 141.0 degC in 1 of 20 runs"}));
}

}  // namespace tiretherm::post
