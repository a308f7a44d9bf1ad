// SPDX-License-Identifier: BSD-3-Clause
// A part of a study's runs, for one call among several that share the study.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tiretherm::diagnosis {

/// The K-th of N parts of a study's runs. Neighbouring runs cost alike, so that each part takes every N-th.
struct StudyPart {
    std::size_t index = 1;  ///< K, from 1
    std::size_t count = 1;  ///< N; 1: all runs

    [[nodiscard]] bool is_whole() const { return count == 1; }
    /// Whether a run belongs to it. @param run from 0
    [[nodiscard]] bool has(std::size_t run) const { return run % count == index - 1; }
    /// How many of a study's runs it has.
    [[nodiscard]] std::size_t size(std::size_t runs) const { return runs / count + (runs % count >= index ? 1 : 0); }
    /// "3/16"
    [[nodiscard]] std::string text() const;
    /// Name of the folder of its runs, inside that of the study: "part_3_of_16".
    [[nodiscard]] std::string folder() const;

    /// @param text "3/16"  @returns nothing where it is none: 1 <= K <= N <= most_parts
    [[nodiscard]] static std::optional<StudyPart> parse(std::string_view text);
    /// @param name "part_3_of_16"
    [[nodiscard]] static std::optional<StudyPart> from_folder(std::string_view name);

    static constexpr std::size_t most_parts = 100000;

    friend auto operator<=>(const StudyPart&, const StudyPart&) = default;
};

}  // namespace tiretherm::diagnosis
