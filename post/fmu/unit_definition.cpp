// SPDX-License-Identifier: BSD-3-Clause
// UDUNITS knows what a unit is made of; the standard wants its base units one by one.

#include "post/fmu/unit_definition.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "input/text/units.hpp"

namespace tiretherm::post {

namespace {

/// One factor of a product: "m-2".
struct UnitPower {
    std::string_view unit;
    int exponent = 1;
};

/// The factors of "W m-2 K-1", or of "kg.s-3".
std::vector<UnitPower> powers_of(std::string_view product, char between) {
    std::vector<UnitPower> powers;
    while (!product.empty()) {
        const std::size_t end = std::min(product.find(between), product.size());
        const std::string_view word = product.substr(0, end);
        const std::size_t letters = std::min(word.find_first_of("-0123456789"), word.size());
        if (letters > 0) {
            const std::string exponent(word.substr(letters));
            powers.push_back({word.substr(0, letters), exponent.empty() ? 1 : std::stoi(exponent)});
        }
        product.remove_prefix(std::min(end + 1, product.size()));
    }
    return powers;
}

struct DisplayUnit {
    std::string_view of;
    std::string_view name;
    double factor = 1.0;
    double offset = 0.0;  ///< display = factor value + offset
};
constexpr std::array display_units{
    DisplayUnit{"K", "degC", 1.0, -273.15},
    DisplayUnit{"m s-1", "km/h", 3.6},
    DisplayUnit{"radian", "deg", 57.29577951308232},
    DisplayUnit{"Pa", "bar", 1e-5},
};

const DisplayUnit* find_display_unit(std::string_view udunits) {
    const auto found = std::ranges::find(display_units, udunits, &DisplayUnit::of);
    return found != display_units.end() ? &*found : nullptr;
}

}  // namespace

std::string fmi_unit(std::string_view udunits) {
    std::string above;
    std::string below;
    int count_below = 0;
    for (const UnitPower& power : powers_of(udunits, ' ')) {
        std::string& side = power.exponent > 0 ? above : below;
        const int size = std::abs(power.exponent);
        side += fmt::format("{}{}{}", side.empty() ? "" : ".", power.unit == "radian" ? "rad" : power.unit,
                            size == 1 ? "" : std::to_string(size));
        count_below += power.exponent < 0 ? 1 : 0;
    }
    above = above.empty() ? "1" : above;
    return count_below == 0   ? above
           : count_below == 1 ? fmt::format("{}/{}", above, below)
                              : fmt::format("{}/({})", above, below);
}

std::string_view fmi_display_unit(std::string_view udunits) {
    const DisplayUnit* found = find_display_unit(udunits);
    return found != nullptr ? found->name : std::string_view();
}

std::string fmi_unit_definition(std::string_view udunits) {
    const std::string base = input::signature(udunits);
    const auto conversion = input::conversion(udunits, base, input::Scale::absolute);
    if (!std::holds_alternative<input::Conversion>(conversion)) {
        throw std::logic_error(fmt::format("\"{}\" is no unit", udunits));
    }
    std::string definition = fmt::format("<Unit name=\"{}\"><BaseUnit", fmi_unit(udunits));
    for (const UnitPower& power : powers_of(base, '.')) {
        definition += fmt::format(" {}=\"{}\"", power.unit, power.exponent);
    }
    const auto [factor, offset] = std::get<input::Conversion>(conversion);
    if (factor != 1.0) {
        definition += fmt::format(" factor=\"{}\"", factor);
    }
    if (offset != 0.0) {
        definition += fmt::format(" offset=\"{}\"", offset);
    }
    definition += "/>";
    if (const DisplayUnit* shown = find_display_unit(udunits)) {
        definition += fmt::format("<DisplayUnit name=\"{}\" factor=\"{}\" offset=\"{}\"/>", shown->name, shown->factor,
                                  shown->offset);
    }
    return definition + "</Unit>";
}

}  // namespace tiretherm::post
