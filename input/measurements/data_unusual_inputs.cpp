// SPDX-License-Identifier: BSD-3-Clause
// Data check: inputs that are possible but outside the usual range of tire tests.

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"
#include "input/measurements/usual_units.hpp"
#include "physics/celsius.hpp"

/// Inputs that are possible but unusual.
namespace tiretherm::input {

namespace {

/// What is usual of an input.
struct Usual {
    std::string_view name;
    double low;
    double high;
};
constexpr std::array usual{Usual{"speed", -no_limit, 300.0 * km_h},
                           Usual{"vertical_load", 0.0, 1.5e4},
                           Usual{"slip_angle", -15.0 * degree, 15.0 * degree},
                           Usual{"slip_ratio", -1.0, 1.0},
                           Usual{"lateral_force", -2e4, 2e4},
                           Usual{"longitudinal_force", -2e4, 2e4},
                           Usual{"camber", -10.0 * degree, 10.0 * degree},
                           Usual{"inflation_pressure", 1.0 * bar, 5.0 * bar},
                           Usual{"air_temperature", zero_celsius - 30.0, zero_celsius + 50.0},
                           Usual{"road_temperature", zero_celsius - 30.0, zero_celsius + 70.0},
                           Usual{"laser_power", 0.0, 10.0}};

}  // namespace

std::string find_unusual(const Recording&, const RecordedColumn& column) {
    const auto range = std::find_if(usual.begin(), usual.end(), [&](const Usual& u) { return u.name == column.name; });
    if (!column.is_input || range == usual.end()) {
        return {};
    }
    const auto [low, high] = std::minmax_element(column.value.begin(), column.value.end());
    if (*high > range->high) {
        return fmt::format("reaches {}, which is unusual: it is mostly at most {}", column.show(*high),
                           column.show(range->high));
    }
    if (*low < range->low) {
        return fmt::format("falls to {}, which is unusual: it is mostly at least {}", column.show(*low),
                           column.show(range->low));
    }
    return {};
}

}  // namespace tiretherm::input
