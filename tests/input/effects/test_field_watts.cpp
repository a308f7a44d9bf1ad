// SPDX-License-Identifier: BSD-3-Clause
// Watts of a structural code are taken as they are: the user is informed which of his keys then say nothing.
#include <gtest/gtest.h>

#include "input/effects/field_bench.hpp"

namespace tiretherm::input {

namespace {

using namespace field_bench;

const std::string contact = "y [mm],friction_power [W/m2]\n-50,100\n0,200\n50,100\n";

std::string warnings(const std::string& tables, const std::string& field) {
    const Reading reading = read(tables, field);
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    std::string text;
    for (const std::string& warning : reading.warnings) {
        text += warning.find("is ignored") != std::string::npos ? warning + "\n" : "";
    }
    return text;
}

}  // namespace

TEST(FieldOfWatts, SilencesTheScalesAndSwitchesOfFriction) {
    const std::string keys = "lambda_x = 0.5\nlambda_y = 1.2\nlongitudinal = \"off\"\npartition = 0.5\n";
    const std::string report = warnings(friction_watts + keys, contact);
    for (const std::string key : {"lambda_x", "lambda_y", "longitudinal"}) {
        EXPECT_NE(report.find(key + " is ignored: the field gives the watts"), std::string::npos) << report;
    }
    // The tire's share of the watts is not in the file, and the law scales a shape.
    EXPECT_EQ(report.find("partition is"), std::string::npos) << report;
    EXPECT_EQ(warnings(friction + keys, contact), "");
}

TEST(FieldOfWatts, SaysNothingOfKeysThatNobodyWrote) { EXPECT_EQ(warnings(friction_watts, contact), ""); }

TEST(FieldOfWatts, SilencesTheNumbersOfTheLoss) {
    const std::string field = "y [mm],loss_density [W/m3]\n-50,1e5\n0,1e5\n50,1e5\n";
    const std::string report = warnings(loss + "use = \"watts\"\nlambda_blk = 1.1\ntan_delta_a = 2e15\n", field);
    EXPECT_NE(report.find("lambda_blk is ignored"), std::string::npos) << report;
    EXPECT_NE(report.find("tan_delta_a is ignored"), std::string::npos) << report;
}

}  // namespace tiretherm::input
