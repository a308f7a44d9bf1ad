// SPDX-License-Identifier: BSD-3-Clause
// Corners of a car compared: figures by corner, and what all, one axle or one side have in common.

#include "diagnosis/compare/corner_comparison.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "post/comparison/comparison_report.hpp"
#include "post/comparison/corner_sections.hpp"
#include "tests/diagnosis/compare/compared_bench.hpp"

namespace tiretherm::diagnosis {
namespace {

CornerFigures corner(const std::string& name, double rolling, double slipping, double deviation = 0.1) {
    CornerFigures one{.corner = name, .figures = {}, .phases = {}};
    one.phases.push_back(
        {.phase = Phase::slipping, .share = 0.3, .figures = {.bias = slipping, .bias_deviation = deviation}});
    one.phases.push_back(
        {.phase = Phase::free_rolling, .share = 0.7, .figures = {.bias = rolling, .bias_deviation = deviation}});
    return one;
}

// Rolling, all four are too hot by 1 to 4 K; slipping, the left ones alone are off, too cold by 0.5 and 0.6 K. The longer
// phase stands first.
TEST(CornerComparison, FindsWhatAllAndWhatOneSideHasInCommon) {
    const std::vector<CornerFigures> corners{corner("FL", 1.0, -0.5), corner("FR", 4.0, 0.1), corner("RL", 2.0, -0.6),
                                             corner("RR", 3.0, -0.1)};
    const std::vector<CommonBias> common = common_biases(corners);
    ASSERT_EQ(common.size(), 2u);
    EXPECT_EQ(common[0].phase, Phase::free_rolling);
    EXPECT_EQ(common[0].group, "all");
    EXPECT_EQ(common[0].least, 1.0);
    EXPECT_EQ(common[0].most, 4.0);
    EXPECT_EQ(common[1].phase, Phase::slipping);
    EXPECT_EQ(common[1].group, "left");
    EXPECT_EQ(common[1].corners, (std::vector<std::string>{"FL", "RL"}));
    EXPECT_EQ(common[1].most, -0.6);
}

// Without a rear left tire, the front axle is FL and FR, and FL alone is no side: RL would have been one of it.
TEST(CornerComparison, AGroupIsAllOfItsCornersThatAreMeasured) {
    const std::vector<CornerFigures> corners{corner("FL", 1.0, 1.0), corner("FR", 1.0, 0.0), corner("RR", 0.0, 0.0)};
    const std::vector<CommonBias> common = common_biases(corners);
    ASSERT_EQ(common.size(), 2u);
    EXPECT_EQ(common[0].group, "front");
    EXPECT_EQ(common[1].group, "");
    EXPECT_EQ(common[1].corners, std::vector<std::string>{"FL"});
}

// 1 K with a standard deviation of 0.6 K is within chance; of one corner alone nothing is common.
TEST(CornerComparison, SaysNothingWithinChanceOrOfOneCorner) {
    EXPECT_TRUE(common_biases(std::vector{corner("FL", 1.0, 1.0, 0.6), corner("FR", 1.0, 1.0, 0.6)}).empty());
    EXPECT_TRUE(common_biases(std::vector{corner("FL", 1.0, 1.0)}).empty());
}

// The bench stays at 23 degC. FL is measured at 20 degC (+3 K) and FR at 25 degC (-2 K) by the same log.
TEST(CornerComparison, PageHasATableByCorner) {
    const input::Written written;
    written.add("car.csv",
                "time [s],speed [km/h],vertical_load [N],air_temperature [degC],B_FL [degC],B_FR [degC]\n"
                "0,36,4000,13,20,25\n2,36,4000,13,20,25\n4,36,4000,13,20,25\n6,36,4000,13,20,25\n");
    const std::string car = sample::idle + R"([[corner]]
name = "FL"
columns = { B_FL = "bulk_temperature" }
[[corner]]
name = "FR"
columns = { B_FR = "bulk_temperature" }
[[run]]
file = "car.csv"
)";
    const input::ExperimentReading reading = input::read_experiment(written.add("car.toml", car));
    ASSERT_TRUE(reading.experiment) << input::error_report(reading);
    const Comparison comparison = compare(*reading.experiment, "car");
    ASSERT_EQ(comparison.channels.size(), 1u);
    const ComparedChannel& bulk = comparison.channels.front();
    ASSERT_EQ(bulk.corners.size(), 2u);
    EXPECT_NEAR(bulk.corners[0].figures.bias, 3.0, 1e-9);
    EXPECT_NEAR(bulk.corners[1].figures.bias, -2.0, 1e-9);
    const std::string page = post::page_text(post::comparison_report(comparison, {}), false);
    EXPECT_NE(page.find("Corners\n"), std::string::npos) << page;
    EXPECT_NE(page.find("bulk_temperature, free rolling: only FL is too hot, by 3.00 K"), std::string::npos) << page;
    EXPECT_NE(page.find("bulk_temperature, free rolling: only FR is too cold, by 2.00 K"), std::string::npos) << page;
}

// The last lap of one run is number 3 of a counter, that of the other is number 4: one row has both, and the third lap of the longer run is
// another row.
TEST(LapTable, HasARowForInLapsWhateverTheirNumbers) {
    const input::Written written;
    const auto log = [](int laps) {
        std::string text =
            "time [s],lap,speed [km/h],vertical_load [N],air_temperature [degC],bulk_temperature [degC]\n";
        for (int i = 0; i < 4 * laps; ++i) {
            text += std::to_string(i) + "," + std::to_string(1 + i / 4) + ",36,4000,13,20\n";
        }
        return text;
    };
    written.add("a.csv", log(3));
    written.add("b.csv", log(4));
    const input::ExperimentReading reading = input::read_experiment(
        written.add("laps.toml", std::string(sample::idle) + "[[run]]\nfile = \"a.csv\"\n[[run]]\nfile = \"b.csv\"\n"));
    ASSERT_TRUE(reading.experiment) << input::error_report(reading);
    const Comparison comparison = compare(*reading.experiment, "laps");
    const std::string page = post::page_text(post::comparison_report(comparison, {}), false);
    EXPECT_NE(page.find("lap  bias a  bias b\n"
                        "  bulk_temperature  K     out   +3.00   +3.00\n"
                        "                            2   +3.00   +3.00\n"
                        "                            3       -   +3.00\n"
                        "                           in   +3.00   +3.00\n"),
              std::string::npos)
        << page;
    // Simulated 23 degC, measured 20 degC throughout; a lap takes 4 s.
    const std::string csv = post::laps_csv(post::lap_rows(comparison.channels, comparison.runs));
    EXPECT_NE(csv.find("\na,,2,4,bulk_temperature,degC,20,20,20,23,23,23,3,3\n"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\nb,,all,15,bulk_temperature,degC,20,20,20,23,23,23,3,3\n"), std::string::npos) << csv;
    EXPECT_NE(page.find("0:04.000"), std::string::npos) << page;
}

}  // namespace
}  // namespace tiretherm::diagnosis
