// SPDX-License-Identifier: BSD-3-Clause
// Reads [[sensor]]: its kind, its angle on a ring, derived quantities such as cornering stiffness, and the standard
// deviation.

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "input/model/probes.hpp"
#include "input/model/sensors.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"
#include "mesh/ring.hpp"
#include "physics/celsius.hpp"

namespace tiretherm::input {

namespace {

struct Kind {
    std::string_view name;
    Where (*read)(TomlTable& sensor, const mesh::Mesh& mesh);
    std::string_view meaning;
};
constexpr std::array kinds{
    Kind{"point", read_point, "at a point"},
    Kind{"spot", read_spot, "mean over a disc about the centre of a block or a disc"},
    Kind{"patch", read_patch, "mean over a patch, a part of the boundary"},
    Kind{"layer", read_layer, "mean over a layer, on a section also of one zone"},
    Kind{"region", read_region, "mean over a region: surface or bulk"},
    Kind{"zone", read_zone, "mean over a zone of a section"},
    Kind{"node", read_node, "the gas or the rim"},
    Kind{"strip", read_strip, "mean over the outer surface between two arc lengths, by area"},
};
constexpr std::string_view strips = "strips";

/// What sensors may refer to.
struct SensorSurroundings {
    const solver::Problem& problem;
    bool has_tire = false;
    const GivenSignals& given;
    std::string property_file;                ///< that the case names, empty: none
    std::vector<solver::Channel> channels{};  ///< of the sensors so far
};

/// The sum over the surface nodes of a patch, over its area.
Where read_passage(TomlTable& sensor, solver::Channel channel, const mesh::Mesh& mesh) {
    const Where surface = read_patch(sensor, mesh);
    if (!surface) {
        return std::nullopt;
    }
    const mesh::Patch& patch = mesh.patches[static_cast<std::size_t>(mesh.find_patch(*sensor.text("patch")))];
    for (const mesh::PatchFace& face : patch.faces) {
        if (face.node == face.cell) {
            return sensor.add_error("kind", "a lump has no surface of its own through which heat could pass",
                                    "take a mesh of cells");
        }
        channel.where.nodes.push_back(face.node);
    }
    // The faces give watts each; what a heat-flux sensor reads is their density.
    channel.where.weights.assign(channel.where.nodes.size(), 1.0 / patch.area());
    channel.meaning += ", " + surface->meaning;
    return channel;
}

/// A quantity that follows from inputs, from the heat lost by deformation or from a temperature that another sensor or a
/// region gives.
Where read_quantity(TomlTable& sensor, const solver::QuantityDescription& quantity, const SensorSurroundings& in) {
    const mesh::Mesh& mesh = in.problem.mesh;
    solver::Channel channel{
        .name = {}, .meaning = std::string(quantity.meaning), .where = {}, .quantity = quantity.quantity};
    if (quantity.needs_tire && !in.has_tire) {
        sensor.add_error("kind", fmt::format("{} is that of a tire, and there is no tire", quantity.kind),
                         "add [tire]");
    }
    for (const std::string_view signal : quantity.signals) {
        const bool is_given = in.given.contains(signal) || (signal == "slip_ratio" && in.given.contains("slip_speed"));
        if (!is_given) {
            sensor.add_error("kind", fmt::format("{} follows {}, which [drive] lacks", quantity.kind, signal),
                             fmt::format("add {} to [drive]", signal));
        }
    }
    const physics::Handling& handling = in.problem.handling;
    if (quantity.needs_grip && !handling.grip) {
        return sensor.add_error(
            "kind",
            fmt::format("{} cannot be computed: [tire] lacks how friction follows the temperature", quantity.kind),
            "add [tire.grip]");
    }
    if ((quantity.needs_magic_formula && !handling.magic_formula) || (quantity.needs_peak && !handling.can_corner())) {
        if (in.property_file.empty()) {
            sensor.add_error("kind", fmt::format("{} cannot be computed: the tire has no property file", quantity.kind),
                             quantity.needs_peak ? "add property_file = \"....tir\" to [tire], or [tire.lateral_peak]"
                                                 : "add property_file = \"....tir\" to [tire]");
        } else {
            sensor.add_error(
                "kind", fmt::format("{} cannot be computed: the property file {} could not be used, see its errors",
                                    quantity.kind, in.property_file));
        }
        return std::nullopt;
    }
    if (!quantity.needs_effect.empty() && std::ranges::none_of(in.problem.effects, [&](const auto& active) {
            return active.effect->id == quantity.needs_effect;
        })) {
        sensor.add_error("kind", fmt::format("{} follows {}, which is off", quantity.kind, quantity.needs_effect),
                         fmt::format("switch it on: [effects.{}]", quantity.needs_effect));
    }
    if (quantity.through_patch) {
        return read_passage(sensor, std::move(channel), mesh);
    }
    if (quantity.region.empty()) {
        return channel;
    }
    if (const std::optional<std::string> of = sensor.text("temperature_of")) {
        std::vector<solver::Channel> channels;
        std::ranges::copy_if(in.channels, std::back_inserter(channels),
                             [](const auto& c) { return c.quantity == solver::Quantity::temperature; });
        const auto found = find_name({*of, sensor.place("temperature_of")}, names_of(channels),
                                     "no sensor of a temperature above this one is called", "sensors", sensor.errors());
        if (!found) {
            return std::nullopt;
        }
        channel.where = channels[*found].where;
        channel.meaning += fmt::format(" at {}", *of);
        return channel;
    }
    const int region = mesh.find_region(quantity.region);
    if (region < 0) {
        return sensor.add_error(
            "kind", fmt::format("{} follows the {}, which this case does not have", quantity.kind, quantity.region),
            quantity.region == "gas" ? "switch it on: [effects.inner_gas]" : "name a sensor: temperature_of = \"...\"");
    }
    channel.where = mesh.regions[static_cast<std::size_t>(region)].mean;
    channel.meaning += fmt::format(" at the temperature of the {}", quantity.region);
    return channel;
}

/// What a kind of sensor reads.
solver::Quantity quantity_of(std::string_view kind) {
    const auto found = std::ranges::find(solver::quantities(), kind, &solver::QuantityDescription::kind);
    return found != solver::quantities().end() ? found->quantity : solver::Quantity::temperature;
}

/// The channels of a sensor, without their names: one, or of strips several. Empty after an error.
std::vector<solver::Channel> read_places(TomlTable& sensor, std::string_view kind, const SensorSurroundings& in) {
    if (kind == strips) {
        return read_strips(sensor, in.problem.mesh);
    }
    const auto place = std::ranges::find(kinds, kind, &Kind::name);
    const Where where =
        place != kinds.end()
            ? place->read(sensor, in.problem.mesh)
            : read_quantity(sensor, *std::ranges::find(solver::quantities(), kind, &solver::QuantityDescription::kind),
                            in);
    return where ? std::vector{*where} : std::vector<solver::Channel>{};
}

/// On a ring a sensor reads the mean around the circumference, or one place of the turning rubber.
void read_angle(TomlTable& sensor, const mesh::Mesh& mesh, std::vector<solver::Channel>& found) {
    const std::optional<double> angle = sensor.quantity("angle");
    if (angle && !mesh.is_ring()) {
        sensor.add_error("angle", "only a ring has places around the circumference",
                         "remove angle, or give [mesh] sectors");
    }
    for (solver::Channel& channel : found) {
        const bool of_place = angle && channel.quantity == solver::Quantity::temperature;
        if (mesh.is_ring() && !channel.where.nodes.empty()) {
            channel.where = of_place ? mesh::at_angle(mesh, channel.where, *angle) : mesh::around(mesh, channel.where);
            channel.meaning += of_place
                                   ? fmt::format(", {:.6g} deg around the rubber", *angle * 180.0 / std::numbers::pi)
                                   : ", mean around the circumference";
        }
    }
}

/// "ir" of one channel; "ir_1", "ir_2" ... of several.
std::string numbered(const std::string& name, std::size_t i, std::size_t of) {
    return of == 1 ? name : fmt::format("{}_{}", name, i + 1);
}

/// "camera", or of strips "camera, from -20 to 20 mm".
std::string described(const std::optional<std::string>& meaning, const std::string& place, bool one) {
    if (!meaning) {
        return place;
    }
    return one ? *meaning : *meaning + ": " + place;
}

/// Adds the channels under their names, which nobody else may have.
void add_channels(const TomlTable& sensor, const std::string& name, std::vector<solver::Channel> found,
                  std::vector<solver::Channel>& channels) {
    for (std::size_t i = 0; i < found.size(); ++i) {
        found[i].name = numbered(name, i, found.size());
        const bool taken = std::any_of(channels.begin(), channels.end(),
                                       [&](const auto& other) { return other.name == found[i].name; });
        if (taken && !name.empty()) {
            sensor.add_error("name", fmt::format("a second sensor is called \"{}\"", found[i].name), "rename one");
        }
        channels.push_back(std::move(found[i]));
    }
}

/// No property file tells at which temperature its tire was measured.
void say_temperature_of_file(const TomlTable& root, const TomlValue& file, const physics::Handling& handling,
                             const std::vector<solver::Channel>& channels) {
    using enum solver::Quantity;
    const bool is_said = handling.replaces_stiffness || handling.stiffness_table || !handling.magic_formula ||
                         root.content().find({"tire", "modulus", "reference_temperature"}) != nullptr;
    const auto follows = std::ranges::find_if(channels, [](const solver::Channel& channel) {
        return channel.quantity == cornering_stiffness || channel.quantity == bulk_temperature_factor ||
               channel.quantity == lateral_force;
    });
    if (!is_said && follows != channels.end()) {
        root.errors().warn(
            file.place,
            "the cornering stiffness of {} is taken for that at a bulk of {:g} degC, from where {} follows the "
            "temperature: give reference_temperature in [tire.modulus], or tuned = true where the moduli are "
            "those of this tire",
            file.text, celsius(handling.reference_temperature), follows->name);
    }
}

}  // namespace

std::vector<SensorKind> sensor_kinds() {
    std::vector<SensorKind> all;
    for (const Kind& kind : kinds) {
        all.push_back({.name = kind.name, .meaning = kind.meaning, .is_place = true});
    }
    all.push_back({.name = strips, .meaning = "several strips side by side: NAME_1, NAME_2 ...", .is_place = true});
    for (const solver::QuantityDescription& quantity : solver::quantities()) {
        if (!quantity.kind.empty()) {
            all.push_back({.name = quantity.kind, .meaning = quantity.meaning, .is_place = false});
        }
    }
    return all;
}

bool is_channel_of(std::string_view channel, std::string_view sensor) {
    if (!channel.starts_with(sensor)) {
        return false;
    }
    const std::string_view rest = channel.substr(sensor.size());
    return rest.empty() || (rest.size() > 1 && rest.front() == '_' &&
                            rest.find_first_not_of("0123456789", 1) == std::string_view::npos);
}

std::vector<std::string> sensor_names(const TomlValue& document) {
    std::vector<std::string> names;
    const TomlValue* sensors = document.find("sensor");
    for (const TomlValue& sensor : sensors != nullptr ? sensors->items : std::vector<TomlValue>{}) {
        const TomlValue* name = sensor.find("name");
        const TomlValue* kind = sensor.find("kind");
        const TomlValue* count = sensor.find("count");
        if (name == nullptr || name->kind != TomlValue::Kind::text) {
            continue;
        }
        const bool several =
            kind != nullptr && kind->text == strips && count != nullptr && count->number <= most_strips;
        const std::size_t of = several ? static_cast<std::size_t>(std::max(1.0, count->number)) : 1;
        for (std::size_t i = 0; i < of; ++i) {
            names.push_back(numbered(name->text, i, of));
        }
    }
    return names;
}

std::vector<solver::Channel> read_sensors(TomlTable& root, const solver::Problem& problem, bool has_tire,
                                          const GivenSignals& given) {
    std::vector<std::string_view> names;
    std::ranges::transform(sensor_kinds(), std::back_inserter(names), &SensorKind::name);
    const TomlValue* named = root.content().find({"tire", "property_file"});
    SensorSurroundings in{
        .problem = problem, .has_tire = has_tire, .given = given, .property_file = named != nullptr ? named->text : ""};
    root.each("sensor", [&](TomlTable& sensor) {
        const std::optional<std::string> name = sensor.name("name", Need::required);
        const std::optional<std::string> meaning = sensor.text("meaning");
        const std::optional<std::size_t> kind = sensor.choice("kind", names);
        // Files of results have a column of this name, and formulas of user effects a signal.
        if (name == "time") {
            sensor.add_error("name", "time is the name of the clock", "rename the sensor");
        }
        std::optional<double> sigma;
        if (kind) {
            sigma = sensor.quantity("standard_deviation", deviation_spec(quantity_of(names[*kind])));
        } else {
            sensor.declare_keys({"standard_deviation"});  // in the unit of nobody knows what
        }
        std::vector<solver::Channel> found;
        if (kind && problem.mesh.n_nodes > 0) {
            found = read_places(sensor, names[*kind], in);
            read_angle(sensor, problem.mesh, found);
        } else {
            for (const std::string_view key : {"depth", "x", "y", "radius", "from", "to", "angle"}) {
                sensor.quantity(key, quantity_specs::coordinate, Need::optional);
            }
            sensor.allow_unknown_keys();
        }
        if (found.empty()) {
            found.emplace_back();  // others may refer to it
        } else {
            for (solver::Channel& channel : found) {
                channel.standard_deviation = sigma;
                channel.meaning = described(meaning, channel.meaning, found.size() == 1);
            }
        }
        add_channels(sensor, name.value_or(""), std::move(found), in.channels);
    });
    if (in.channels.empty() && !root.has("camera")) {
        root.errors().warn(root.place(), "the case has no [[sensor]]: no channels are written");
    }
    if (named != nullptr) {
        say_temperature_of_file(root, *named, problem.handling, in.channels);
    }
    return std::move(in.channels);
}

}  // namespace tiretherm::input
