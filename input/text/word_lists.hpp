// SPDX-License-Identifier: BSD-3-Clause
// Names of things, and lists of words as a sentence has them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tiretherm::input {

/// "a, b and c".
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

/// A text of each item. @param text a member, or a function of an item
template <typename Items, typename Text>
[[nodiscard]] std::vector<std::string> names_of(const Items& items, Text text) {
    std::vector<std::string> names;
    names.reserve(items.size());
    for (const auto& item : items) {
        names.emplace_back(std::invoke(text, item));
    }
    return names;
}
template <typename Items>
[[nodiscard]] std::vector<std::string> names_of(const Items& items) {
    return names_of(items, [](const auto& item) { return item.name; });
}

}  // namespace tiretherm::input
