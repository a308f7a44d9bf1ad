// SPDX-License-Identifier: BSD-3-Clause
// Where the tires of a car come from: [vehicle] itself, or the property file of [tire].

#include "input/vehicle/vehicle_tire.hpp"

#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"
#include "input/tire_property_file/tir_file.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array<std::string_view, 4> stiffness_keys{"front_cornering_stiffness", "rear_cornering_stiffness",
                                                         "front_slip_stiffness", "rear_slip_stiffness"};

void take(TomlTable& table, VehicleNumber number, VehicleSettings& settings, Need need = Need::optional) {
    const VehicleNumberSpec& its = spec_of(number);
    settings.numbers[number] = table.quantity(its.key, need).value_or(its.absent);
}

/// The law of a property file that a key names; nothing without the key, or after an error.
std::optional<physics::MagicFormula> law_of(TomlTable& table, std::string_view key) {
    const std::optional<std::string> path = table.text(key);
    if (!path) {
        return std::nullopt;
    }
    const SourceLocation mentioned = table.place(key);
    const std::filesystem::path beside = std::filesystem::path(table.errors().file(mentioned.file)).parent_path();
    const auto file = read_tir_file((beside / *path).lexically_normal(), mentioned, table.errors());
    return file ? std::optional(file->law_on_the_right()) : std::nullopt;
}

/// @param rear of the rear tires, where they are others
void use(const physics::MagicFormula& law, const std::optional<physics::MagicFormula>& rear, const TomlTable& table,
         VehicleSettings& settings) {
    settings.kind.laws = {law, rear ? *rear : law};
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
    using enum VehicleNumber;
    for (const VehicleNumber number :
         {front_cornering_stiffness, rear_cornering_stiffness, front_slip_stiffness, rear_slip_stiffness}) {
        take(table, number, settings, Need::required);
    }
    take(table, friction, settings);
    for (const std::string_view key : {"friction_scale", "stiffness_scale"}) {
        if (table.has(key)) {
            table.add_error(key, fmt::format("{} is a factor on a property file, and the tires are stiffnesses", key),
                            "change friction or the stiffnesses themselves");
        }
    }
}

}  // namespace

void read_vehicle_tires(TomlTable& table, const std::optional<physics::MagicFormula>& of_tire,
                        VehicleSettings& settings) {
    table.declare_keys({"property_file", "rear_property_file", "front_cornering_stiffness", "rear_cornering_stiffness",
                        "front_slip_stiffness", "rear_slip_stiffness", "friction", "friction_scale",
                        "stiffness_scale"});
    std::vector<std::string> stiffnesses;
    for (const std::string_view key : stiffness_keys) {
        if (table.has(key)) {
            stiffnesses.emplace_back(key);
        }
    }
    take(table, VehicleNumber::friction_scale, settings);
    take(table, VehicleNumber::stiffness_scale, settings);
    const bool has_file = table.text("property_file").has_value();
    const std::optional<physics::MagicFormula> law = law_of(table, "property_file");
    const std::optional<physics::MagicFormula> rear = law_of(table, "rear_property_file");
    if (has_file && !stiffnesses.empty()) {
        table.add_error("property_file",
                        fmt::format("both property_file and {} are given: which is the tire?", listed(stiffnesses)),
                        "keep the property file, or the stiffnesses of both axles");
        return;
    }
    if (law) {
        use(*law, rear, table, settings);
    } else if (stiffnesses.empty() && of_tire) {
        use(*of_tire, rear, table, settings);
    } else if (stiffnesses.empty() && table.has("property_file")) {
        return;  // no text, which has been reported
    } else {
        read_stiffnesses(table, settings);
        if (table.has("rear_property_file")) {
            table.add_error("rear_property_file", "the rear tires have a property file and the front ones stiffnesses",
                            "add property_file = \"....tir\" for the front tires");
        }
    }
}

}  // namespace tiretherm::input
