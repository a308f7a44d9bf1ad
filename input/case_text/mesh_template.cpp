// SPDX-License-Identifier: BSD-3-Clause
// What a new case takes from the library's cases of the thesis's tire.
#include "input/case_text/mesh_template.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/case_text/case_writer.hpp"
#include "input/case_text/shipped_cases.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

/// A mesh's cases in the library: the first tells sources and assumptions, the last those of its effects.
struct Library {
    std::string_view what;
    std::array<std::string_view, 2> files;
    std::string_view heat_paths{};  ///< lies over the others; empty: none does
};
constexpr std::array<std::string_view, 4> names{"section", "layers", "two_node", specimen_mesh};
constexpr std::array<Library, 4> libraries{
    Library{"a cross-section", {"section/common.toml", "section/4000N_100kmh.toml"}, "section/all_heat_paths.toml"},
    Library{"layers through the crown", {"layers/common.toml", "layers/two_conductivities.toml"}},
    Library{"two nodes, surface and bulk", {"two_node/common.toml", "two_node/4000N_100kmh.toml"}},
    Library{"a specimen under a laser", {"laser/common.toml", "laser/one_watt.toml"}}};

constexpr QuantitySpec force{.unit = "N"};
constexpr QuantitySpec moment{.unit = "N m"};
constexpr QuantitySpec radius{.unit = "m"};

/// A key of a sensor and its value.
using SensorEntry = std::pair<std::string_view, std::string>;

TemplateSensor extra(const std::string& name, const QuantitySpec& spec, const std::string& kind,
                     std::vector<SensorEntry> more = {}) {
    TemplateSensor sensor{.name = name, .spec = spec, .shipped = false, .lines = {"[[sensor]]"}};
    more.insert(more.begin(), {{"name", name}, {"kind", kind}});
    for (const auto& [key, value] : more) {
        sensor.lines.push_back(entry_line("sensor", key, value));
    }
    return sensor;
}

/// Sensors that the library's case does not have, under the names that logs of one may have.
void add_extra_sensors(MeshTemplate& made, double tread_thickness_mm) {
    if (made.name == "section") {
        for (const std::string zone : {"outside_shoulder", "crown", "inside_shoulder"}) {
            const SensorEntry zones{"zones", fmt::format("[\"{}\"]", zone)};
            made.sensors.push_back(
                extra(zone + "_surface_temperature", quantity_specs::temperature, "point", {zones, {"depth", "0 mm"}}));
            made.sensors.push_back(extra(zone + "_inner_liner_temperature", quantity_specs::temperature, "point",
                                         {zones, {"depth", fmt::format("{:g} mm", tread_thickness_mm)}}));
        }
    }
    made.sensors.push_back(extra("drag_force", force, "drag_force"));
    made.sensors.push_back(extra("rolling_moment", moment, "rolling_moment"));
    made.sensors.push_back(extra("loaded_radius", radius, "loaded_radius"));
}

/// Probes of the library's cases are 10 mm deep in the crown of 12 mm. In a thinner one they are as near to its inner surface.
void raise_probes(MeshTemplate& made, double tread_thickness_mm) {
    constexpr double of_library = 12.0;  // mm
    constexpr std::string_view depth = "10 mm";
    for (TemplateSensor& sensor : made.sensors) {
        for (std::string& line : sensor.lines) {
            if (const std::size_t at = line.find(depth); at != std::string::npos && tread_thickness_mm < of_library) {
                line.replace(at, depth.size(), fmt::format("{:g} mm", tread_thickness_mm - 2.0));
            }
        }
    }
}

/// The lines above the first heading: what is said of sources and assumptions, and the key `sources`.
void take_head(const CasePart& head, MeshTemplate& into) {
    if (into.sources.empty()) {
        into.sources = head.value("sources");
    }
    bool told = false;
    for (const std::string& line : head.lines) {
        told = told || line.starts_with("# Source:");
        if (told && line.starts_with('#')) {
            into.origin.push_back(line);
        }
    }
}

void take(CasePart part, MeshTemplate& into) {
    constexpr std::string_view effects = "effects.";
    const bool of_specimen = into.name == specimen_mesh && part.table.starts_with(effects);  // with its own values
    if (part.table == "mesh" || part.table == "mesh.layer" || part.table == "material" || of_specimen) {
        into.mesh.push_back(std::move(part));
    } else if (part.table.starts_with(effects)) {
        std::erase_if(into.effects, [&](const CasePart& known) { return known.table == part.table; });
        into.effects.push_back(std::move(part));
    } else if (part.table == "drive" || part.table == "initial" || part.table == "time") {
        into.settings.push_back(std::move(part));
    } else if (part.table == "sensor") {
        into.sensors.push_back(
            {.name = part.text("name"), .spec = quantity_specs::temperature, .lines = std::move(part.lines)});
    }
}

}  // namespace

std::string MeshTemplate::setting(std::string_view table, std::string_view key) const {
    for (const CasePart& part : settings) {
        if (part.table == table && !part.value(key).empty()) {
            return part.text(key);
        }
    }
    return {};
}

const TemplateSensor* MeshTemplate::find_sensor(std::string_view wanted) const {
    const auto found = std::ranges::find(sensors, wanted, &TemplateSensor::name);
    return found == sensors.end() ? nullptr : &*found;
}

std::span<const std::string_view> mesh_template_names() { return names; }

MeshTemplate mesh_template(std::string_view name, double tread_thickness_mm) {
    const auto index = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    const Library& library = libraries.at(index);
    MeshTemplate made{.name = std::string(name), .what = std::string(library.what)};
    for (const std::string_view file : {library.files[0], library.files[1], library.heat_paths}) {
        if (file.empty()) {
            continue;
        }
        std::vector<CasePart> parts = cut_case(shipped_case(file));
        if (file != library.files.back()) {
            take_head(parts.front(), made);
        }
        for (std::size_t i = 1; i < parts.size(); ++i) {
            if (file != library.heat_paths && parts[i].table.starts_with("effects.") && made.name != specimen_mesh) {
                parts[i].lines.clear();  // the standard values
            }
            take(std::move(parts[i]), made);
        }
    }
    // A specimen does not roll: it has none of these forces.
    if (made.name != specimen_mesh) {
        raise_probes(made, tread_thickness_mm);
        add_extra_sensors(made, tread_thickness_mm);
    }
    return made;
}

}  // namespace tiretherm::input
