// SPDX-License-Identifier: BSD-3-Clause
// What names and units of columns say.

#include <gtest/gtest.h>

#include "input/text/column_names.hpp"

namespace tiretherm::input {

using Words = std::vector<std::string>;

TEST(ColumnNames, AreSplitAtSignsCapitalsAndDigits) {
    EXPECT_EQ(words_of("brake_temperature"), (Words{"brake", "temperature"}));
    EXPECT_EQ(words_of("BrakeTempFL2"), (Words{"brake", "temp", "fl", "2"}));
    EXPECT_EQ(words_of("T shoulder (sim)"), (Words{"t", "shoulder", "sim"}));
    EXPECT_EQ(words_of("TPMSTemp"), (Words{"tpms", "temp"}));
    EXPECT_EQ(words_of(""), Words{});
}

TEST(ColumnNames, OfResults) {
    EXPECT_EQ(word_of_result("T_surface_calc"), "calc");
    EXPECT_EQ(word_of_result("SimulatedBulk"), "simulated");
    EXPECT_EQ(word_of_result("tire_est_1"), "est");
    // Parts of words are no words.
    EXPECT_EQ(word_of_result("east_wind"), "");
    EXPECT_EQ(word_of_result("calcium"), "");
}

TEST(ColumnNames, OfClocks) {
    EXPECT_EQ(word_of_clock("LapNumber"), "lap");
    EXPECT_EQ(word_of_clock("Distance"), "distance");
    EXPECT_EQ(word_of_clock("GPS Lat"), "lat");
    EXPECT_EQ(word_of_clock("lat"), "lat");
    EXPECT_EQ(word_of_clock("X"), "x");
    // A lateral acceleration, an overlap and a time that something takes are not.
    EXPECT_EQ(word_of_clock("lat_acceleration"), "");
    EXPECT_EQ(word_of_clock("overlap"), "");
    EXPECT_EQ(word_of_clock("injection_time"), "");
    EXPECT_EQ(word_of_clock("gps_speed"), "");
}

TEST(ColumnNames, OfTemperatures) {
    EXPECT_TRUE(is_temperature("x", "degC"));
    EXPECT_TRUE(is_temperature("x", "K"));
    EXPECT_TRUE(is_temperature("x", "degF"));
    EXPECT_TRUE(is_temperature("x", "C"));
    EXPECT_TRUE(is_temperature("Brake Temp", ""));
    EXPECT_FALSE(is_temperature("x", ""));
    EXPECT_FALSE(is_temperature("x", "bar"));
    EXPECT_FALSE(is_temperature("temperature_rate", "K/s"));
    EXPECT_EQ(word_of_tire("TreadMiddle"), "tread");
    EXPECT_EQ(word_from_outside("brake_disc"), "brake");
    EXPECT_EQ(word_from_outside("hair_dryer"), "");
}

}  // namespace tiretherm::input
