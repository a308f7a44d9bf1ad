// SPDX-License-Identifier: BSD-3-Clause
// Facts of the effects beside their equations: plausible ranges are complete, inside what the effects allow and different
// for kinds of sensors; groups of like signatures and trial values are of effects and parameters that there are.
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
    for (const Effect* effect : catalogue()) {
        std::set<std::tuple<std::string_view, SensorKind>> seen;
        for (const PlausibleRange& range : effect->plausible) {
            const std::string name = std::string(effect->id) + "." + std::string(range.parameter);
            EXPECT_TRUE(seen.insert({range.parameter, range.sensor}).second) << name << " is there twice";
            EXPECT_GE(range.source.size(), 10U) << name;
            EXPECT_GE(range.why.size(), 10U) << name;
            const bool is_law = effect->id == "conduction" && plausible_range_of_law(range.parameter) == &range;
            EXPECT_TRUE(is_law || range.parameter == "*" || find_parameter(*effect, range.parameter) >= 0) << name;
            EXPECT_TRUE(range.sensor == SensorKind::any || effect->sensor_model() != nullptr) << name;
        }
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

TEST(ConfoundedGroups, AreOfEffectsAndParametersThatThereAreAndStandWithTheirFirst) {
    for (const Effect* effect : catalogue()) {
        for (const ConfoundedGroup& group : effect->confounded) {
            EXPECT_EQ(group.members[0].substr(0, group.members[0].find('.')), effect->id);
            EXPECT_FALSE(group.members[1].empty()) << effect->id;
            EXPECT_GE(group.separated.size(), 10U) << effect->id;
            for (const std::string_view member : group.members) {
                const std::string_view id = member.substr(0, member.find('.'));
                const Effect* named = find_effect(id);
                ASSERT_TRUE(member.empty() || named != nullptr) << member;
                if (id != member) {
                    EXPECT_GE(find_parameter(*named, member.substr(id.size() + 1)), 0) << member;
                }
            }
        }
    }
}

TEST(TrialValues, AreOfParametersThatThereAreAndWithinTheirBounds) {
    for (const Effect* effect : catalogue()) {
        for (const TrialValues& one : effect->trials) {
            SCOPED_TRACE(std::string(effect->id) + "." + std::string(one.parameter));
            const int index = find_parameter(*effect, one.parameter);
            ASSERT_GE(index, 0);
            const ParameterSpec& parameter = effect->parameters[static_cast<std::size_t>(index)];
            EXPECT_FALSE(std::isnan(parameter.absent)) << "is no candidate";
            EXPECT_EQ(std::ranges::count(effect->trials, one.parameter, &TrialValues::parameter), 1) << "twice";
            for (const double value : one.trials) {
                EXPECT_TRUE(value == 0.0 || (value >= parameter.low && value <= parameter.high)) << value;
            }
            if (one.other.empty()) {
                EXPECT_EQ(one.factor, 0.0);
                EXPECT_EQ(one.held[0], 0.0);
                continue;
            }
            const int other_index = find_parameter(*effect, one.other);
            ASSERT_GE(other_index, 0) << one.other;
            const ParameterSpec& other = effect->parameters[static_cast<std::size_t>(other_index)];
            const auto end = std::ranges::find(one.held, 0.0);
            EXPECT_TRUE(std::is_sorted(one.held.begin(), end));
            EXPECT_NE(end - one.held.begin(), 1) << "a single value has no neighbour";
            for (auto value = one.held.begin(); value != end; ++value) {
                EXPECT_GE(*value, other.low);
                EXPECT_LE(*value, other.high);
            }
        }
    }
}

}  // namespace tiretherm::physics
