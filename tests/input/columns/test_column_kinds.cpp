// SPDX-License-Identifier: BSD-3-Clause
// Unused columns of a log: what each is, by its name, its unit and its course.

#include <cmath>

#include <gtest/gtest.h>

#include "input/columns/column_kinds.hpp"
#include "input/measurements/made_up_log.hpp"

namespace tiretherm::input {

namespace {

/// How far the tire has come to a steady state after t, a minute after its start. @param tau s
double warm(double t, double tau) { return t < 60.0 ? 0.0 : 1.0 - std::exp(-(t - 60.0) / tau); }

double noise_of(double t) { return 0.3 * std::sin(0.7 * t) * std::cos(3.1 * t); }

double speed_of(double t) { return t < 60.0 ? 0.0 : 90.0 + 30.0 * std::sin(t / 37.0) + 10.0 * std::sin(t / 11.0); }

/// Pedals and brakes that come and go: 1 in some seconds of 40, at moments that follow no simple rule.
double pedal(double t) { return std::sin(t / 6.5) + std::sin(t / 9.7 + 1.0) > 0.4 ? 1.0 : 0.0; }

/// Twenty minutes, a sample a second; the tire rolls from 60 s on, its surface warms in 100 s, its bulk in 400.
MadeUpLog session() {
    MadeUpLog log(1200, 1.0);
    log.add("speed", "km/h", speed_of);
    log.add("vertical_load", "N", [](double t) { return 4000.0 + 500.0 * std::sin(t / 21.0) * std::sin(t / 50.0); });
    log.add("air_temperature", "degC", [](double) { return 25.0; });
    log.add("road_temperature", "degC", [](double) { return 30.0; });
    log.add("surface_temperature", "degC", [](double t) {
        return 25.0 + 20.0 * warm(t, 100.0) + 3.0 * std::sin(t / 90.0) * warm(t, 1.0) + noise_of(t);
    });
    log.add("bulk_temperature", "degC", [](double t) { return 25.0 + 40.0 * warm(t, 400.0) + noise_of(t + 17.0); });
    return log;
}

/// The kind of a column that is added to the session, and why.
ColumnSummary judged(const std::string& name, const std::string& unit, const std::function<double(double)>& value,
                     MadeUpLog log = session()) {
    log.add(name, unit, value);
    const ExperimentReading reading = read_logs({log});
    if (!reading.experiment) {
        ADD_FAILURE() << error_report(reading);
        return {};
    }
    return unused_columns(reading.experiment->runs).back();
}

ColumnKind kind_of(const std::string& name, const std::string& unit, const std::function<double(double)>& value) {
    return judged(name, unit, value).kind;
}

}  // namespace

TEST(ColumnKinds, PedalsAreDrives) {
    const ColumnSummary throttle = judged("throttle", "-", pedal);
    EXPECT_EQ(throttle.kind, ColumnKind::drive) << throttle.reason;
    EXPECT_TRUE(throttle.may_be_cause);
    EXPECT_EQ(kind_of("brake", "bar", [](double t) { return 30.0 * pedal(t + 100.0) * (1.2 + std::sin(t / 5.0)); }),
              ColumnKind::drive);
    EXPECT_EQ(kind_of("gear", "", [](double t) { return std::floor(3.0 + 2.0 * std::sin(t / 14.0)); }),
              ColumnKind::drive);
    // A valve that pulses evenly is no clock, and one that is opened once is none either.
    EXPECT_EQ(kind_of("valve", "-", [](double t) { return std::fmod(t, 40.0) < 10.0 ? 1.0 : 0.0; }), ColumnKind::drive);
    EXPECT_EQ(kind_of("flap", "-", [](double t) { return t < 400.0 ? 0.0 : 1.0; }), ColumnKind::drive);
}

// A slow drive, a sine of 400 s, comes before what it heats: with 100 s the response is 57 degrees, or 64 s, later.
TEST(ColumnKinds, ASlowDriveComesBeforeWhatItHeats) {
    MadeUpLog log = session();
    log.columns[4].value.clear();
    for (const double t : log.time) {
        log.columns[4].value.push_back(35.0 + 5.0 * std::sin((t - 64.0) * 2.0 * M_PI / 400.0) + noise_of(t));
    }
    const ColumnSummary power = judged(
        "heater", "kW", [](double t) { return 2.0 + std::sin(t * 2.0 * M_PI / 400.0); }, log);
    EXPECT_EQ(power.kind, ColumnKind::drive) << power.reason;
}

// The neighbour of an infrared sensor has its temperatures, a little less and later; by its unit it is one of the tire, and
// by its course it is where the unit is missing.
TEST(ColumnKinds, ANeighbouringSensorIsATemperatureOfTheTire) {
    const auto neighbour = [](double t) {
        return 26.0 + 17.0 * warm(t, 110.0) + 2.7 * std::sin(t / 90.0) * warm(t, 1.0) + 0.8 * noise_of(t + 40.0);
    };
    const ColumnSummary by_unit = judged("ir_4", "degC", neighbour);
    EXPECT_EQ(by_unit.kind, ColumnKind::temperature_of_tire);
    EXPECT_FALSE(by_unit.may_be_cause);
    EXPECT_EQ(by_unit.reason, "a temperature, and its name says of nothing that acts on the tire from outside");
    EXPECT_EQ(judged("tread 3", "degF", neighbour).reason, "a temperature of the tire by its name (tread)");
    const ColumnSummary by_course = judged("channel_7", "V", [&](double t) { return 0.01 * neighbour(t); });
    EXPECT_EQ(by_course.kind, ColumnKind::temperature_of_tire) << by_course.reason;
    EXPECT_TRUE(by_course.reason.starts_with("moves like surface_temperature (r = 0.9")) << by_course.reason;
}

TEST(ColumnKinds, TemperaturesFromOutsideAreDrives) {
    const auto disc = [](double t) { return 100.0 + 200.0 * warm(t, 60.0) + 50.0 * pedal(t); };
    EXPECT_EQ(judged("brake_disc_temperature", "degC", disc).reason,
              "a temperature from outside of the tire by its name (brake)");
    EXPECT_EQ(kind_of("gearbox", "degC", disc), ColumnKind::drive);
    EXPECT_EQ(kind_of("Air Temp Track Side", "degC", [](double t) { return 25.0 + std::sin(t / 200.0); }),
              ColumnKind::drive);
    // Whose temperature T7 is its name does not say: 50 K hotter than the tire and before all of its sensors, it heats it.
    const auto pulse = [](double t) { return std::exp(-std::pow((t - 500.0) / 60.0, 2)); };
    MadeUpLog log = session();
    for (std::size_t c : {4U, 5U}) {
        for (std::size_t i = 0; i < log.time.size(); ++i) {
            log.columns[c].value[i] = 25.0 + 20.0 * pulse(log.time[i] - 40.0) + noise_of(log.time[i]);
        }
    }
    const ColumnSummary hot = judged(
        "T7", "degC", [&](double t) { return 40.0 + 100.0 * pulse(t); }, log);
    EXPECT_EQ(hot.kind, ColumnKind::drive) << hot.reason;
    const ColumnSummary late = judged(
        "T7", "degC", [&](double t) { return 40.0 + 100.0 * pulse(t - 80.0); }, log);
    EXPECT_EQ(late.kind, ColumnKind::temperature_of_tire) << late.reason;
}

TEST(ColumnKinds, Copies) {
    const ColumnSummary scaled = judged("v_wheel", "m/s", [](double t) { return speed_of(t) / 3.6 + 1.0; });
    EXPECT_EQ(scaled.kind, ColumnKind::copy);
    EXPECT_EQ(scaled.reason, "a copy of speed (r = 1.0000)");
    MadeUpLog log = session();
    log.add("brake_front", "bar", pedal);
    const ColumnSummary rear = judged(
        "brake_rear", "psi", [](double t) { return 0.6 - 5.0 * pedal(t); }, log);
    EXPECT_EQ(rear.kind, ColumnKind::copy);
    EXPECT_EQ(rear.reason, "a copy of brake_front (r = -1.0000)");
    // Close is not a copy: r = 1 / sqrt(1 + 0.05^2 / var) is some 0.99 for a pedal with a variance near 0.25.
    const ColumnSummary near = judged(
        "brake_rear", "psi", [](double t) { return pedal(t) + 0.1 * std::sin(4.0 * t); }, log);
    EXPECT_EQ(near.kind, ColumnKind::drive) << near.reason;
}

TEST(ColumnKinds, Results) {
    EXPECT_EQ(judged("power_calc", "W", pedal).reason, "computed, by its name (calc)");
    const ColumnSummary drag = judged("drag", "N", [](double t) { return 0.1 * std::pow(speed_of(t), 3.0); });
    EXPECT_EQ(drag.kind, ColumnKind::result);
    EXPECT_EQ(drag.reason, "an exact function of speed");
    const ColumnSummary power = judged("p_roll", "W", [](double t) {
        return 0.01 / 3.6 * speed_of(t) * (4000.0 + 500.0 * std::sin(t / 21.0) * std::sin(t / 50.0));
    });
    EXPECT_EQ(power.kind, ColumnKind::result);
    EXPECT_EQ(power.reason, "follows from inputs: speed * vertical_load (r = 1.0000)");
}

TEST(ColumnKinds, ClocksCountersAndDistances) {
    EXPECT_EQ(judged("Lap Number", "", [](double t) { return std::floor(t / 90.0); }).reason,
              "a time, a counter, a distance or a place by its name (lap)");
    const std::string even = "goes evenly with the time or the way, or counts";
    EXPECT_EQ(judged("logger", "ms", [](double t) { return 1e6 + 1000.0 * t; }).reason, even);
    EXPECT_EQ(judged("turn", "", [](double t) { return std::floor(t / 300.0); }).reason, even);
    // The way of a lap begins anew each 90 s: 40 m/s for the bends of a saw-tooth.
    EXPECT_EQ(judged("progress", "", [](double t) { return std::fmod(t, 90.0); }).reason, even);
    MadeUpLog log = session();
    std::vector<double> way{0.0};
    for (std::size_t i = 1; i < log.time.size(); ++i) {
        way.push_back(way.back() + 0.5 * (speed_of(log.time[i - 1]) + speed_of(log.time[i])) / 3.6);
    }
    EXPECT_EQ(judged(
                  "s_gps", "m", [&](double t) { return way[static_cast<std::size_t>(t)]; }, log)
                  .reason,
              even);
    // Down as well as up: the fuel that is left.
    EXPECT_EQ(judged("fuel", "kg", [](double t) { return 60.0 - 0.02 * t; }).reason, even);
}

// It rises evenly, as a clock does; it is what the gas does that warms up, or the oil's, which may be a cause.
TEST(ColumnKinds, APressureIsNoClock) {
    const auto even = [](double t) { return 2.0 + 0.0005 * t; };
    const ColumnSummary tire = judged("TPMS 3", "bar", even);
    EXPECT_EQ(tire.kind, ColumnKind::result);
    EXPECT_EQ(tire.reason, "a pressure of the tire by its name (tpms), which follows its temperature");
    EXPECT_NE(kind_of("Oil Pressure Lap", "kPa", even), ColumnKind::clock);
}

TEST(ColumnKinds, ConstantsAreNoCauses) {
    EXPECT_EQ(judged("map_switch", "-", [](double) { return 3.0; }).reason, "never changes");
}

// What is constant in one run and moves in another is judged by both, and has one kind in both.
TEST(ColumnKinds, AreThoseOfAllRunsTogether) {
    MadeUpLog first = session();
    MadeUpLog second = session();
    first.add("throttle", "-", [](double) { return 0.0; });
    second.add("throttle", "-", pedal);
    second.add("clutch", "-", [](double t) { return pedal(t + 333.0); });
    const ExperimentReading reading = read_logs({first, second});
    ASSERT_TRUE(reading.experiment.has_value()) << error_report(reading);
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    EXPECT_EQ(runs[0].unused.front().kind, ColumnKind::drive);
    EXPECT_EQ(runs[1].unused.front().kind, ColumnKind::drive);
    EXPECT_EQ(unused_columns(runs).size(), 2U);
}

}  // namespace tiretherm::input
