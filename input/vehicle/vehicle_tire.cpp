// SPDX-License-Identifier: BSD-3-Clause
// Where the tires of a car come from: [vehicle] itself, or the property file of [tire].

#include "input/vehicle/vehicle_settings.hpp"

#include <array>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"
#include "input/tire_property_file/tir_file.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array stiffnesses{VehicleNumber::front_cornering_stiffness, VehicleNumber::rear_cornering_stiffness,
                                 VehicleNumber::front_slip_stiffness, VehicleNumber::rear_slip_stiffness};

/// The law of a property file that a key names; nothing without the key, or after an error.
std::optional<physics::MagicFormula> law_of(TomlTable& table, std::string_view key) {
    const std::optional<std::string> path = table.text(key);
    if (!path) {
        return std::nullopt;
    }
    const SourceLocation mentioned = table.place(key);
    const auto file = read_tir_file(table.errors().beside(mentioned, *path), mentioned, table.errors());
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
    if (std::ranges::none_of(stiffnesses, [&](VehicleNumber number) { return table.has(spec_of(number).key); })) {
        table.add_error("", "the slips of the tires follow from their stiffness, and none is given",
                        "add property_file = \"....tir\" to [vehicle] or [tire], or front_cornering_stiffness = \"80 "
                        "kN/rad\" and the other three");
        return;
    }
    for (const VehicleNumber number : stiffnesses) {
        take(table, number, settings.numbers, Need::required);
    }
    take(table, VehicleNumber::friction, settings.numbers);
    for (const std::string_view key : {"friction_scale", "stiffness_scale"}) {
        if (table.has(key)) {
            table.add_error(key, fmt::format("{} is a factor on a property file, and the tires are stiffnesses", key),
                            "change friction or the stiffnesses themselves");
        }
    }
}

}  // namespace

void take(TomlTable& table, VehicleNumber number, VehicleNumbers& into, Need need) {
    const VehicleNumberSpec& its = spec_of(number);
    into[number] = table.quantity(its.key, need).value_or(its.absent);
}

void read_vehicle_tires(TomlTable& table, const std::optional<physics::MagicFormula>& of_tire,
                        VehicleSettings& settings) {
    table.declare_keys({"property_file", "rear_property_file", "front_cornering_stiffness", "rear_cornering_stiffness",
                        "front_slip_stiffness", "rear_slip_stiffness", "friction", "friction_scale",
                        "stiffness_scale"});
    std::vector<std::string> given;
    for (const VehicleNumber number : stiffnesses) {
        if (const std::string_view key = spec_of(number).key; table.has(key)) {
            given.emplace_back(key);
        }
    }
    take(table, VehicleNumber::friction_scale, settings.numbers);
    take(table, VehicleNumber::stiffness_scale, settings.numbers);
    const bool has_file = table.text("property_file").has_value();
    const std::optional<physics::MagicFormula> law = law_of(table, "property_file");
    const std::optional<physics::MagicFormula> rear = law_of(table, "rear_property_file");
    if (has_file && !given.empty()) {
        table.add_error("property_file",
                        fmt::format("both property_file and {} are given: which is the tire?", listed(given)),
                        "keep the property file, or the stiffnesses of both axles");
        return;
    }
    if (law) {
        use(*law, rear, table, settings);
    } else if (given.empty() && of_tire) {
        use(*of_tire, rear, table, settings);
    } else if (given.empty() && table.has("property_file")) {
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
