#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "input/effects/effect_requirements.hpp"
#include "input/model/channel_value.hpp"
#include "input/model/probes.hpp"
#include "input/model/problem_builder.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "mesh/ring.hpp"

namespace tiretherm::input {

namespace {

struct Kind {
    std::string_view name;
    Where (*read)(TomlTable& sensor, const mesh::Mesh& mesh);
};
constexpr std::array kinds{Kind{"point", read_point}, Kind{"spot", read_spot},     Kind{"patch", read_patch},
                           Kind{"layer", read_layer}, Kind{"region", read_region}, Kind{"zone", read_zone},
                           Kind{"node", read_node},   Kind{"strip", read_strip}};
constexpr std::string_view strips = "strips";

/// What else than a temperature a sensor may read. `meaning` says it where the case does not.
struct Reading {
    std::string_view name;
    solver::Quantity quantity;
    std::string_view meaning;
    std::string_view region;  ///< whose temperature it follows, unless the case names a sensor
    bool needs_magic_formula = false;
    std::string_view needs_effect{};
};
constexpr std::array readings{
    Reading{"drag_force", solver::Quantity::drag_force, "rolling resistance, as a force at the axle", ""},
    Reading{"rolling_moment", solver::Quantity::rolling_moment, "rolling resistance, as a moment about the axle", ""},
    Reading{"loaded_radius", solver::Quantity::loaded_radius, "radius under load", ""},
    Reading{"cornering_stiffness", solver::Quantity::cornering_stiffness, "cornering stiffness", "bulk"},
    Reading{"bulk_temperature_factor", solver::Quantity::bulk_temperature_factor,
            "cornering stiffness over that of the Magic Formula, lambda_Tb", "bulk", true},
    Reading{"lateral_force", solver::Quantity::lateral_force,
            "lateral force in pure slip, Magic Formula with the cornering stiffness", "bulk", true},
    Reading{"reference_lateral_force", solver::Quantity::reference_lateral_force,
            "lateral force in pure slip, Magic Formula without temperature", "", true},
    Reading{"longitudinal_force", solver::Quantity::longitudinal_force,
            "longitudinal force in pure slip, Magic Formula without temperature", "", true},
    Reading{"surface_at_entry", solver::Quantity::surface_at_entry,
            "outer surface where it meets the road, in each revolution", "surface", false, "resolved_contact"},
    Reading{"surface_at_exit", solver::Quantity::surface_at_exit,
            "outer surface where it leaves the road, in each revolution", "surface", false, "resolved_contact"},
    Reading{"gas_pressure", solver::Quantity::gas_pressure, "inflation pressure above the atmosphere", "gas"},
};

/// A quantity that follows from inputs, from the heat lost by deformation or from a temperature that another sensor or a
/// region gives.
Where read_quantity(TomlTable& sensor, const Reading& reading, const ProblemBuilder& builder) {
    const mesh::Mesh& mesh = builder.problem.mesh;
    solver::Channel channel{
        .name = {}, .meaning = std::string(reading.meaning), .where = {}, .quantity = reading.quantity};
    if (!builder.has_tire && reading.quantity != solver::Quantity::gas_pressure) {
        sensor.add_error("kind", fmt::format("{} is that of a tire, and there is no tire", reading.name), "add [tire]");
    }
    for (const std::string_view signal : signals_of(reading.quantity)) {
        if (!builder.given.contains(signal)) {
            sensor.add_error("kind", fmt::format("{} follows {}, which [drive] lacks", reading.name, signal),
                             fmt::format("add {} to [drive]", signal));
        }
    }
    if (reading.needs_magic_formula && !builder.problem.handling.magic_formula) {
        sensor.add_error(
            "kind",
            fmt::format("{} cannot be computed: the tire has no property file that could be used", reading.name),
            "add property_file = \"....tir\" to [tire]");
        return std::nullopt;
    }
    if (!reading.needs_effect.empty() && std::ranges::none_of(builder.problem.effects, [&](const auto& active) {
            return active.effect->id == reading.needs_effect;
        })) {
        sensor.add_error("kind", fmt::format("{} follows {}, which is off", reading.name, reading.needs_effect),
                         fmt::format("switch it on: [effects.{}]", reading.needs_effect));
    }
    if (reading.region.empty()) {
        return channel;
    }
    if (const std::optional<std::string> of = sensor.text("temperature_of")) {
        std::vector<solver::Channel> channels;
        std::ranges::copy_if(builder.problem.channels, std::back_inserter(channels),
                             [](const auto& c) { return c.quantity == solver::Quantity::temperature; });
        const auto found = std::find_if(channels.begin(), channels.end(), [&](const auto& c) { return c.name == *of; });
        if (found == channels.end()) {
            sensor.add_error("temperature_of",
                             fmt::format("no sensor of a temperature above this one is called \"{}\"", *of),
                             suggest(*of, names_of(channels), "sensors"));
            return std::nullopt;
        }
        channel.where = found->where;
        channel.meaning += fmt::format(" at {}", *of);
        return channel;
    }
    const int region = mesh.find_region(reading.region);
    if (region < 0) {
        sensor.add_error(
            "kind", fmt::format("{} follows the {}, which this case does not have", reading.name, reading.region),
            reading.region == "gas" ? "switch it on: [effects.inner_gas]" : "name a sensor: temperature_of = \"...\"");
        return std::nullopt;
    }
    channel.where = mesh.regions[static_cast<std::size_t>(region)].mean;
    channel.meaning += fmt::format(" at the temperature of the {}", reading.region);
    return channel;
}

/// What a [[sensor]] may be, by its key `kind`.
std::vector<std::string_view> kind_names() {
    std::vector<std::string_view> names;
    const auto name_of = [](const auto& kind) { return kind.name; };
    std::transform(kinds.begin(), kinds.end(), std::back_inserter(names), name_of);
    names.push_back(strips);
    std::transform(readings.begin(), readings.end(), std::back_inserter(names), name_of);
    return names;
}

/// The channels of a sensor, without their names: one, or of strips several. Empty after an error.
std::vector<solver::Channel> read_places(TomlTable& sensor, std::string_view kind, const ProblemBuilder& builder) {
    if (kind == strips) {
        return read_strips(sensor, builder.problem.mesh);
    }
    const auto by_name = [&](const auto& candidate) { return candidate.name == kind; };
    const auto place = std::find_if(kinds.begin(), kinds.end(), by_name);
    const Where where = place != kinds.end()
                            ? place->read(sensor, builder.problem.mesh)
                            : read_quantity(sensor, *std::find_if(readings.begin(), readings.end(), by_name), builder);
    return where ? std::vector{*where} : std::vector<solver::Channel>{};
}

/// On a ring a sensor reads the mean around the circumference, or one place of the turning rubber.
void read_angle(TomlTable& sensor, const mesh::Mesh& mesh, std::vector<solver::Channel>& found) {
    const std::optional<double> angle = sensor.quantity("angle", {.unit = "radian", .low = -1e3, .high = 1e3});
    if (angle && mesh.sectors == 1) {
        sensor.add_error("angle", "only a ring has places around the circumference",
                         "remove angle, or give [mesh] sectors");
    }
    for (solver::Channel& channel : found) {
        const bool of_place = angle && channel.quantity == solver::Quantity::temperature;
        if (mesh.sectors > 1 && !channel.where.nodes.empty()) {
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
                  ProblemBuilder& builder) {
    std::vector<solver::Channel>& channels = builder.problem.channels;
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

}  // namespace

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

void read_sensors(TomlTable& root, ProblemBuilder& builder) {
    const std::vector<std::string_view> names = kind_names();
    root.each("sensor", [&](TomlTable& sensor) {
        const std::optional<std::string> name = sensor.name("name", Need::required);
        const std::optional<std::string> meaning = sensor.text("meaning");
        const std::optional<std::size_t> kind = sensor.choice("kind", names, Need::required);
        if (name == "time") {
            sensor.add_error("name", "time is the name of the clock", "rename the sensor");
        }
        std::vector<solver::Channel> found;
        if (kind && builder.has_mesh) {
            found = read_places(sensor, names[*kind], builder);
            read_angle(sensor, builder.problem.mesh, found);
        } else {
            for (const std::string_view key : {"depth", "x", "y", "radius", "from", "to", "angle"}) {
                sensor.quantity(key, quantity_specs::coordinate);
            }
            sensor.declare_keys({"standard_deviation"});
            sensor.allow_unknown_keys();
        }
        if (found.empty()) {
            sensor.declare_keys({"standard_deviation"});
            found.emplace_back();  // others may refer to it
        } else {
            const auto sigma = sensor.quantity("standard_deviation", deviation_spec(found.front().quantity));
            for (solver::Channel& channel : found) {
                channel.standard_deviation = sigma;
                channel.meaning = described(meaning, channel.meaning, found.size() == 1);
            }
        }
        add_channels(sensor, name.value_or(""), std::move(found), builder);
    });
    if (builder.problem.channels.empty() && !root.has("camera")) {
        root.errors().warn(root.place(), "the case has no [[sensor]]: no channels are written");
    }
}

}  // namespace tiretherm::input
