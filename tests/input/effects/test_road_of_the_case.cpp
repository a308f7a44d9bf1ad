// SPDX-License-Identifier: BSD-3-Clause
// What a case says of its road: a drum that the tire heats starts at the road's temperature and has a sensor; the drum on
// which the loss was measured; what is told where the two do not agree with the rest.
#include <gtest/gtest.h>

#include "support/written.hpp"

namespace tiretherm::input {

namespace {

Reading with_road(const std::string& tables, const std::string& base = "tire") {
    const Written written;
    return read_case(written.add(
        "case.toml",
        "include = [\"" + (source_folder() / "tests/bad_cases/good" / (base + ".toml")).string() + "\"]\n" + tables));
}

double start_of_drum(const Reading& reading) {
    const solver::Problem& problem = *reading.problem;
    return problem.initial[static_cast<std::size_t>(problem.mesh.find_lumped_node("drum"))];
}

const std::string drum = "[effects.drum_heating]\n";
const std::string warm_road = "[drive]\nroad_temperature = \"31 degC\"\n";

}  // namespace

TEST(RoadOfTheCase, ADrumStartsAtTheRoadsTemperatureOrWhereTheCaseSays) {
    const Reading plain = with_road(drum + warm_road);
    ASSERT_TRUE(plain.problem.has_value()) << render(plain);
    EXPECT_TRUE(plain.warnings.empty()) << render(plain);
    EXPECT_NEAR(start_of_drum(plain), 304.15, 1e-9);
    const Reading own = with_road(drum + warm_road + "[initial]\ndrum = \"40 degC\"\n");
    ASSERT_TRUE(own.problem.has_value()) << render(own);
    EXPECT_NEAR(start_of_drum(own), 313.15, 1e-9);
}

TEST(RoadOfTheCase, ASensorReadsTheDrum) {
    const Reading read = with_road(drum + "[[sensor]]\nname = \"belt\"\nkind = \"node\"\nnode = \"drum\"\n", "section");
    ASSERT_TRUE(read.problem.has_value()) << render(read);
    EXPECT_EQ(read.problem->channels.back().where.nodes, std::vector{read.problem->mesh.find_lumped_node("drum")});
}

TEST(RoadOfTheCase, ARoadThatChangesIsToldWhereADrumFollowsItsOwnHeat) {
    const std::string series =
        "unset = [\"drive.road_temperature\"]\n[[drive.schedule]]\ncolumns = [\"time [s]\", \"road_temperature "
        "[degC]\"]\nrows = [[0, 20], [60, 30]]\n";
    EXPECT_TRUE(with_road(series).warnings.empty());
    const Reading read = with_road(series + drum);
    ASSERT_EQ(read.warnings.size(), 1U) << render(read);
    EXPECT_NE(read.warnings.front().find("road_temperature changes along the run"), std::string::npos);
    EXPECT_NEAR(start_of_drum(read), 293.15, 1e-9);
}

TEST(RoadOfTheCase, TheTireSaysOnWhichDrumItsLossWasMeasured) {
    const std::string measured = "[tire]\nloss_drum_diameter = \"1707 mm\"\n";
    EXPECT_EQ(with_road("").problem->tire.loss_drum_diameter, 0.0);
    const Reading read = with_road(measured);
    ASSERT_TRUE(read.problem.has_value()) << render(read);
    EXPECT_TRUE(read.warnings.empty()) << "which road it runs on the case does not say: " << render(read);
    EXPECT_NEAR(read.problem->tire.loss_drum_diameter, 1.707, 1e-12);
}

// 1/sqrt(1 + 0.3308 * 2/1.707) = 0.849
TEST(RoadOfTheCase, ACarOnAFlatRoadIsToldOfALossFromADrum) {
    const std::string car = "[[drive.file]]\npath = \"" + (source_folder() / "tests/bad_cases/good/car.csv").string() +
                            "\"\n[tire]\nloss_drum_diameter = \"1.707 m\"\n";
    const auto told = [&](const std::string& tables) {
        return render(with_road(tables, "car")).find("a car drives on a flat road, where it is 0.849 of that");
    };
    EXPECT_NE(told(car), std::string::npos);
    EXPECT_EQ(told(car + "[effects.drum_curvature]\ncurvature = \"0 1/m\"\n"), std::string::npos);
}

}  // namespace tiretherm::input
