// SPDX-License-Identifier: BSD-3-Clause
// Look-ups in the ranges of the effects.
#include "physics/plausible_ranges.hpp"

#include <algorithm>

namespace tiretherm::physics {

namespace {

const PlausibleRange* find(const Effect& effect, std::string_view parameter, SensorKind sensor) {
    const auto found = std::ranges::find_if(effect.plausible, [&](const PlausibleRange& range) {
        return range.parameter == parameter && range.sensor == sensor;
    });
    return found == effect.plausible.end() ? nullptr : &*found;
}

}  // namespace

const PlausibleRange* plausible_range(const Effect& effect, std::size_t parameter, SensorKind sensor) {
    for (const std::string_view name : {effect.parameters[parameter].key, std::string_view("*")}) {
        for (const SensorKind kind : {sensor, SensorKind::any}) {
            if (const PlausibleRange* range = find(effect, name, kind); range != nullptr) {
                return range;
            }
        }
    }
    return nullptr;
}

const PlausibleRange* plausible_range_of_law(std::string_view law) {
    return find(*find_effect("conduction"), law, SensorKind::any);
}

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
