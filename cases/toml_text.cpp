#include "cases/toml_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace tiretherm::cases::toml_text {

std::string quoted(std::string_view text) {
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
    return bare ? std::string(key) : quoted(key);
}

std::string quantity(double value, std::string_view unit) {
    return unit == "1" ? fmt::format("{}", value) : fmt::format("\"{} {}\"", value, unit);
}

std::string temperature(double kelvin) {
    constexpr double zero = 273.15;
    const double celsius = std::round((kelvin - zero) * 1e9) / 1e9;
    return celsius + zero == kelvin ? quantity(celsius, "degC") : quantity(kelvin, "K");
}

std::string path(const std::filesystem::path& file, const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file));
    const fs::path from_there = whole.lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
    return toml_text::quoted((from_there.empty() ? whole : from_there).generic_string());
}

}  // namespace tiretherm::cases::toml_text
