// SPDX-License-Identifier: BSD-3-Clause
// Effects whose signatures are alike for physical reasons, whatever the data, with the experiment that separates them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::diagnosis {

/// Causes whose signatures are alike by their physics, whatever the data: naming one of them is a guess unless what
/// separates them was measured.
struct ConfoundedGroup {
    std::vector<std::string_view> members;  ///< ids of effects; numbers of effects as "effect.key"
    std::string_view separated;             ///< by what an experiment tells them apart
};
[[nodiscard]] std::span<const ConfoundedGroup> confounded_groups();

/// Those that a cause belongs to.
[[nodiscard]] std::vector<const ConfoundedGroup*> confounded_groups_of(std::string_view id);

/// The other members, as a list. @param id of the member that is left out
[[nodiscard]] std::string others_of(const ConfoundedGroup& group, std::string_view id);

}  // namespace tiretherm::diagnosis
