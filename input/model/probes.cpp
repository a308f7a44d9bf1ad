// SPDX-License-Identifier: BSD-3-Clause
// Turns the keys of each sensor kind into weighted means over nodes and a sentence that says what is read.

#include "input/model/probes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"
#include "mesh/column_probe.hpp"
#include "mesh/probe.hpp"

namespace tiretherm::input {

namespace {

/// What the surface of a mesh looks like: a sensor is placed by other keys on each.
enum class Plan { lumps, strip, section, disc, block };

Plan plan_of(const mesh::Mesh& mesh) {
    if (mesh.is_section()) {
        return Plan::section;
    }
    if (!mesh.grid) {
        return Plan::lumps;
    }
    if (mesh.stack) {
        return Plan::strip;
    }
    return mesh.grid->metric == mesh::Metric::axisymmetric ? Plan::disc : Plan::block;
}

std::string millimetres(double metres) { return fmt::format("{:.6g} mm", metres * 1e3); }

/// The extent of the mesh in words, for a point that lies outside.
std::string extent(const mesh::Mesh& mesh) {
    if (mesh.is_section()) {
        const auto [thin, thick] = std::minmax_element(
            mesh.columns.begin(), mesh.columns.end(),
            [](const mesh::Column& a, const mesh::Column& b) { return a.edge.back() < b.edge.back(); });
        return fmt::format("the mesh goes from {:.6g} to {} along the meridian and is {:.6g} to {} thick",
                           mesh.columns.front().from * 1e3, millimetres(mesh.columns.back().to),
                           thin->edge.back() * 1e3, millimetres(thick->edge.back()));
    }
    const auto span = [&](std::string_view name, std::size_t axis) {
        const std::vector<double>& edge = mesh.grid->edge[axis];
        return fmt::format("{} from {:.6g} to {}", name, edge.front() * 1e3, millimetres(edge.back()));
    };
    std::string depth = "the mesh has " + span("depth", 2);
    switch (plan_of(mesh)) {
        case Plan::lumps:
        case Plan::section:
        case Plan::strip:
            return depth;
        case Plan::disc:
            return fmt::format("{}, {}", depth, span("radius", 0));
        case Plan::block:
            return fmt::format("{}, {}, {}", depth, span("x", 0), span("y", 1));
    }
    return depth;
}

/// "3 mm below the outer surface".
std::string level(double depth, double bottom) {
    if (depth == 0.0) {
        return "outer surface";
    }
    return std::abs(depth - bottom) < 1e-9 * bottom ? "inner surface" : millimetres(depth) + " below the outer surface";
}

/// Index of the part of the mesh that a key names, or an error.
std::optional<int> read_part(TomlTable& sensor, std::string_view key, std::string_view plural,
                             const std::vector<std::string>& known) {
    const std::optional<std::string> name = sensor.text(key, Need::required);
    if (!name) {
        return std::nullopt;
    }
    const auto found =
        find_name({*name, sensor.place(key)}, known, fmt::format("the mesh has no {}", key), plural, sensor.errors());
    return found ? std::optional(static_cast<int>(*found)) : std::nullopt;
}

solver::Channel channel(std::string meaning, mesh::Functional where) {
    return {.name = {}, .meaning = std::move(meaning), .where = std::move(where)};
}

/// Middle of a zone along the meridian. @returns m
double middle_of(const mesh::Mesh& mesh, int zone) {
    double from = 1e300;
    double to = -1e300;
    for (const mesh::Column& column : mesh.columns) {
        if (column.zone == zone) {
            from = std::min(from, column.from);
            to = std::max(to, column.to);
        }
    }
    return 0.5 * (from + to);
}

/// A point of a section: at a place along the meridian, or in the middle of a zone; of several zones the mean.
Where read_section_point(TomlTable& sensor, const mesh::Mesh& mesh) {
    const double depth = sensor.quantity("depth").value_or(0.0);
    const std::optional<double> along = sensor.quantity("along");
    const std::vector<LocatedString> zones = sensor.texts("zones");
    std::vector<double> places;
    std::string where;
    if (zones.empty()) {
        places.push_back(along.value_or(0.0));
        where = along ? fmt::format(", {} along the meridian", millimetres(*along)) : ", centre of the crown";
    } else if (along) {
        sensor.add_error("along", "both along and zones are given", "keep one of them");
    }
    for (const LocatedString& word : zones) {
        const auto zone = find_name(word, mesh.zones, "the mesh has no zone", "zones", sensor.errors());
        if (!zone) {
            return std::nullopt;
        }
        places.push_back(middle_of(mesh, static_cast<int>(*zone)));
        where += fmt::format("{}{}", where.empty() ? ", middle of the " : " and of the ", word.text);
    }
    mesh::Functional mean;
    for (const double s : places) {
        const mesh::Point point{s, 0.0, depth};
        if (!mesh::contains(mesh, point)) {
            return sensor.errors().add(sensor.place(), "the sensor lies outside of the mesh", extent(mesh));
        }
        const mesh::Functional one = mesh::at_point(mesh, point);
        for (std::size_t i = 0; i < one.nodes.size(); ++i) {
            mean.add(one.nodes[i], one.weights[i] / static_cast<double>(places.size()));
        }
    }
    const std::ptrdiff_t column = mesh::column_at(mesh, places.front());
    solver::Channel found =
        channel(level(depth, mesh.columns[static_cast<std::size_t>(column)].edge.back()) + where, std::move(mean));
    // A sensor model that conducts along its wires needs the point; a mean of several has none.
    if (places.size() == 1) {
        found.point = mesh::Point{places.front(), 0.0, depth};
    }
    return found;
}

/// A piece of the meridian. m
struct Reach {
    double from = 0.0;
    double to = 0.0;
};

/// The keys from and to, within the mesh.
std::optional<Reach> read_reach(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::optional<double> from = sensor.quantity("from", Need::required);
    const std::optional<double> to = sensor.quantity("to", Need::required);
    if (plan_of(mesh) != Plan::section) {
        return sensor.add_error("kind", "there are strips only on a section", "take kind = \"patch\"");
    }
    if (!from || !to) {
        return std::nullopt;
    }
    if (*from >= *to) {
        return sensor.add_error(
            "to", "the strip ends where it begins or before",
            "arc lengths run from outboard, negative, to inboard: swap from and to or widen the strip");
    }
    const Reach whole{.from = mesh.columns.front().from, .to = mesh.columns.back().to};
    // The user writes half the width that the mesh has; both may differ in their last digit.
    const double slack = 1e-9 * (whole.to - whole.from);
    if (*from < whole.from - slack || *to > whole.to + slack) {
        return sensor.add_error(*from < whole.from - slack ? "from" : "to", "the strip reaches beyond the mesh",
                                extent(mesh));
    }
    return Reach{.from = std::max(*from, whole.from), .to = std::min(*to, whole.to)};
}

solver::Channel strip(const mesh::Mesh& mesh, const Reach& reach) {
    return channel(fmt::format("outer surface, mean from {:.6g} to {} along the meridian", reach.from * 1e3,
                               millimetres(reach.to)),
                   mesh::over_strip(mesh, reach.from, reach.to));
}

}  // namespace

Where read_point(TomlTable& sensor, const mesh::Mesh& mesh) {
    const Plan plan = plan_of(mesh);
    if (plan == Plan::section) {
        return read_section_point(sensor, mesh);
    }
    if (plan == Plan::lumps) {
        sensor.add_error("kind", "a lump has no points", "take kind = \"layer\" and the lump's name: layer = \"bulk\"");
        sensor.allow_unknown_keys();
        return std::nullopt;
    }
    mesh::Point point{0.0, 0.0, sensor.quantity("depth").value_or(0.0)};
    std::string across;
    if (plan == Plan::disc) {
        point[0] = sensor.quantity("radius").value_or(0.0);
        across = point[0] == 0.0 ? ", on the axis" : fmt::format(", {} from the axis", millimetres(point[0]));
    } else if (plan == Plan::block) {
        point[0] = sensor.quantity("x").value_or(0.0);
        point[1] = sensor.quantity("y").value_or(0.0);
        across = fmt::format(", x = {}, y = {}", millimetres(point[0]), millimetres(point[1]));
    }
    if (!mesh::contains(mesh, point)) {
        return sensor.errors().add(sensor.place(), "the sensor lies outside of the mesh", extent(mesh));
    }
    solver::Channel found = channel(level(point[2], mesh.grid->edge[2].back()) + across, mesh::at_point(mesh, point));
    found.point = point;
    return found;
}

Where read_spot(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::optional<double> radius = sensor.quantity("radius", Need::required);
    const std::optional<int> patch = read_part(sensor, "patch", "patches", names_of(mesh.patches));
    const Plan plan = plan_of(mesh);
    if (plan == Plan::lumps || plan == Plan::strip || plan == Plan::section) {
        return sensor.add_error("kind", "there are spots only on a block and on a disc", "take kind = \"patch\"");
    }
    if (!radius || !patch) {
        return std::nullopt;
    }
    const std::string& name = mesh.patches[static_cast<std::size_t>(*patch)].name;
    if (name != "top" && name != "bottom") {
        return sensor.add_error("patch", fmt::format("a spot lies on top or bottom, not on {}", name),
                                "take kind = \"patch\"");
    }
    const mesh::Grid& grid = *mesh.grid;
    const double room = plan == Plan::disc ? grid.edge[0].back() : std::min(grid.edge[0].back(), grid.edge[1].back());
    if (*radius > room * (1.0 + 1e-9)) {
        return sensor.add_error("radius", "the spot is larger than the mesh", extent(mesh));
    }
    return channel(fmt::format("{}, mean over a disc of {} radius", name, millimetres(*radius)),
                   mesh::over_disc(mesh, *patch, *radius));
}

Where read_patch(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::vector<std::string> names = names_of(mesh.patches);
    const std::optional<int> patch = read_part(sensor, "patch", "patches", names);
    return patch ? Where(channel("mean over the patch " + names[static_cast<std::size_t>(*patch)],
                                 mesh::over_patch(mesh, *patch)))
                 : std::nullopt;
}

Where read_layer(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::optional<int> layer = read_part(sensor, "layer", "layers", mesh.layers);
    const bool in_zone = !mesh.zones.empty() && sensor.has("zone");
    const std::optional<int> zone = in_zone ? read_part(sensor, "zone", "zones", mesh.zones) : std::optional(-1);
    if (!layer || !zone) {
        return std::nullopt;
    }
    std::string meaning = "mean over the layer " + mesh.layers[static_cast<std::size_t>(*layer)];
    if (in_zone) {
        meaning += " in the zone " + mesh.zones[static_cast<std::size_t>(*zone)];
    }
    mesh::Functional where = mesh::over_cells(mesh, *layer, *zone);
    if (where.nodes.empty()) {
        return sensor.add_error("zone", "the layer does not reach into this zone", "name another zone or layer");
    }
    return channel(std::move(meaning), std::move(where));
}

Where read_zone(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::optional<int> zone = read_part(sensor, "zone", "zones", mesh.zones);
    return zone ? Where(channel("mean over the zone " + mesh.zones[static_cast<std::size_t>(*zone)],
                                mesh::over_cells(mesh, -1, *zone)))
                : std::nullopt;
}

Where read_strip(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::optional<Reach> reach = read_reach(sensor, mesh);
    return reach ? Where(strip(mesh, *reach)) : std::nullopt;
}

std::vector<solver::Channel> read_strips(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::optional<int> count = sensor.count("count");
    const std::optional<Reach> reach = read_reach(sensor, mesh);
    const bool inboard_first = sensor.choice("first").value_or(0) == 1;
    std::vector<solver::Channel> strips(static_cast<std::size_t>(count.value_or(0)));
    for (std::size_t i = 0; reach && i < strips.size(); ++i) {
        const double width = (reach->to - reach->from) / static_cast<double>(strips.size());
        const double from = reach->from + static_cast<double>(i) * width;
        strips[inboard_first ? strips.size() - 1 - i : i] = strip(mesh, {.from = from, .to = from + width});
    }
    return strips;
}

Where read_node(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::vector<std::string> names = names_of(mesh.lumped_nodes);
    sensor.declare_keys({"node"});
    if (names.empty() && sensor.has("node")) {
        return sensor.add_error("node", "no active effect brings a node of its own",
                                "switch inner_gas or rim_conduction on");
    }
    const std::optional<int> found = read_part(sensor, "node", "nodes", names);
    if (!found) {
        return std::nullopt;
    }
    const mesh::LumpedNode& node = mesh.lumped_nodes[static_cast<std::size_t>(*found)];
    return channel("the " + node.name, {{node.node}, {1.0}});
}

Where read_region(TomlTable& sensor, const mesh::Mesh& mesh) {
    const std::optional<int> region = read_part(sensor, "region", "regions", names_of(mesh.regions));
    if (!region) {
        return std::nullopt;
    }
    const mesh::Region& found = mesh.regions[static_cast<std::size_t>(*region)];
    return channel("mean over the region " + found.name, found.mean);
}

}  // namespace tiretherm::input
