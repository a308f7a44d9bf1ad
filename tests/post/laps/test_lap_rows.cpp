// SPDX-License-Identifier: BSD-3-Clause
// Sensors lap by lap: names of laps and runs, the table, the data and the file.
#include "post/laps/lap_rows.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "solver/quantity.hpp"

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;
using input::Lap;
using input::LapKind;

const Lap out{.number = 0, .start = 0.0, .end = 100.0, .kind = LapKind::out};
const Lap first{.number = 1, .start = 100.0, .end = 190.0};
const Lap second{.number = 2, .start = 190.0, .end = 279.5};
const Lap in{.number = 3, .start = 279.5, .end = 400.0, .kind = LapKind::in};

/// The surface in a lap, or over the whole run: mean and last value in degC.
LapRow row(const std::string& corner, std::optional<Lap> lap, double mean, double end) {
    return {.run = "session_" + corner,
            .corner = corner,
            .lap = lap,
            .seconds = lap ? lap->end - lap->start : 400.0,
            .channel = "surface",
            .unit = solver::shown_unit(solver::Quantity::temperature),
            .simulated = {.mean = mean + 273.15, .highest = mean + 283.15, .end = end + 273.15}};
}

TEST(LapRows, OutLapsComeFirstAndInLapsLastWhateverTheirNumbers) {
    EXPECT_EQ(lap_name(out), "out");
    EXPECT_EQ(lap_name(second), "2");
    // The second run had its in-lap after one lap.
    EXPECT_EQ(names_of_laps({{out, first, second, in}, {out, first, in}}),
              (std::vector<std::string>{"out", "1", "2", "in"}));
}

TEST(LapRows, RunsOfOneRecordingAreCalledByTheirCorners) {
    EXPECT_EQ(short_names({"session_FL", "session_RR"}), (std::vector<std::string>{"FL", "RR"}));
    EXPECT_EQ(short_names({"monday_FL", "tuesday_FL"}), (std::vector<std::string>{"monday_FL", "tuesday_FL"}));
}

TEST(LapRows, ASingleTireWithoutLapsNeedsNoTable) {
    EXPECT_FALSE(have_laps_or_corners({row("", std::nullopt, 60.0, 70.0)}));
    EXPECT_TRUE(have_laps_or_corners({row("", first, 60.0, 70.0), row("", std::nullopt, 60.0, 70.0)}));
    EXPECT_TRUE(have_laps_or_corners({row("FL", std::nullopt, 60.0, 70.0)}));
}

// 89.5 s are 1:29.500.
TEST(LapRows, TheTableHasEachLapWithItsTimeAndTheWholeRunBehindThem) {
    Report report{.title = "page"};
    report.add(lap_section({row("FL", second, 80.0, 85.0), row("FL", std::nullopt, 71.0, 85.0)}));
    const std::string page = page_text(report, false);
    EXPECT_NE(page.find("1:29.500"), std::string::npos) << page;
    EXPECT_NE(page.find("all"), std::string::npos) << page;
    EXPECT_NE(page.find("80.00"), std::string::npos) << page;
    EXPECT_LT(page.find("80.00"), page.find("71.00")) << page;
}

TEST(LapRows, TheFileHasARowForEachLapAndOneForTheRun) {
    const std::string csv = laps_csv({row("FL", first, 80.0, 85.0), row("FL", std::nullopt, 71.0, 85.0)});
    EXPECT_EQ(std::ranges::count(csv, '\n'), 3) << csv;
    EXPECT_NE(csv.find("\nsession_FL,FL,1,90,surface,degC,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\nsession_FL,FL,all,400,surface,degC,"), std::string::npos) << csv;
}

// 80 degC in the lap, 71 degC over the run: in the units that users see.
TEST(LapRows, TheDataHaveLapsAndRunsApart) {
    Value data{{"case", "made up"}};
    add_lap_data(data, {row("FL", first, 80.0, 85.0), row("FL", std::nullopt, 71.0, 85.0)});
    const Json read = Json::parse(json_text(data));
    ASSERT_EQ(read["laps"].size(), 1U) << read;
    ASSERT_EQ(read["run_values"].size(), 1U) << read;
    EXPECT_NEAR(read["laps"][0]["simulated"]["mean"].get<double>(), 80.0, 1e-9) << read;
}

}  // namespace
}  // namespace tiretherm::post
