// SPDX-License-Identifier: BSD-3-Clause
// Look-ups in the groups of effects whose signatures are alike.

#include "diagnosis/detect/confounded_effects.hpp"

#include <algorithm>

#include "physics/effect.hpp"

namespace tiretherm::diagnosis {

std::vector<const physics::ConfoundedGroup*> confounded_groups_of(std::string_view id) {
    std::vector<const physics::ConfoundedGroup*> found;
    for (const physics::Effect* effect : physics::catalogue()) {
        for (const physics::ConfoundedGroup& group : effect->confounded) {
            if (std::ranges::find(group.members, id) != group.members.end()) {
                found.push_back(&group);
            }
        }
    }
    return found;
}

std::string others_of(const physics::ConfoundedGroup& group, std::string_view id) {
    std::string text;
    for (const std::string_view member : group.members) {
        if (member != id && !member.empty()) {
            text += (text.empty() ? "" : ", ") + std::string(member);
        }
    }
    return text;
}

}  // namespace tiretherm::diagnosis
