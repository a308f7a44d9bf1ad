// SPDX-License-Identifier: BSD-3-Clause
// Dead, clipped and stuck sensors are found before any fit, and what they did not measure is left out.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "input/measurements/dead_stretches.hpp"
#include "input/measurements/made_up_log.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t n_rows_each = 600;

double to_step(double value, double step) { return step * std::round(value / step); }

/// Ten minutes, a sample a second; rolling from 60 s on, with noise of 0.3 K written to 0.01 K.
MadeUpLog session() {
    MadeUpLog log(n_rows_each, 1.0);
    Noise noise(0.3);
    const auto warm = [](double t) { return t < 60.0 ? 0.0 : 1.0 - std::exp(-(t - 60.0) / 150.0); };
    log.add("speed", "km/h", [](double t) { return t < 60.0 ? 0.0 : 100.0 + 10.0 * std::sin(t / 20.0); });
    log.add("vertical_load", "N", [](double) { return 4000.0; });
    log.add("air_temperature", "degC", [](double) { return 25.0; });
    log.add("road_temperature", "degC", [](double) { return 25.0; });
    log.add("surface_temperature", "degC", [&](double t) { return to_step(25.0 + 20.0 * warm(t) + noise(), 0.01); });
    log.add("bulk_temperature", "degC", [&](double t) { return to_step(25.0 + 60.0 * warm(t) + noise(), 0.01); });
    return log;
}

std::vector<double>& bulk(MadeUpLog& log) { return log.columns.back().value; }

/// What was read of the bulk, and what was found.
struct Read {
    std::vector<std::string> findings;
    MeasuredSeries series;
    MeasuredSeries surface;
    [[nodiscard]] std::size_t missing() const {
        return static_cast<std::size_t>(std::ranges::count_if(series.value, [](double v) { return std::isnan(v); }));
    }
};

Read read(const MadeUpLog& log, const std::string& more = "") {
    const ExperimentReading reading = read_logs({log}, more);
    EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
    if (!reading.experiment) {
        return {};
    }
    const MeasuredRun& run = reading.experiment->runs.front();
    return {reading.data_warnings, *find_series(run, "bulk_temperature"), *find_series(run, "surface_temperature")};
}

using Texts = std::vector<std::string>;
const std::string out = " Fits and diagnoses leave these samples out";

}  // namespace

TEST(UnusableSamples, SoundDataAreKept) {
    const Read found = read(session());
    EXPECT_EQ(found.findings, Texts{});
    EXPECT_EQ(found.missing(), 0U);
}

TEST(UnusableSamples, AStuckStretchIsLeftOut) {
    MadeUpLog log = session();
    std::fill_n(bulk(log).begin() + 200, 50, 51.23);
    const Read found = read(log);
    EXPECT_EQ(found.findings,
              Texts{"run1.csv: bulk_temperature stands at 51.2 degC for 50 samples, from 200 s to 249 s, while it "
                    "otherwise changes: was it stuck?" +
                    out});
    EXPECT_EQ(found.missing(), 50U);
    EXPECT_TRUE(std::isnan(found.series.value[200]));
    EXPECT_TRUE(std::isnan(found.series.value[249]));
    EXPECT_FALSE(std::isnan(found.series.value[199]));
    EXPECT_FALSE(std::isnan(found.series.value[250]));
    // Whoever knows better keeps them; the finding is there all the same.
    for (const char* where : {"[data]\nkeep_suspicious = true\n", "keep_suspicious = true\n"}) {
        const Read kept = read(log, where);
        ASSERT_EQ(kept.findings.size(), 1U);
        EXPECT_TRUE(kept.findings.front().ends_with("was it stuck?"));
        EXPECT_EQ(kept.missing(), 0U);
    }
}

// 165 K for two samples is no tire's; 5 K, between 8 and 24 of the sensor's deviations of 0.3 K, may be one, and counts.
TEST(UnusableSamples, ASpikeThatNoTireHasIsLeftOut) {
    MadeUpLog log = session();
    bulk(log)[300] = bulk(log)[301] = 250.0;
    bulk(log)[400] += 5.0;
    const Read found = read(log);
    ASSERT_EQ(found.findings.size(), 1U);
    EXPECT_TRUE(found.findings[0].ends_with("off the samples about it; 2 of them are left out")) << found.findings[0];
    EXPECT_EQ(found.missing(), 2U);
    EXPECT_TRUE(std::isnan(found.series.value[300]));
    EXPECT_TRUE(std::isnan(found.series.value[301]));
    EXPECT_EQ(read(log, "keep_suspicious = true\n").missing(), 0U);
}

// Half of a sensor's samples stand still. What scatters in the other half is as it always was.
TEST(UnusableSamples, AStuckHalfMakesNoOutliersOfTheOther) {
    MadeUpLog log = session();
    std::fill_n(bulk(log).begin() + static_cast<std::ptrdiff_t>(n_rows_each / 2), n_rows_each - n_rows_each / 2, 0.0);
    for (const std::string& finding : read(log).findings) {
        EXPECT_EQ(finding.find("outlier"), std::string::npos) << finding;
    }
}

// In whole degrees without noise, the bulk comes to rest at 85 degC as its own law says: nothing is stuck or clipped.
TEST(UnusableSamples, ACoarseSensorAtRestIsKept) {
    MadeUpLog log = session();
    for (std::size_t i = 0; i < n_rows_each; ++i) {
        const double t = static_cast<double>(i);
        bulk(log)[i] = std::round(25.0 + 60.0 * (t < 60.0 ? 0.0 : 1.0 - std::exp(-(t - 60.0) / 60.0)));
    }
    EXPECT_EQ(read(log).missing(), 0U);
    // Noise that flickers between two steps of the logger is no clipping either.
    Noise noise(0.3);
    for (std::size_t i = 0; i < n_rows_each; ++i) {
        const double t = static_cast<double>(i);
        bulk(log)[i] = std::round(25.0 + 60.4 * (t < 60.0 ? 0.0 : 1.0 - std::exp(-(t - 60.0) / 60.0)) + noise());
    }
    EXPECT_EQ(read(log).missing(), 0U);
}

// The soak before the run and the stand after it.
TEST(UnusableSamples, ASensorOfATireThatStandsIsKept) {
    MadeUpLog log = session();
    std::fill_n(bulk(log).begin(), 55, 25.0);
    std::fill_n(bulk(log).begin() + 550, 50, 80.0);
    std::fill_n(log.columns.front().value.begin() + 540, 60, 0.0);
    EXPECT_EQ(read(log).missing(), 0U);
}

// The amplifier ends at 75 degC: noise is cut off there, first now and then, from 330 s on nearly always.
TEST(UnusableSamples, AClippedSensorIsLeftOutAtTheRail) {
    MadeUpLog log = session();
    std::size_t clipped = 0;
    for (double& value : bulk(log)) {
        clipped += value >= 75.0 ? 1 : 0;
        value = std::min(value, 75.0);
    }
    const Read found = read(log);
    ASSERT_EQ(found.findings.size(), 1U);
    EXPECT_TRUE(
        found.findings.front().starts_with("run1.csv: bulk_temperature stands at its highest value, 75 degC, for "))
        << found.findings.front();
    EXPECT_TRUE(found.findings.front().ends_with(": is it clipped?" + out)) << found.findings.front();
    // What stands at the rail for less than five samples stays.
    EXPECT_GT(found.missing(), clipped * 9 / 10);
    EXPECT_LE(found.missing(), clipped);
    for (std::size_t i = 0; i < n_rows_each; ++i) {
        EXPECT_TRUE(!std::isnan(found.series.value[i]) || bulk(log)[i] == 75.0) << i;
    }
}

// A broken wire reads -40 degC for half a minute.
TEST(UnusableSamples, ADisconnectedSensorIsLeftOutAtTheRail) {
    MadeUpLog log = session();
    std::fill_n(bulk(log).begin() + 300, 30, -40.0);
    const Read found = read(log);
    ASSERT_EQ(found.findings.size(), 1U);
    EXPECT_EQ(found.findings.front(),
              "run1.csv: bulk_temperature stands at its lowest value, -40 degC, for 30 samples in one stretch, first "
              "from 300 s to 329 s: was it disconnected?" +
                  out);
    EXPECT_EQ(found.missing(), 30U);
}

// A dead input of a logger flickers between two of its codes; nothing can be learnt from it.
TEST(UnusableSamples, TwoCodesAreADeadSensor) {
    MadeUpLog log = session();
    Noise noise(1.0);
    for (double& value : bulk(log)) {
        value = noise() > 0.0 ? 21.4 : 21.2;
    }
    const Read found = read(log);
    EXPECT_EQ(found.findings,
              Texts{"run1.csv: bulk_temperature has two values in all its 600 samples, 21.2 degC and 21.4 degC, while "
                    "others move by more than 10 times as much: is the sensor connected? Fits and diagnoses leave it "
                    "out"});
    EXPECT_TRUE(found.series.frozen);
    EXPECT_FALSE(found.surface.frozen);
    EXPECT_FALSE(read(log, "keep_suspicious = true\n").series.frozen);
}

// A disc at 80 degC whose wire is broken for 20 s says -1 degC, 81 K off. What meets it sees the straight line between the
// samples at 199 and 220 s, which are within three standard deviations of 0.3 K of 80 degC.
TEST(UnusableSamples, ATemperatureOfARunThatOnlyAnEffectFollowsIsReadAsAnInput) {
    MadeUpLog log = session();
    Noise noise(0.3, 6);
    std::vector<double>& disc = log.add("disc", "degC", [&](double) { return to_step(80.0 + noise(), 0.01); });
    std::fill_n(disc.begin() + 200, 20, -1.0);
    const ExperimentReading reading = read_logs({log}, R"(
[[exchange]]
name = "brake"
follows = "1"
at = "bulk"
conductance = "1 W/K"
temperature = "disc"
)");
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    const auto says = [](const std::string& warning) {
        return warning.find("disc stands at -1 degC from 200 s to 219 s") != std::string::npos;
    };
    EXPECT_TRUE(std::ranges::any_of(reading.warnings, says));
    const solver::Problem& problem = reading.experiment->runs.front().problem;
    const physics::ActiveEffect& brake = problem.effects.at(solver::find_user_effect(problem, "brake"));
    EXPECT_NEAR(brake.tables.at(1)->value(210.0), 273.15 + 80.0, 0.9);
}

// A logger of coarse numbers without noise repeats them all in the same samples: it has stopped.
TEST(UnusableSamples, SensorsThatStandStillTogetherAreLeftOut) {
    MadeUpLog log = session();
    for (std::size_t c : {4U, 5U}) {
        std::vector<double>& value = log.columns[c].value;
        for (std::size_t i = 0; i < n_rows_each; ++i) {
            value[i] = to_step(25.0 + (c == 4 ? 20.0 : 60.0) * (static_cast<double>(i) / n_rows_each), 0.05);
        }
        std::fill_n(value.begin() + 300, 40, value[300]);
    }
    const Read found = read(log);
    ASSERT_FALSE(found.findings.empty());
    EXPECT_TRUE(
        found.findings.back().starts_with("run1.csv: surface_temperature, bulk_temperature are constant together, "
                                          "from 300 s to 339 s: did the logger stop?"))
        << found.findings.back();
    EXPECT_GE(found.missing(), 40U);
    EXPECT_TRUE(std::isnan(found.surface.value[320]));
}

namespace {

using Values = std::vector<double>;

struct Recorded {
    Values time;
    Values value;
};

/// A surface that warms up from 40 to 80 degC within 100 s, with noise of 0.3 K, ten times a second, in kelvin.
Recorded warming(double interval = 0.1) {
    Recorded course;
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.3);
    for (double t = 0.0; t < 200.0; t += interval) {
        course.time.push_back(t);
        course.value.push_back(273.15 + 80.0 - 40.0 * std::exp(-t / 30.0) + noise(random));
    }
    return course;
}

/// The same with one value from one time to another.
Recorded with(double celsius, double from, double to, double interval = 0.1) {
    Recorded course = warming(interval);
    for (std::size_t i = 0; i < course.time.size(); ++i) {
        if (course.time[i] >= from - 1e-9 && course.time[i] < to - 1e-9) {
            course.value[i] = celsius + 273.15;
        }
    }
    return course;
}

std::vector<Stretch> dead_in(const Recorded& course, std::string_view si = "K") {
    return dead_stretches(course.time, course.value, si);
}

}  // namespace

// -1, -40, 0 or 1037.55 degC for five seconds, and the 80 of a reset for one: 50 and 10 samples at the start; 50 in the middle,
// at 60 s; 50 at the end.
TEST(DeadStretches, ValuesOfNoSensorAreFoundAtAnyPlace) {
    for (const double value : {-1.0, -40.0, 0.0, 1037.55}) {
        const std::vector<Stretch> start = dead_in(with(value, 0.0, 5.0));
        ASSERT_EQ(start.size(), 1U) << value;
        EXPECT_EQ(start[0].first, 0U);
        EXPECT_EQ(start[0].length, 50U);
        const std::vector<Stretch> middle = dead_in(with(value, 60.0, 65.0));
        ASSERT_EQ(middle.size(), 1U) << value;
        EXPECT_EQ(middle[0].first, 600U);
        EXPECT_EQ(middle[0].length, 50U);
        EXPECT_EQ(dead_in(with(value, 195.0, 201.0)).size(), 1U) << value;
    }
    ASSERT_EQ(dead_in(with(80.0, 0.0, 1.0)).size(), 1U);
    EXPECT_EQ(dead_in(with(80.0, 0.0, 1.0))[0].length, 10U);
    EXPECT_EQ(dead_in(with(-1.0, 0.0, 5.0, 1.0)).size(), 1U);  // once a second
    EXPECT_TRUE(dead_in(warming()).empty());
}

// A broken wire and then a reset: both are no readings, and what follows is one.
TEST(DeadStretches, SeveralInARowAreOne) {
    Recorded course = with(-40.0, 0.0, 3.0);
    const Recorded reset = with(80.0, 0.0, 4.0);
    std::copy(reset.value.begin() + 30, reset.value.begin() + 40, course.value.begin() + 30);
    const std::vector<Stretch> found = dead_in(course);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].length, 40U);
}

// A tire that waits cold in the pits at 20 degC and then warms up; one that is read once a minute and warms by 30 K in the first;
// a temperature that somebody wrote by hand, 30 and later 45 degC; a record that never moves.
TEST(DeadStretches, AColdStartAndAConstantAreReadings) {
    Recorded cold = warming();
    for (std::size_t i = 0; i < cold.time.size(); ++i) {
        cold.value[i] = 293.15 + (cold.time[i] < 20.0 ? 0.0 : 50.0 * (1.0 - std::exp((20.0 - cold.time[i]) / 5.0)));
    }
    EXPECT_TRUE(dead_in(cold).empty());
    Recorded slow;
    for (const double t : {0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 360.0}) {
        slow.time.push_back(t);
        slow.value.push_back(t < 61.0 ? 293.15 : 323.15 + t / 100.0);
    }
    EXPECT_TRUE(dead_in(slow).empty());
    Recorded by_hand = warming();
    for (std::size_t i = 0; i < by_hand.time.size(); ++i) {
        by_hand.value[i] = 273.15 + (by_hand.time[i] < 50.0 ? 30.0 : 45.0);
    }
    EXPECT_TRUE(dead_in(by_hand).empty());
    by_hand.value.back() += 2.0;
    EXPECT_TRUE(dead_in(by_hand).empty());
    std::fill_n(by_hand.value.begin(), 20, 273.15 - 40.0);  // what nobody writes
    EXPECT_EQ(dead_in(by_hand).size(), 1U);
    std::ranges::fill(by_hand.value, 272.15);
    EXPECT_TRUE(dead_in(by_hand).empty());
}

// The air stands at 21 degC for 200 s, in steps of 1 degC, but for 6 s of another value, some 60 of 2000 samples, or 5 s at its end. In 60 lines
// the same may be meant.
TEST(DeadStretches, ValuesOfNoSensorAreFoundBesideAConstant) {
    for (const double value : {-1.0, 0.0, 85.0}) {
        for (const double from : {0.0, 60.0, 195.0}) {
            Recorded air = with(value, from, from + 6.0);
            for (double& kelvin : air.value) {
                kelvin = kelvin == value + 273.15 ? kelvin : 294.15;
            }
            const std::vector<Stretch> found = dead_in(air);
            ASSERT_EQ(found.size(), 1U) << value << " from " << from;
            EXPECT_EQ(found[0].length, std::ranges::count(air.value, value + 273.15));
        }
    }
    Recorded by_hand;
    for (std::size_t i = 0; i < 60; ++i) {
        by_hand.time.push_back(0.5 * static_cast<double>(i));
        by_hand.value.push_back(i < 10 ? 273.15 : 294.15);
    }
    EXPECT_TRUE(dead_in(by_hand).empty());
}

// A laser that is on from the first of samples every 5 s on heats a spot from 23 to 78 degC: the first one is the start.
TEST(DeadStretches, ASingleFirstSampleIsAStart) {
    Recorded spot;
    for (double t = 0.0; t < 300.0; t += 5.0) {
        spot.time.push_back(t);
        spot.value.push_back(273.15 + (t == 0.0 ? 23.3 : 78.0 + 5.0 * std::log(t / 5.0)));
    }
    EXPECT_TRUE(dead_in(spot).empty());
}

// A laser heats a spot as the square root of time: 25 degC, then 31.6 K more after the first tenth of a second, 44.7, 54.8 ...; the
// second step is 0.41 of the first, an aftermath.
TEST(DeadStretches, AJumpWithAnAftermathIsMeasured) {
    Recorded spot = warming();
    for (std::size_t i = 0; i < spot.time.size(); ++i) {
        spot.value[i] = 298.15 + (spot.time[i] < 10.0 ? 0.0 : 100.0 * std::sqrt(spot.time[i] - 9.9));
    }
    EXPECT_TRUE(dead_in(spot).empty());
    EXPECT_TRUE(dead_stretches(with(80.0, 0.0, 1.0).time, with(80.0, 0.0, 1.0).value, "K", [](double from, double to) {
                    return from < 1.0 && to > 0.95;  // an input jumps with it
                }).empty());
}

// 60 mph for three seconds 0: no car brakes with 27 g. A car that stops within two seconds, stands, and drives on does.
TEST(DeadStretches, ASpeedThatIsLostIsFound) {
    Recorded lost;
    Recorded stops;
    for (double t = 0.0; t < 100.0; t += 0.1) {
        lost.time.push_back(t);
        lost.value.push_back(t >= 40.0 && t < 43.0 ? 0.0 : 26.8 + std::sin(0.3 * t));
        stops.time.push_back(t);
        stops.value.push_back(t < 40.0 ? 20.0 + std::sin(t)
                                       : std::max({0.0, 20.0 - 10.0 * (t - 40.0), 4.0 * (t - 50.0)}));
    }
    ASSERT_EQ(dead_in(lost, "m s-1").size(), 1U);
    EXPECT_NEAR(static_cast<double>(dead_in(lost, "m s-1")[0].length), 30.0, 1.0);
    EXPECT_TRUE(dead_in(stops, "m s-1").empty());
    EXPECT_EQ(sentence_of_dead(dead_in(lost, "m s-1"), lost.time, lost.value, "m s-1").substr(0, 16),
              "stands at 0 km/h");
}

// The logger wakes its channels one by one. The tire starts at what its sensor reads when it speaks, 40.5 degC, and the air is what the log has later, 25 degC.
TEST(DeadStretches, NeitherTireNorAirStartsWithThem) {
    MadeUpLog log(600, 0.1);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.2);
    log.add("speed", "km/h", [](double t) { return t < 5.0 ? 0.0 : 80.0 + 20.0 * std::sin(t); });
    log.add("vertical_load", "N", [](double) { return 4000.0; });
    log.add("road_temperature", "degC", [](double) { return 30.0; });
    log.add("air_temperature", "degC", [&](double t) { return t < 2.0 ? -40.0 : 25.0 + noise(random); });
    log.add("surface_temperature", "degC", [&](double t) { return t < 5.0 ? -1.0 : 40.0 + 0.1 * t + noise(random); });
    const Written written;
    written.add("log.csv", log.text());
    const ExperimentReading reading = read_experiment(
        written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"log.csv\"\n[run.initial]\ntemperature = "
                                                      "\"surface_temperature\"\n"));
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_NEAR(run.problem.initial.front(), 273.15 + 40.5, 0.5);
    EXPECT_NEAR(run.problem.input_signals.at(0.0, solver::JumpSide::after).air_temperature, 298.15, 0.6);
    EXPECT_TRUE(std::isnan(run.series.front().value[10]));
    EXPECT_FALSE(std::isnan(run.series.front().value[60]));
    EXPECT_NE(error_report(reading).find("air_temperature stands at -40 degC from 0 s to 1.9 s and jumps by 6"),
              std::string::npos)
        << error_report(reading);
}

}  // namespace tiretherm::input
