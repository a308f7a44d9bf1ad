// SPDX-License-Identifier: BSD-3-Clause
// Warnings about suspicious data (units, clock, frozen sensors, outliers): each fires on its fault and none on sound
// data.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "input/measurements/data_warnings.hpp"
#include "input/measurements/measured_bench.hpp"

// What is suspicious about data is reported before any fit, in sentences that are held to the letter here. Each test
// starts from a recording about which there is nothing to say.
namespace tiretherm::input {

namespace {

constexpr int n_samples = 400;

/// A column by its numbers as the file writes them.
struct Numbers {
    std::string name;
    std::string unit;
    std::vector<double> numbers;
};

/// Forty minutes on a bench, a sample every 6 s: speeds and loads that step, a sweep of slip, and temperatures that warm
/// up from the air's 25 degC with noise of 0.3 K, written to 0.01 K.
class Session {
public:
    Session() {
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0.0, 0.3);
        std::vector<double> speed, load, angle, force, air, pressure, surface, bulk;
        for (int i = 0; i < n_samples; ++i) {
            time.push_back(6.0 * i);
            speed.push_back(i < 10 ? 0.0 : i < 200 ? 80.0 : 120.0);
            load.push_back(i < 150 ? 4000.0 : 5000.0);
            const bool sweeps = i >= 250 && i < 300;
            angle.push_back(sweeps ? 4.0 * std::sin(0.25 * (i - 250)) : 0.0);
            force.push_back(-700.0 * angle.back());
            air.push_back(25.0);
            pressure.push_back(2.4);
            const double warm = 1.0 - std::exp(-i / 80.0);
            surface.push_back(std::round(100.0 * (25.0 + 15.0 * warm + noise(random))) / 100.0);
            bulk.push_back(std::round(100.0 * (25.0 + 50.0 * warm + noise(random))) / 100.0);
        }
        columns = {{"speed", "km/h", speed},
                   {"vertical_load", "N", load},
                   {"slip_angle", "deg", angle},
                   {"lateral_force", "N", force},
                   {"air_temperature", "degC", air},
                   {"inflation_pressure", "bar", pressure},
                   {"surface_temperature", "degC", surface},
                   {"bulk_temperature", "degC", bulk}};
    }

    [[nodiscard]] Numbers& column(const std::string& name) {
        for (Numbers& written : columns) {
            if (written.name == name) {
                return written;
            }
        }
        throw std::invalid_argument(name);
    }
    /// The same physical values labelled as another unit: the numbers of `really`, the name of `label`.
    void mislabel(const std::string& name, double factor, double offset, const std::string& label) {
        for (double& number : column(name).numbers) {
            number = number * factor + offset;
        }
        column(name).unit = label;
    }

    [[nodiscard]] std::vector<std::string> warnings() const {
        std::string log = "time [s]";
        for (const Numbers& written : columns) {
            log += "," + written.name + " [" + written.unit + "]";
        }
        for (std::size_t i = 0; i < time.size(); ++i) {
            log += "\n" + std::to_string(time[i]);
            for (const Numbers& written : columns) {
                char number[40];
                std::snprintf(number, sizeof number, ",%.10g", written.numbers[i]);
                log += number;
            }
        }
        const Written files;
        files.add("run1.csv", log + "\n");
        const ExperimentReading reading = read_experiment(
            files.add("case.toml",
                      std::string(bench) + "[drive]\nroad_temperature = \"25 degC\"\n[[run]]\nfile = \"run1.csv\"\n"));
        EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
        std::vector<std::string> found;
        for (const std::string& sentence : reading.data_warnings) {
            found.push_back(replaced(sentence, files.folder().generic_string() + "/", ""));
        }
        return found;
    }

    std::vector<double> time;
    std::vector<Numbers> columns;
};

using Sentences = std::vector<std::string>;

}  // namespace

TEST(DataWarnings, NothingIsSaidAboutSoundData) { EXPECT_EQ(Session().warnings(), Sentences{}); }

TEST(DataWarnings, APauseOfTheLogger) {
    Session session;
    for (std::size_t i = 100; i < session.time.size(); ++i) {
        session.time[i] += 120.0;
    }
    EXPECT_EQ(
        session.warnings(),
        Sentences{"run1.csv: time jumps by 126 s after 594 s, where a sample mostly comes every 6 s: was the logger "
                  "paused?"});
    for (std::size_t i = 200; i < session.time.size(); ++i) {
        session.time[i] += 200.0;
    }
    EXPECT_EQ(
        session.warnings(),
        Sentences{"run1.csv: time jumps 2 times, at most by 206 s after 1314 s, where a sample mostly comes every 6 "
                  "s: was the logger paused?"});
}

// Pairs of lines at one time, 6 s apart: half of the intervals are 0, and none is a pause.
TEST(DataWarnings, LinesThatStandTwiceAreNoPause) {
    Session session;
    for (std::size_t i = 0; i < session.time.size(); ++i) {
        session.time[i] = 6.0 * static_cast<double>(i / 2);
    }
    for (const std::string& sentence : session.warnings()) {
        EXPECT_EQ(sentence.find("paused"), std::string::npos) << sentence;
    }
}

TEST(DataWarnings, AClockInMilliseconds) {
    Session session;
    for (double& time : session.time) {
        time *= 1000.0;
    }
    EXPECT_EQ(session.warnings(),
              Sentences{"run1.csv: time goes on for 665 h, and 2390000 ms would be 2390 s: is the column in ms?"});
}

TEST(DataWarnings, ASensorThatHangs) {
    Session session;
    std::vector<double>& bulk = session.column("bulk_temperature").numbers;
    std::fill(bulk.begin() + 100, bulk.begin() + 140, 60.31);
    EXPECT_EQ(session.warnings(),
              Sentences{"run1.csv: bulk_temperature stands at 60.3 degC for 40 samples, from 600 s to 834 s, while it "
                        "otherwise changes: was it stuck? Fits and diagnoses leave these samples out"});
    // As long as a fiftieth of the run or twenty samples it may.
    session = Session();
    std::vector<double>& other = session.column("bulk_temperature").numbers;
    std::fill(other.begin() + 100, other.begin() + 120, 60.31);
    EXPECT_EQ(session.warnings(), Sentences{});
}

// A coarse sensor stands on each of its steps; nothing hangs. In whole degrees the bulk, which rises by 50 K in 400
// samples and slower and slower, stays on one for tens of samples.
TEST(DataWarnings, ACoarseSensorDoesNotHang) {
    Session session;
    for (int i = 0; i < n_samples; ++i) {
        const double warm = 1.0 - std::exp(-i / 200.0);
        session.column("bulk_temperature").numbers[static_cast<std::size_t>(i)] = std::floor(25.0 + 50.0 * warm);
    }
    EXPECT_EQ(session.warnings(), Sentences{});
}

// Written to 0.1 K, air that hardly changes flickers on the edge of a step for a while and then no more.
TEST(DataWarnings, AirThatHardlyChangesDoesNotHang) {
    Session session;
    for (std::size_t i = 0; i < 100; ++i) {
        session.column("air_temperature").numbers[i] = i % 3 == 0 ? 25.1 : 25.0;
    }
    EXPECT_EQ(session.warnings(), Sentences{});
}

// Before it rolls, a tire stays as it is; when it rolls, it does not.
TEST(DataWarnings, ATireThatStandsFromTheStartDoesNotHang) {
    Session session;
    std::vector<double>& speed = session.column("speed").numbers;
    std::fill(speed.begin(), speed.begin() + 60, 0.0);
    std::vector<double>& bulk = session.column("bulk_temperature").numbers;
    std::fill(bulk.begin(), bulk.begin() + 50, 25.0);
    EXPECT_EQ(session.warnings(), Sentences{});
    speed[30] = 80.0;
    EXPECT_EQ(session.warnings(),
              Sentences{"run1.csv: bulk_temperature stands at 25 degC for 50 samples, from 0 s to 294 "
                        "s, while it otherwise changes: was it stuck? Fits and diagnoses leave these samples out"});
}

TEST(DataWarnings, AnInputThatHangs) {
    Session session;
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 20.0);
    std::vector<double>& load = session.column("vertical_load").numbers;
    for (double& value : load) {
        value += noise(random);
    }
    EXPECT_EQ(session.warnings(), Sentences{});
    std::fill(load.begin() + 50, load.begin() + 90, 4017.0);
    EXPECT_EQ(
        session.warnings(),
        Sentences{"run1.csv: vertical_load stands at 4020 N for 40 samples, from 300 s to 534 s, while it otherwise "
                  "changes: was it stuck?"});
}

TEST(DataWarnings, Outliers) {
    Session session;
    std::vector<double>& surface = session.column("surface_temperature").numbers;
    surface[350] = surface[349] + 41.0;
    EXPECT_EQ(session.warnings().size(), 1U);
    // Off the median of the eleven about it by 41 K and the noise of two samples.
    EXPECT_TRUE(session.warnings().front().starts_with("run1.csv: surface_temperature has an outlier at 2100 s, 4"));
    EXPECT_TRUE(session.warnings().front().ends_with(" K off the samples about it; it is left out"));
    surface[360] = surface[361] = -10.0;
    EXPECT_TRUE(
        session.warnings().front().starts_with("run1.csv: surface_temperature has 3 outliers, the first at 2100 s, 4"));
}

// A pulse that an input explains is no outlier: braking to a standstill within a sample.
TEST(DataWarnings, WhatAnInputExplainsIsNoOutlier) {
    Session session;
    session.column("surface_temperature").numbers[350] += 15.0;
    EXPECT_EQ(session.warnings().size(), 1U);
    session.column("speed").numbers[350] = 60.0;
    session.column("speed").numbers[351] = 60.0;
    EXPECT_EQ(session.warnings(), Sentences{});
}

// A driver's slip moves by 1 degree from sample to sample, and in one of them turns back for 1.2 degrees: no outlier. The same
// spike in a slip at rest is one.
TEST(DataWarnings, AnInputThatIsLivelyHasNoOutlier) {
    const auto with_spike = [](bool lively) {
        Session session;
        std::vector<double>& slip = session.column("slip_angle").numbers;
        for (std::size_t i = 330; lively && i < 370; ++i) {
            slip[i] = static_cast<double>(i % 8 < 4 ? i % 8 : 8 - i % 8);
        }
        slip[349] = slip[348] - 1.2;
        std::vector<double>& force = session.column("lateral_force").numbers;
        std::ranges::transform(slip, force.begin(), [](double angle) { return -700.0 * angle; });
        Sentences found = session.warnings();
        std::erase_if(found, [](const std::string& one) { return one.find("outlier") == std::string::npos; });
        return found;
    };
    EXPECT_EQ(with_spike(true), Sentences{});
    ASSERT_FALSE(with_spike(false).empty());
    EXPECT_TRUE(with_spike(false).front().starts_with("run1.csv: slip_angle has an outlier at 2094 s"))
        << with_spike(false).front();
}

// A laser that is on for two samples of ten and off for eight: five pulses a minute, each with ramps of a sample.
TEST(DataWarnings, AnInputThatIsSwitched) {
    Session session;
    std::vector<double>& speed = session.column("speed").numbers;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        speed[i] = i % 10 < 2 ? 80.0 : 0.0;
    }
    const Sentences found = session.warnings();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(
        found.front(),
        "run1.csv: speed jumps between samples, up to 79 times, and is read as straight in between, over 6 s. What "
        "is switched can hold each value until the next sample: hold = [\"speed\"]");
}

// The bulk's probe is not connected: 25 degC all the time. When nothing happens at all, nothing is said.
TEST(DataWarnings, ASensorThatIsDead) {
    Session session;
    std::ranges::fill(session.column("bulk_temperature").numbers, 25.0);
    EXPECT_EQ(
        session.warnings(),
        Sentences{"run1.csv: bulk_temperature is 25 degC in all 400 samples, while the tire rolls or other sensors "
                  "change: is the sensor connected? Fits and diagnoses leave it out"});
    for (Numbers& column : session.columns) {
        std::ranges::fill(column.numbers, column.name == "speed" ? 0.0 : column.numbers.back());
    }
    EXPECT_EQ(session.warnings(), Sentences{});
}

// 120 km/h are 33.3 m/s.
TEST(DataWarnings, ASpeedInMetresPerSecond) {
    Session session;
    session.mislabel("speed", 1.0 / 3.6, 0.0, "km/h");
    EXPECT_EQ(
        session.warnings(),
        Sentences{"run1.csv: speed is at most 33.3 km/h over the whole run, and 33.3 m/s would be 120 km/h: is the "
                  "column in m/s?"});
    // A tire that stays cold may well have rolled so slowly.
    for (const char* name : {"surface_temperature", "bulk_temperature"}) {
        for (double& number : session.column(name).numbers) {
            number = 25.0 + 0.1 * (number - 25.0);
        }
    }
    EXPECT_EQ(session.warnings(), Sentences{});
}

TEST(DataWarnings, ASpeedInKilometresPerHour) {
    Session session;
    session.mislabel("speed", 1.0, 0.0, "m/s");
    EXPECT_EQ(session.warnings(),
              Sentences{"run1.csv: speed reaches 120 m/s, and 120 km/h would be 33.3 m/s: is the column in km/h?"});
}

TEST(DataWarnings, ALoadInKilonewtons) {
    Session session;
    session.mislabel("vertical_load", 1e-3, 0.0, "N");
    // With it the lateral force has become huge beside the load, which the load alone explains.
    EXPECT_EQ(session.warnings(),
              Sentences{"run1.csv: vertical_load is at most 5 N over the whole run, and 5 kN would be 5000 N: is the "
                        "column in kN?"});
}

TEST(DataWarnings, ASlipAngleInRadians) {
    Session session;
    session.mislabel("slip_angle", M_PI / 180.0, 0.0, "deg");
    // 4 degrees are 0.0698 rad.
    EXPECT_EQ(session.warnings(),
              Sentences{"run1.csv: slip_angle is at most 0.0698 deg over the whole run, and 0.0698 rad would be 4 deg: "
                        "is the column in rad?"});
}

TEST(DataWarnings, ASlipAngleInDegrees) {
    Session session;
    session.mislabel("slip_angle", 0.25, 0.0, "rad");
    EXPECT_EQ(session.warnings(),
              Sentences{"run1.csv: slip_angle reaches 1 rad, and 1 deg would be 0.0175 rad: is the column in "
                        "deg?"});
}

TEST(DataWarnings, PressuresInOtherUnits) {
    const auto says = [](double factor, const std::string& label) {
        Session session;
        session.mislabel("inflation_pressure", factor, 0.0, label);
        return session.warnings();
    };
    EXPECT_EQ(
        says(1.0, "kPa"),
        Sentences{"run1.csv: inflation_pressure is at most 2.4 kPa over the whole run, and 2.4 bar would be 240 kPa: "
                  "is the column in bar?"});
    EXPECT_EQ(says(100.0, "psi"),
              Sentences{"run1.csv: inflation_pressure reaches 240 psi, and 240 kPa would be 34.8 psi: is the column in "
                        "kPa?"});
    // 2.4 bar are 34.8 psi.
    EXPECT_EQ(
        says(14.5038, "kPa"),
        Sentences{"run1.csv: inflation_pressure is at most 34.8 kPa over the whole run, and 34.8 psi would be 240 "
                  "kPa: is the column in psi?"});
}

TEST(DataWarnings, TemperaturesInOtherUnits) {
    const auto says = [](const std::string& name, double factor, double offset, const std::string& label) {
        Session session;
        session.mislabel(name, factor, offset, label);
        const Sentences found = session.warnings();
        return found.size() == 1 ? found.front() : std::to_string(found.size()) + " sentences";
    };
    // From 25 degC to 75 degC in kelvin, labelled degC; and in degC, labelled kelvin.
    EXPECT_TRUE(
        says("bulk_temperature", 1.0, 273.15, "degC").starts_with("run1.csv: bulk_temperature reaches 348 degC, "));
    EXPECT_TRUE(says("bulk_temperature", 1.0, 273.15, "degC").ends_with(" would be 74.9 degC: is the column in K?"))
        << says("bulk_temperature", 1.0, 273.15, "degC");
    EXPECT_TRUE(says("bulk_temperature", 1.0, 0.0, "K").ends_with(": is the column in degC?"))
        << says("bulk_temperature", 1.0, 0.0, "K");
    // 25 degC are 77 degF: too warm for air by itself, and for a tire that has not yet rolled.
    EXPECT_EQ(says("air_temperature", 1.8, 32.0, "degC"),
              "run1.csv: air_temperature reaches 77 degC, and 77 degF would be 25 degC: is the column in degF?");
    const std::string start = says("surface_temperature", 1.8, 32.0, "degC");
    EXPECT_TRUE(start.starts_with("run1.csv: surface_temperature starts at 7")) << start;
    EXPECT_NE(start.find(" degC in air of 25 degC, and "), std::string::npos) << start;
    EXPECT_TRUE(start.ends_with(": is the column in degF?")) << start;
}

TEST(DataWarnings, UnusualInputs) {
    Session session;
    session.mislabel("inflation_pressure", 2.5, 0.0, "bar");
    for (double& number : session.column("air_temperature").numbers) {
        number = 52.0;
    }
    EXPECT_EQ(session.warnings(),
              (Sentences{"run1.csv: air_temperature reaches 52 degC, which is unusual: it is mostly at most 50 degC",
                         "run1.csv: inflation_pressure reaches 6 bar, which is unusual: it is mostly at most 5 bar"}));
}

TEST(DataWarnings, AColumnOfAnotherNameIsShownByBoth) {
    Recording recording{.time = {0, 1, 2}, .time_unit = "s", .columns = {}};
    recording.columns.push_back({.name = "camber",
                                 .heading = "IA",
                                 .unit = "deg",
                                 .si = "radian",
                                 .conversion = {.factor = M_PI / 180.0, .offset = 0.0},
                                 .is_input = true,
                                 .time = {0, 1, 2},
                                 .value = {0.0, 0.1, 0.2}});
    EXPECT_EQ(find_suspicious(recording),
              Sentences{"camber (column IA) reaches 11.5 deg, which is unusual: it is mostly at most 10 deg"});
}

TEST(DataWarnings, NumbersAreShownToThreeDigits) {
    EXPECT_EQ(three_digits(4323.5), "4320");
    EXPECT_EQ(three_digits(27.777), "27.8");
    EXPECT_EQ(three_digits(0.042149), "0.0421");
    EXPECT_EQ(three_digits(-10.0), "-10");
}

}  // namespace tiretherm::input
