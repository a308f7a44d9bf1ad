// SPDX-License-Identifier: BSD-3-Clause
// Finds the drum's coupling faces by their nodes, and shares an exchange out over the face and the surroundings.

#include "physics/contact/heated_road.hpp"

#include <map>

#include "mesh/index.hpp"

namespace tiretherm::physics {

void place_heated_road(const PlacementContext& context, ActiveEffect& active) {
    active.coupling_faces.clear();
    active.share_of_drum = 0.0;
    const ActiveEffect* drum = context.find("drum_heating");
    if (drum == nullptr) {
        return;
    }
    std::map<int, int> face_of;
    for (const int face : drum->coupling_faces) {
        face_of[context.mesh.faces[at(face)].a] = face;
    }
    for (const int node : active.nodes) {
        const auto found = face_of.find(node);
        if (found == face_of.end()) {
            active.coupling_faces.clear();
            return;
        }
        active.coupling_faces.push_back(found->second);
    }
    const auto share = at(find_parameter(*drum->effect, "share"));
    active.share_of_drum = active.coupling_faces.empty() ? 0.0 : (*drum)[share];
}

void exchange_with_road(const EvaluationState& state, std::size_t i, double G, double T_road, double dG_dT,
                        Terms& terms) {
    const double share = state.active.share_of_drum;
    if (share > 0.0) {
        terms.conduct(state.active.coupling_faces[i], share * G, share * dG_dT, 0.0);
    }
    if (share < 1.0) {
        terms.exchange(state.active.nodes[i], (1.0 - share) * G, T_road, (1.0 - share) * dG_dT);
    }
}

void take_from_drum(const EvaluationState& state, std::size_t i, double W, double dW_dT, double dW_dT_drum,
                    Terms& terms) {
    const int face = state.active.coupling_faces[i];
    const mesh::Face& ends = state.mesh.faces[at(face)];
    terms.heat(ends.a, W);
    terms.heat(ends.b, -W);
    terms.conduct(face, 0.0, dW_dT, dW_dT_drum, 1.0);  // a flow without a conductance: its derivatives alone
}

}  // namespace tiretherm::physics
