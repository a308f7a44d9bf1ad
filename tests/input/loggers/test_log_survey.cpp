// SPDX-License-Identifier: BSD-3-Clause
// What `tiretherm check LOG` says of a file: channels with rate, range and use, laps, and what looks wrong.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/log_survey/log_survey.hpp"
#include "input/loggers/ld_writer.hpp"
#include "input/loggers/logger_files.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

LogSurvey survey(const std::string& name, std::string_view content) {
    const Written written;
    InputErrors errors;
    const std::optional<LogSurvey> found = survey_log(written.add(name, content), {}, errors);
    for (const InputError& error : errors.in_order()) {
        ADD_FAILURE() << render(error);
    }
    return found.value_or(LogSurvey{});
}

const ColumnSurvey& column(const LogSurvey& survey, std::string_view name) {
    static const ColumnSurvey none;
    const auto found = std::ranges::find(survey.columns, name, &ColumnSurvey::name);
    EXPECT_NE(found, survey.columns.end()) << name;
    return found == survey.columns.end() ? none : *found;
}

bool doubts(const LogSurvey& survey, std::string_view sentence) {
    return std::ranges::any_of(survey.doubts,
                               [&](const std::string& doubt) { return doubt.find(sentence) != std::string::npos; });
}

}  // namespace

// 110 s at 20 Hz; the tread warms from 60 to 60 + 25 (1 - exp(-110 / 40)) = 83.402 degC.
TEST(LogSurvey, SaysWhatIsInAnAimFile) {
    const LogSurvey found = survey("session.csv", made_up::aim_csv(made_up::Session(2201, 0.05)));
    EXPECT_EQ(found.description.format, "AiM CSV");
    EXPECT_EQ(found.rows, 2201U);
    EXPECT_EQ(found.laps.laps.size(), 4U);
    EXPECT_EQ(column(found, "Time").use, "time");
    EXPECT_EQ(column(found, "speed").used_as, "speed");
    const ColumnSurvey& tread = column(found, "surface_temperature");
    EXPECT_EQ(tread.use, "sensor");
    EXPECT_NEAR(tread.rate, 20.0, 1e-6);
    EXPECT_DOUBLE_EQ(*tread.low, 60.0);
    EXPECT_NEAR(*tread.high, 83.402, 5e-4);
}

// 40 to 59 degC and 100 to 119 degC at 0 to 19 s; before the sensors answer, and at 7 s, the logger writes 9999 or 65535.
TEST(LogSurvey, RangesAreThoseOfTheValuesThatAreUsed) {
    std::string log = "time [s],speed [km/h],surface_temperature [degC],Oil Temp [degC]\n";
    for (int i = 0; i < 20; ++i) {
        log += fmt::format("{0},{1},{2},{3}\n", i, 80 + i, i < 2 || i == 7 ? 9999 : 40 + i, i < 3 ? 65535 : 100 + i);
    }
    const LogSurvey found = survey("log.csv", log);
    EXPECT_EQ(*column(found, "surface_temperature").low, 42.0);
    EXPECT_EQ(*column(found, "surface_temperature").high, 59.0);
    EXPECT_EQ(column(found, "surface_temperature").samples, 17U);
    EXPECT_EQ(*column(found, "Oil Temp").high, 119.0);
    EXPECT_TRUE(doubts(found, "surface_temperature is 9999 degC in 3 of 20 samples, which no sensor of it reads"));
    EXPECT_TRUE(doubts(found, "Oil Temp is 65535 degC in 3 of 20 samples, which no sensor of it reads: left out"));
    EXPECT_FALSE(doubts(found, "10000 degC")) << "what is left out is doubted once";
}

// Two lines a minute under a clock without seconds; the second half of a file that is cut off.
TEST(LogSurvey, SaysWhatWasDecidedWhileReading) {
    const LogSurvey found = survey("log.csv",
                                   "Time,speed [km/h]\n10/24/2026 11:20,36\n10/24/2026 11:20,36\n"
                                   "10/24/2026 11:21,36\n10/24/2026 11:21,36\n10/24/2026 11:22");
    EXPECT_EQ(found.to, 90.0);
    EXPECT_TRUE(doubts(found, "line 1: Time: the clock goes on by 60 s, and up to 2 lines have one time"));
    EXPECT_TRUE(doubts(found, "line 6: the last line has 1 of 2 values"));
}

// Five of every hundred samples are missing; a channel in C whose name tells nothing is asked for; rear is front with 2 K added.
TEST(LogSurvey, SaysWhatLooksWrong) {
    std::string log = "time [s],speed [km/h],Front Temp [degC],Rear Temp [degC],Quantity [C]\n";
    for (int i = 0; i < 400; ++i) {
        const double t = 0.1 * i;
        const std::string front = made_up::digits(60.0 + 8.0 * std::sin(0.2 * t) + 0.1 * ((i * 7) % 5), 1);
        const std::string rear = made_up::digits(62.0 + 8.0 * std::sin(0.2 * t) + 0.1 * ((i * 7) % 5), 1);
        log += made_up::digits(t, 1) + "," + (i % 20 == 10 ? "" : made_up::digits(80.0 + 0.01 * i, 2)) + "," + front +
               "," + rear + ",1\n";
    }
    const LogSurvey found = survey("log.csv", log);
    EXPECT_NEAR(column(found, "speed").missing, 0.05, 1e-9);
    EXPECT_TRUE(doubts(found, "the column Quantity is in C: degC or coulomb?"));
    EXPECT_TRUE(doubts(found, "Rear Temp is a copy of Front Temp with 2 K added, sample by sample"));
}

// Samples 0.1 s apart, every tenth 0.3 s: no field is empty. A throttle rests at 0 % in half of them, and nothing uses it. The laps
// come from a column that no model knows.
TEST(LogSurvey, CallsNothingMissingOrClippedThatIsNot) {
    std::string log = "time [s],speed [km/h],throttle [%],lap_number,surface_temperature [degC]\n";
    double t = 0.0;
    for (int i = 0; i < 400; ++i) {
        t += i % 10 == 9 ? 0.3 : 0.1;
        log += made_up::digits(t, 1) + "," + made_up::digits(100.0 + 20.0 * std::sin(0.3 * i), 1) + "," +
               made_up::digits(std::max(0.0, 80.0 * std::sin(0.3 * i) + 0.1 * ((i * 7) % 5)), 1) + "," +
               std::to_string(1 + i / 100) + "," + made_up::digits(60.0 + 0.02 * i + 0.1 * ((i * 7) % 5), 1) + "\n";
    }
    const LogSurvey found = survey("log.csv", log);
    for (const ColumnSurvey& one : found.columns) {
        EXPECT_EQ(one.missing, 0.0) << one.name;
    }
    EXPECT_FALSE(doubts(found, "throttle"));
    EXPECT_EQ(column(found, "lap_number").use, "laps");
}

// Tolerance: a step is the difference of two times of some 10 s, known to 2e-15 s of 0.02 s.
TEST(LogSurvey, KeepsTheRatesOfALdFile) {
    using made_up::integers;
    const std::string bytes =
        made_up::LdWriter::file({integers("speed", "km/h", 50, std::vector<int>(500, 80)),
                                 integers("surface_temperature", "C", 5, std::vector<int>(50, 70))});
    const LogSurvey found = survey("session.ld", bytes);
    EXPECT_NEAR(column(found, "speed").rate, 50.0, 1e-10);
    EXPECT_NEAR(column(found, "surface_temperature").rate, 5.0, 1e-10);
    EXPECT_EQ(column(found, "surface_temperature").samples, 50U);
    EXPECT_EQ(column(found, "surface_temperature").missing, 0.0);
}

// Accelerations with noise, as every car's log has them, explain no outlier of a tire: 30 K at 20 s. The 0 of a speed that is lost
// for 3 s, in bends of 0.8 g, draws a remark.
TEST(LogSurvey, FindsOutliersAndALostSpeedBesideNoisyAccelerations) {
    std::string log = "time [s],speed [km/h],LatAcc [g],LonAcc [g],Tire Temp FL [degC],Tire Temp FR [degC]\n";
    for (int i = 0; i < 1000; ++i) {
        const double t = 0.1 * i;
        const double noise = 0.2 * std::sin(37.0 * i);
        log += std::to_string(t) + "," + std::to_string(i >= 500 && i < 530 ? 0.0 : 96.0 + 5.0 * std::sin(0.3 * t)) +
               "," + std::to_string(0.8 * std::sin(0.5 * t) + noise) + "," +
               std::to_string(0.3 * std::cos(0.3 * t) - noise) + "," +
               std::to_string(60.0 + 0.1 * t + noise + (i == 200 ? 30.0 : 0.0)) + "," +
               std::to_string(61.0 + 0.1 * t - noise) + "\n";
    }
    const LogSurvey found = survey("log.csv", log);
    EXPECT_TRUE(doubts(found, "(column Tire Temp FL) has an outlier at 20 s")) << [&] {
        std::string all;
        for (const std::string& doubt : found.doubts) {
            all += doubt + "\n";
        }
        return all;
    }();
    EXPECT_TRUE(doubts(found, "speed stands at 0 km/h from 50 s to 52.9 s and jumps by 9"));
}

// Air of -1 degC for 5 s and of 21 afterwards, in 60 s at 10 Hz: 25 degC of a tire are -3.9 degF, near the -1 of a sensor that was not yet
// awake, and 25 degC beside the air itself.
TEST(LogSurvey, DoubtsNoUnitBesideADeadAir) {
    std::string log = "time [s],air_temperature [degC],Tire Temp FL [C]\n";
    for (int i = 0; i < 600; ++i) {
        log += fmt::format("{:.1f},{},{:.2f}\n", 0.1 * i, i < 50 ? -1 : 21, 25.0 + 0.01 * i);
    }
    const LogSurvey found = survey("log.csv", log);
    EXPECT_TRUE(doubts(found, "stands at -1 degC from 0 s to 4.9 s"));
    EXPECT_FALSE(doubts(found, "is the column in degF?"));
}

}  // namespace tiretherm::input
