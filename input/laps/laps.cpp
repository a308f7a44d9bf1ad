// SPDX-License-Identifier: BSD-3-Clause
// Cuts a recording into laps and finds the stretch that a choice of laps means.

#include "input/laps/laps.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

constexpr double shortest_between_marks = 0.5;  ///< s; closer marks are duplicates of one crossing
constexpr std::size_t most_laps = 5000;         ///< a column that changes more often counts something else
constexpr std::size_t most_listed = 60;

void set_kinds(std::vector<Lap>& laps) {
    if (laps.size() > 1) {
        laps.front().kind = LapKind::out;
        laps.back().kind = LapKind::in;
    }
}

std::optional<int> whole_number(std::string_view text) {
    text = trim(text);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// Numbers of the laps from `first` to `last`, each in its place in the list of laps, or nothing after an error.
struct Range {
    int first = 0;
    int last = 0;
};
std::optional<std::vector<Range>> read_ranges(std::string_view text) {
    std::vector<Range> ranges;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view part = trim(text.substr(0, comma));
        const std::size_t dash = part.find('-', 1);
        const std::optional<int> first = whole_number(part.substr(0, dash));
        const std::optional<int> last =
            dash == std::string_view::npos ? first : whole_number(part.substr(std::min(dash + 1, part.size())));
        if (!first || !last || *last < *first) {
            return std::nullopt;
        }
        ranges.push_back({*first, *last});
        if (comma == text.size()) {
            return ranges;
        }
        text.remove_prefix(comma + 1);
    }
}

}  // namespace

std::vector<Lap> laps_between(const std::vector<double>& markers, double from, double to) {
    std::vector<double> crossings;
    for (const double marker : markers) {
        const bool inside = marker > from + shortest_between_marks && marker < to - shortest_between_marks;
        if (inside && (crossings.empty() || marker > crossings.back() + shortest_between_marks)) {
            crossings.push_back(marker);
        }
    }
    if (crossings.empty()) {
        return {};
    }
    std::vector<Lap> laps;
    double start = from;
    crossings.push_back(to);
    for (const double end : crossings) {
        laps.push_back({.number = static_cast<int>(laps.size()), .start = start, .end = end});
        start = end;
    }
    set_kinds(laps);
    return laps;
}

std::vector<Lap> laps_by_counter(const std::vector<double>& time, const std::vector<double>& number) {
    std::vector<Lap> laps;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (std::isnan(number[i])) {
            continue;
        }
        if (number[i] != std::floor(number[i]) || std::abs(number[i]) > 1e6) {
            return {};
        }
        const int lap = static_cast<int>(number[i]);
        if (laps.empty() || lap != laps.back().number) {
            if (!laps.empty()) {
                laps.back().end = time[i];
            }
            if ((!laps.empty() && lap < laps.back().number) || laps.size() == most_laps) {
                return {};
            }
            laps.push_back({.number = lap, .start = time[i]});
        }
        laps.back().end = time[i];
    }
    // A counter that has no number on the way out of the pits and back has none of those two laps.
    constexpr double pit_way = 5.0;  // s; at least, to be told from a counter that is logged more slowly
    if (!laps.empty() && laps.front().start > time.front() + pit_way) {
        laps.insert(laps.begin(),
                    {.number = laps.front().number - 1, .start = time.front(), .end = laps.front().start});
    }
    if (!laps.empty() && laps.back().end < time.back() - pit_way) {
        laps.push_back({.number = laps.back().number + 1, .start = laps.back().end, .end = time.back()});
    }
    set_kinds(laps);
    return laps.size() > 1 ? laps : std::vector<Lap>{};
}

std::string never_crossed(double nearest) {
    return fmt::format("the car never crosses the start line, and comes no nearer to it than {:.3g} {}",
                       nearest < 1000.0 ? nearest : 1e-3 * nearest, nearest < 1000.0 ? "m" : "km");
}

LapChoice choose_laps(const std::string& text, const Laps& laps) {
    const std::optional<std::vector<Range>> ranges = read_ranges(text);
    if (!ranges) {
        return {.error = fmt::format("laps is \"{}\"; numbers of laps are wanted", text),
                .remedy = "write laps = \"2\", \"3-9\" or \"2, 4-6\""};
    }
    if (laps.laps.empty() && laps.nearest) {
        return {.error = fmt::format("no laps are known of the file: {}", never_crossed(*laps.nearest)),
                .remedy = std::string(line_remedy)};
    }
    if (laps.laps.empty()) {
        return {.error = "no laps are known of the file: it has no marks between laps and no column that counts them",
                .remedy =
                    "say where the line is, start_line = [[latitude, longitude], [latitude, longitude]] in degrees, "
                    "or use from and to"};
    }
    std::vector<bool> chosen(laps.laps.size(), false);
    for (const Range& range : *ranges) {
        for (const int number : {range.first, range.last}) {
            if (std::ranges::find(laps.laps, number, &Lap::number) == laps.laps.end()) {
                return {.error = fmt::format("there is no lap {}", number),
                        .remedy = fmt::format("the laps are {}", list_laps(laps.laps))};
            }
        }
        for (std::size_t i = 0; i < laps.laps.size(); ++i) {
            chosen[i] = chosen[i] || (laps.laps[i].number >= range.first && laps.laps[i].number <= range.last);
        }
    }
    const auto first = static_cast<std::size_t>(std::ranges::find(chosen, true) - chosen.begin());
    std::size_t last = chosen.size() - 1;
    while (!chosen[last]) {
        --last;
    }
    LapChoice choice{.window = LapWindow{.from = laps.laps[first].start, .to = laps.laps[last].end},
                     .first_ends = laps.laps[first].end,
                     .starts_from_the_pits = laps.laps[first].kind == LapKind::out};
    for (std::size_t i = first; i < last; ++i) {
        if (!chosen[i]) {
            choice.left_out.push_back({.from = laps.laps[i].start, .to = laps.laps[i].end});
        }
    }
    return choice;
}

std::string lap_time(double seconds) {
    const double rounded = std::round(1000.0 * seconds) / 1000.0;
    const double minutes = std::floor(rounded / 60.0);
    return fmt::format("{:.0f}:{:06.3f}", minutes, rounded - 60.0 * minutes);
}

std::string list_laps(const std::vector<Lap>& laps) {
    std::vector<std::string> listed;
    for (std::size_t i = 0; i < std::min(laps.size(), most_listed); ++i) {
        const Lap& lap = laps[i];
        const std::string_view kind = lap.kind == LapKind::out ? "out, " : lap.kind == LapKind::in ? "in, " : "";
        listed.push_back(fmt::format("{} ({}{})", lap.number, kind, lap_time(lap.end - lap.start)));
    }
    return fmt::format("{}{}", fmt::join(listed, ", "), laps.size() > most_listed ? " ..." : "");
}

std::string_view word_of(LapKind kind) {
    return kind == LapKind::out ? "out-lap" : kind == LapKind::in ? "in-lap" : "lap";
}

}  // namespace tiretherm::input
