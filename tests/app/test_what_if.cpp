// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm run --what-if` and `--change`: what single values of a case do, and which do nothing.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/input/measurements/measured_bench.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

/// A tire that nothing heats, in the steady state: it has the temperature of the air.
struct Cold {
    input::Written written;
    std::string file;

    Cold() {
        file = written
                   .add("cold.toml", std::string(input::bench) + R"([effects]
strain_energy_loss = { on = false }
sliding_friction = { on = false }
road_contact = { on = false }
[drive]
speed = "72 km/h"
vertical_load = "4000 N"
air_temperature = "20 degC"
camber = "-1 deg"
[time]
steady = true
)")
                   .string();
    }
    [[nodiscard]] Call run(const std::string& arguments) const {
        return call("run " + file + " --no-vtk --out out " + arguments, written.folder());
    }
};

// In the steady state without a source every sensor follows the air: +5 K and -5 K.
TEST(WhatIf, SaysWhatEachChangeDoesAndWhichDoNothing) {
    const Cold cold;
    const Call run = cold.run("--what-if --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json what_if = Json::parse(run.out)["what_if"];
    ASSERT_EQ(what_if["changes"].size(), 4u);  // camber and air, up and down
    const Json& warmer = what_if["changes"][2];
    EXPECT_EQ(warmer["key"], "drive.air_temperature");
    EXPECT_EQ(warmer["change"], "+5 K");
    EXPECT_NEAR(warmer["hottest"], 5.0, 1e-6);
    EXPECT_NEAR(warmer["channels"][1]["end"], 5.0, 1e-6);
    EXPECT_NEAR(what_if["changes"][3]["hottest"], -5.0, 1e-6);
    const std::vector<std::string> remarks = what_if["remarks"];
    EXPECT_NE(std::ranges::find(remarks, "drive.inflation_pressure is not given by the case: nothing follows it."),
              remarks.end());
    EXPECT_NE(std::ranges::find(remarks, "drive.road_temperature is not given by the case: nothing follows it."),
              remarks.end());
    EXPECT_NE(std::ranges::find(remarks,
                                "drive.camber moves nothing: no effect that is on reads it; camber_asymmetry and "
                                "pressure_across_tread would."),
              remarks.end())
        << what_if["remarks"];
    EXPECT_NE(cold.run("--what-if").out.find("What if\n"), std::string::npos);
}

// The air at 30 degC in the place of 20 degC: 10 K. A steady state has no heat capacity, and without a source it has the temperature of
// the air whatever the film; lambda_h is not in the case and counts by its standard value, 1.
TEST(WhatIf, AnyValueOfTheCaseCanBeChanged) {
    const Cold cold;
    const Json json =
        Json::parse(cold.run("--json --change 'drive.air_temperature=30 degC' --change 'material.rubber.density=+10 %' "
                             "--change 'effects.air_convection.lambda_h=+10 %'")
                        .out)["what_if"];
    ASSERT_EQ(json["changes"].size(), 3u);
    EXPECT_NEAR(json["changes"][2]["hottest"], 0.0, 1e-9);
    EXPECT_NEAR(json["changes"][0]["hottest"], 10.0, 1e-6);
    EXPECT_EQ(json["changes"][1]["hottest"], 0.0);
    EXPECT_EQ(json["remarks"][0], "material.rubber.density moves nothing: no effect that is on looks at it.");
}

TEST(WhatIf, ErrorsNameTheCallAndTheRemedy) {
    const Cold cold;
    for (const auto& [change, words] :
         {std::pair("drive.camber", "a key and its change are wanted"),
          std::pair("drive.camber=+1 turnip", "\"+1 turnip\" is no number with a unit"),
          std::pair("drive.vertical_load=-5000 N", "vertical_load would be -1000 N"),
          std::pair("drive.camber=+1 kg", "camber is a mass"),
          std::pair("effects.air_convection.lambda_g=1.1", "lambda_g"),
          std::pair("material.rubber.elasticity=+10 %", "the case does not give material.rubber.elasticity"),
          std::pair("camber=+1 deg", "did you mean \"drive.camber\"?")}) {
        const Call refused = cold.run(std::string("--change '") + change + "'");
        EXPECT_EQ(refused.exit_code, 1) << change;
        EXPECT_NE(refused.err.find(words), std::string::npos) << change << ": " << refused.err;
        EXPECT_NE(refused.err.find("nothing was run"), std::string::npos) << refused.err;
    }
}

}  // namespace
}  // namespace tiretherm::app_test
