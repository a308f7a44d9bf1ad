// SPDX-License-Identifier: BSD-3-Clause
// A made-up session in the layouts of AiM, MoTeC, RaceChrono and VBOX, and with comments and clocks, is read back to the last
// digit that was written.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/laps/file_laps.hpp"
#include "input/loggers/logger_files.hpp"
#include "input/loggers/read_back.hpp"

namespace tiretherm::input {

namespace {

using made_up::digits;
using made_up::Session;

/// What was written of a value, as a number.
double written(double value, int decimals) { return std::strtod(digits(value, decimals).c_str(), nullptr); }

/// Time, speed, load and temperature of every line. Tolerance: the conversion to SI rounds once, to 1e-15 of the value.
void expect_session(ReadBack& file, const Session& session, const std::string& time, const std::string& speed) {
    ASSERT_TRUE(file.is_open()) << file.messages();
    const std::vector<double> t = file.column(time, "s", Purpose::clock);
    const std::vector<double> v = file.column(speed, "m s-1");
    const std::vector<double> load = file.column("vertical_load", "N");
    const std::vector<double> tread = file.column("surface_temperature", "K");
    ASSERT_EQ(t.size(), session.time.size());
    ASSERT_TRUE(v.size() == t.size() && load.size() == t.size() && tread.size() == t.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
        EXPECT_DOUBLE_EQ(t[i], written(session.time[i], 3));
        EXPECT_DOUBLE_EQ(v[i], written(Session::speed(session.time[i]), 2) / 3.6);
        EXPECT_DOUBLE_EQ(load[i], written(Session::load(session.time[i]), 1));
        EXPECT_DOUBLE_EQ(tread[i], written(Session::tread(session.time[i]), 3) + 273.15);
    }
}

}  // namespace

TEST(AimCsv, IsReadToTheLastDigitInEveryStyle) {
    const Session session(200, 0.05);
    for (const made_up::Style& style :
         {made_up::Style{}, made_up::Style{.quotes = false}, made_up::Style{.separator = ';', .comma = true},
          made_up::Style{.separator = ';', .comma = true, .quotes = false}}) {
        ReadBack file("session.csv", made_up::aim_csv(session, style));
        expect_session(file, session, "Time", "speed");
        EXPECT_EQ(file.file().description().format, "AiM CSV");
        EXPECT_TRUE(file.file().heads()[0].is_clock);
    }
}

// Marks at 15.708, 47.124 and 78.540 s cut 110 s into four parts; those at 109.956 s and at the export's end are no crossings, for
// less than half a second is left.
TEST(AimCsv, HasItsLapsBetweenTheBeacons) {
    const Session session(2201, 0.05);
    ReadBack file("session.csv", made_up::aim_csv(session));
    ASSERT_TRUE(file.is_open());
    const Laps laps = find_laps(file.file(), session.time, std::nullopt, false, file.errors());
    ASSERT_EQ(laps.laps.size(), 4U);
    EXPECT_EQ(laps.source, LapSource::markers);
    EXPECT_EQ(laps.laps[0].kind, LapKind::out);
    EXPECT_EQ(laps.laps[3].kind, LapKind::in);
    EXPECT_DOUBLE_EQ(laps.laps[1].start, written(Session::crossing(0), 3));
    EXPECT_DOUBLE_EQ(laps.laps[1].end, written(Session::crossing(1), 3));
}

TEST(MotecCsv, IsReadToTheLastDigitWithItsBeaconsInOneField) {
    const Session session(2201, 0.05);
    ReadBack file("session.csv", made_up::motec_csv(session));
    expect_session(file, session, "Time", "speed");
    const std::vector<double> marks{written(Session::crossing(0), 3), written(Session::crossing(1), 3),
                                    written(Session::crossing(2), 3), written(Session::crossing(3), 3)};
    EXPECT_EQ(file.file().description().markers, marks);
    EXPECT_EQ(file.file().description().format, "MoTeC CSV");
}

// Seconds since 1970 count from the first line on; equal names have their sources; an empty field is a missing value.
TEST(RaceChronoCsv, HasUnixTimesSourcesAndMissingValues) {
    const Session session(1000, 0.1);
    ReadBack file("session.csv", made_up::racechrono_csv(session));
    ASSERT_TRUE(file.is_open()) << file.messages();
    const std::vector<double> t = file.column("timestamp", "s", Purpose::clock);
    const std::vector<double> gps = file.column("speed (gps)", "m s-1");
    const std::vector<double> calculated = file.column("speed (calc)", "m s-1");
    const std::vector<double> tread = file.column("surface_temperature", "K");
    ASSERT_EQ(t.size(), 1000U);
    for (std::size_t i = 0; i < t.size(); ++i) {
        EXPECT_NEAR(t[i], session.time[i], 1e-9);  // rounded to a microsecond
        EXPECT_DOUBLE_EQ(gps[i], written(Session::speed(session.time[i]) / 3.6, 3));
        EXPECT_DOUBLE_EQ(calculated[i], written(Session::speed(session.time[i]) / 3.6 + 1.0, 3));
        EXPECT_EQ(std::isnan(tread[i]), i % 2 == 1);
    }
    EXPECT_DOUBLE_EQ(tread[10], written(Session::tread(1.0), 3) + 273.15);
    const Laps laps = find_laps(file.file(), t, std::nullopt, false, file.errors());
    EXPECT_EQ(laps.source, LapSource::column);
    ASSERT_EQ(laps.laps.size(), 4U);
    EXPECT_NEAR(laps.laps[1].start, Session::crossing(0), 0.1);  // the line after it
}

TEST(RaceChronoCsv, OfFormatTwoHasUnitsInRoundBrackets) {
    const Session session(50, 0.1);
    ReadBack file("session.csv", made_up::racechrono_csv_2(session));
    expect_session(file, session, "Time", "Speed *gps");
    EXPECT_TRUE(file.file().heads()[0].is_clock);
}

// From 10 s before midnight on: the clock goes from 235950.00 to 000139.95, the times from 0 to 109.95 s. Positions are in
// minutes with the west positive, and the car crosses the line of [laptiming] at 5 pi, 15 pi and 25 pi s; between two samples
// at 40 m/s, 2 m apart, the chord differs from the circle by 2.5 mm, which is 0.06 ms; six decimals of a minute are 1.9 mm.
TEST(VboxVbo, PassesMidnightAndCrossesItsStartLine) {
    const Session session(2200, 0.05);
    ReadBack file("session.vbo", made_up::vbox_vbo(session, 86390.0));
    ASSERT_TRUE(file.is_open()) << file.messages();
    const std::vector<double> t = file.column("time", "s", Purpose::clock);
    const std::vector<double> speed = file.column("velocity", "m s-1");
    const std::vector<double> tread = file.column("surface_temperature", "K");
    ASSERT_EQ(t.size(), session.time.size()) << file.messages();
    for (std::size_t i = 0; i < t.size(); ++i) {
        EXPECT_NEAR(t[i], session.time[i], 1e-9);
        EXPECT_DOUBLE_EQ(speed[i], written(Session::speed(session.time[i]), 3) / 3.6);
        EXPECT_DOUBLE_EQ(tread[i], written(Session::tread(session.time[i]), 3) + 273.15);
    }
    const Laps laps = find_laps(file.file(), t, std::nullopt, false, file.errors());
    EXPECT_EQ(laps.source, LapSource::start_line);
    ASSERT_EQ(laps.laps.size(), 4U);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(laps.laps[static_cast<std::size_t>(k)].end, Session::crossing(k), 2e-4);
    }
}

// As the session above: the car crosses the line at 5 pi, 15 pi and 25 pi s, whatever its longitude is called.
TEST(VboxVbo, LongitudeHasSeveralNames) {
    const Session session(2200, 0.05);
    for (const char* name : {"lng", "lon", "longitude"}) {
        std::string text = made_up::vbox_vbo(session, 36000.0);
        const std::string old = "sats time lat long ";
        ASSERT_NE(text.find(old), std::string::npos);
        text.replace(text.find(old), old.size(), std::string("sats time lat ") + name + " ");
        ReadBack file("session.vbo", text);
        ASSERT_TRUE(file.is_open()) << file.messages();
        const Laps laps = find_laps(file.file(), session.time, std::nullopt, false, file.errors());
        EXPECT_EQ(laps.source, LapSource::start_line) << name;
        EXPECT_EQ(laps.laps.size(), 4U) << name;
    }
}

// Newer loggers have units for the last columns, and some of these are no standard ones: of four columns before the units' own none is in bar.
TEST(VboxVbo, UnitsAreThoseOfTheLastColumns) {
    std::string text = made_up::vbox_vbo(Session(20, 0.05), 36000.0);
    const auto put = [&](const std::string& old, const std::string& now) {
        ASSERT_NE(text.find(old), std::string::npos) << old;
        text.replace(text.find(old), old.size(), now);
    };
    put("height vertical_load", "height Tsample avifileindex vertical_load");
    put("height\r\nvertical_load", "height\r\nsampleperiod\r\navifileindex\r\nvertical_load");
    for (std::size_t at = 0; (at = text.find(" +0100.00 ", at)) != std::string::npos; at += 20) {
        text.insert(at + 10, "0.050 0001 ");
    }
    ReadBack file("session.vbo", text);
    ASSERT_TRUE(file.is_open()) << file.messages();
    for (const auto& [name, unit] : {std::pair{"Tsample", ""}, std::pair{"avifileindex", ""},
                                     std::pair{"vertical_load", "N"}, std::pair{"surface_temperature", "C"}}) {
        const int column = file.file().find(name);
        ASSERT_GE(column, 0) << name;
        EXPECT_EQ(file.file().heads()[static_cast<std::size_t>(column)].heading.unit.value_or(""), unit) << name;
    }
    EXPECT_DOUBLE_EQ(file.column("vertical_load", "N").front(), written(Session::load(0.0), 1));
}

// As a program that is not Racelogic's writes it: without [header], rows with blanks before and between.
TEST(VboxVbo, NeedsNoHeaderAndMayHaveBlanks) {
    ReadBack file("short.vbo",
                  "File created on 31/07/2006 at 09:55:20\n\n[column names]\nsats time lat long velocity\n\n[data]\n"
                  "  12   163920.600    3072.358730    96.835005    95.907\n"
                  "  12   163920.700    3072.357558    96.833676    96.381\n");
    EXPECT_EQ(file.column("velocity", "m s-1"), (std::vector<double>{95.907 / 3.6, 96.381 / 3.6}));
}

// Three units for two columns that are not standard, of which the first would be that of the height, and no length: whose they are nobody
// knows, so none is taken, and the survey says so.
TEST(VboxVbo, UnitsThatFitNoColumnAreNotTaken) {
    std::string text = made_up::vbox_vbo(Session(20, 0.05), 36000.0);
    const std::string two = "[channel units]\r\nN\r\nC\r\n";
    ASSERT_NE(text.find(two), std::string::npos);
    text.replace(text.find(two), two.size(), "[channel units]\r\nbar\r\nN\r\nC\r\n");
    ReadBack file("session.vbo", text);
    ASSERT_TRUE(file.is_open()) << file.messages();
    for (const ColumnHead& head : file.file().heads()) {
        const bool is_own = head.heading.name == "vertical_load" || head.heading.name == "surface_temperature";
        EXPECT_EQ(head.heading.unit.value_or("").empty(), is_own) << head.heading.name;
    }
    const auto& details = file.file().description().details;
    EXPECT_TRUE(
        std::ranges::any_of(details, [](const auto& one) { return one.value == "not taken: 3 for 9 columns"; }));
}

// Comments above and between the lines; a clock of the day that passes midnight counts from the first line on.
TEST(PlainCsv, HasCommentsAndClocks) {
    ReadBack file("log.csv",
                  "# logger 7\n// made by hand\nTime,speed [km/h],surface_temperature [C]\n23:59:59.500,36,60.0\n"
                  "# a pause\n00:00:00.250,54,60.5\n00:00:01.250,72,61.0\n");
    EXPECT_EQ(file.column("Time", "s", Purpose::clock), (std::vector<double>{0.0, 0.75, 1.75}));
    EXPECT_EQ(file.column("speed", "m s-1"), (std::vector<double>{10.0, 15.0, 20.0}));
}

TEST(PlainCsv, HasItsNamesInAComment) {
    ReadBack file("log.txt", "# by a program\n# time [s], speed [km/h]\n\n0,36\n2,54\n");
    EXPECT_EQ(file.column("time", "s", Purpose::clock), (std::vector<double>{0.0, 2.0}));
    EXPECT_EQ(file.column("speed", "m s-1"), (std::vector<double>{10.0, 15.0}));
}

// A clock that goes back by an hour was set; only more than half a day is midnight.
TEST(PlainCsv, RefusesAClockThatWasSetBack) {
    ReadBack file("log.csv", "time,speed [km/h]\n12:00:00,36\n11:00:00,54\n");
    ASSERT_TRUE(file.is_open());
    const auto read = file.file().read(
        {{.column = 0, .name = "time", .spec = {.unit = "s"}, .purpose = Purpose::clock}}, file.errors());
    EXPECT_TRUE(read.empty());
    EXPECT_NE(file.messages().find("time goes backwards to 11:00:00"), std::string::npos) << file.messages();
}

// A spreadsheet fills empty lines with separators.
TEST(AimCsv, MayHaveBeenSavedByASpreadsheet) {
    const Session session(200, 0.05);
    std::string text = made_up::aim_csv(session, {.quotes = false});
    for (std::size_t at = 0; (at = text.find("\r\n\r\n", at)) != std::string::npos; at += 4) {
        text.insert(at + 2, ",,,,,");
    }
    ReadBack file("session.csv", text);
    expect_session(file, session, "Time", "speed");
}

TEST(AimCsv, NeedsNoEmptyLineAboveTheNames) {
    ReadBack file("dense.csv",
                  "\"Format\",\"AiM CSV File\"\n\"Time\",\"11:49 AM\"\n\"Beacon "
                  "Markers\",0.7,2\n\"Time\",\"Speed\"\n\"s\",\"km/h\"\n"
                  "0,36\n1,72\n");
    EXPECT_EQ(file.column("Speed", "m s-1"), (std::vector<double>{10.0, 20.0}));
}

TEST(AimCsv, NumbersNamesThatStandTwice) {
    ReadBack file(
        "twice.csv",
        "\"Format\",\"AiM CSV File\"\n\"Beacon Markers\",\"Unknown\"\n\n\"Time\",\"Speed\",\"Speed\",\"Time\"\n"
        "\"s\",\"km/h\",\"mph\",\"min\"\n\n\"0\",\"36\",\"20\",\"0\"\n\"0.1\",\"72\",\"40\",\"0\"\n");
    ASSERT_TRUE(file.is_open()) << file.messages();
    EXPECT_EQ(file.file().heads()[2].heading.name, "Speed (2)");
    EXPECT_EQ(file.file().heads()[3].heading.name, "Time (2)");
    EXPECT_TRUE(file.file().heads()[0].is_clock);
    EXPECT_EQ(file.column("Speed", "m s-1"), (std::vector<double>{10.0, 20.0}));
    EXPECT_TRUE(file.file().description().markers.empty());  // and the file is read all the same
}

// The battery was taken out while the last line was written.
TEST(CsvLog, LeavesOutALastLineThatIsCutOff) {
    ReadBack file("cut.csv", "time [s],speed [km/h],load [N]\n0,36,4000\n1,72,4000\n2,10");
    EXPECT_EQ(file.column("speed", "m s-1"), (std::vector<double>{10.0, 20.0}));
    ASSERT_EQ(file.errors().warnings().size(), 1U);
    EXPECT_NE(file.errors().warnings()[0].what.find("the last line has 2 of 3 values"), std::string::npos);
}

TEST(CsvLog, UnitsMayStandInRoundBrackets) {
    ReadBack file("round.csv",
                  "Time (sec),Speed (Km/h),Coolant (C),Gear (Gear),Lean (left)\n0,36,80,1,2\n1,72,81,1,3\n");
    ASSERT_TRUE(file.is_open()) << file.messages();
    EXPECT_EQ(file.column("Speed", "m s-1"), (std::vector<double>{10.0, 20.0}));
    EXPECT_EQ(file.column("Coolant", "K"), (std::vector<double>{353.15, 354.15}));
    EXPECT_EQ(file.file().heads()[3].heading.name, "Gear (Gear)");  // no unit
    EXPECT_EQ(file.file().heads()[4].heading.name, "Lean (left)");
    EXPECT_TRUE(file.file().heads()[0].is_clock);
}

// 20 ft/s2 are 6.096 m/s2, 50 degF 283.15 K, 10 lbf 44.48 N.
TEST(CsvLog, ImperialUnitsMayStandInRoundBrackets) {
    ReadBack file("round.csv", "Time (s),Lat Accel (ft/s2),Tire (degF),Load (lbf)\n0,20,50,10\n1,20,50,10\n");
    ASSERT_TRUE(file.is_open()) << file.messages();
    EXPECT_NEAR(file.column("Lat Accel", "m s-2").front(), 6.096, 1e-9);
    EXPECT_NEAR(file.column("Tire", "K").front(), 283.15, 1e-9);
    EXPECT_NEAR(file.column("Load", "N").front(), 44.482216, 1e-6);
}

// Words and dashes for nothing, in the first line, too, are missing values.
TEST(CsvLog, WordsForNoReadingAreMissingValues) {
    for (const char* word : {"", "-", "--", "n/a", "N/A", "#N/A", "NA", "NaN", "null"}) {
        ReadBack file("missing.csv",
                      fmt::format("time [s],tread [degC],speed [km/h]\n0,{},36\n1,30,36\n2,{},36\n", word, word));
        ASSERT_TRUE(file.is_open()) << word << file.messages();
        const std::vector<double> tread = file.column("tread", "K");
        ASSERT_EQ(tread.size(), 3U) << word << file.messages();
        EXPECT_TRUE(std::isnan(tread[0]) && std::isnan(tread[2])) << word;
        EXPECT_DOUBLE_EQ(tread[1], 303.15);
    }
}

// 0, 0.05 and 0.1 s after the first line in whatever the logger calls its time. Digits of a clock go from 14:30:59 to 14:31:01.
TEST(CsvLog, TimesOfManyKindsCountFromTheFirstLine) {
    const auto times = [](const std::string& heading, const std::vector<std::string>& fields) {
        std::string text = heading + ",speed [km/h]\n";
        for (const std::string& field : fields) {
            text += field + ",36\n";
        }
        ReadBack file("times.csv", text);
        EXPECT_TRUE(file.is_open() && file.file().heads()[0].is_clock) << heading;
        const std::vector<std::vector<double>> read = file.file().read(
            {{.column = 0, .name = "time", .spec = {.unit = "s"}, .purpose = Purpose::clock}}, file.errors());
        EXPECT_FALSE(read.empty()) << heading << "\n" << file.messages();
        return read.empty() ? std::vector<double>{} : read.front();
    };
    const std::vector<double> expected{0.0, 0.05, 0.1};
    EXPECT_EQ(times("timestamp", {"1757000000.00", "1757000000.05", "1757000000.10"}), expected);
    EXPECT_EQ(times("Time (s)", {"1757000000.00", "1757000000.05", "1757000000.10"}), expected);
    EXPECT_EQ(times("timestamp", {"1757000000000", "1757000000050", "1757000000100"}), expected);
    EXPECT_EQ(times("Timestamp", {"2025-09-05T00:28:00.000Z", "2025-09-05T00:28:00.050Z", "2025-09-05T00:28:00.100Z"}),
              expected);
    EXPECT_EQ(times("Date and time", {"9/5/2025 10:28:00.000", "9/5/2025 10:28:00.050", "9/5/2025 10:28:00.100"}),
              expected);
    EXPECT_EQ(times("timestamp_us", {"1757000000000000", "1757000000050000", "1757000000100000"}), expected);
    EXPECT_EQ(times("Time [ns]", {"1757000000000000000", "1757000000050000000", "1757000000100000000"}), expected);
    EXPECT_EQ(times("TimestampMS", {"0", "50", "100"}), expected);
    EXPECT_EQ(times("timestamp_ms", {"0", "50", "100"}), expected);
    EXPECT_EQ(times("SessionTime [s]", {"0", "0.05", "0.1"}), expected);
    EXPECT_EQ(times("Time", {"143059", "143100", "143101"}), (std::vector<double>{0.0, 1.0, 2.0}));
    EXPECT_EQ(times("Time [s]", {"143059", "143100", "143101"}), (std::vector<double>{143059.0, 143100.0, 143101.0}));
}

}  // namespace tiretherm::input
