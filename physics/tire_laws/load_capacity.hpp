// SPDX-License-Identifier: BSD-3-Clause
// What a tire may carry by its load index (ISO 4000-1) and at lower inflation pressures, load ~ pressure^0.8 (ETRTO).
#pragma once

#include <optional>

namespace tiretherm::physics {

/// Speeds and loads that a service description such as 94H stands for.
struct ServiceDescription {
    int load_index = 0;       ///< 50 to 160
    char speed_symbol = ' ';  ///< F to Y; ' ' where none is given

    /// @returns N, nothing for an index outside the table of ISO 4000-1 that is kept here
    [[nodiscard]] std::optional<double> load() const;
    /// @returns m/s, nothing without a symbol
    [[nodiscard]] std::optional<double> speed() const;
};

/// Pressure above the atmosphere at which a passenger tire of standard load carries the load of its index; 290 kPa of an
/// extra-load one. ETRTO Standards Manual (recalled). Pa
inline constexpr double standard_load_pressure = 250e3;

/// What it carries at another pressure: load (p/reference)^0.8, no more than the load. The exponent is ETRTO's of passenger
/// tires (recalled); TRA has 0.65 to 0.8 by size. @param load N  @param pressure, reference Pa  @returns N
[[nodiscard]] double load_capacity(double load, double pressure, double reference = standard_load_pressure);

}  // namespace tiretherm::physics
