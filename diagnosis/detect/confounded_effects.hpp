// SPDX-License-Identifier: BSD-3-Clause
// Look-ups in the groups of effects whose signatures are alike.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "physics/effect_facts.hpp"

namespace tiretherm::diagnosis {

/// Those that a cause belongs to, in the order of the catalogue.
[[nodiscard]] std::vector<const physics::ConfoundedGroup*> confounded_groups_of(std::string_view id);

/// The other members, as a list. @param id of the member that is left out
[[nodiscard]] std::string others_of(const physics::ConfoundedGroup& group, std::string_view id);

}  // namespace tiretherm::diagnosis
