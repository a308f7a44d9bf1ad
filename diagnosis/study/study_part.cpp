// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes the names of a study's parts.

#include "diagnosis/study/study_part.hpp"

#include <charconv>

#include <fmt/format.h>

namespace tiretherm::diagnosis {

namespace {

constexpr std::string_view before = "part_";
constexpr std::string_view between = "_of_";

/// A whole number without sign or leading zero, and nothing else.
std::optional<std::size_t> whole_number(std::string_view text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_all = error == std::errc() && end == text.data() + text.size();
    return is_all && !text.starts_with('0') ? std::optional(number) : std::nullopt;
}

std::optional<StudyPart> part_of(std::string_view index, std::string_view count) {
    const std::optional<std::size_t> k = whole_number(index);
    const std::optional<std::size_t> n = whole_number(count);
    return k && n && *k <= *n && *n <= StudyPart::most_parts ? std::optional(StudyPart{.index = *k, .count = *n})
                                                             : std::nullopt;
}

}  // namespace

std::string StudyPart::text() const { return fmt::format("{}/{}", index, count); }

std::string StudyPart::folder() const { return fmt::format("{}{}{}{}", before, index, between, count); }

std::optional<StudyPart> StudyPart::parse(std::string_view text) {
    const std::size_t slash = text.find('/');
    return slash == std::string_view::npos ? std::nullopt : part_of(text.substr(0, slash), text.substr(slash + 1));
}

std::optional<StudyPart> StudyPart::from_folder(std::string_view name) {
    if (!name.starts_with(before)) {
        return std::nullopt;
    }
    name.remove_prefix(before.size());
    const std::size_t at = name.find(between);
    return at == std::string_view::npos ? std::nullopt : part_of(name.substr(0, at), name.substr(at + between.size()));
}

}  // namespace tiretherm::diagnosis
