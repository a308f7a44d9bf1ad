// SPDX-License-Identifier: BSD-3-Clause
// Names of things, and lists of words as a sentence has them.
#pragma once

#include <string>
#include <vector>

namespace tiretherm::input {

/// "a, b and c".
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

template <typename Items>
[[nodiscard]] std::vector<std::string> names_of(const Items& items) {
    std::vector<std::string> names;
    names.reserve(items.size());
    for (const auto& item : items) {
        names.emplace_back(item.name);
    }
    return names;
}

}  // namespace tiretherm::input
