// SPDX-License-Identifier: BSD-3-Clause
// A measured total of the loss as a user gives it: a drum's table or SAE J2452 coefficients.
#include <cmath>

#include <gtest/gtest.h>

#include "physics/tire_laws/measured_loss.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

Reading read_loss(const std::string& tables, const std::string& table = "") {
    const Written written;
    written.add("drum.csv", table);
    return read_case(written.add(
        "case.toml",
        "include = [\"" + (source_folder() / "tests/bad_cases/good/section.toml").string() + "\"]\n" + tables));
}

std::string said_of_loss(const std::string& tables, const std::string& table = "") {
    const Reading reading = read_loss(tables, table);
    EXPECT_FALSE(reading.problem.has_value());
    return render(reading);
}

void expect_said_of_loss(const std::string& text, const std::vector<std::string>& pieces) {
    for (const std::string& piece : pieces) {
        EXPECT_NE(text.find(piece), std::string::npos) << "lacks: " << piece << "\nin:\n" << text;
    }
}

/// Mean power of the loss in a run. W
double mean_loss(const solver::Problem& problem) {
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok());
    EXPECT_LE(report.energy_closure, 1e-10);
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        if (problem.effects[e].effect->id == "strain_energy_loss") {
            return report.joules[e] / (problem.settings.end - problem.settings.start);
        }
    }
    return 0.0;
}

const std::string total = "[effects.strain_energy_loss]\ntotal = \"drum.csv\"\n";
const std::string drive = "[drive]\nspeed = \"90 km/h\"\nvertical_load = \"4000 N\"\n";

}  // namespace

// 90 km/h = 25 m/s lies half-way between 80 and 100 km/h, 4000 N on a row: (36 + 40)/2 = 38 N, 950 W. Given as power,
// 36 N 22.222 m/s = 800 W and 40 N 27.778 m/s = 1111.1 W, the same.
TEST(MeasuredLossCase, TableIsForceTimesSpeedInTheLedger) {
    const std::string force = "speed [km/h],vertical_load [kN],force [N]\n80,4,36\n100,4,40\n80,6,50\n100,6,60\n";
    const Reading reading = read_loss(drive + total, force);
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    EXPECT_NEAR(mean_loss(*reading.problem), 950.0, 950.0 * 1e-9);
    const Reading power =
        read_loss(drive + total, "speed [km/h],vertical_load [kN],power [W]\n80,4,800\n100,4,1111.1111111111111\n");
    ASSERT_TRUE(power.problem.has_value()) << render(power);
    EXPECT_NEAR(mean_loss(*power.problem), 950.0, 950.0 * 1e-9);
}

// SAE J2452 by hand: 230^-0.4 4000^1 (0.08 + 1e-4 90 + 1e-6 8100) = 0.113576 4000 0.0971 = 44.113 N; times 25 m/s.
TEST(MeasuredLossCase, CoastdownIsForceTimesSpeedInTheLedger) {
    const std::string fit =
        "[effects.strain_energy_loss]\ncoastdown = { alpha = -0.4, beta = 1.0, a = 0.08, b = 1e-4, "
        "c = 1e-6 }\n";
    const Reading reading = read_loss(drive + "inflation_pressure = \"230 kPa\"\n" + fit);
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    const double by_hand = std::pow(230.0, -0.4) * 4000.0 * (0.08 + 1e-4 * 90.0 + 1e-6 * 8100.0) * 25.0;
    EXPECT_NEAR(by_hand, 1102.8, 0.5);
    EXPECT_NEAR(mean_loss(*reading.problem), by_hand, by_hand * 1e-9);
    expect_said_of_loss(said_of_loss(drive + fit),
                        {"[drive] lacks inflation_pressure, over which the loss was measured"});
}

// A loss that falls with the bulk's temperature warms the tire less than one that stays at its value for the cold.
TEST(MeasuredLossCase, TableOfTheBulksTemperatureIsFollowed) {
    const Reading reading = read_loss(drive + total,
                                      "speed [km/h],vertical_load [kN],bulk_temperature [degC],force [N]\n"
                                      "90,4,20,50\n90,4,60,30\n90,4,100,20\n");
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    const double mean = mean_loss(*reading.problem);
    EXPECT_LT(mean, 49.0 * 25.0);
    EXPECT_GT(mean, 20.0 * 25.0);
}

// One temperature is none to follow: the force stays at its 50 N.
TEST(MeasuredLossCase, TableAtOneTemperatureOfTheBulkIsConstant) {
    const Reading reading =
        read_loss(drive + total, "speed [km/h],vertical_load [kN],bulk_temperature [degC],force [N]\n90,4,40,50\n");
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_NEAR(mean_loss(*reading.problem), 50.0 * 25.0, 1e-6);
}

TEST(MeasuredLossCase, BeyondTheTableItsEndIsHeldWithAWarning) {
    const Reading reading = read_loss(drive + total, "speed [km/h],vertical_load [kN],force [N]\n60,4,36\n80,4,40\n");
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    ASSERT_EQ(reading.warnings.size(), 1U);
    expect_said_of_loss(reading.warnings.front(),
                        {"speed goes from 25 to 25 m s-1, the table from 16.6667 to 22.2222: beyond its "
                         "ends the table is held"});
    EXPECT_NEAR(mean_loss(*reading.problem), 40.0 * 25.0, 1e-6);
}

TEST(MeasuredLossCase, WrongTablesAreExplained) {
    expect_said_of_loss(
        said_of_loss(drive + total, "speed [km/h],vertical_load [kN],force [N]\n80,4,36\n100,4,40\n80,6,50\n"),
        {"drum.csv: the table has no row for speed = 27.7778 m s-1 and vertical_load = 6000 N"});
    expect_said_of_loss(said_of_loss(drive + total, "speed [km/h],vertical_load [kN],force [N]\n80,4,36\n80,4,40\n"),
                        {"drum.csv:3:1: a second row for the same point"});
    expect_said_of_loss(said_of_loss(drive + total, "speed [N],load [kN],force [N]\n80,4,-3\n"),
                        {"the column speed is in [N]", "a table of the loss has no column \"load\"",
                         "the table has no vertical_load", "force is -3 N"});
    expect_said_of_loss(said_of_loss(drive + total, "speed [km/h],vertical_load [kN]\n80,4\n"),
                        {"the table gives neither force nor power"});
    expect_said_of_loss(said_of_loss(drive + total + "coastdown = { alpha = 0, beta = 1, a = 1, b = 0, c = 0 }\n",
                                     "speed [km/h],vertical_load [kN],force [N]\n80,4,36\n"),
                        {"the loss is measured twice: total and coastdown"});
    expect_said_of_loss(said_of_loss(drive + total + "temperature = \"local\"\n",
                                     "speed [km/h],vertical_load [kN],force [N]\n90,4,36\n"),
                        {"remove temperature = \"local\""});
    expect_said_of_loss(
        said_of_loss(drive + "[effects.strain_energy_loss]\ncoastdown = { alpha = -0.4, beta = 1, a = 1, d = 2, "
                             "speed_unit = \"kg\" }\n"),
        {"lacks b", "lacks c", "\"d\" is not a key of", "speed_unit"});
}

}  // namespace tiretherm::input
