// SPDX-License-Identifier: BSD-3-Clause
// Dead, clipped and stuck sensors are found before any fit, and what they did not measure is left out.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

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
        found.findings.back().starts_with("run1.csv: surface_temperature, bulk_temperature stand still together, "
                                          "from 300 s to 339 s: did the logger stop?"))
        << found.findings.back();
    EXPECT_GE(found.missing(), 40U);
    EXPECT_TRUE(std::isnan(found.surface.value[320]));
}

}  // namespace tiretherm::input
