// SPDX-License-Identifier: BSD-3-Clause
// Data check: values whose size suggests another unit, such as km/h read as m/s or degF read as degC.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"
#include "input/measurements/dead_stretches.hpp"
#include "input/measurements/usual_units.hpp"
#include "physics/celsius.hpp"

/// What looks suspicious in the size of a signal: its unit is probably another one.
namespace tiretherm::input {

namespace {

/// The largest magnitude of an input, 0 where the file does not have it.
double largest(const Recording& recording, std::string_view name) {
    const RecordedColumn* column = recording.find(name);
    return column == nullptr || column->value.empty() ? 0.0 : column->largest();
}

/// How far the hottest sensor gets above its start and above air and road, K.
double rise(const Recording& recording) {
    double surroundings = 0.0;
    for (const RecordedColumn& column : recording.columns) {
        if (column.is_input && column.is_temperature() && !column.value.empty()) {
            surroundings = std::max(surroundings, column.high());
        }
    }
    double highest = 0.0;
    for (const RecordedColumn& column : recording.columns) {
        if (!column.is_input && column.is_temperature() && !column.value.empty()) {
            highest = std::max(highest, column.high() - std::max(surroundings, column.value.front()));
        }
    }
    return highest;
}

/// Free rolling heats a tire by some 10 K at 25 km/h, and in proportion; what gets hotter rolled faster or slid.
bool is_heated(const Recording& recording) {
    const double speed = largest(recording, "speed");
    return largest(recording, "vertical_load") > 0.0 && rise(recording) > 10.0 * std::max(1.0, speed / (25.0 * km_h));
}

bool rolls(const Recording& recording) { return largest(recording, "speed") > 5.0; }

/// A lateral force of a fifth of the load takes more than 0.3 degrees of slip on any tire.
bool corners(const Recording& recording) {
    return largest(recording, "lateral_force") > 0.2 * largest(recording, "vertical_load") &&
           largest(recording, "vertical_load") > 0.0;
}

bool slips(const Recording& recording) {
    return largest(recording, "slip_angle") > 1.0 * degree && largest(recording, "vertical_load") > 500.0;
}

bool always(const Recording&) { return true; }

/// What the largest magnitude of a signal is expected to be, and the units in which loggers write it.
struct Size {
    std::string_view name;
    double low = 0.0;  ///< smaller is suspicious where `matters`
    double high = no_limit;
    bool (*matters)(const Recording& recording) = always;
    std::array<std::string_view, 4> units{};  ///< the likeliest first
};
constexpr std::array sizes{
    Size{"speed", 45.0 * km_h, 70.0, is_heated, {"m/s", "km/h", "mph"}},
    Size{"vertical_load", 200.0, 4e4, rolls, {"kN", "N", "kgf", "lbf"}},
    Size{"lateral_force", 30.0, 4e4, slips, {"kN", "N", "kgf", "lbf"}},
    Size{"slip_angle", 0.3 * degree, 0.4, corners, {"rad", "deg"}},
    Size{"camber", 0.0, 20.0 * degree, always, {"deg", "rad"}},
    Size{"slip_ratio", 0.0, 2.0, always, {"%"}},
    Size{"inflation_pressure", 0.5 * bar, 7.0 * bar, always, {"bar", "kPa", "psi", "Pa"}},
    Size{"laser_power", 0.0, 50.0, always, {"mW"}},
};

/// Between which temperatures nearly all samples lie.
struct Span {
    std::string_view name;  ///< of an input; empty: of any sensor
    double low;
    double high;
};
constexpr std::array spans{Span{"air_temperature", zero_celsius - 40.0, zero_celsius + 55.0},
                           Span{"road_temperature", zero_celsius - 40.0, zero_celsius + 75.0},
                           Span{"", zero_celsius - 50.0, zero_celsius + 200.0}};
/// What may be meant, the likeliest first: numbers of 300 are rather kelvin than degrees Fahrenheit.
constexpr std::array<std::string_view, 3> temperature_units{"K", "degC", "degF"};
constexpr double wider = 1.5;         ///< usual sizes as bounds of what a column may be in another unit
constexpr double agreeing = 3.0;      ///< K: a tire that starts with the air
constexpr double disagreeing = 20.0;  ///< K

/// How the numbers of a column would be read in another unit; nothing when that is the same.
std::optional<Conversion> in_unit(const RecordedColumn& column, std::string_view unit) {
    const auto read = unit.empty() ? std::variant<Conversion, UnitError>(UnitError::unknown)
                                   : conversion(unit, column.si, Scale::absolute);
    const auto* found = std::get_if<Conversion>(&read);
    const bool other = found != nullptr && (std::abs(found->factor / column.conversion.factor - 1.0) > 1e-6 ||
                                            std::abs(found->offset - column.conversion.offset) > 1e-3);
    return other ? std::optional(*found) : std::nullopt;
}

/// @param is what is seen: "reaches 100 m/s"
std::string doubt(const RecordedColumn& column, double si_amount, std::string_view is, const Conversion& as,
                  std::string_view unit) {
    const double written = column.conversion.from_si(si_amount);
    return fmt::format("{}, and {} {} would be {}: is the column in {}?", is, three_digits(written), unit,
                       column.show(as.to_si(written)), unit);
}

std::string doubt_size(const Recording& recording, const RecordedColumn& column, const Size& size) {
    const double now = column.largest();
    const bool small = now < size.low && now > 0.0 && size.matters(recording);
    if (!small && now <= size.high) {
        return {};
    }
    for (const std::string_view unit : size.units) {
        const std::optional<Conversion> as = in_unit(column, unit);
        if (!as) {
            continue;
        }
        const double other = as->to_si(column.conversion.from_si(now));
        if (other > size.low && other <= size.high) {
            const std::string is = small ? fmt::format("is at most {} over the whole run", column.show(now))
                                         : fmt::format("reaches {}", column.show(now));
            return doubt(column, now, is, *as, unit);
        }
    }
    return {};
}

std::string doubt_span(const RecordedColumn& column, const Span& span) {
    const double low = column.low();
    const double high = column.high();
    if (low >= span.low && high <= span.high) {
        return {};
    }
    for (const std::string_view unit : temperature_units) {
        const std::optional<Conversion> as = in_unit(column, unit);
        const auto read = [&](double si) { return as->to_si(column.conversion.from_si(si)); };
        if (as && read(low) >= span.low && read(high) <= span.high) {
            const bool above = high > span.high;
            const double extreme = above ? high : low;
            const std::string is = fmt::format("{} {}", above ? "reaches" : "falls to", column.show(extreme));
            return doubt(column, extreme, is, *as, unit);
        }
    }
    return {};
}

/// A sensor that starts far from the air, but with it if its numbers were in another unit.
std::string doubt_start(const Recording& recording, const RecordedColumn& column) {
    const RecordedColumn* air = recording.find("air_temperature");
    if (column.is_input || air == nullptr || air->value.empty()) {
        return {};
    }
    const std::vector<Stretch> dead = dead_stretches(air->time, air->value, air->si);
    const bool starts_dead = !dead.empty() && dead.front().first == 0 && dead.front().length < air->value.size();
    const double outside = air->value[starts_dead ? dead.front().length : 0];
    const double start = column.value.front();
    if (std::abs(start - outside) < disagreeing) {
        return {};
    }
    for (const std::string_view unit : temperature_units) {
        const std::optional<Conversion> as = in_unit(column, unit);
        if (as && std::abs(as->to_si(column.conversion.from_si(start)) - outside) < agreeing) {
            const std::string is = fmt::format("starts at {} in air of {}", column.show(start), column.show(outside));
            return doubt(column, start, is, *as, unit);
        }
    }
    return {};
}

}  // namespace

std::string find_unit_slip(const Recording& recording, const RecordedColumn& column) {
    for (const Size& size : sizes) {
        if (column.is_input && column.name == size.name) {
            return doubt_size(recording, column, size);
        }
    }
    if (!column.is_temperature()) {
        return {};
    }
    for (const Span& span : spans) {
        if (column.is_input ? column.name == span.name : span.name.empty()) {
            const std::string sentence = doubt_span(column, span);
            return sentence.empty() ? doubt_start(recording, column) : sentence;
        }
    }
    return {};
}

ReadColumn with_other_units(const RecordedColumn& column) {
    ReadColumn read{.name = column.name,
                    .heading = column.heading,
                    .unit = column.unit,
                    .quantity = std::string(column.si),
                    .line = column.line,
                    .is_input = column.is_input};
    // The same number under two units: from what was read back to the number, and from there to the other unit's amount.
    const auto add = [&](std::string_view unit, const auto& is_usual) {
        if (const std::optional<Conversion> as = in_unit(column, unit)) {
            const Conversion& now = column.conversion;
            const double factor = as->factor / now.factor;
            const Conversion from_read{.factor = factor, .offset = as->offset - factor * now.offset};
            if (is_usual(from_read)) {
                read.others.push_back({.name = std::string(unit), .from_read = from_read});
            }
        }
    };
    if (column.value.empty()) {
        return read;
    }
    for (const Size& size : sizes) {
        for (const std::string_view unit :
             column.is_input&& column.name == size.name ? size.units : decltype(size.units){}) {
            add(unit, [&](const Conversion& as) {
                const double largest = std::abs(as.to_si(column.largest()));
                return largest > size.low / wider && largest < size.high * wider;
            });
        }
    }
    for (const Span& span : spans) {
        if (column.is_temperature() && (column.is_input ? column.name == span.name : span.name.empty())) {
            for (const std::string_view unit : temperature_units) {
                add(unit, [&](const Conversion& as) {
                    return as.to_si(column.low()) >= span.low && as.to_si(column.high()) <= span.high;
                });
            }
        }
    }
    return read;
}

}  // namespace tiretherm::input
