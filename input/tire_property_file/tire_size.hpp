// SPDX-License-Identifier: BSD-3-Clause
// The size of a tire as it stands on its sidewall (ISO 4000-1): "225/50 R17", or in inches: "31x10.50R15LT", "11R22.5".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "input/text/input_error.hpp"
#include "physics/tire_laws/load_capacity.hpp"

namespace tiretherm::input {

/// Width in mm / section height in % of it, R, diameter of the rim in inches; or outer diameter, width and rim in inches, or
/// width and rim alone; with or without what sidewalls add.
struct TireSize {
    std::string text;             ///< as written
    double width = 0.0;           ///< m
    double section_height = 0.0;  ///< m
    double rim_diameter = 0.0;    ///< m
    double aspect_ratio = 0.0;    ///< %
    bool light_truck = false;     ///< LT or ST before the width, C or LT behind the rim; a truck's
    bool truck = false;           ///< a rim of half inches, or of 20 in and more with a width in inches
    /// M/C behind the rim, or as motorcycles alone have them: a width in whole centimetres, of at most 240 mm (ETRTO writes those of
    /// passenger tires with a 5 at the end; recalled).
    bool motorcycle = false;
    std::string assumption{};                              ///< what the size does not say; empty: nothing
    std::optional<physics::ServiceDescription> service{};  ///< what may stand behind: 94H

    /// Pressure above the atmosphere at which it carries the load of its index: 250 kPa, of light trucks 450, of trucks 800, of
    /// a motorcycle's rear 290; usual ones (recalled), for sidewalls differ. Pa
    [[nodiscard]] double load_pressure() const;
    /// On rims of 5 and 6 in.
    [[nodiscard]] bool is_kart() const { return rim_diameter < 0.17; }
    /// Of a motorcycle, up to 130 mm of width: assumed.
    [[nodiscard]] bool is_motorcycle_front() const { return motorcycle && width < 0.135; }
    /// Half the rim and the section height: m, without load.
    [[nodiscard]] double radius() const { return 0.5 * rim_diameter + section_height; }
};

/// @returns the size, or why the text is none and what to write
[[nodiscard]] std::variant<TireSize, ErrorText> read_tire_size(std::string_view text);

}  // namespace tiretherm::input
