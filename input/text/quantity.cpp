// SPDX-License-Identifier: BSD-3-Clause
// Parses numbers with units, checks unit, dimension and range, and words the errors with an example.

#include "input/text/quantity.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "input/text/characters.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/unit_text.hpp"
#include "physics/celsius.hpp"

namespace tiretherm::input {

namespace {

/// "-540 km/h".
std::string spell(double si, const Conversion& unit_conversion, std::string_view unit) {
    const double written = unit_conversion.from_si(si);
    // A bound of zero may come back as 1e-14 through an offset.
    const double rounded = std::abs(written) < 1e-9 * std::abs(unit_conversion.offset) ? 0.0 : written;
    const std::string number = fmt::format("{:.6g}", rounded);
    unit.remove_prefix(unit.starts_with(turned_sign) ? turned_sign.size() : 0);
    return unit.empty() || unit == "1" || unit == "-" ? number : fmt::format("{} {}", number, unit);
}

std::string range(const QuantitySpec& spec, double low, double high, const Conversion& conversion,
                  std::string_view unit) {
    if (conversion.factor < 0.0) {
        const Conversion same_sign{.factor = -conversion.factor, .offset = -conversion.offset};
        QuantitySpec mirrored = spec;
        mirrored.above = false;
        return range(mirrored, -high, -low, same_sign, unit);
    }
    const bool below = std::isfinite(low);
    const bool over = std::isfinite(high);
    const std::string from = below ? spell(low, conversion, unit) : "";
    const std::string to = over ? spell(high, conversion, unit) : "";
    const std::string_view least = spec.above && low == spec.low ? "above" : "at least";
    if (below && over) {
        return spec.above && low == spec.low ? fmt::format("above {} and at most {}", from, to)
                                             : fmt::format("between {} and {}", from, to);
    }
    return below ? fmt::format("{} {}", least, from) : fmt::format("at most {}", to);
}

bool decimal_comma(std::string_view rest) {
    return rest.size() > 1 && rest[0] == ',' && rest[1] >= '0' && rest[1] <= '9';
}

/// Of a number that no double holds: whether it is too close to zero, not too large. @param text as std::from_chars read it
bool is_tiny(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view digits = text.substr(0, e);
    const std::size_t first = digits.find_first_of("123456789");
    const std::size_t point = std::min(digits.find('.'), digits.size());
    if (first == std::string_view::npos) {
        return true;
    }
    int exponent = 0;
    if (e != std::string_view::npos) {
        const std::size_t from = e + (text[e + 1] == '+' ? 2 : 1);
        if (std::from_chars(text.data() + from, text.data() + text.size(), exponent).ec != std::errc()) {
            return text[e + 1] == '-';  // an exponent of more than nine digits
        }
    }
    // Of the first digit that counts, its power of ten and the exponent.
    return static_cast<double>(point) - static_cast<double>(first) + exponent < 0.0;
}

/// A decimal number of at most 15 digits without an exponent, as logs have: a whole number over a power of ten. Both are exact, so that
/// the quotient is rounded once, as by from_chars, which takes four times as long. @returns how long it is; 0: there is none such
std::size_t read_short_decimal(std::string_view text, double& value) {
    constexpr std::array powers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool is_negative = text.starts_with('-');
    std::int64_t whole = 0;
    std::size_t digits = 0;
    std::size_t decimals = 0;
    std::size_t point = 0;
    std::size_t i = is_negative ? 1 : 0;
    for (; i < text.size() && digits < powers.size(); ++i) {
        const auto digit = static_cast<unsigned char>(text[i] - '0');
        if (digit < 10) {
            whole = 10 * whole + digit;
            ++digits;
            decimals += point;
        } else if (text[i] == '.' && point == 0) {
            point = 1;
        } else {
            break;
        }
    }
    if (digits == 0 || digits == powers.size() || (i < text.size() && (text[i] == 'e' || text[i] == 'E'))) {
        return 0;
    }
    const double size = static_cast<double>(whole) / powers[decimals];
    value = is_negative ? -size : size;
    return i;
}

}  // namespace

std::optional<Number> leading_number(std::string_view text) {
    text = trim(text);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    if (const std::size_t length = read_short_decimal(text, value); length > 0) {
        return Number{value, trim(text.substr(length))};
    }
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range) {
        const std::string_view read(text.data(), static_cast<std::size_t>(end - text.data()));
        const double size = is_tiny(read) ? 0.0 : std::numeric_limits<double>::infinity();
        value = text.starts_with('-') ? -size : size;
    } else if (error != std::errc()) {
        return std::nullopt;
    }
    return Number{value, trim(text.substr(static_cast<std::size_t>(end - text.data())))};
}

std::string spell_example(const QuantitySpec& spec) {
    const std::string example = dimension(spec.unit, spec.scale).example;
    return spec.is_pure() ? example : fmt::format("\"{}\"", example.empty() ? "1 " + std::string(spec.unit) : example);
}

std::string write_like(const QuantitySpec& spec) {
    return fmt::format("write {}, such as {}", dimension(spec.unit, spec.scale).name, spell_example(spec));
}

namespace {

/// The usual unit of this kind that was probably meant, or else an example.
std::string unit_remedy(std::string_view unit, const QuantitySpec& spec) {
    std::istringstream words(dimension(spec.unit, spec.scale).units);
    const std::vector<std::string> usual{std::istream_iterator<std::string>(words), {}};
    const std::string near = nearest(unit, usual);
    return near.empty() ? write_like(spec) : fmt::format("did you mean `{}`?", near);
}

}  // namespace

std::string absolute_pressure_remedy(std::string_view unit, const QuantitySpec& spec) {
    constexpr double atmosphere = 101325.0;  // Pa, ISO 2533 at sea level
    const std::string_view gauge = gauge_unit_of(unit);
    if (gauge.empty() || signature(spec.unit) != signature("Pa")) {
        return {};
    }
    const auto read = std::get<Conversion>(conversion(gauge, "Pa", Scale::absolute));
    return fmt::format("take the atmosphere's {:.4g} {} (at sea level) away from the numbers and write {}",
                       read.from_si(atmosphere), gauge, gauge);
}

UnitRead read_unit(std::string_view unit, const QuantitySpec& spec, std::string_view subject) {
    const auto result = conversion(unit, spec.unit, spec.scale);
    if (const auto* found = std::get_if<Conversion>(&result)) {
        return {*found, std::nullopt};
    }
    // UDUNITS takes the a of psi(a) for 100 m2.
    if (const std::string absolute = absolute_pressure_remedy(unit, spec); !absolute.empty()) {
        return {{},
                ErrorText{fmt::format("{}: \"{}\" is an absolute pressure; wanted is one above the atmosphere", subject,
                                      unit),
                          absolute}};
    }
    const std::string remedy = write_like(spec);
    switch (std::get<UnitError>(result)) {
        case UnitError::unknown:
            return {{}, ErrorText{fmt::format("{}: \"{}\" is not a unit", subject, unit), unit_remedy(unit, spec)}};
        case UnitError::number_inside:
            return {{}, ErrorText{fmt::format("{}, with a number inside the unit \"{}\"", subject, unit), remedy}};
        case UnitError::other_dimension:
            break;
    }
    const bool is_temperature = signature(spec.unit) == "K";
    std::string_view aside;
    if (is_temperature && (unit == "C" || unit == "F")) {
        aside = unit == "C" ? " (C is the coulomb)" : " (F is the farad)";
    }
    return {{},
            ErrorText{fmt::format("{}, {}{}; {} is wanted", subject, dimension(unit, Scale::absolute).name, aside,
                                  dimension(spec.unit, spec.scale).name),
                      remedy}};
}

ParsedQuantity check_quantity(double written, const Conversion& unit_conversion, std::string_view unit,
                              const QuantitySpec& spec, std::string_view name, std::string_view shown) {
    ParsedQuantity parsed{.value = unit_conversion.to_si(written), .error = {}, .remark = {}};
    const auto refuse = [&](std::string what, std::string remedy = {}) {
        parsed.error = ErrorText{std::move(what), std::move(remedy)};
        return parsed;
    };
    if (!std::isfinite(written)) {
        const std::size_t first = shown.find_first_not_of("\"+-. ");
        const bool huge = first != std::string_view::npos && shown[first] >= '0' && shown[first] <= '9';
        return refuse(huge
                          ? fmt::format("{} is {}, larger than any number that is computed with (1.8e308)", name, shown)
                          : fmt::format("{} is {}, not a finite number", name, shown),
                      write_like(spec));
    }
    // A constant of a law may lie below zero on the scale of temperatures; it says so by its bounds.
    const bool only_a_place = std::isfinite(spec.low) && spec.low < 0.0;
    if (spec.unit == "K" && spec.scale == Scale::absolute && !only_a_place && parsed.value < 0.0) {
        return refuse(fmt::format("{} is {}, below absolute zero", name, shown));
    }
    if (parsed.value < spec.low || parsed.value > spec.high || (spec.above && parsed.value == spec.low)) {
        const bool forgotten = spec.unit == "K" && spec.scale == Scale::absolute && unit == "K" &&
                               written + zero_celsius >= spec.low && written + zero_celsius <= spec.high;
        return refuse(fmt::format("{} is {}; it must be {}", name, shown,
                                  range(spec, spec.low, spec.high, unit_conversion, unit)),
                      forgotten ? fmt::format("did you mean \"{:.6g} degC\"?", written) : "");
    }
    if (parsed.value < spec.usual_low || parsed.value > spec.usual_high) {
        parsed.remark = fmt::format("{} is {}, which is unusual: it is mostly {}", name, shown,
                                    range(spec, spec.usual_low, spec.usual_high, unit_conversion, unit));
    }
    return parsed;
}

ParsedQuantity parse_quantity(std::string_view text, const QuantitySpec& spec, std::string_view name) {
    const std::string shown = fmt::format("\"{}\"", text);
    const std::string subject = fmt::format("{} is {}", name, shown);
    const std::optional<Number> number = leading_number(text);
    if (!number) {
        return {0.0, ErrorText{fmt::format("{}, which does not start with a number", subject), write_like(spec)}, {}};
    }
    if (decimal_comma(number->rest)) {
        std::string point(text);
        point.replace(point.find(','), 1, ".");
        const std::size_t comma = text.find(',');
        const bool thousands = text.find_first_not_of("0123456789", comma + 1) == comma + 4;
        std::string none(text);
        none.erase(comma, 1);
        return {0.0,
                ErrorText{fmt::format("{}, with a comma in the number", subject),
                          thousands ? fmt::format("write \"{}\" or \"{}\"", none, point)
                                    : fmt::format("write \"{}\"", point)},
                {}};
    }
    if (number->rest.empty() && !spec.is_pure()) {
        return {0.0, ErrorText{fmt::format("{}, without a unit", subject), write_like(spec)}, {}};
    }
    const UnitRead unit = read_unit(number->rest, spec, subject);
    if (unit.error) {
        return {0.0, unit.error, {}};
    }
    return check_quantity(number->value, unit.conversion, number->rest, spec, name, shown);
}

}  // namespace tiretherm::input
