// SPDX-License-Identifier: BSD-3-Clause
// The table of plausible ranges and the look-ups in it.
#include "physics/plausible_ranges.hpp"

#include <algorithm>
#include <array>

namespace tiretherm::physics {

namespace {

#define RANGE(sensor, effect, parameter, low, high, source, why) \
    PlausibleRange{effect, parameter, low, high, source, why, SensorKind::sensor},
constexpr std::array list{
#include "physics/plausible_ranges.list"
};
#undef RANGE

const PlausibleRange* find(std::string_view effect, std::string_view parameter, SensorKind sensor) {
    const auto found = std::ranges::find_if(list, [&](const PlausibleRange& range) {
        return range.effect == effect && range.parameter == parameter && range.sensor == sensor;
    });
    return found == list.end() ? nullptr : &*found;
}

}  // namespace

std::span<const PlausibleRange> plausible_ranges() { return list; }

const PlausibleRange* plausible_range(const Effect& effect, std::size_t parameter) {
    return plausible_range(effect, parameter, SensorKind::any);
}

const PlausibleRange* plausible_range(const Effect& effect, std::size_t parameter, SensorKind sensor) {
    const std::string_view key = effect.parameters[parameter].key;
    for (const std::string_view name : {key, std::string_view("*")}) {
        for (const SensorKind kind : {sensor, SensorKind::any}) {
            if (const PlausibleRange* range = find(effect.id, name, kind); range != nullptr) {
                return range;
            }
        }
    }
    return nullptr;
}

const PlausibleRange* plausible_range_of_law(std::string_view law) { return find("conduction", law, SensorKind::any); }

bool is_plausible(const Effect& effect, std::size_t parameter, double value, SensorKind sensor) {
    const PlausibleRange* range = plausible_range(effect, parameter, sensor);
    return range == nullptr || is_plausible(*range, value);
}

std::string_view name_of(SensorKind sensor) {
    switch (sensor) {
        case SensorKind::any:
            return "";
        case SensorKind::infrared:
            return "infrared sensor";
        case SensorKind::probe:
            return "probe in rubber";
        case SensorKind::gas:
            return "sensor in the gas";
    }
    return "";
}

}  // namespace tiretherm::physics
