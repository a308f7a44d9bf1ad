// SPDX-License-Identifier: BSD-3-Clause
// Parses TOML with toml++ into a document with places. The only file that includes toml++.

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "input/files/regular_file.hpp"
#include "input/text/characters.hpp"
#include "input/text/quantity.hpp"
#include "input/toml/document.hpp"
#include "input/toml/toml_depth.hpp"

namespace tiretherm::input {

namespace {

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

/// A text from the beginning of a line on. @param line counted from 1
std::string_view from_line(std::string_view text, int line) {
    for (int skipped = 1; skipped < line; ++skipped) {
        text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
    }
    return text;
}

/// In bytes. A case has kilobytes; what is measured stands in files of its own.
constexpr std::uintmax_t largest_toml = std::uintmax_t{16} << 20U;

/// Where a bracket was opened that is not closed before a heading or a key, which the parser then takes for a value.
/// @returns a line; 0: there is none, or the line may stand in a list
int open_list_before(std::string_view text, int line) {
    const std::string_view rest = from_line(text, line);
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
    text = from_line(text, static_cast<int>(error.source().begin.line));
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
        return errors.add({.file = file.number}, "the file " + reason.what,
                          "give measured values as a CSV or HDF5 file");
    }
    if (const std::optional<TextPlace> deep = first_too_deep(file.text)) {
        return errors.add(
            {.file = file.number, .line = deep->line, .column = deep->column, .length = 1},
            fmt::format("keys and values stand more than {} deep within each other", most_levels),
            "no key of a case has more than a few parts: remove what stands between the dots or the brackets");
    }
    try {
        TomlValue root = convert(toml::parse(file.text), file.number);
        root.place = {.file = file.number};  // what a file lacks stands in no line of it
        return root;
    } catch (const toml::parse_error& error) {
        const auto line = static_cast<int>(error.source().begin.line);
        const bool at_end = error.description().find("end-of-file") != std::string_view::npos;
        if (const int open = at_end ? line_of_open_bracket(file.text) : open_list_before(file.text, line); open > 0) {
            return errors.add(place_of(error.source(), file.number),
                              fmt::format("not valid TOML: the bracket that is opened in line {} is not closed {}",
                                          open, at_end ? "before the end of the file" : "before this line"),
                              "write the missing ] or }");
        }
        std::string what(error.description());
        what.erase(0, what.starts_with("Error while parsing ") ? 20 : 0);
        return errors.add(place_of(error.source(), file.number), fmt::format("not valid TOML: {}", what),
                          remedy_for(error, file.text));
    }
}

}  // namespace tiretherm::input
