#include "input/text/quantity.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

/// "-540 km/h".
std::string spell(double si, const Conversion& unit_conversion, std::string_view unit) {
    const double written = unit_conversion.from_si(si);
    // A bound of zero may come back as 1e-14 through an offset.
    const double rounded = std::abs(written) < 1e-9 * std::abs(unit_conversion.offset) ? 0.0 : written;
    const std::string number = fmt::format("{:.6g}", rounded);
    return unit.empty() || unit == "1" || unit == "-" ? number : fmt::format("{} {}", number, unit);
}

std::string range(const Wanted& wanted, double low, double high, const Conversion& conversion, std::string_view unit) {
    const bool below = std::isfinite(low);
    const bool over = std::isfinite(high);
    const std::string from = below ? spell(low, conversion, unit) : "";
    const std::string to = over ? spell(high, conversion, unit) : "";
    const std::string_view least = wanted.above && low == wanted.low ? "above" : "at least";
    if (below && over) {
        return wanted.above && low == wanted.low ? fmt::format("above {} and at most {}", from, to)
                                                 : fmt::format("between {} and {}", from, to);
    }
    return below ? fmt::format("{} {}", least, from) : fmt::format("at most {}", to);
}

bool decimal_comma(std::string_view rest) {
    return rest.size() > 1 && rest[0] == ',' && rest[1] >= '0' && rest[1] <= '9';
}

}  // namespace

std::optional<Number> leading_number(std::string_view text) {
    text = trim(text);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range) {
        value = std::numeric_limits<double>::infinity();
    } else if (error != std::errc()) {
        return std::nullopt;
    }
    return Number{value, trim(text.substr(static_cast<std::size_t>(end - text.data())))};
}

std::string spell_example(const Wanted& wanted) {
    const std::string example = dimension(wanted.unit, wanted.scale).example;
    return wanted.is_pure() ? example
                            : fmt::format("\"{}\"", example.empty() ? "1 " + std::string(wanted.unit) : example);
}

std::string write_like(const Wanted& wanted) {
    return fmt::format("write {}, such as {}", dimension(wanted.unit, wanted.scale).name, spell_example(wanted));
}

UnitRead read_unit(std::string_view unit, const Wanted& wanted, std::string_view subject) {
    const auto result = conversion(unit, wanted.unit, wanted.scale);
    if (const auto* found = std::get_if<Conversion>(&result)) {
        return {*found, std::nullopt};
    }
    const std::string remedy = write_like(wanted);
    switch (std::get<UnitFault>(result)) {
        case UnitFault::unknown:
            return {{}, Fault{fmt::format("{}: \"{}\" is not a unit", subject, unit), remedy}};
        case UnitFault::number_inside:
            return {{}, Fault{fmt::format("{}, with a number inside the unit \"{}\"", subject, unit), remedy}};
        case UnitFault::other_dimension:
            break;
    }
    const bool is_temperature = signature(wanted.unit) == "K";
    std::string_view aside;
    if (is_temperature && (unit == "C" || unit == "F")) {
        aside = unit == "C" ? " (C is the coulomb)" : " (F is the farad)";
    }
    return {{},
            Fault{fmt::format("{}, {}{}; {} is wanted", subject, dimension(unit, Scale::absolute).name, aside,
                              dimension(wanted.unit, wanted.scale).name),
                  remedy}};
}

Judged judge(double written, const Conversion& unit_conversion, std::string_view unit, const Wanted& wanted,
             std::string_view name, std::string_view shown) {
    Judged judged{.value = unit_conversion.to_si(written), .fault = {}, .remark = {}};
    const auto refuse = [&](std::string what, std::string remedy = {}) {
        judged.fault = Fault{std::move(what), std::move(remedy)};
        return judged;
    };
    if (!std::isfinite(written)) {
        return refuse(fmt::format("{} is {}, not a finite number", name, shown), write_like(wanted));
    }
    // A constant of a law may lie below zero on the scale of temperatures; it says so by its bounds.
    const bool only_a_place = std::isfinite(wanted.low) && wanted.low < 0.0;
    if (wanted.unit == "K" && wanted.scale == Scale::absolute && !only_a_place && judged.value < 0.0) {
        return refuse(fmt::format("{} is {}, below absolute zero", name, shown));
    }
    if (judged.value < wanted.low || judged.value > wanted.high || (wanted.above && judged.value == wanted.low)) {
        const bool forgotten = wanted.unit == "K" && wanted.scale == Scale::absolute && unit == "K" &&
                               written + 273.15 >= wanted.low && written + 273.15 <= wanted.high;
        return refuse(fmt::format("{} is {}; it must be {}", name, shown,
                                  range(wanted, wanted.low, wanted.high, unit_conversion, unit)),
                      forgotten ? fmt::format("did you mean \"{:.6g} degC\"?", written) : "");
    }
    if (judged.value < wanted.usual_low || judged.value > wanted.usual_high) {
        judged.remark = fmt::format("{} is {}, which is unusual: it is mostly {}", name, shown,
                                    range(wanted, wanted.usual_low, wanted.usual_high, unit_conversion, unit));
    }
    return judged;
}

Judged quantity(std::string_view text, const Wanted& wanted, std::string_view name) {
    const std::string shown = fmt::format("\"{}\"", text);
    const std::string subject = fmt::format("{} is {}", name, shown);
    const std::optional<Number> number = leading_number(text);
    if (!number) {
        return {0.0, Fault{fmt::format("{}, which does not start with a number", subject), write_like(wanted)}, {}};
    }
    if (decimal_comma(number->rest)) {
        std::string point(text);
        point.replace(point.find(','), 1, ".");
        const std::size_t comma = text.find(',');
        const bool thousands = text.find_first_not_of("0123456789", comma + 1) == comma + 4;
        std::string none(text);
        none.erase(comma, 1);
        return {
            0.0,
            Fault{fmt::format("{}, with a comma in the number", subject),
                  thousands ? fmt::format("write \"{}\" or \"{}\"", none, point) : fmt::format("write \"{}\"", point)},
            {}};
    }
    if (number->rest.empty() && !wanted.is_pure()) {
        return {0.0, Fault{fmt::format("{}, without a unit", subject), write_like(wanted)}, {}};
    }
    const UnitRead unit = read_unit(number->rest, wanted, subject);
    if (unit.fault) {
        return {0.0, unit.fault, {}};
    }
    return judge(number->value, unit.conversion, number->rest, wanted, name, shown);
}

}  // namespace tiretherm::input
