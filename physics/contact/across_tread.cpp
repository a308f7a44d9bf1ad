// SPDX-License-Identifier: BSD-3-Clause
// Means of y and (1 - 3 y^2)/2 over each face of the contact, and weights that are normalised whatever the pressure.

#include "physics/contact/across_tread.hpp"

#include <algorithm>
#include <numeric>

#include "mesh/index.hpp"
#include "physics/contact/heated_road.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics {

void place_contact(const PlacementContext& context, ActiveEffect& active, const std::optional<Curve>& profile) {
    spread_over_patches(context, active, profile);
    place_heated_road(context, active);
    active.skew.clear();
    active.crown.clear();
    if (active.field || !context.mesh.is_section()) {
        return;
    }
    const double half = half_tread(context.mesh);
    for (const int patch : active.patches) {
        for (const mesh::PatchFace& face : context.mesh.patches[at(patch)].faces) {
            // The arc length is negative outboard.
            const double from = std::clamp(-face.extent[0] / half, -1.0, 1.0);
            const double to = std::clamp(-face.extent[1] / half, -1.0, 1.0);
            active.skew.push_back(0.5 * (from + to));
            active.crown.push_back(0.5 * (1.0 - (from * from + from * to + to * to)));
        }
    }
}

void note_across_tread(const Laws& laws, double whole, std::span<double> coefficients) {
    coefficients[coefficients.size() - 2] = whole * laws.contact_skew;
    coefficients.back() = whole * laws.contact_crown;
}

AcrossTread::AcrossTread(const ActiveEffect& active, double skew, double crown, FollowsPressure follows)
    : active_(&active),
      skew_(skew),
      crown_(crown),
      even_(active.skew.empty() || (skew == 0.0 && crown == 0.0)),
      by_root_(follows == FollowsPressure::by_root) {
    if (!even_) {
        double sum = 0.0;
        for (std::size_t i = 0; i < active.weights.size(); ++i) {
            sum += loaded(i);
        }
        even_ = sum <= 0.0;  // a profile without weight where the pressure is
        scale_ = even_ ? 1.0 : std::accumulate(active.weights.begin(), active.weights.end(), 0.0) / sum;
    }
}

double relative_contact_pressure(const mesh::Mesh& mesh, std::span<const ActiveEffect> effects, const Laws& laws,
                                 std::string_view zone) {
    const auto contact = std::ranges::find_if(effects, [](const ActiveEffect& e) { return !e.crown.empty(); });
    const int wanted = mesh.find_zone(zone);
    if (contact == effects.end() || wanted < 0) {
        return 1.0;
    }
    const AcrossTread across(*contact, laws.contact_skew, laws.contact_crown);
    double load = 0.0;
    double all_load = 0.0;
    double area = 0.0;
    double all_area = 0.0;
    std::size_t i = 0;
    for (const int patch : contact->patches) {
        for (const mesh::PatchFace& face : mesh.patches[at(patch)].faces) {
            const double share = mesh.zone[at(face.cell)] == wanted ? 1.0 : 0.0;
            const double weight = across.weight(i++);
            load += share * weight;
            all_load += weight;
            area += share * face.area;
            all_area += face.area;
        }
    }
    return area > 0.0 ? load / all_load * (all_area / area) : 1.0;
}

}  // namespace tiretherm::physics
