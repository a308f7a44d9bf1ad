// SPDX-License-Identifier: BSD-3-Clause
// [[instrument]] and instruments that are assumed by names and places of sensors.

#include <cmath>

#include <gtest/gtest.h>

#include "input/columns/instruments.hpp"
#include "input/measurements/made_up_log.hpp"

namespace tiretherm::input {

namespace {

/// A sensor of a region of the bench.
std::string sensor(const std::string& name, const std::string& region, const std::string& deviation = "") {
    return "[[sensor]]\nname = \"" + name + "\"\nkind = \"region\"\nregion = \"" + region + "\"\n" +
           (deviation.empty() ? "" : "standard_deviation = \"" + deviation + "\"\n");
}

/// A log of the bench with a column for each of these sensors.
MadeUpLog log_of(const std::vector<std::string>& sensors) {
    MadeUpLog log(60, 5.0);
    log.add("speed", "km/h", [](double t) { return t < 20.0 ? 0.0 : 80.0; });
    log.add("vertical_load", "N", [](double) { return 4000.0; });
    log.add("air_temperature", "degC", [](double) { return 25.0; });
    log.add("road_temperature", "degC", [](double) { return 30.0; });
    double shift = 0.0;
    for (const std::string& name : sensors) {
        shift += 1.0;
        log.add(name, "degC", [&](double t) { return 45.0 - 20.0 * std::exp(-t / 150.0) + 0.3 * std::sin(t * shift); });
    }
    return log;
}

/// "name: sensor, sensor" of each, with a star where it is assumed.
std::vector<std::string> instruments(const std::vector<std::string>& logged, const std::string& more) {
    const ExperimentReading reading = read_logs({log_of(logged)}, more);
    std::vector<std::string> found;
    EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
    if (reading.experiment) {
        for (const Instrument& one : reading.experiment->instruments) {
            std::string& text = found.emplace_back(one.name + (one.assumed ? " *:" : ":"));
            for (const std::size_t channel : one.channels) {
                text += " " + reading.experiment->runs.front().problem.channels[channel].name;
            }
        }
    }
    return found;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST(Instruments, AreStatedByNamesAndPatterns) {
    const std::string sensors = sensor("probe_a", "bulk") + sensor("ir_1", "surface") + sensor("ir_2", "surface");
    EXPECT_EQ(instruments({"probe_a", "ir_1", "ir_2"},
                          sensors + "[[instrument]]\nname = \"amplifier\"\nsensors = [\"probe_a\", \"ir_*\"]\n"),
              Texts{"amplifier: probe_a ir_1 ir_2"});
    // A sensor may be behind two of them: an array and the amplifier that reads it.
    EXPECT_EQ(instruments({"probe_a", "ir_1", "ir_2"},
                          sensors + "[[instrument]]\nname = \"amplifier\"\nsensors = [\"probe_a\", \"ir_*\"]\n"
                                    "[[instrument]]\nname = \"array\"\nsensors = \"ir_?\"\n"),
              (Texts{"amplifier: probe_a ir_1 ir_2", "array: ir_1 ir_2"}));
}

// What was not measured has no error: an instrument with one measured sensor is none.
TEST(Instruments, HaveMeasuredSensors) {
    const std::string sensors = sensor("ir_1", "surface") + sensor("ir_2", "surface") + sensor("ir_3", "surface") +
                                "[[instrument]]\nname = \"array\"\nsensors = [\"ir_*\"]\n";
    EXPECT_EQ(instruments({"ir_1", "ir_3"}, sensors), Texts{"array: ir_1 ir_3"});
    EXPECT_EQ(instruments({"ir_1"}, sensors), Texts{});
}

TEST(Instruments, AreAssumedByNumbersAndPlaces) {
    EXPECT_EQ(instruments({"ir_1", "ir_2", "ir_3"},
                          sensor("ir_1", "surface") + sensor("ir_2", "surface") + sensor("ir_3", "surface")),
              Texts{"ir_1 to ir_3, 3 sensors *: ir_1 ir_2 ir_3"});
    EXPECT_EQ(instruments({"surface_inside", "surface_centre"},
                          sensor("surface_inside", "surface") + sensor("surface_centre", "surface")),
              Texts{"surface_inside and surface_centre *: surface_inside surface_centre"});
    // The surface and the bulk of the bench are read by different devices, and so are one number at different places.
    EXPECT_EQ(instruments({"surface_temperature", "bulk_temperature"}, ""), Texts{});
    EXPECT_EQ(instruments({"t_1", "t_2"}, sensor("t_1", "surface") + sensor("t_2", "bulk")), Texts{});
}

TEST(Instruments, AreAssumedOfSurfacesWithOneDeviation) {
    EXPECT_EQ(instruments({"pyrometer", "array"},
                          sensor("pyrometer", "surface", "0.5 K") + sensor("array", "surface", "0.5 K")),
              Texts{"pyrometer and array *: pyrometer array"});
    EXPECT_EQ(instruments({"pyrometer", "array"},
                          sensor("pyrometer", "surface", "0.5 K") + sensor("array", "surface", "0.7 K")),
              Texts{});
    EXPECT_EQ(instruments({"probe", "needle"}, sensor("probe", "bulk", "0.5 K") + sensor("needle", "bulk", "0.5 K")),
              Texts{});
}

// Where the case says what reads some sensors, these are in no group that is assumed.
TEST(Instruments, ThatAreStatedLeaveTheRestToAssume) {
    std::string sensors;
    Texts names;
    for (const char* number : {"1", "2", "3", "4"}) {
        names.push_back(std::string("ir_") + number);
        sensors += sensor(names.back(), "surface");
    }
    EXPECT_EQ(instruments(names, sensors + "[[instrument]]\nname = \"front\"\nsensors = [\"ir_1\", \"ir_2\"]\n"),
              (Texts{"front: ir_1 ir_2", "ir_3 and ir_4 *: ir_3 ir_4"}));
}

}  // namespace tiretherm::input
