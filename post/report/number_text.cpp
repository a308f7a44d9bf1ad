// SPDX-License-Identifier: BSD-3-Clause
// Rounds a value to the digits of its interval, and rewrites units with negative powers as fractions.

#include "post/report/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace tiretherm::post {

std::string without_sign_of_zero(std::string number) {
    const bool is_zero = number.starts_with('-') && number.find_first_not_of("-0.") == std::string::npos;
    return is_zero ? number.substr(1) : number;
}

std::string to_its_digits(double value, double half_width) {
    if (!std::isfinite(value)) {
        return "-";
    }
    const double size = std::max(std::abs(value), half_width);
    if (size >= 1e5 || (size > 0.0 && size < 1e-3) || !(half_width > 0.0) || !std::isfinite(half_width)) {
        return fmt::format("{:.4g}", value);
    }
    const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(half_width))), 0, 8);
    return without_sign_of_zero(fmt::format("{:.{}f}", value, digits));
}

std::string with_decimals(double value, int decimals) {
    if (!std::isfinite(value)) {
        return "-";
    }
    return std::abs(value) < compact_from ? without_sign_of_zero(fmt::format("{:.{}f}", value, decimals))
                                          : fmt::format("{:.4g}", value);
}

std::string in_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string difference_unit(std::string_view unit) { return std::string(unit == "degC" ? "K" : unit); }

std::string in_digits_of(std::string_view unit, double value) {
    return without_sign_of_zero(fmt::format("{:.{}f}", value,
                                            unit == "1"                      ? 3
                                            : unit == "s" || unit == "N/rad" ? 0
                                                                             : 1));
}

std::string range_text(std::string_view unit, double low, double high) {
    if (std::isinf(low)) {
        return "< " + in_digits_of(unit, high);
    }
    if (std::isinf(high)) {
        return "> " + in_digits_of(unit, low);
    }
    return in_digits_of(unit, low) + (low == high ? "" : " to " + in_digits_of(unit, high));
}

std::string slashed_unit(std::string_view unit) {
    std::vector<std::string> above;
    std::vector<std::string> below;
    for (std::size_t from = 0; from < unit.size();) {
        const std::size_t to = std::min(unit.find(' ', from), unit.size());
        const std::string_view factor = unit.substr(from, to - from);
        const std::size_t minus = factor.find('-');
        if (minus == std::string_view::npos || minus == 0) {  // a "-" by itself is a pure number's unit
            above.emplace_back(factor);
        } else {
            const std::string_view power = factor.substr(minus + 1);
            below.push_back(std::string(factor.substr(0, minus)) + (power == "1" ? "" : std::string(power)));
        }
        from = to + 1;
    }
    if (below.empty()) {
        return std::string(unit);
    }
    return fmt::format("{}/{}{}{}", above.empty() ? "1" : fmt::format("{}", fmt::join(above, " ")),
                       below.size() > 1 ? "(" : "", fmt::join(below, " "), below.size() > 1 ? ")" : "");
}

}  // namespace tiretherm::post
