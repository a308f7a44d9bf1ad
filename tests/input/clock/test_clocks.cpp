// SPDX-License-Identifier: BSD-3-Clause
// Times of logs: dates in every order, clocks without seconds, daylight saving, whole seconds, dates in a column of their own.

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/clock/clock_times.hpp"
#include "input/loggers/read_back.hpp"
#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

namespace {

using Fields = std::vector<std::string>;
using Times = std::vector<double>;

/// A log with these times and a speed.
std::string log_of(const std::string& heading, const Fields& fields) {
    std::string text = heading + ",speed [km/h]\n";
    for (const std::string& field : fields) {
        text += "\"" + field + "\",36\n";
    }
    return text;
}

/// What is read of a log's times, and what is said of them.
struct ReadClock {
    Times times{};
    std::string messages{};
    std::string warnings{};
};

ReadClock read_clock(const std::string& text, const std::string& unit = "") {
    ReadBack file("log.csv", text);
    EXPECT_TRUE(file.is_open()) << text << file.messages();
    int column = -1;
    for (std::size_t i = 0; file.is_open() && i < file.file().heads().size(); ++i) {
        ColumnHead& head = file.file().heads()[i];
        if (head.is_clock || head.heading.name == "time") {
            column = static_cast<int>(i);
            head.heading.unit = unit.empty() ? head.heading.unit : unit;
        }
    }
    if (column < 0) {
        return {.messages = "no column is the time"};
    }
    auto read = file.file().read({{.column = column, .name = "time", .spec = {.unit = "s"}, .purpose = Purpose::clock}},
                                 file.errors());
    return {.times = read.empty() ? Times{} : read.front(),
            .messages = file.messages(),
            .warnings = fmt::format("{}", fmt::join(render(file.errors().warnings(), 0), "\n"))};
}

Times times_of(const Fields& fields, const std::string& heading = "Date Time") {
    const ReadClock read = read_clock(log_of(heading, fields));
    EXPECT_FALSE(read.times.empty()) << fields.front() << "\n" << read.messages;
    return read.times;
}

}  // namespace

// Each pair is 30 s apart, over noon, midnight or the end of a year.
TEST(Clock, IsReadInEverySpelling) {
    for (const Fields& pair : {Fields{"10/24/2026 11:59:45 AM", "10/24/2026 12:00:15 PM"},
                               Fields{"12:59:45 pm", "1:00:15 pm"},
                               Fields{"12:00:00 a.m.", "12:00:30 a.m."},
                               Fields{"2026-12-31T23:59:45+02:00", "2027-01-01T00:00:15+02:00"},
                               Fields{"2026-10-24T11:20:00.000Z", "2026-10-24T11:20:30.000Z"},
                               Fields{"2026-10-24T11:20:00+02:00", "2026-10-24T09:20:30Z"},
                               Fields{"2026-10-24 11:20:00 CEST", "2026-10-24 10:20:30 CET"},
                               Fields{"24.10.2026 23:59:45", "25.10.2026 00:00:15"},
                               Fields{"24.10.26 23:59:45", "25.10.26 00:00:15"},
                               Fields{"10/24/26 23:59:45", "10/25/26 00:00:15"},
                               Fields{"24-Oct-2026 23:59:45", "25-Oct-2026 00:00:15"},
                               Fields{"Sep 3, 2024 2:05:01 PM", "Sep 3, 2024 2:05:31 PM"},
                               Fields{"3 Sep 2024 14:05:01", "3 Sep 2024 14:05:31"},
                               Fields{"Tue Sep 03 14:05:01 GMT+02:00 2024", "Tue Sep 03 14:05:31 GMT+02:00 2024"},
                               Fields{"14:05:01 03.09.2024", "14:05:31 03.09.2024"},
                               Fields{"20240903 23:59:45", "20240904 00:00:15"},
                               Fields{"20240903T235945.250", "20240904T000015.250"},
                               Fields{"20240903T235945Z", "20240904T000015Z"},
                               Fields{"20240903235945.5", "20240904000015.5"},
                               Fields{"2024-09-03 235945", "2024-09-04 000015"},
                               Fields{"2024/09/03 14:05:01,5", "2024/09/03 14:05:31,5"},
                               Fields{"14:05:01:250", "14:05:31:250"},
                               Fields{"31. Dez. 2026 23:59:45", "1. Jan. 2027 00:00:15"},
                               Fields{"0 days 23:59:45", "1 days 00:00:15"}}) {
        EXPECT_EQ(times_of(pair), (Times{0.0, 30.0})) << pair.front();
    }
}

// 24 October 23:00 to 26 October 01:00 are 26 h = 93600 s; a 24th month there is not.
TEST(Clock, KeepsItsDaysWhereAFieldAboveTwelveTellsTheOrder) {
    const Times expected{0.0, 1800.0, 93600.0};
    EXPECT_EQ(times_of({"10/24/2026 23:00:00", "10/24/2026 23:30:00", "10/26/2026 01:00:00"}), expected);
    EXPECT_EQ(times_of({"24/10/2026 23:00:00", "24/10/2026 23:30:00", "26/10/2026 01:00:00"}), expected);
    // A day and half a second from line to line; the thirteenth line tells.
    Fields days;
    Times daily;
    for (int day = 1; day <= 13; ++day) {
        days.push_back(fmt::format("{}/1/2026 10:00:{:04.1f}", day, 0.5 * (day - 1)));
        daily.push_back(86400.5 * (day - 1));
    }
    EXPECT_EQ(times_of(days), daily);
}

// 12 January to 1 February goes forwards; 1 December to 2 January of the same year would go backwards.
TEST(Clock, GoesForwardsInTheRightOrderOfDayAndMonth) {
    EXPECT_EQ(times_of({"12/01/2026 10:00:00", "01/02/2026 10:00:00"}), (Times{0.0, 20.0 * 86400.0}));
    // The same day whatever the order: nothing to decide.
    EXPECT_EQ(times_of({"01/02/2026 10:00:00", "01/02/2026 10:00:30"}), (Times{0.0, 30.0}));
}

// From 1 to 2 February is a day; from 2 January to 2 February are 31. It is said which was taken, and may be said otherwise.
TEST(Clock, TakesDaysThatFollowOneAnotherAndSaysSo) {
    const std::string text = log_of("time", {"01/02/2026 23:00:00", "02/02/2026 01:00:00"});
    const ReadClock read = read_clock(text);
    EXPECT_EQ(read.times, (Times{0.0, 7200.0})) << read.messages;
    EXPECT_NE(read.warnings.find("dates such as 01/02/2026 are read as day/month/year"), std::string::npos)
        << read.warnings;
    EXPECT_EQ(read_clock(text, "mm/dd/yyyy").times, (Times{0.0, 7200.0 + 30.0 * 86400.0}));
}

// 1 February and 3 April, or 2 January and 4 March: 61 days either way.
TEST(Clock, AsksForTheOrderThatNoLineTells) {
    const std::string text = log_of("time", {"01/02/2026 10:00:00", "03/04/2026 10:00:00"});
    const ReadClock read = read_clock(text);
    EXPECT_TRUE(read.times.empty());
    EXPECT_EQ(
        read.messages,
        "01/02/2026 is day/month/year or month/day/year in time, and no line tells which | write \"time [d/m/y]\" or "
        "\"time [m/d/y]\" in the heading, units = { \"time\" = \"d/m/y\" } in the case, or --unit \"time=d/m/y\"\n");
    EXPECT_EQ(read_clock(text, "d/m/y").times, (Times{0.0, 61.0 * 86400.0}));
    EXPECT_EQ(read_clock(log_of("time [d/m/y]", {"01/02/2026 10:00:00", "02/03/2026 10:00:00"})).times,
              (Times{0.0, 29.0 * 86400.0}));
}

// Europe put its clocks back at 3:00 on Sunday 25 October 2026, and forward at 2:00 on 29 March 2026.
TEST(Clock, GoesOnThroughTheHoursOfDaylightSaving) {
    const Times expected{0.0, 30.0, 60.0, 90.0};
    EXPECT_EQ(times_of({"2026-10-25 02:59:00", "2026-10-25 02:59:30", "2026-10-25 02:00:00", "2026-10-25 02:00:30"}),
              expected);
    EXPECT_EQ(times_of({"2026-03-29 01:59:00", "2026-03-29 01:59:30", "2026-03-29 03:00:00", "2026-03-29 03:00:30"}),
              expected);
    EXPECT_EQ(times_of({"02:59:00", "02:59:30", "02:00:00", "02:00:30"}, "Time"), expected);
    // On another day or at noon a clock that goes back was set.
    for (const Fields& set : {Fields{"2026-10-24 02:59:00", "2026-10-24 02:59:30", "2026-10-24 02:00:00"},
                              Fields{"2026-10-25 12:59:00", "2026-10-25 12:59:30", "2026-10-25 12:00:00"}}) {
        const ReadClock read = read_clock(log_of("time", set));
        EXPECT_NE(read.messages.find("time goes backwards"), std::string::npos) << set.back();
    }
    // With their offsets from UTC there is nothing to put right: 02:59:30 in summer and 02:00:00 in winter.
    EXPECT_EQ(times_of({"2026-10-25T02:59:30+02:00", "2026-10-25T02:00:00+01:00"}), (Times{0.0, 30.0}));
}

// Two lines a minute; ten lines a second, of which the recording has the last three and then all of the next two seconds.
TEST(Clock, ThatIsTooCoarseHasItsLinesSpread) {
    EXPECT_EQ(times_of({"10/24/2026 11:20", "10/24/2026 11:20", "10/24/2026 11:21", "10/24/2026 11:21"}),
              (Times{0.0, 30.0, 60.0, 90.0}));
    Fields fields(3, "12:00:00");
    fields.insert(fields.end(), 10, "12:00:01");
    fields.insert(fields.end(), 10, "12:00:02");
    const ReadClock read = read_clock(log_of("time", fields));
    ASSERT_EQ(read.times.size(), 23U) << read.messages;
    for (std::size_t i = 0; i < read.times.size(); ++i) {
        EXPECT_NEAR(read.times[i], 0.1 * static_cast<double>(i), 1e-9);
    }
    EXPECT_NE(read.warnings.find("the clock goes on by 1 s, and up to 10 lines have one time: they are spread evenly"),
              std::string::npos)
        << read.warnings;
}

// The same of seconds as numbers and of seconds since 1970; a pause of an hour stays one.
TEST(Clock, OfWholeSecondsInNumbersHasItsLinesSpread) {
    for (const double start : {0.0, 1757000000.0}) {
        Fields fields;
        for (const double second : {0.0, 1.0, 2.0, 3602.0, 3603.0}) {
            fields.insert(fields.end(), 5, fmt::format("{:.0f}", start + second));
        }
        const ReadClock read = read_clock(log_of("time [s]", fields));
        ASSERT_EQ(read.times.size(), 25U) << read.messages;
        EXPECT_NEAR(read.times[4], 0.8, 1e-9);
        EXPECT_NEAR(read.times[14], 2.8, 1e-9);
        EXPECT_NEAR(read.times[15], 3602.0, 1e-9);
        EXPECT_NEAR(read.times[24], 3603.8, 1e-9);
    }
}

// 46090.5 is noon of a day in 2026, as spreadsheets keep it; 1/86400 of a day is a second. Seconds of the day go on by more than 78 s / 86400.
TEST(Clock, CountsTheDaysOfASpreadsheet) {
    const ReadClock read = read_clock(log_of("DateTime", {"46090.5", "46090.50005787", "46090.50034722"}));
    ASSERT_EQ(read.times.size(), 3U) << read.messages;
    EXPECT_NEAR(read.times[1], 5.0, 1e-3);
    EXPECT_NEAR(read.times[2], 30.0, 1e-3);
    EXPECT_EQ(read_clock("DateTime;speed [km/h]\n46090,5;36\n46090,50034722;36\n").times.size(), 2U);
    EXPECT_NEAR(read_clock("DateTime;speed [km/h]\n46090,5;36\n46090,50034722;36\n").times.back(), 30.0, 1e-3);
    EXPECT_EQ(read_clock(log_of("time [s]", {"46090.5", "46090.6", "46091.5"})).times,
              (Times{46090.5, 46090.6, 46091.5}));
}

// Of a schedule in clocks: at 12:10 the speed jumps.
TEST(Clock, KeepsAJumpWhereItIsFineEnough) {
    EXPECT_EQ(times_of({"12:00:00", "12:10:00", "12:10:00", "12:20:00"}), (Times{0.0, 600.0, 600.0, 1200.0}));
}

// A date in a column of its own, over two midnights without a line between them: 24 October 23:00 to 26 October 01:00.
TEST(Clock, MayHaveItsDateInAnotherColumn) {
    const Times expected{0.0, 93600.0};
    for (const char* rows :
         {"24.10.2026,23:00:00,36\n26.10.2026,01:00:00,36\n", "10/24/2026,11:00:00 PM,36\n10/26/2026,1:00:00 AM,36\n",
          "20261024,23:00:00,36\n20261026,01:00:00,36\n", "24-Oct-26,23:00,36\n26-Oct-26,01:00,36\n"}) {
        EXPECT_EQ(read_clock(std::string("Date,Time,speed [km/h]\n") + rows).times, expected) << rows;
    }
    EXPECT_EQ(read_clock("Time;Date;speed [km/h]\n23:00:00;24.10.2026;36,0\n01:00:00;26.10.2026;36,0\n").times,
              expected);
}

TEST(Clock, CountsMinutesAndHours) {
    for (const char* heading : {"Elapsed (min)", "time [min]", "time_min", "Elapsed Time (minutes)"}) {
        EXPECT_EQ(times_of({"0", "0.5", "1"}, heading), (Times{0.0, 30.0, 60.0})) << heading;
    }
    for (const char* heading : {"time (h)", "Elapsed_hours", "time [hours]"}) {
        EXPECT_EQ(times_of({"0", "0.5", "1"}, heading), (Times{0.0, 1800.0, 3600.0})) << heading;
    }
}

// Minutes and seconds where another line has hours or decimals; hours and minutes where midnight is passed; else it is asked.
TEST(Clock, OfTwoPartsIsToldByOtherLinesOrAskedFor) {
    EXPECT_EQ(times_of({"59:58", "59:59", "1:00:00"}, "Time"), (Times{0.0, 1.0, 2.0}));
    EXPECT_EQ(times_of({"1:23.5", "1:24", "1:24.5"}, "Time"), (Times{0.0, 0.5, 1.0}));
    EXPECT_EQ(times_of({"23:58", "23:59", "00:00"}, "Time"), (Times{0.0, 60.0, 120.0}));
    EXPECT_EQ(times_of({"2:05", "2:06"}, "Time [h:mm]"), (Times{0.0, 60.0}));
    EXPECT_EQ(times_of({"2:05", "2:06"}, "Time (mm:ss)"), (Times{0.0, 1.0}));
    const ReadClock read = read_clock(log_of("Time", {"2:05", "2:06"}));
    EXPECT_NE(read.messages.find("Time may be hours and minutes, or minutes and seconds"), std::string::npos)
        << read.messages;
}

TEST(Clock, OfNoDayIsAnError) {
    for (const char* wrong : {"31.02.2026 10:00:00", "2026-13-01 10:00:00", "10:61:00", "24.10. 10:00:00", "noon"}) {
        const ReadClock read = read_clock(log_of("time", {"24.10.2026 10:00:00", wrong}));
        EXPECT_NE(read.messages.find("which is no time"), std::string::npos) << wrong << "\n" << read.messages;
    }
}

// A phone's logger that is started anew writes its headings again.
TEST(CsvLog, MayHaveItsHeadingsAgainAndDashesForNothing) {
    ReadBack file("log.csv", "time [s],speed [km/h],load [N]\n0,36,-\ntime [s],speed [km/h],load [N]\n1,72,4000\n");
    EXPECT_EQ(file.column("speed", "m s-1"), (Times{10.0, 20.0}));
    EXPECT_TRUE(std::isnan(file.column("load", "N").front()));
}

// The order that the case says reaches the run: 1 February to 2 March are 29 days, 2 January to 3 February 32.
TEST(RunOfAClock, TakesTheOrderOfItsUnits) {
    for (const auto& [unit, days] : {std::pair{"d/m/y", 29.0}, std::pair{"m/d/y", 32.0}}) {
        const Written written;
        written.add(
            "log.csv",
            "When,speed [km/h],vertical_load [N],surface_temperature [C]\n01/02/2026 10:00:00,36,4000,30\n02/03/2026 "
            "10:00:00,36,4000,31\n");
        const ExperimentReading reading = read_experiment(written.add(
            "case.toml", std::string(bench) +
                             "[drive]\nair_temperature = \"25 degC\"\nroad_temperature = \"30 degC\"\n[[run]]\nfile = "
                             "\"log.csv\"\nunits = { When = \"" +
                             unit + "\" }\n"));
        ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
        EXPECT_EQ(reading.experiment->runs.front().time, (Times{0.0, days * 86400.0})) << unit;
    }
}

}  // namespace tiretherm::input
