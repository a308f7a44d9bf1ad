// SPDX-License-Identifier: BSD-3-Clause
// Reads [mesh] kind = "section": crown, shoulders and sidewalls along the meridian, and with `sectors` the ring around
// the circumference.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "input/model/mesh.hpp"
#include "input/text/quantity_specs.hpp"
#include "mesh/ring.hpp"
#include "physics/contact/travelling.hpp"

namespace tiretherm::input {

namespace {

/// How far the profile has turned from the axis where the shoulder ends and where the bead begins. These two angles shape
/// the picture and, through the local radius, the area of shoulders and sidewalls by a few per cent; assumed.
constexpr double turn_at_sidewall = 45.0 / 180.0 * std::numbers::pi;
constexpr double turn_at_bead = 120.0 / 180.0 * std::numbers::pi;

/// One of the three kinds of zone, on both sides of the centre plane but for the crown.
struct MeridianStretch {
    std::string_view word;  ///< in a layer's list of zones
    double length = 0.0;    ///< m
    int cells = 0;          ///< none: the tire has no such zone
    double ratio = 1.0;     ///< bead end's cell over the crown end's
    std::vector<int> stack{};
};

enum : std::size_t { crown, shoulders, sidewalls };

/// Which layers reach into which zones.
bool fill_stacks(TomlTable& mesh, const std::vector<std::vector<LocatedString>>& zones,
                 std::array<MeridianStretch, 3>& stretches) {
    const std::size_t before = mesh.errors().count();
    const std::vector<std::string> known{"crown", "shoulders", "sidewalls"};
    for (std::size_t layer = 0; layer < zones.size(); ++layer) {
        for (const LocatedString& word : zones[layer]) {
            static_cast<void>(find_name(word, known, "there is no zone", "zones", mesh.errors()));
        }
        for (MeridianStretch& stretch : stretches) {
            const auto named = [&](const LocatedString& word) { return word.text == stretch.word; };
            if (zones[layer].empty() || std::any_of(zones[layer].begin(), zones[layer].end(), named)) {
                stretch.stack.push_back(static_cast<int>(layer));
            }
        }
    }
    for (const MeridianStretch& stretch : stretches) {
        if (stretch.cells > 0 && stretch.stack.empty() && mesh.errors().count() == before) {
            mesh.errors().add(mesh.place(), fmt::format("no layer reaches into the {}", stretch.word),
                              fmt::format("name the zone in a layer, or leave it out: {}_cells = 0",
                                          stretch.word.substr(0, stretch.word.size() - 1)));
        }
    }
    return mesh.errors().count() == before;
}

/// The outer profile; gives the sidewalls a length with which it ends at the bead, unless they have one.
mesh::Meridian profile(const physics::Tire& tire, double crown_radius, std::array<MeridianStretch, 3>& stretches) {
    std::vector<mesh::Meridian::Arc> arcs{{.length = 0.5 * stretches[crown].length, .curvature = 1.0 / crown_radius}};
    double turn = arcs.front().length / crown_radius;
    if (const MeridianStretch& shoulder = stretches[shoulders]; shoulder.cells > 0) {
        arcs.push_back({.length = shoulder.length, .curvature = (turn_at_sidewall - turn) / shoulder.length});
        turn = turn_at_sidewall;
    }
    const double tread_end = arcs.front().length + (arcs.size() > 1 ? arcs.back().length : 0.0);
    if (MeridianStretch& wall = stretches[sidewalls]; wall.cells > 0) {
        const double from = mesh::Meridian(tire.unloaded_radius, arcs).at(tread_end).radius;
        const double to = tire.unloaded_radius - tire.section_height;
        const double turned = turn_at_bead - turn;
        if (wall.length <= 0.0) {
            // A profile that turns evenly from angle a to b descends by length (cos a - cos b)/(b - a).
            wall.length = (from - to) * turned / (std::cos(turn) - std::cos(turn_at_bead));
        }
        arcs.push_back({.length = wall.length, .curvature = turned / wall.length});
    }
    return {tire.unloaded_radius, std::move(arcs)};
}

double thickness_of(const mesh::Section& section, const MeridianStretch& stretch) {
    double sum = 0.0;
    for (const int layer : stretch.stack) {
        sum += section.layers[static_cast<std::size_t>(layer)].thickness;
    }
    return sum;
}

/// Whether the profile and what lies inside of it stay clear of the tire's axis.
bool is_sound(TomlTable& mesh, const mesh::Section& section, const std::array<MeridianStretch, 3>& stretches) {
    double reach = 0.5 * stretches[crown].length;
    double thickest = thickness_of(section, stretches[crown]);
    for (const std::size_t zone : {shoulders, sidewalls}) {
        if (stretches[zone].cells > 0) {
            reach += stretches[zone].length;
            thickest = std::max(thickest, thickness_of(section, stretches[zone]));
        }
    }
    double lowest = section.meridian.at(0.0).radius;
    // A profile may come near the axis between its ends, where a sharp shoulder turns inwards.
    for (int i = 0; i <= 100; ++i) {
        const double s = reach * i / 100.0;
        lowest = std::min({lowest, section.meridian.at(s).radius, section.meridian.inside(s, thickest).radius});
    }
    if (lowest < 0.02) {
        mesh.add_error(
            mesh.has("sidewall_length") ? "sidewall_length" : "kind",
            fmt::format(
                "the profile, {:.4g} mm from the centre to the bead, would come within {:.4g} mm of the tire's axis",
                reach * 1e3, lowest * 1e3),
            "shorten the sidewalls or the tread, or flatten the crown");
        return false;
    }
    return true;
}

/// The loss follows the tire's thicknesses (66)(67), the mesh its layers': they should be one tire's.
void warn_of_other_sizes(TomlTable& mesh, const mesh::Section& section, const std::array<MeridianStretch, 3>& stretches,
                         const physics::Tire& tire) {
    const auto warn = [&](std::string_view what, double layers, double stated, std::string_view key) {
        if (std::abs(layers / stated - 1.0) > 0.1) {
            mesh.errors().warn(mesh.place(),
                               "the layers of the {0} are {1:.4g} mm thick, but [tire] says {2:.4g} mm, from which the "
                               "strain-energy loss follows; remedy: [tire] {3} = \"{1:.4g} mm\", or other layers",
                               what, layers * 1e3, stated * 1e3, key);
        }
    };
    warn("crown", thickness_of(section, stretches[crown]), tire.tread_thickness, "tread_thickness");
    if (stretches[sidewalls].cells > 0) {
        warn("sidewalls", thickness_of(section, stretches[sidewalls]), tire.sidewall_thickness, "sidewall_thickness");
    }
    const double tread =
        stretches[crown].length + (stretches[shoulders].cells > 0 ? 2.0 * stretches[shoulders].length : 0.0);
    if (tread > 1.1 * tire.width) {
        mesh.errors().warn(mesh.place("tread_width"), "the tread is {:.4g} mm wide on a tire of {:.4g} mm", tread * 1e3,
                           tire.width * 1e3);
    }
}

std::vector<mesh::Zone> zones_of(const std::array<MeridianStretch, 3>& stretches) {
    std::vector<mesh::Zone> zones;
    const auto add = [&](std::string_view name, const MeridianStretch& s, bool outboard, bool tread) {
        if (s.cells > 0) {
            zones.push_back({.name = std::string(name),
                             .length = s.length,
                             .cells = s.cells,
                             .ratio = outboard ? 1.0 / s.ratio : s.ratio,
                             .stack = s.stack,
                             .tread = tread});
        }
    };
    add("outside_sidewall", stretches[sidewalls], true, false);
    add("outside_shoulder", stretches[shoulders], true, true);
    add("crown", stretches[crown], false, true);
    add("inside_shoulder", stretches[shoulders], false, true);
    add("inside_sidewall", stretches[sidewalls], false, false);
    return zones;
}

double cells_of(const mesh::Section& section) {
    double sum = 0.0;
    for (const mesh::Zone& zone : section.zones) {
        for (const int layer : zone.stack) {
            sum += static_cast<double>(zone.cells) * section.layers[static_cast<std::size_t>(layer)].cells;
        }
    }
    return sum;
}

}  // namespace

bool read_section(TomlTable& mesh, const MeshSource& from, MeshTable& into) {
    const physics::Tire& tire = from.tire.tire;
    if (!from.tire.given) {
        mesh.add_error("kind", "a section is that of a tire, and there is no tire",
                       "add [tire] with size = \"225/50 R17\"");
    }
    const double tread = mesh.quantity("tread_width").value_or(tire.width);
    const double shoulder = mesh.quantity("shoulder_width").value_or(0.2 * tread);
    const double crown_radius = mesh.quantity("crown_radius").value_or(1.0);
    std::array<MeridianStretch, 3> stretches{MeridianStretch{.word = "crown"}, MeridianStretch{.word = "shoulders"},
                                             MeridianStretch{.word = "sidewalls"}};
    stretches[crown].cells = mesh.count("crown_cells").value_or(1);
    stretches[shoulders].cells = mesh.count("shoulder_cells").value_or(0);
    stretches[sidewalls].cells = mesh.count("sidewall_cells").value_or(0);
    stretches[shoulders].ratio = mesh.quantity("shoulder_ratio").value_or(1.0);
    stretches[sidewalls].ratio = mesh.quantity("sidewall_ratio").value_or(1.0);
    stretches[shoulders].length = shoulder;
    stretches[crown].length = tread - (stretches[shoulders].cells > 0 ? 2.0 * shoulder : 0.0);
    stretches[sidewalls].length = mesh.quantity("sidewall_length").value_or(0.0);
    const int sectors = mesh.count("sectors").value_or(1);
    std::vector<std::vector<LocatedString>> zones;
    mesh::Section section;
    section.layers = read_stack(mesh, from, into, &zones);
    if (stretches[crown].length <= 0.0) {
        mesh.add_error("shoulder_width",
                       fmt::format("two shoulders of {:.6g} mm leave no crown of a tread of {:.6g} mm", shoulder * 1e3,
                                   tread * 1e3));
    }
    const bool has_stacks = fill_stacks(mesh, zones, stretches);
    if (stretches[crown].length <= 0.0 || section.layers.empty() || !from.tire.given || !has_stacks) {
        return false;
    }
    section.meridian = profile(tire, crown_radius, stretches);
    if (!is_sound(mesh, section, stretches)) {
        return false;
    }
    warn_of_other_sizes(mesh, section, stretches, tire);
    section.zones = zones_of(stretches);
    if (!is_affordable(mesh, cells_of(section) * sectors, from.limits)) {
        return false;
    }
    into.mesh = build(section);
    if (sectors > 1) {
        into.mesh = mesh::ring(into.mesh, sectors);
    }
    return true;
}

}  // namespace tiretherm::input
