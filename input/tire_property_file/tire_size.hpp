// SPDX-License-Identifier: BSD-3-Clause
// The size of a tire as it stands on its sidewall (ISO 4000-1): "225/50 R17".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "input/text/input_error.hpp"
#include "physics/tire_laws/load_capacity.hpp"

namespace tiretherm::input {

/// Width in mm / section height in % of it, R, diameter of the rim in inches; with or without what sidewalls add.
struct TireSize {
    std::string text;                                      ///< as written
    double width = 0.0;                                    ///< m
    double section_height = 0.0;                           ///< m
    double rim_diameter = 0.0;                             ///< m
    double aspect_ratio = 0.0;                             ///< %
    bool light_truck = false;                              ///< LT before the width or C behind the rim
    std::optional<physics::ServiceDescription> service{};  ///< what may stand behind: 94H

    /// Half the rim and the section height: m, without load.
    [[nodiscard]] double radius() const { return 0.5 * rim_diameter + section_height; }
};

/// @returns the size, or why the text is none and what to write
[[nodiscard]] std::variant<TireSize, ErrorText> read_tire_size(std::string_view text);

}  // namespace tiretherm::input
