// SPDX-License-Identifier: BSD-3-Clause
// Patterns of names: "ir_*" means all names that begin with ir_.
#pragma once

#include <string_view>

namespace tiretherm::input {

/// Whether a name is meant by a pattern: `*` stands for any characters or none, `?` for one byte; all others, capitals
/// too, for themselves.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view name);

/// Whether a word has a `*` or a `?`: it may mean several names.
[[nodiscard]] bool is_pattern(std::string_view word);

}  // namespace tiretherm::input
