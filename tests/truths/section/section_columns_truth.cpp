// SPDX-License-Identifier: BSD-3-Clause
// Converts inputs and readings of the section bench to the units of a log.

#include "section/section_columns_truth.hpp"

#include <numbers>

namespace hidden_effects {

namespace {

std::vector<double> converted(std::vector<double> x, double scale, double shift = 0.0) {
    for (double& value : x) {
        value = scale * value + shift;
    }
    return x;
}

}  // namespace

std::vector<Column> section_columns(const SectionProgramme& programme, const SectionTrace& trace,
                                    std::span<const std::string_view> channels) {
    constexpr double celsius = -273.15;
    constexpr double degrees = 180.0 / std::numbers::pi;
    std::vector<Column> columns{{"time [s]", 0, programme.time},
                                {"speed [km/h]", 2, converted(programme.speed, 3.6)},
                                {"vertical_load [N]", 1, programme.vertical_load},
                                {"slip_angle [deg]", 4, converted(programme.slip_angle, degrees)},
                                {"lateral_force [N]", 1, programme.lateral_force},
                                {"camber [deg]", 2, converted(programme.camber, degrees)},
                                {"air_temperature [degC]", 1, converted(programme.air_temperature, 1.0, celsius)},
                                {"road_temperature [degC]", 1, converted(programme.road_temperature, 1.0, celsius)},
                                {"throttle [-]", 3, programme.throttle}};
    for (std::size_t c = 0; c < channels.size(); ++c) {
        columns.push_back({std::string(channels[c]) + " [degC]", 2, converted(trace.channel[c], 1.0, celsius)});
    }
    return columns;
}

}  // namespace hidden_effects
