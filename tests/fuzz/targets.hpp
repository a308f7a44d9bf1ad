// SPDX-License-Identifier: BSD-3-Clause
// What is fuzzed: one target for each kind of file, and the promises that hold for any content.
#pragma once

#include <span>
#include <string_view>

namespace tiretherm::fuzz {

/// One kind of content that comes from outside.
struct Target {
    std::string_view name;  ///< also of its folder in tests/fuzz/corpus
    /// Reads bytes as a user's file is read, and what was read once through.
    /// @returns whether they were accepted   @errors BrokenPromise, or whatever the reader throws: both are findings
    bool (*take)(std::string_view bytes);
};

/// All targets.
[[nodiscard]] std::span<const Target> targets();

/// The target of this name, or null.
[[nodiscard]] const Target* find_target(std::string_view name);

}  // namespace tiretherm::fuzz
