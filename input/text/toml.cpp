// SPDX-License-Identifier: BSD-3-Clause
// Parses TOML with toml++ into a document with places. The only file that includes toml++. A scan without it finds what is
// too deep for the parser, which recurses, and brackets that are left open.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "input/text/document.hpp"
#include "input/text/quantity.hpp"
#include "input/text/regular_file.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

/// Keys and values may stand one within the other so deep. A case needs seven levels: [[run]], drive, schedule, rows.
constexpr int most_levels = 64;

/// A place of a text, counted from 1; the column in characters.
struct TextPlace {
    int line = 0;
    int column = 0;
};

/// Where a string that starts at `from` ends: behind its last quote, or at the end of the line or of the text.
std::size_t end_of_string(std::string_view text, std::size_t from) {
    const char quote = text[from];
    const std::string three(3, quote);
    const bool lines = text.substr(from, 3) == three;
    for (std::size_t i = from + (lines ? 3 : 1); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (lines ? text.substr(i, 3) == three : text[i] == quote) {
            return i + (lines ? 3 : 1);
        } else if (!lines && text[i] == '\n') {
            return i;
        }
    }
    return text.size();
}

TextPlace place_in(std::string_view text, std::size_t at) {
    const std::string_view before = text.substr(0, at);
    const std::size_t line_start = before.rfind('\n') + 1;  // 0 in the first line
    const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return {.line = static_cast<int>(std::ranges::count(before, '\n')) + 1,
            .column = static_cast<int>(std::ranges::count_if(before.substr(line_start), starts_character)) + 1};
}

struct Bracket {
    int levels;      ///< the parts of the key before it, and so its levels
    std::size_t at;  ///< in the text
};

/// Goes through a text until it is too deep.
struct Scan {
    std::vector<Bracket> open;
    std::optional<std::size_t> too_deep;  ///< start of the key or the value that goes too deep

    explicit Scan(std::string_view text, int most) {
        int levels = 0;         // of all open brackets
        int parts = 1;          // of the key that is under way; a number behind it adds one at most
        std::size_t start = 0;  // where what is under way starts
        bool started = false;
        for (std::size_t i = 0; i < text.size() && !too_deep; ++i) {
            const char c = text[i];
            if (!started && c != ' ' && c != '\t') {
                start = i;
                started = true;
            }
            const bool opens = c == '[' || c == '{';
            if (c == '.') {
                ++parts;
            } else if (opens) {
                open.push_back({parts, i});
                levels += parts;
            } else if ((c == ']' || c == '}') && !open.empty()) {
                levels -= open.back().levels;
                open.pop_back();
            }
            if (opens || c == ']' || c == '}' || c == ',' || c == '\n') {
                parts = 1;
                started = false;
            }
            if (levels + parts > most) {
                too_deep = start;
            }
            if (c == '"' || c == '\'') {
                i = end_of_string(text, i) - 1;
            } else if (c == '#') {
                i = std::min(text.find('\n', i), text.size()) - 1;
            }
        }
    }
};

/// Where a TOML text goes deeper than `most_levels`: each part of a dotted key counts, and each bracket about a value.
/// Of a text that is not valid TOML the answer may be about any line. Takes a time linear in the text, and no stack.
std::optional<TextPlace> first_too_deep(std::string_view text) {
    const Scan scan(text, most_levels);
    return scan.too_deep ? std::optional(place_in(text, *scan.too_deep)) : std::nullopt;
}

/// The line in which the outermost bracket is opened that a TOML text leaves open; 0 where there is none.
int line_of_open_bracket(std::string_view text) {
    const Scan scan(text, std::numeric_limits<int>::max());
    return scan.open.empty() ? 0 : place_in(text, scan.open.front().at).line;
}

SourceLocation place_of(const toml::source_region& region, int file) {
    const auto line = static_cast<int>(region.begin.line);
    const auto column = static_cast<int>(region.begin.column);
    const bool one_line = region.end.line == region.begin.line;
    return {.file = file,
            .line = line,
            .column = column,
            .length = one_line ? std::max(1, static_cast<int>(region.end.column) - column) : 1};
}

bool follows(const SourceLocation& later, const SourceLocation& earlier) {
    return std::pair(later.line, later.column) > std::pair(earlier.line, earlier.column);
}

TomlValue convert(const toml::node& from, int file) {
    TomlValue to;
    to.place = place_of(from.source(), file);
    from.visit([&](const auto& value) {
        using Kind = TomlValue::Kind;
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, toml::table>) {
            to.kind = Kind::table;
            for (const auto& [key, item] : value) {
                Entry entry{std::string(key.str()), place_of(key.source(), file), convert(item, file)};
                // A table in braces follows its key; a heading [a.b] begins before it, the a of `a.b = 1` with it.
                entry.value.in_braces = entry.value.kind == Kind::table && follows(entry.value.place, entry.place);
                to.entries.push_back(std::move(entry));
            }
            // The parser sorts by name; a case is read, and its errors are listed, in the order it was written.
            std::stable_sort(to.entries.begin(), to.entries.end(),
                             [](const Entry& a, const Entry& b) { return follows(b.place, a.place); });
        } else if constexpr (std::is_same_v<Value, toml::array>) {
            to.kind = Kind::array;
            for (const toml::node& item : value) {
                to.items.push_back(convert(item, file));
            }
        } else if constexpr (std::is_same_v<Value, toml::value<std::string>>) {
            to.kind = Kind::text;
            to.text = value.get();
        } else if constexpr (std::is_same_v<Value, toml::value<std::int64_t>>) {
            to.kind = Kind::integer;
            to.number = static_cast<double>(value.get());
        } else if constexpr (std::is_same_v<Value, toml::value<double>>) {
            to.kind = Kind::real;
            to.number = value.get();
        } else if constexpr (std::is_same_v<Value, toml::value<bool>>) {
            to.kind = Kind::boolean;
            to.truth = value.get();
        } else {
            to.kind = Kind::date;
        }
    });
    return to;
}

/// In bytes. A case has kilobytes; what is measured stands in files of its own.
constexpr std::uintmax_t largest_toml = std::uintmax_t{16} << 20U;

/// Where a bracket was opened that is not closed before a heading or a key, which the parser then takes for a value.
/// @returns a line; 0: there is none, or the line may stand in a list
int open_list_before(std::string_view text, int line) {
    std::string_view rest = text;
    for (int skipped = 1; skipped < line; ++skipped) {
        rest.remove_prefix(std::min(rest.find('\n') + 1, rest.size()));
    }
    const std::size_t before = text.size() - rest.size();
    std::string_view here = trim(rest.substr(0, rest.find('\n')));
    const auto starts_key = [](std::string_view word) {
        return !word.empty() && (std::isalpha(static_cast<unsigned char>(word.front())) != 0 || word.front() == '_');
    };
    const std::size_t name = std::min(here.find_first_not_of('['), here.size());
    const bool heading = (name == 1 || name == 2) && starts_key(here.substr(name));
    const std::size_t equals = here.find('=');
    const bool key = starts_key(here) && equals != std::string_view::npos &&
                     here.substr(0, equals).find_first_of("\"',[]{}") == std::string_view::npos;
    return heading || key ? line_of_open_bracket(text.substr(0, before)) : 0;
}

/// The commonest slip is a quantity without quotes.
std::string remedy_for(const toml::parse_error& error, std::string_view text) {
    for (toml::source_index line = 1; line < error.source().begin.line; ++line) {
        text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
    }
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
        return {};
    }
    const std::string_view value = trim(line.substr(equals + 1, line.find('#') - equals - 1));
    const std::optional<Number> number = leading_number(value);
    if (number && number->rest.empty() && std::isinf(number->value)) {
        return "the number is beyond 1.8e308, the largest that is read: correct its exponent";
    }
    if (number && number->rest.empty() && number->value == 0.0 &&
        value.substr(0, value.find_first_of("eE")).find_first_of("123456789") != std::string_view::npos) {
        return "the number is nearer to 0 than 5e-324, the smallest that is read: write 0";
    }
    if (value.empty() || std::string_view("+-.0123456789").find(value.front()) == std::string_view::npos) {
        return {};
    }
    return fmt::format("put quantities in quotes: {} = \"{}\"", trim(line.substr(0, equals)), value);
}

}  // namespace

std::optional<TomlValue> parse_toml(const TextFile& file, InputErrors& errors) {
    if (file.text.size() > largest_toml) {
        ErrorText reason = too_large(file.text.size(), largest_toml);
        errors.add({.file = file.number}, "the file " + reason.what, "give measured values as a CSV or HDF5 file");
        return std::nullopt;
    }
    if (const std::optional<TextPlace> deep = first_too_deep(file.text)) {
        errors.add({.file = file.number, .line = deep->line, .column = deep->column, .length = 1},
                   fmt::format("keys and values stand more than {} deep within each other", most_levels),
                   "no key of a case has more than a few parts: remove what stands between the dots or the brackets");
        return std::nullopt;
    }
    try {
        TomlValue root = convert(toml::parse(std::string_view(file.text)), file.number);
        root.place = {.file = file.number};  // what a file lacks stands in no line of it
        return root;
    } catch (const toml::parse_error& error) {
        const auto line = static_cast<int>(error.source().begin.line);
        const bool at_end = error.description().find("end-of-file") != std::string_view::npos;
        if (const int open = at_end ? line_of_open_bracket(file.text) : open_list_before(file.text, line); open > 0) {
            errors.add(place_of(error.source(), file.number),
                       fmt::format("not valid TOML: the bracket that is opened in line {} is not closed {}", open,
                                   at_end ? "before the end of the file" : "before this line"),
                       "write the missing ] or }");
            return std::nullopt;
        }
        std::string what(error.description());
        what.erase(0, what.starts_with("Error while parsing ") ? 20 : 0);
        errors.add(place_of(error.source(), file.number), fmt::format("not valid TOML: {}", what),
                   remedy_for(error, file.text));
        return std::nullopt;
    }
}

}  // namespace tiretherm::input
