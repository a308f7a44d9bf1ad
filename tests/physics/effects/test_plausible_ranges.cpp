// SPDX-License-Identifier: BSD-3-Clause
// The table of plausible ranges: complete, inside what the effects allow, and different for kinds of sensors.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "physics/plausible_ranges.hpp"

namespace tiretherm::physics {

namespace {

const PlausibleRange* range_of(const char* effect, const char* parameter, SensorKind sensor = SensorKind::any) {
    const Effect* found = find_effect(effect);
    const int index = found == nullptr ? -1 : find_parameter(*found, parameter);
    return index < 0 ? nullptr : plausible_range(*found, static_cast<std::size_t>(index), sensor);
}

}  // namespace

// An effect that is absent is plausible, and what a case may not say is not.
TEST(PlausibleRanges, EveryParameterThatCanBeACauseHasOneThatHoldsItsAbsence) {
    for (const Effect* effect : catalogue()) {
        for (std::size_t p = 0; p < effect->parameters.size(); ++p) {
            const ParameterSpec& spec = effect->parameters[p];
            for (const SensorKind sensor :
                 {SensorKind::any, SensorKind::infrared, SensorKind::probe, SensorKind::gas}) {
                const PlausibleRange* range = plausible_range(*effect, p, sensor);
                const std::string name = std::string(effect->id) + "." + std::string(spec.key);
                if (range == nullptr) {
                    EXPECT_TRUE(std::isnan(spec.absent)) << name;
                    continue;
                }
                EXPECT_LT(range->low, range->high) << name;
                EXPECT_GE(range->low, spec.low) << name;
                EXPECT_LE(range->high, spec.high) << name;
                if (!std::isnan(spec.absent)) {
                    EXPECT_TRUE(is_plausible(*effect, p, spec.absent, sensor)) << name;
                }
                if (effect->on) {  // the thesis's own numbers
                    EXPECT_TRUE(is_plausible(*effect, p, spec.standard, sensor)) << name;
                }
            }
        }
    }
}

TEST(PlausibleRanges, EachHasASourceAndAReasonAndBelongsToAParameterOnce) {
    std::set<std::tuple<std::string_view, std::string_view, SensorKind>> seen;
    for (const PlausibleRange& range : plausible_ranges()) {
        const std::string name = std::string(range.effect) + "." + std::string(range.parameter);
        EXPECT_TRUE(seen.insert({range.effect, range.parameter, range.sensor}).second) << name << " is there twice";
        EXPECT_GE(range.source.size(), 10U) << name;
        EXPECT_GE(range.why.size(), 10U) << name;
        const Effect* effect = find_effect(range.effect);
        if (effect == nullptr) {
            EXPECT_EQ(range.effect, "input_delay");  // an effect of the catalogue that may come
            continue;
        }
        const bool is_law = range.effect == "conduction" && plausible_range_of_law(range.parameter) == &range;
        EXPECT_TRUE(is_law || range.parameter == "*" || find_parameter(*effect, range.parameter) >= 0) << name;
        EXPECT_TRUE(range.sensor == SensorKind::any || effect->sensor_model() != nullptr) << name;
    }
    EXPECT_EQ(plausible_range_of_law("viscosity"), nullptr);
}

// By the kind of the sensor: 3 s for infrared, 30 s for a probe, 180 s in the gas and where nothing is known of it. A lag
// of 12 s is a probe's, not that of an infrared sensor.
TEST(PlausibleRanges, ALagIsJudgedByTheKindOfSensor) {
    EXPECT_EQ(range_of("sensor_lag", "tau", SensorKind::infrared)->high, 3.0);
    EXPECT_EQ(range_of("sensor_lag", "tau", SensorKind::probe)->high, 30.0);
    EXPECT_EQ(range_of("sensor_lag", "tau", SensorKind::gas)->high, 180.0);
    EXPECT_EQ(range_of("sensor_lag", "tau")->high, 180.0);
    EXPECT_TRUE(is_plausible(*range_of("sensor_lag", "tau", SensorKind::probe), 12.0));
    EXPECT_FALSE(is_plausible(*range_of("sensor_lag", "tau", SensorKind::infrared), 12.0));
    // No range of its own for gas: the one for any sensor.
    EXPECT_EQ(range_of("sensor_gain", "excess", SensorKind::gas), range_of("sensor_gain", "excess"));
}

// Sizes that no engineer would believe: a layer that conducts 14 times as well, half the speed, a tread that takes all
// the heat of sliding. All are within what a case may say.
TEST(PlausibleRanges, SizesThatNobodyWouldBelieveAreOutside) {
    EXPECT_FALSE(is_plausible(*range_of("layer_conductivity", "scale"), 14.0));
    EXPECT_FALSE(is_plausible(*range_of("speed_input_gain", "gain"), 0.9));
    EXPECT_FALSE(is_plausible(*range_of("sliding_friction", "partition"), 1.0));
    EXPECT_FALSE(is_plausible(*range_of("road_temperature_drift", "rate"), 40.0));
    EXPECT_TRUE(is_plausible(*range_of("layer_conductivity", "scale"), 1.2));
    // Nothing is known of the conductivity of air in a law: everything is plausible.
    const Effect& air = *find_effect("air_convection");
    EXPECT_TRUE(is_plausible(air, static_cast<std::size_t>(find_parameter(air, "air_viscosity")), 1e-3));
}

}  // namespace tiretherm::physics
