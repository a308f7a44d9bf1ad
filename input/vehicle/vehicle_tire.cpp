// SPDX-License-Identifier: BSD-3-Clause
// Where the tires of a car come from: [vehicle] itself, or the property file of [tire].

#include "input/vehicle/vehicle_tire.hpp"

#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/tire_property_file/tir_file.hpp"

namespace tiretherm::input {

namespace {

constexpr QuantitySpec cornering{
    .unit = "N radian-1", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5e3, .usual_high = 1e6};
constexpr QuantitySpec slip{.unit = "N", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5e3, .usual_high = 1e6};
constexpr QuantitySpec friction_spec{
    .unit = "1", .low = 0.0, .high = 10.0, .above = true, .usual_low = 0.2, .usual_high = 2.5};
constexpr QuantitySpec scale{.unit = "1", .low = 0.0, .high = 10.0, .above = true, .usual_low = 0.5, .usual_high = 1.5};

constexpr std::array<std::string_view, 4> stiffness_keys{"front_cornering_stiffness", "rear_cornering_stiffness",
                                                         "front_slip_stiffness", "rear_slip_stiffness"};

/// Factors on the friction and the stiffness of a property file.
struct Scales {
    double friction = 1.0;
    double stiffness = 1.0;
};

void use(const physics::MagicFormula& law, const Scales& scales, const TomlTable& table, VehicleSettings& settings) {
    physics::MagicFormula scaled = law;
    scaled.lambda.mux *= scales.friction;
    scaled.lambda.muy *= scales.friction;
    scaled.lambda.Kx *= scales.stiffness;
    scaled.lambda.Ky *= scales.stiffness;
    settings.has_slip_ratio = scaled.pCx1 != 0.0 && scaled.pDx1 != 0.0;
    for (physics::Axle& axle : settings.vehicle.axles) {
        axle.tire.magic_formula = scaled;
    }
    if (table.has("friction")) {
        table.add_error("friction", "friction belongs to stiffnesses, and the tires are those of a property file",
                        "write friction_scale = 0.9, a factor on that of the file");
    }
}

void read_stiffnesses(TomlTable& table, VehicleSettings& settings) {
    const bool any = table.has("front_cornering_stiffness") || table.has("rear_cornering_stiffness") ||
                     table.has("front_slip_stiffness") || table.has("rear_slip_stiffness");
    if (!any) {
        table.add_error("", "the slips of the tires follow from their stiffness, and none is given",
                        "add property_file = \"....tir\" to [vehicle] or [tire], or front_cornering_stiffness = \"80 "
                        "kN/rad\" and the other three");
        return;
    }
    auto& axles = settings.vehicle.axles;
    axles[0].tire.cornering_stiffness = table.quantity(stiffness_keys[0], cornering, Need::required).value_or(1.0);
    axles[1].tire.cornering_stiffness = table.quantity(stiffness_keys[1], cornering, Need::required).value_or(1.0);
    axles[0].tire.slip_stiffness = table.quantity(stiffness_keys[2], slip, Need::required).value_or(1.0);
    axles[1].tire.slip_stiffness = table.quantity(stiffness_keys[3], slip, Need::required).value_or(1.0);
    const std::optional<double> friction = table.quantity("friction", friction_spec);
    for (physics::Axle& axle : axles) {
        axle.tire.friction = friction.value_or(axle.tire.friction);
    }
    for (const std::string_view key : {"friction_scale", "stiffness_scale"}) {
        if (table.has(key)) {
            table.add_error(key, fmt::format("{} is a factor on a property file, and the tires are stiffnesses", key),
                            "change friction or the stiffnesses themselves");
        }
    }
}

}  // namespace

void read_vehicle_tires(TomlTable& table, const ProblemBuilder& builder, VehicleSettings& settings) {
    table.declare_keys({"property_file", "front_cornering_stiffness", "rear_cornering_stiffness",
                        "front_slip_stiffness", "rear_slip_stiffness", "friction", "friction_scale",
                        "stiffness_scale"});
    std::vector<std::string> stiffnesses;
    for (const std::string_view key : stiffness_keys) {
        if (table.has(key)) {
            stiffnesses.emplace_back(key);
        }
    }
    const Scales scales{.friction = table.quantity("friction_scale", scale).value_or(1.0),
                        .stiffness = table.quantity("stiffness_scale", scale).value_or(1.0)};
    const std::optional<std::string> path = table.text("property_file");
    if (path && !stiffnesses.empty()) {
        table.add_error("property_file",
                        fmt::format("both property_file and {} are given: which is the tire?", listed(stiffnesses)),
                        "keep the property file, or the stiffnesses of both axles");
        return;
    }
    if (path) {
        const SourceLocation mentioned = table.place("property_file");
        const std::filesystem::path beside = std::filesystem::path(table.errors().file(mentioned.file)).parent_path();
        if (const auto file = read_tir_file((beside / *path).lexically_normal(), mentioned, table.errors())) {
            use(file->law, scales, table, settings);
        }
    } else if (stiffnesses.empty() && builder.problem.handling.magic_formula) {
        use(*builder.problem.handling.magic_formula, scales, table, settings);
    } else if (stiffnesses.empty() && table.has("property_file")) {
        return;  // no text, which has been reported
    } else {
        read_stiffnesses(table, settings);
    }
}

}  // namespace tiretherm::input
