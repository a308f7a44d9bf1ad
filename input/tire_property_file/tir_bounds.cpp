// SPDX-License-Identifier: BSD-3-Clause
// The bounds of each key as a table; they take in everything from bicycles to trucks and racing slicks, and exclude slips of
// the pen, lost decimal points and signs that turn a force off.

#include "input/tire_property_file/tir_bounds.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

/// Which values a key may have.
struct Bounds {
    std::string_view keys;  ///< a blank apart, and at both ends
    double low = 0.0;
    double high = 0.0;
    bool by_magnitude = false;  ///< the sign is that of the file's axis system
    std::string_view what;      ///< the key's meaning, with its usual size
};

constexpr std::array all_bounds{
    Bounds{" PCX1 PCY1 ", 0.1, 3.0, false, "a shape factor C, 1 to 2 for tires"},
    Bounds{" PDX1 PDY1 ", 0.1, 5.0, true, "the friction at the nominal load, 0.7 to 3 for tires"},
    Bounds{" PKX1 PKY1 ", 1.0, 500.0, true, "a stiffness over the nominal load, 5 to 100 for tires"},
    Bounds{" PKY2 ", 0.05, 50.0, true,
           "the load over the nominal one at which the stiffness is largest, 1 to 5 for tires"},
    Bounds{" LFZO LCX LMUX LKX LCY LMUY LKY ", 0.01, 10.0, false,
           "a scaling factor, 1 for the tire as it was measured"},
    Bounds{" LMUV ", 0.0, 10.0, false, "the decay of friction with the sliding speed, 0 without one"},
    Bounds{" LEX LHX LVX LEY LHY LVY LKYC LGAX LGAY ", -10.0, 10.0, false,
           "a scaling factor, 1 for the tire as it was measured"},
    Bounds{" PHX1 PHX2 PHY1 PHY2 PHY3 ", -1.0, 1.0, false, "a shift of the slip, some thousandths for tires"},
    Bounds{" PVX1 PVX2 PVY1 PVY2 PVY3 PVY4 ", -10.0, 10.0, false,
           "a shift of the force over the load, some hundredths"},
    Bounds{" PDX2 PDX3 PDY2 PDY3 PKX3 PKY3 PKY4 ", -100.0, 100.0, false, "a change with load or camber"},
    Bounds{" PKX2 PKY5 PKY6 PKY7 PEX1 PEX2 PEX3 PEX4 PEY1 PEY2 PEY3 PEY4 PEY5 ", -1000.0, 1000.0, false,
           "a coefficient of a tire"},
};

const Bounds* bounds_of(std::string_view key) {
    const std::string word = fmt::format(" {} ", key);
    for (const Bounds& bounds : all_bounds) {
        if (bounds.keys.find(word) != std::string_view::npos) {
            return &bounds;
        }
    }
    return nullptr;
}

}  // namespace

void check_tir_bounds(const TirLines& lines, InputErrors& errors) {
    InputErrors unheard = errors;  // what is no number is said by who reads it
    for (const TirLines::Entry& entry : lines.entries()) {
        const Bounds* bounds = lines.find(entry.key) == &entry ? bounds_of(entry.key) : nullptr;
        const std::optional<double> value = bounds != nullptr ? lines.number(entry.key, unheard) : std::nullopt;
        if (!value) {
            continue;
        }
        const double size = bounds->by_magnitude ? std::abs(*value) : *value;
        if (size < bounds->low || size > bounds->high) {
            errors.add(entry.place,
                       fmt::format("{} is {}; {:g} to {:g}{} are possible", entry.key, entry.value, bounds->low,
                                   bounds->high, bounds->by_magnitude ? " of either sign" : ""),
                       fmt::format("correct it: {} is {}", entry.key, bounds->what));
        }
    }
}

}  // namespace tiretherm::input
