// SPDX-License-Identifier: BSD-3-Clause
// Laps by marks, counters and positions; which stretch a choice of laps means, and runs that are cut by it.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/laps/file_laps.hpp"
#include "input/laps/laps.hpp"
#include "input/laps/track_laps.hpp"
#include "input/loggers/logger_files.hpp"
#include "input/loggers/read_back.hpp"
#include "input/measurements/measured_bench.hpp"

namespace tiretherm::input {

namespace {

using made_up::Session;

Laps four_laps() { return {.source = LapSource::markers, .laps = laps_between({30.0, 90.0, 150.5}, 0.0, 200.0)}; }

Positions driven_circuit(double end, double step) {
    Positions positions;
    for (double t = 0.0; t < end; t += step) {
        positions.time.push_back(t);
        positions.latitude.push_back(Session::north(t));
        positions.longitude.push_back(Session::east(t));
    }
    return positions;
}

/// The bench with an AiM file of 110 s; its laps are cut at 5 pi, 15 pi and 25 pi s. @param keys of [[run]]
ExperimentReading read_aim(const std::string& keys) {
    const Written written;
    written.add("session.csv", made_up::aim_csv(Session(2201, 0.05)));
    const std::string driven_circuit = "[drive]\nair_temperature = \"25 degC\"\nroad_temperature = \"30 degC\"\n";
    return read_experiment(written.add("case.toml", std::string(bench) + driven_circuit + keys));
}

}  // namespace

TEST(Laps, LieBetweenMarks) {
    const std::vector<Lap> laps = four_laps().laps;
    ASSERT_EQ(laps.size(), 4U);
    EXPECT_EQ(laps[0].number, 0);
    EXPECT_EQ(laps[0].kind, LapKind::out);
    EXPECT_EQ(laps[2].end, 150.5);
    EXPECT_EQ(laps[2].kind, LapKind::flying);
    EXPECT_EQ(laps[3].kind, LapKind::in);
    EXPECT_EQ(laps[3].end, 200.0);
    // Marks at the ends of the recording, and a second one within half a second, are no crossings.
    EXPECT_EQ(laps_between({0.0, 30.0, 30.2, 200.0}, 0.0, 200.0).size(), 2U);
    EXPECT_TRUE(laps_between({-5.0, 300.0}, 0.0, 200.0).empty());
}

TEST(Laps, AreCountedByAColumn) {
    const double none = std::nan("");
    const std::vector<Lap> laps = laps_by_counter({0, 1, 2, 3, 4, 5}, {3, none, 4, 4, 5, none});
    ASSERT_EQ(laps.size(), 3U);
    EXPECT_EQ(laps[1].number, 4);
    EXPECT_EQ(laps[0].end, 2.0);
    EXPECT_EQ(laps[1].end, 4.0);
    // What goes down, stands still or has fractions counts no laps.
    EXPECT_TRUE(laps_by_counter({0, 1, 2}, {2, 1, 3}).empty());
    EXPECT_TRUE(laps_by_counter({0, 1, 2}, {1, 1, 1}).empty());
    EXPECT_TRUE(laps_by_counter({0, 1, 2}, {1, 1.5, 2}).empty());
}

TEST(Laps, AreChosenByTheirNumbers) {
    const LapChoice one = choose_laps("1", four_laps());
    ASSERT_TRUE(one.window.has_value());
    EXPECT_EQ(one.window->from, 30.0);
    EXPECT_EQ(one.window->to, 90.0);
    for (const char* text : {"1-2", "1,2", " 2 , 1 "}) {
        const LapChoice two = choose_laps(text, four_laps());
        ASSERT_TRUE(two.window.has_value()) << text;
        EXPECT_EQ(two.window->from, 30.0);
        EXPECT_EQ(two.window->to, 150.5);
    }
    const LapChoice apart = choose_laps("0, 2-3", four_laps());
    ASSERT_TRUE(apart.window.has_value());
    EXPECT_EQ(apart.window->from, 0.0);
    EXPECT_EQ(apart.window->to, 200.0);
    EXPECT_EQ(apart.first_ends, 30.0);
    ASSERT_EQ(apart.left_out.size(), 1U);
    EXPECT_EQ(apart.left_out[0].from, 30.0);
    EXPECT_EQ(apart.left_out[0].to, 90.0);
    EXPECT_EQ(choose_laps("7", four_laps()).remedy,
              "the laps are 0 (out, 0:30.000), 1 (1:00.000), 2 (1:00.500), 3 (in, 0:49.500)");
    for (const char* text : {"", "-", "3-1", "1-", "a", "1;2", "99999999999"}) {
        EXPECT_TRUE(choose_laps(text, four_laps()).error.has_value()) << text;
    }
}

// 59.9996 s is a minute when milliseconds are shown, not 60 seconds.
TEST(Laps, ShowTheirTimeInMinutes) {
    EXPECT_EQ(lap_time(121.006), "2:01.006");
    EXPECT_EQ(lap_time(59.9996), "1:00.000");
}

// A line of 40 m whose middle lies 1/111.32 of a degree, 1 km, north of the circle's northernmost point at the least: how near the car came
// is said. Across the way it is crossed, and nothing is.
TEST(Track, ALineThatIsNeverCrossedSaysHowNearTheCarCame) {
    const Positions positions = driven_circuit(110.0, 0.1);
    const double north = *std::ranges::max_element(positions.latitude) + 1.0 / 111.32;
    const auto at = static_cast<std::size_t>(std::ranges::max_element(positions.latitude) - positions.latitude.begin());
    const StartLine line{.latitude_a = north,
                         .longitude_a = positions.longitude[at] - 1e-4,
                         .latitude_b = north,
                         .longitude_b = positions.longitude[at] + 1e-4};
    EXPECT_TRUE(crossings_of(positions, line).empty());
    EXPECT_NEAR(nearest_to(positions, line), 1000.0, 0.5);
    EXPECT_EQ(never_crossed(1000.4), "the car never crosses the start line, and comes no nearer to it than 1 km");
    const LapChoice choice = choose_laps("1", {.nearest = 350.0});
    EXPECT_EQ(
        choice.error,
        "no laps are known of the file: the car never crosses the start line, and comes no nearer to it than 350 m");
    EXPECT_EQ(choice.remedy, line_remedy);
}

// The car goes round a circle; where the line is found, it is crossed once in each lap of 10 pi s, whatever the place. Between
// samples 4 m apart a straight line differs from the circle by 10 mm at most, 0.3 ms at 40 m/s.
TEST(Track, ClosesOnceALap) {
    const Positions positions = driven_circuit(110.0, 0.1);
    const std::optional<StartLine> line = find_start_line(positions);
    ASSERT_TRUE(line.has_value());
    const std::vector<double> times = crossings_of(positions, *line);
    ASSERT_GE(times.size(), 3U);
    for (std::size_t i = 1; i < times.size(); ++i) {
        EXPECT_NEAR(times[i] - times[i - 1], 10.0 * std::acos(-1.0), 1e-3);
    }
    EXPECT_FALSE(find_start_line(driven_circuit(25.0, 0.1)).has_value());  // less than a lap
}

// Where a circle that is driven counter-clockwise is furthest east, the way is north. A line of 6 m along it is put across; one across it stays.
TEST(Track, ALineAlongTheWayIsPutAcross) {
    const Positions positions = driven_circuit(110.0, 0.1);
    const double t = 3.0;
    const double before = t - 0.05;
    const double after = t + 0.05;
    const StartLine along{.latitude_a = Session::north(before),
                          .longitude_a = Session::east(before),
                          .latitude_b = Session::north(after),
                          .longitude_b = Session::east(after)};
    const StartLine across = line_across(positions, along);
    const std::vector<double> times = crossings_of(positions, across);
    ASSERT_EQ(times.size(), 4U);
    for (std::size_t k = 0; k < times.size(); ++k) {
        EXPECT_NEAR(times[k], t + 10.0 * std::acos(-1.0) * static_cast<double>(k), 2e-3);
    }
    const StartLine again = line_across(positions, across);
    EXPECT_EQ(again.latitude_a, across.latitude_a);
    EXPECT_EQ(again.longitude_b, across.longitude_b);
}

// Without a choice of laps the run goes on, with a warning at the line: 0.003 degrees north of where the way ends are 334 m.
TEST(Track, AStartLineThatIsNeverCrossedIsWarnedOf) {
    const std::filesystem::path folder = source_folder() / "tests/bad_cases";
    const Written written;
    const ExperimentReading reading = read_experiment(written.add(
        "case.toml", fmt::format("include = [\"{}\"]\n[[run]]\nfile = \"{}\"\n"
                                 "start_line = [[48.004, 10.999], [48.004, 11.001]]\n",
                                 (folder / "data/bench.inc").string(), (folder / "loggers/lap_far.csv").string())));
    ASSERT_TRUE(reading.experiment);
    EXPECT_TRUE(std::ranges::any_of(reading.warnings, [](const std::string& warning) {
        return warning.find(
                   "case.toml:4: the car never crosses the start line, and comes no nearer to it than 334 m: write "
                   "the ends") != std::string::npos;
    })) << fmt::format("{}", fmt::join(reading.warnings, "\n"));
}

// From the pits a car crosses the line the other way and turns; then it laps four times in 110 s.
TEST(Track, TheDirectionIsThatOfMostCrossings) {
    Positions positions = driven_circuit(110.0, 0.1);
    const StartLine line{.latitude_a = Session::latitude,
                         .longitude_a = Session::longitude + (Session::radius - 15.0) / 111320.0 /
                                                                 std::cos(Session::latitude * std::acos(-1.0) / 180.0),
                         .latitude_b = Session::latitude,
                         .longitude_b = Session::longitude + (Session::radius + 15.0) / 111320.0 /
                                                                 std::cos(Session::latitude * std::acos(-1.0) / 180.0)};
    const std::vector<double> laps = crossings_of(positions, line);
    ASSERT_EQ(laps.size(), 4U);
    // 10 m further out, from north to south, in the 20 s before.
    Positions out;
    for (int i = 0; i < 20; ++i) {
        out.time.push_back(-20.0 + i);
        out.latitude.push_back(Session::latitude + (10.0 - i) / 111320.0);
        out.longitude.push_back(line.longitude_b - 5.0 / 111320.0);
    }
    for (auto [whole, more] : {std::pair{&out.time, &positions.time}, std::pair{&out.latitude, &positions.latitude},
                               std::pair{&out.longitude, &positions.longitude}}) {
        whole->insert(whole->end(), more->begin(), more->end());
    }
    EXPECT_EQ(crossings_of(out, line), laps);
}

// Of loggers and their converters; what is of something else is no position.
TEST(Track, KnowsTheNamesOfPositions) {
    const Session session(2201, 0.05);
    const auto laps_of = [&](const std::string& north, const std::string& east) {
        std::string text = "time [s]," + north + "," + east + "\n";
        for (const double t : session.time) {
            text += fmt::format("{:.2f},{:.8f},{:.8f}\n", t, Session::north(t), Session::east(t));
        }
        ReadBack file("log.csv", text);
        return file.is_open() ? find_laps(file.file(), session.time, std::nullopt, true, file.errors()).laps.size() : 0;
    };
    for (const auto& [north, east] :
         {std::pair{"lat", "lng"}, std::pair{"GPS_Lat", "GPS_Lng"},
          std::pair{"GPS Latitude [deg]", "GPS Longitude [deg]"}, std::pair{"gpsLat", "gpsLong"},
          std::pair{"Latitude (deg) *gps", "Longitude (deg) *gps"}, std::pair{"PosLat", "PosLon"},
          std::pair{"Vehicle Latitude", "Vehicle Longitude"}, std::pair{"LAT", "LON"}}) {
        EXPECT_GT(laps_of(north, east), 2U) << north;
    }
    EXPECT_EQ(laps_of("Lat Acc", "Long Acc"), 0U);
}

// A counter without a number on the way out of the pits, for 20 s: its lap 1 is a whole one.
TEST(Laps, OfACounterThatBeginsAtTheLine) {
    std::vector<double> time;
    std::vector<double> number;
    for (int i = 0; i <= 100; ++i) {
        time.push_back(i);
        number.push_back(i < 20 || i > 80 ? std::nan("") : i < 50 ? 1.0 : 2.0);
    }
    const std::vector<Lap> laps = laps_by_counter(time, number);
    ASSERT_EQ(laps.size(), 4U);
    EXPECT_EQ(laps[0].kind, LapKind::out);
    EXPECT_EQ(laps[0].number, 0);
    EXPECT_EQ(laps[1].kind, LapKind::flying);
    EXPECT_EQ(laps[1].start, 20.0);
    EXPECT_EQ(laps[2].end, 80.0);
    EXPECT_EQ(laps[3].kind, LapKind::in);
}

// Lap 1 goes from 15.708 to 47.124 s in steps of 0.05 s: from 15.75 to 47.10 s.
TEST(RunOfLaps, HasTheSamplesOfItsLapsAndTheirName) {
    const ExperimentReading reading = read_aim("[[run]]\nfile = \"session.csv\"\nlaps = \"1\"\n");
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_EQ(run.name, "session_lap_1");
    EXPECT_DOUBLE_EQ(run.time.front(), 15.75);
    EXPECT_DOUBLE_EQ(run.time.back(), 47.1);
    ASSERT_EQ(run.laps.size(), 1U);
    EXPECT_EQ(run.laps[0].number, 1);
}

TEST(RunOfLaps, AreSeveralOfOneFile) {
    const ExperimentReading reading =
        read_aim("[[run]]\nfile = \"session.csv\"\nlaps = \"0\"\n[[run]]\nfile = \"session.csv\"\nlaps = \"1-2\"\n");
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    EXPECT_EQ(reading.experiment->runs[0].name, "session_lap_0");
    EXPECT_EQ(reading.experiment->runs[1].name, "session_laps_1-2");
}

// Lap 1, from 15.708 to 47.124 s, drives the tire, but its readings do not count.
TEST(RunOfLaps, LeavesOutTheReadingsBetweenThem) {
    const ExperimentReading reading = read_aim("[[run]]\nfile = \"session.csv\"\nlaps = \"0, 2\"\n");
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    const MeasuredRun& run = reading.experiment->runs.front();
    const ExperimentReading of_all = read_aim("[[run]]\nfile = \"session.csv\"\nlaps = \"0-2\"\n");
    ASSERT_TRUE(of_all.experiment.has_value()) << error_report(of_all);
    const MeasuredRun& whole = of_all.experiment->runs.front();
    EXPECT_EQ(run.name, "session_laps_0_2");
    ASSERT_EQ(run.time, whole.time);
    ASSERT_EQ(run.series.size(), 1U);
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        const bool is_left_out = run.time[i] > 15.7080 && run.time[i] < 47.1238;
        EXPECT_EQ(std::isnan(run.series[0].value[i]), is_left_out) << run.time[i];
    }
    for (const double t : {3.0, 20.0, 40.0, 60.0}) {
        EXPECT_EQ(run.problem.input_signals.at(t, solver::JumpSide::after),
                  whole.problem.input_signals.at(t, solver::JumpSide::after));
    }
}

// Two laps of 20 s at 10 Hz whose speed and load never repeat; with repeat_first_lap = 2 the run is that of a log in which the first
// one was written three times. The tire starts 40 s earlier, at what its sensor reads when the first lap that counts begins.
TEST(RunOfLaps, DrivesTheFirstLapBefore) {
    const auto log = [](int before) {
        std::string text = "time [s],lap,speed [km/h],vertical_load [N],surface_temperature [degC]\n";
        for (int i = -200 * before; i < 400; ++i) {
            const int of_lap = i >= 0 ? i : (i + 200 * before) % 200;
            text += fmt::format("{:.1f},{},{:.3f},{:.2f},{:.3f}\n", 0.1 * i, i < 200 ? 1 : 2, 100.0 + 0.05 * of_lap,
                                4000.0 + of_lap, 40.0 + 0.01 * i);
        }
        return text;
    };
    const Written written;
    written.add("short.csv", log(0));
    written.add("long.csv", log(2));
    const std::string base =
        std::string(bench) + "[drive]\nair_temperature = \"25 degC\"\nroad_temperature = \"30 degC\"\n";
    const std::string start = "initial = { temperature = \"surface_temperature\" }\n";
    const ExperimentReading led = read_experiment(written.add(
        "led.toml", base + "[[run]]\nfile = \"short.csv\"\nlaps = \"1-2\"\nrepeat_first_lap = 2\n" + start));
    const ExperimentReading whole = read_experiment(written.add("whole.toml", base + "[[run]]\nfile = \"long.csv\"\n"));
    ASSERT_TRUE(led.experiment.has_value()) << error_report(led);
    // By the counter it is the first lap of the file, which may be one out of the pits.
    EXPECT_TRUE(std::ranges::any_of(led.warnings, [](const std::string& warning) {
        return warning.find("is the first of the file: if the car comes from the pits") != std::string::npos;
    }));
    ASSERT_TRUE(whole.experiment.has_value()) << error_report(whole);
    // What another file gives is not repeated, which is said.
    written.add("weather.csv", "time [s],air_temperature [degC]\n0,25\n40,25\n");
    const ExperimentReading beside = read_experiment(
        written.add("beside.toml", std::string(bench) +
                                       "[drive]\nroad_temperature = \"30 degC\"\n[[drive.file]]\npath = "
                                       "\"weather.csv\"\n[[run]]\nfile = \"short.csv\"\nlaps = \"1-2\"\n"
                                       "repeat_first_lap = 2\n" +
                                       start));
    ASSERT_TRUE(beside.experiment.has_value()) << error_report(beside);
    EXPECT_TRUE(std::ranges::any_of(beside.warnings, [](const std::string& warning) {
        return warning.find("not those of [[drive.file]]") != std::string::npos;
    }));
    const MeasuredRun& run = led.experiment->runs.front();
    EXPECT_EQ(run.time.front(), 0.0);  // nothing was measured before
    EXPECT_NEAR(run.problem.settings.start, -40.0, 1e-9);
    EXPECT_NEAR(run.problem.initial.front(), 273.15 + 40.05, 1e-9);  // mean of 40.00 to 40.10 degC in the first second
    for (double t = -39.95; t < 39.8; t += 0.37) {
        const physics::Inputs ours = run.problem.input_signals.at(t, solver::JumpSide::after);
        const physics::Inputs theirs =
            whole.experiment->runs.front().problem.input_signals.at(t, solver::JumpSide::after);
        EXPECT_NEAR(ours.speed, theirs.speed, 1e-6) << t;
        EXPECT_NEAR(ours.vertical_load, theirs.vertical_load, 1e-6) << t;
    }
}

// Lap 1 ends at 47.124 s, between the samples at 47.10 and 47.15 s: of a run of lap 1 that is its last sample, of one that goes on the
// mark itself, and 3 s later are 50.124 s. Another run's stop is not looked for in this one.
TEST(Pyrometer, IsTakenAtTheEndOfALap) {
    const std::string stop =
        "[[pyrometer]]\nsensors = [\"bulk_temperature\"]\nuncertainty = \"2 K\"\nreadings = \"40 degC\"\n";
    const auto time_of = [&](const std::string& laps, const std::string& when) {
        const ExperimentReading reading =
            read_aim("[[run]]\nfile = \"session.csv\"\nname = \"a\"\nlaps = \"" + laps + "\"\n" + stop + when);
        EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
        return reading.experiment ? reading.experiment->runs.front().numbers.at(0).time : -1.0;
    };
    EXPECT_DOUBLE_EQ(time_of("1", "lap = 1\n"), 47.1);
    EXPECT_NEAR(time_of("1-2", "lap = 1\n"), 47.124, 1e-3);
    EXPECT_NEAR(time_of("1-2", "lap = 1\nafter = \"3 s\"\n"), 50.124, 1e-3);
    const ExperimentReading late =
        read_aim("[[run]]\nfile = \"session.csv\"\nlaps = \"1\"\n" + stop + "lap = 1\nafter = \"3 s\"\n");
    ASSERT_EQ(late.errors.size(), 1U);
    EXPECT_TRUE(late.errors[0].what.starts_with("3 s after the end of lap 1 it is 50.1 s")) << late.errors[0].what;
    const std::string run = "[[run]]\nfile = \"session.csv\"\nname = ";
    const ExperimentReading two =
        read_aim(run + "\"a\"\nlaps = \"0-2\"\n" + run + "\"b\"\nlaps = \"1\"\n" + stop + "run = \"a\"\nlap = 2\n");
    ASSERT_TRUE(two.experiment.has_value()) << error_report(two);
    EXPECT_EQ(two.experiment->runs[0].numbers.size(), 1U);
    EXPECT_TRUE(two.experiment->runs[1].numbers.empty());
}

// A stop that names no run is that of the case's only one. A file of --data that is another has no such stop; where the case has no run at all,
// the stop is that of the file.
TEST(Pyrometer, IsNotThatOfAForeignLog) {
    const std::string stop =
        "[[pyrometer]]\nsensors = [\"bulk_temperature\"]\nuncertainty = \"2 K\"\nreadings = \"40 degC\"\n";
    const auto read_with = [&](const std::string& runs, const std::string& file) {
        const Written written;
        const std::string log = made_up::aim_csv(Session(2201, 0.05));
        written.add("session.csv", log);
        written.add("other.csv", log);
        const std::string driven = "[drive]\nair_temperature = \"25 degC\"\nroad_temperature = \"30 degC\"\n";
        return read_experiment(written.add("case.toml", std::string(bench) + driven + runs + stop),
                               {written.folder() / file});
    };
    const auto numbers = [](const ExperimentReading& reading) {
        EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
        return reading.experiment ? reading.experiment->runs.front().numbers.size() : 99U;
    };
    const std::string run = "[[run]]\nfile = \"session.csv\"\n";
    EXPECT_EQ(numbers(read_with(run, "session.csv")), 1U);
    EXPECT_EQ(numbers(read_with("", "other.csv")), 1U);
    const ExperimentReading foreign = read_with(run, "other.csv");
    EXPECT_EQ(numbers(foreign), 0U);
    EXPECT_TRUE(std::ranges::any_of(foreign.warnings, [](const std::string& warning) {
        return warning.find("is not among those of --data: it is left out") != std::string::npos;
    }));
}

// What drives the tire goes on through laps that do not count, and nothing is suspicious about the hole in the readings.
TEST(RunOfLaps, HolesInTheReadingsAreNothingSuspicious) {
    const ExperimentReading whole = read_aim("[[run]]\nfile = \"session.csv\"\nlaps = \"0-2\"\n");
    const ExperimentReading apart = read_aim("[[run]]\nfile = \"session.csv\"\nlaps = \"0, 2\"\n");
    EXPECT_EQ(apart.data_warnings, whole.data_warnings);
}

}  // namespace tiretherm::input
