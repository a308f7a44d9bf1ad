// SPDX-License-Identifier: BSD-3-Clause
// Sensors that were brought to a higher rate: the ratio is found, and one sample for each measured value is kept.

#include <cmath>

#include <gtest/gtest.h>

#include "input/measurements/data_warnings.hpp"
#include "input/measurements/made_up_log.hpp"

namespace tiretherm::input {

namespace {

using How = Resampling::How;

RecordedColumn column_of(std::vector<double> value, double interval = 0.05) {
    RecordedColumn column;
    std::vector<double> time;
    column.name = column.heading = "bulk_temperature";
    column.unit = "degC";
    column.si = "K";
    for (std::size_t i = 0; i < value.size(); ++i) {
        time.push_back(interval * static_cast<double>(i));
    }
    column.time = std::move(time);
    column.value = std::move(value);
    return column;
}

/// A warm-up with noise.
std::vector<double> warm_up(std::size_t n, double noise_of, double length) {
    Noise noise(noise_of, 17);
    std::vector<double> value;
    for (std::size_t i = 0; i < n; ++i) {
        value.push_back(25.0 + 40.0 * (1.0 - std::exp(-static_cast<double>(i) / length)) + noise());
    }
    return value;
}

/// Knots by a rule between them: share of the way from knot k to the next.
template <typename Between>
std::vector<double> spread(const std::vector<double>& knots, std::size_t ratio, std::size_t shift, Between between) {
    std::vector<double> value;
    for (std::size_t i = shift; i < (knots.size() - 4) * ratio; ++i) {
        value.push_back(between(knots, i / ratio + 1, static_cast<double>(i % ratio) / static_cast<double>(ratio)));
    }
    return value;
}

double linear(const std::vector<double>& knots, std::size_t k, double share) {
    return knots[k] + share * (knots[k + 1] - knots[k]);
}
double held(const std::vector<double>& knots, std::size_t k, double) { return knots[k]; }
double rounded(double value, double step) { return step * std::round(value / step); }

/// As a perfect resampler: sinc under a Hann window of 32 knots.
std::vector<double> smooth(const std::vector<double>& knots, std::size_t ratio) {
    std::vector<double> value;
    for (std::size_t i = 16 * ratio; i + 17 * ratio < knots.size() * ratio; ++i) {
        const double at = static_cast<double>(i) / static_cast<double>(ratio);
        double sum = 0.0;
        for (auto k = static_cast<std::size_t>(at) - 15; k <= static_cast<std::size_t>(at) + 16; ++k) {
            const double x = at - static_cast<double>(k);
            const double sinc = x == 0.0 ? 1.0 : std::sin(M_PI * x) / (M_PI * x);
            sum += knots[k] * sinc * 0.5 * (1.0 + std::cos(M_PI * x / 16.0));
        }
        value.push_back(sum);
    }
    return value;
}

}  // namespace

// Knots every 4 samples from the third on; numbers in full and rounded to 0.01 K.
TEST(Resampled, StraightLinesBetweenKnots) {
    for (const double step : {0.0, 0.01}) {
        std::vector<double> value = spread(warm_up(200, 0.3, 60.0), 4, 2, linear);
        for (double& one : value) {
            one = step > 0.0 ? rounded(one, step) : one;
        }
        const Resampling found = resampling_of(column_of(value));
        EXPECT_EQ(found.how, How::linear) << step;
        EXPECT_EQ(found.ratio, 4U);
        EXPECT_EQ(found.first, 2U);  // spread began two samples after a knot
    }
}

TEST(Resampled, HeldValues) {
    const Resampling found = resampling_of(column_of(spread(warm_up(200, 0.3, 60.0), 10, 3, held)));
    EXPECT_EQ(found.how, How::held);
    EXPECT_EQ(found.ratio, 10U);
    EXPECT_EQ(found.first, 7U);
}

// The spectrum ends at a quarter of the highest frequency.
TEST(Resampled, ASmoothInterpolationLeavesTheSpectrumEmpty) {
    const Resampling found = resampling_of(column_of(smooth(warm_up(800, 0.3, 200.0), 4)));
    EXPECT_EQ(found.how, How::smooth);
    EXPECT_EQ(found.ratio, 4U);
}

// 20 Hz with white noise, with noise that a sensor's lag of ten samples has smoothed, and rounded: all are measured.
TEST(Resampled, MeasuredSeriesAreNot) {
    std::vector<double> value = warm_up(4000, 0.3, 1000.0);
    EXPECT_EQ(resampling_of(column_of(value)).how, How::none);
    std::vector<double> lagged{value.front()};
    for (std::size_t i = 1; i < value.size(); ++i) {
        lagged.push_back(lagged.back() + 0.1 * (value[i] - lagged.back()));
    }
    EXPECT_EQ(resampling_of(column_of(lagged)).how, How::none);
    for (double& one : value) {
        one = rounded(one, 0.5);
    }
    EXPECT_EQ(resampling_of(column_of(value)).how, How::none);
}

// Slow and coarse: it stands on its steps for times of all lengths. Without noise, and with a little at the steps' edges.
TEST(Resampled, ACoarseSlowSeriesIsNotHeld) {
    for (const double noise : {0.0, 0.05}) {
        std::vector<double> value = warm_up(3000, noise, 900.0);
        for (double& one : value) {
            one = rounded(one, 0.5);
        }
        EXPECT_EQ(resampling_of(column_of(value)).how, How::none) << noise;
    }
}

// A simulated warm-up without noise, that was heated in pulses of a minute, is as smooth as it is.
TEST(Resampled, ASeriesWithoutNoiseIsNot) {
    std::vector<double> value{25.0};
    for (std::size_t i = 1; i < 3000; ++i) {
        value.push_back(value.back() + (i % 60 < 20 ? 0.2 : 0.0) - 0.004 * (value.back() - 25.0));
    }
    EXPECT_EQ(resampling_of(column_of(value)).how, How::none);
}

TEST(Resampled, OneSampleOfEachMeasuredValueIsKept) {
    const std::vector<double> surface = warm_up(100, 0.3, 30.0);
    const std::vector<double> bulk = spread(surface, 5, 0, linear);
    MadeUpLog log(bulk.size(), 0.1);
    const auto at = [](double t) { return static_cast<std::size_t>(std::lround(t / 0.1)); };
    log.add("speed", "km/h", [&](double t) { return 90.0 + 10.0 * std::sin(t); });
    log.add("vertical_load", "N", [&](double) { return 4000.0; });
    log.add("air_temperature", "degC", [&](double) { return 25.0; });
    log.add("road_temperature", "degC", [&](double) { return 25.0; });
    log.add("bulk_temperature", "degC", [&](double t) { return bulk[at(t)]; });
    const ExperimentReading reading = read_logs({log});
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    ASSERT_EQ(reading.data_warnings.size(), 1U);
    EXPECT_EQ(
        reading.data_warnings.front(),
        "run1.csv: bulk_temperature goes straight from one measured value to the next over 5 samples: a value was "
        "measured every 0.5 s. Fits and diagnoses take one of these samples and leave out the rest");
    const std::vector<double>& value = find_series(reading.experiment->runs.front(), "bulk_temperature")->value;
    for (std::size_t i = 0; i < value.size(); ++i) {
        EXPECT_EQ(std::isnan(value[i]), i % 5 != 0) << i;
    }
    // Inputs keep all their samples.
    EXPECT_EQ(reading.experiment->runs.front().problem.input_signals.series().front().time.size(), bulk.size());
}

}  // namespace tiretherm::input
