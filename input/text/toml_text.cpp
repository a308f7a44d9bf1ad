#include "input/text/toml_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

namespace tiretherm::input::toml_text {

std::string in_quotes(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += '\\';
        }
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

std::string quantity(double value, std::string_view unit) {
    return unit == "1" ? fmt::format("{}", value) : fmt::format("\"{} {}\"", value, unit);
}

std::string temperature(double kelvin) {
    constexpr double zero = 273.15;
    const double celsius = std::round((kelvin - zero) * 1e9) / 1e9;
    return celsius + zero == kelvin ? quantity(celsius, "degC") : quantity(kelvin, "K");
}

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

std::string path(const std::filesystem::path& file, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file));
    const fs::path from_there = whole.lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
    return toml_text::in_quotes((from_there.empty() ? whole : from_there).generic_string());
}

}  // namespace tiretherm::input::toml_text
