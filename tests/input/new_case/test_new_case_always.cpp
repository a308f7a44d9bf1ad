// SPDX-License-Identifier: BSD-3-Clause
// Whatever the log: the new case is one that `check` accepts and that reads the log, or it says first that it does not.
#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "input/log_survey/log_survey.hpp"
#include "input/new_case/made.hpp"
#include "input/runs/read_experiment.hpp"

namespace tiretherm::input {
namespace {

namespace fs = std::filesystem;

/// A line of the case that is no comment begins so.
bool has_line(const std::string& text, std::string_view begin) {
    return std::ranges::any_of(lines_of(text), [&](const std::string& line) { return line.starts_with(begin); });
}

void expect_usable(const NewCase& made, const Written& written, const std::string& log, const std::string& what) {
    if (!made.errors.empty()) {  // of the log itself, never of the case that was made of it
        for (const InputError& error : made.errors) {
            EXPECT_FALSE(error.file.ends_with("case.toml")) << what << "\n" << render(error);
        }
        return;
    }
    const Reading reading = read_case(written.add("case.toml", made.text));
    EXPECT_TRUE(reading.problem) << what << "\n" << render(reading);
    const bool reads = has_line(made.text, "[[run]]") || has_line(made.text, "[[drive.file]]");
    EXPECT_EQ(made.unread.empty(), reads) << what;
    EXPECT_EQ(made.unread.starts_with("The case does not read " + log), !reads) << made.unread;
}

// All logs of the case library and of the tests, good and bad. Large ones have others of their kind beside them.
TEST(NewCaseAlways, IsAcceptedForEveryLogThereIs) {
    constexpr std::uintmax_t largest = 400'000;  // bytes
    int n = 0;
    for (const char* folder : {"cases", "tests/bad_cases", "tests/fuzz/corpus"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(TIRETHERM_SOURCE_DIR) / folder)) {
            if (!entry.is_regular_file() || !is_log_file(entry.path()) || entry.file_size() > largest) {
                continue;
            }
            const Written written;
            NewCaseRequest request{.size = std::get<TireSize>(read_tire_size("225/50 R17")),
                                   .target = written.folder() / "case.toml"};
            request.log = entry.path();
            expect_usable(make_new_case(request), written, entry.path().generic_string(), entry.path().string());
            ++n;
        }
    }
    EXPECT_GT(n, 30);
}

// Channels that loggers, rigs and benches have, with their units and without, and with units that the user gives.
TEST(NewCaseAlways, IsAcceptedForAnySubsetOfColumns) {
    constexpr std::array<std::string_view, 20> headings{
        "GPS Speed [km/h]",           "LatAcc [g]",       "LonAcc [g]",       "YawRate [deg/s]",   "Steering [deg]",
        "Brake Pressure [bar]",       "Brake Volts [V]",  "Throttle [%]",     "Tire Temp FL [C]",  "Tire Temp RR [C]",
        "TPMS Press FL [bar]",        "TPMS Temp FL [C]", "Ambient Temp [C]", "vertical_load [N]", "FZ [N]",
        "surface_temperature [degC]", "P laser [W]",      "Lap [-]",          "slip_angle [deg]",  "lateral_force [N]"};
    std::mt19937 random(7);  // of the standard, the same everywhere
    for (int trial = 0; trial < 120; ++trial) {
        std::string text = random() % 2 == 0 ? "Time [s]" : "Time";
        std::vector<std::string_view> chosen;
        std::vector<GivenUnit> units;
        for (const std::string_view heading : headings) {
            if (random() % 4 != 0) {
                continue;
            }
            chosen.push_back(heading);
            const std::string_view name = heading.substr(0, heading.find(" ["));
            const bool bare = random() % 3 == 0;
            text += fmt::format(",{}", bare ? name : heading);
            if (bare && random() % 2 == 0) {
                const std::string_view unit = heading.substr(name.size() + 2);
                units.push_back({std::string(name), std::string(unit.substr(0, unit.size() - 1))});
            }
        }
        for (int i = 0; i < 40; ++i) {
            text += fmt::format("\n{:.1f}", 0.1 * i);
            for (std::size_t c = 0; c < chosen.size(); ++c) {
                const bool empty = i % 7 == 3 && c % 3 == 1;
                text += empty ? "," : fmt::format(",{:.3f}", i / 10 + 20.0 * std::abs(std::sin(0.3 * i + double(c))));
            }
        }
        const Written written;
        written.add("log.csv", text + "\n");
        const NewCase made = make(written, "225/50 R17", "", "log.csv", units);
        expect_usable(made, written, (written.folder() / "log.csv").generic_string(), text.substr(0, text.find('\n')));
    }
}

// A knock of 320 g in the first quarter of a second: 1 of 201 samples, which is left out. The car goes straight on.
TEST(NewCaseAlways, SurvivesAKnockOfTheAccelerometer) {
    std::string text = "Time [s],Speed [km/h],LatAcc [g],Tire Temp FL [C]";
    for (int i = 0; i <= 200; ++i) {
        text +=
            fmt::format("\n{:.2f},100,{},{:.1f}", 0.05 * i, i == 3 ? 320.0 : 0.1 * std::sin(0.1 * i), 40.0 + 0.05 * i);
    }
    const Written written;
    written.add("log.csv", text + "\n");
    const NewCase made = make(written, "225/50 R17", "", "log.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_TRUE(std::ranges::any_of(made.warnings, [](const std::string& warning) {
        return warning.find(
                   "lateral_acceleration is 3138.13 m/s2 at 0.15 s, beyond -80 to 80, where no car is: the sample is "
                   "left out") != std::string::npos;
    })) << (made.warnings.empty() ? "" : made.warnings.front());
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value());
    // 1350 kg on four wheels; 0.1 g moves 0.55 1350 0.98 0.48/1.55 = 225 N at most.
    const physics::Inputs in = reading.experiment->runs.front().problem.input_signals.at(0.15, solver::JumpSide::after);
    EXPECT_NEAR(in.vertical_load, 3310.0, 230.0);
}

// An acceleration in m/s2 that is called one in g is 9.8 times the slope of speed, which the case is refused for: it is left out, and
// the case reads the rest.
TEST(NewCaseAlways, LeavesOutAColumnThatTheCaseIsRefusedFor) {
    std::string text = "Time [s],Speed [m/s],LonAcc [g],LatAcc [g],Tire Temp FL [C]";
    for (int i = 0; i <= 600; ++i) {
        const double t = 0.1 * i;
        text += fmt::format("\n{:.1f},{:.4f},{:.4f},{:.4f},{:.1f}", t, 30.0 + 10.0 * std::sin(0.3 * t),
                            3.0 * std::cos(0.3 * t), 0.5 * std::sin(0.5 * t), 40.0 + 0.05 * t);
    }
    const Written written;
    written.add("log.csv", text + "\n");
    const NewCase made = make(written, "225/50 R17", "", "log.csv");
    expect_usable(made, written, (written.folder() / "log.csv").generic_string(), "along");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_TRUE(column_of(made, "LonAcc").reason.starts_with("longitudinal_acceleration is "))
        << column_of(made, "LonAcc").reason;
    EXPECT_TRUE(column_of(made, "LatAcc").is_used());
    EXPECT_EQ(made.log->use, LogUse::run);
}

// 90 km/h are 25 m/s; without tire readings and with --unit as with a unit in the heading. A blank field is bridged.
TEST(NewCaseAlways, UnitsThatAreGivenCountWithoutTireReadings) {
    const Written written;
    written.add("a.csv", "Time,Speed\n0,90\n1,\n2,90\n3,90\n");
    for (const auto& [unit, speed] : {std::pair{"km/h", 25.0}, std::pair{"m/s", 90.0}}) {
        const NewCase made = make(written, "225/50 R17", "", "a.csv", {{"Speed", unit}});
        ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
        EXPECT_EQ(made.log->use, LogUse::drive);
        EXPECT_EQ(made.unread, "");
        const Reading reading = read_case(written.add("case.toml", made.text));
        ASSERT_TRUE(reading.problem) << render(reading);
        EXPECT_NEAR(reading.problem->input_signals.at(1.0, solver::JumpSide::after).speed, speed, 1e-9);
        EXPECT_EQ(reading.problem->settings.end, 3.0);
    }
}

TEST(NewCaseAlways, SaysFirstThatALogIsNotReadAndWhy) {
    const Written written;
    written.add("a.csv", "Time [s],Speed\n0,90\n1,90\n2,90\n");
    const NewCase made = make(written, "225/50 R17", "", "a.csv");
    ASSERT_TRUE(made.errors.empty());
    EXPECT_EQ(
        made.unread,
        fmt::format("The case does not read {}: no column of it is known to be an input or a sensor's (Speed may be "
                    "speed: the column Speed has no unit). It lasts as long as the log, with constant inputs.",
                    (written.folder() / "a.csv").generic_string()));
    EXPECT_LT(made.text.find("# The case does not read"), made.text.find("title = "));
}

// Bar before volts, whichever comes first in the file.
TEST(NewCaseAlways, TakesTheBrakesPressureInAUnitOfPressure) {
    const Written written;
    std::string text = "Time [s],Speed [km/h],LatAcc [g],Brake Pressure Front [V],Brake Pressure [bar]";
    for (int i = 0; i <= 20; ++i) {
        text += fmt::format("\n{:.1f},100,0.1,{:.2f},{}", 0.1 * i, 0.5 + 0.05 * i, i);
    }
    written.add("log.csv", text + "\n");
    const NewCase made = make(written, "225/50 R17", "", "log.csv");
    EXPECT_EQ(column_of(made, "Brake Pressure").name, "brake_pressure");
    EXPECT_EQ(column_of(made, "Brake Pressure Front").reason, "another column is taken for brake_pressure");
}

}  // namespace
}  // namespace tiretherm::input
