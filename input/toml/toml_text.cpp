// SPDX-License-Identifier: BSD-3-Clause
// Writing TOML: values as the reader of cases takes them, and whole documents.
#include "input/toml/toml_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "physics/celsius.hpp"

namespace tiretherm::input::toml_text {

std::string in_quotes(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
        }
        // TOML allows no control characters in a text.
        if (static_cast<unsigned char>(c) < ' ' || c == 127) {
            result += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string key(std::string_view key) {
    const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
        return c == '_' || c == '-' ||
               (static_cast<unsigned char>(c) < 128 && std::isalnum(static_cast<unsigned char>(c)) != 0);
    });
    return bare ? std::string(key) : in_quotes(key);
}

std::string quantity(double value, std::string_view unit) { return toml_text::value(quantity_value(value, unit)); }

std::string value(const TomlValue& node) {
    switch (node.kind) {
        case TomlValue::Kind::text:
        case TomlValue::Kind::date:
        case TomlValue::Kind::nothing:
            return in_quotes(node.text);
        case TomlValue::Kind::integer:
        case TomlValue::Kind::real:
            return fmt::format("{}", node.number);
        case TomlValue::Kind::boolean:
            return node.truth ? "true" : "false";
        case TomlValue::Kind::array: {
            std::vector<std::string> items;
            std::transform(node.items.begin(), node.items.end(), std::back_inserter(items), value);
            return fmt::format("[{}]", fmt::join(items, ", "));
        }
        case TomlValue::Kind::table: {
            std::vector<std::string> entries;
            std::transform(
                node.entries.begin(), node.entries.end(), std::back_inserter(entries),
                [](const Entry& entry) { return fmt::format("{} = {}", key(entry.key), value(entry.value)); });
            return fmt::format("{{ {} }}", fmt::join(entries, ", "));
        }
    }
    return {};
}

namespace {

bool is_list_of_tables(const TomlValue& node) {
    return node.kind == TomlValue::Kind::array && !node.items.empty() &&
           std::ranges::all_of(node.items, [](const TomlValue& item) {
               return item.kind == TomlValue::Kind::table && !item.in_braces;
           });
}

bool has_heading(const TomlValue& node) {
    return is_list_of_tables(node) || (node.kind == TomlValue::Kind::table && !node.in_braces);
}

/// The values of a table as lines, then what has headings of its own. @param name its heading; empty: of the document
std::string table_text(const TomlValue& table, const std::string& name) {
    std::string text;
    for (const Entry& entry : table.entries) {
        text += has_heading(entry.value) ? "" : fmt::format("{} = {}\n", key(entry.key), value(entry.value));
    }
    for (const Entry& entry : table.entries) {
        if (!has_heading(entry.value)) {
            continue;
        }
        const std::string path = fmt::format("{}{}{}", name, name.empty() ? "" : ".", key(entry.key));
        const bool is_list = is_list_of_tables(entry.value);
        for (const TomlValue& item : is_list ? entry.value.items : std::vector{entry.value}) {
            if (is_list) {
                text += fmt::format("\n[[{}]]\n", path);
            } else if (std::ranges::any_of(item.entries, [](const Entry& e) { return !has_heading(e.value); })) {
                text += fmt::format("\n[{}]\n", path);
            }
            text += table_text(item, path);
        }
    }
    return text;
}

}  // namespace

std::string document(const TomlValue& root) { return table_text(root, ""); }

TomlValue text_value(std::string text) {
    TomlValue node;
    node.kind = TomlValue::Kind::text;
    node.text = std::move(text);
    return node;
}

TomlValue boolean_value(bool truth) {
    TomlValue node;
    node.kind = TomlValue::Kind::boolean;
    node.truth = truth;
    return node;
}

TomlValue quantity_value(double value, std::string_view unit) {
    if (unit != "1") {
        return text_value(fmt::format("{} {}", value, unit));
    }
    TomlValue node;
    node.kind = TomlValue::Kind::real;
    node.number = value;
    return node;
}

TomlValue temperature_value(double kelvin) {
    // The difference to 0 degC has a digit of rounding at its end; what is written must give the same kelvin again, digit by
    // digit.
    const double written = std::round(celsius(kelvin) * 1e9) / 1e9;
    return written + zero_celsius == kelvin ? quantity_value(written, "degC") : quantity_value(kelvin, "K");
}

TomlValue path_value(const std::filesystem::path& file, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file));
    const fs::path from_there = whole.lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
    return text_value((from_there.empty() ? whole : from_there).generic_string());
}

TomlValue list_value(std::vector<TomlValue> items) {
    TomlValue node;
    node.kind = TomlValue::Kind::array;
    node.items = std::move(items);
    return node;
}

TomlValue texts_value(const std::vector<std::string>& texts) {
    std::vector<TomlValue> items;
    std::ranges::transform(texts, std::back_inserter(items), text_value);
    return list_value(std::move(items));
}

TomlValue table_value(std::vector<std::pair<std::string, TomlValue>> entries) {
    TomlValue node;
    node.kind = TomlValue::Kind::table;
    node.in_braces = true;
    for (auto& [name, its] : entries) {
        node.set(name, std::move(its));
    }
    return node;
}

}  // namespace tiretherm::input::toml_text
