// SPDX-License-Identifier: BSD-3-Clause
// Durability tests on a drum: steps, load and pressure of a tire by its load index and speed symbol.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "input/text/input_error.hpp"
#include "input/tire_property_file/tire_size.hpp"

namespace tiretherm::input {

/// A row of a test's schedule; straight lines between the rows.
struct DrumRow {
    double minutes = 0.0;
    double kmh = 0.0;
    double load_share = 1.0;  ///< of what the load index stands for
};

/// A test as it is for one tire.
struct DrumTest {
    std::string title;
    std::string origin;     ///< a sentence: what was read, recalled or assumed
    double load = 0.0;      ///< N, of the load index
    double pressure = 0.0;  ///< Pa above the atmosphere
    std::string pressure_ground;
    double room = 0.0;  ///< degC
    std::vector<DrumRow> rows;
};

/// un_r30, sae_j1561, fmvss_139_high_speed, fmvss_139_endurance, fmvss_139_low_pressure.
[[nodiscard]] std::span<const std::string_view> drum_test_names();

/// @param name one of them  @returns the test, or why this tire has none: no load index, or no speed symbol where the speeds
/// follow from it, or a tire of a truck
[[nodiscard]] std::variant<DrumTest, ErrorText> drum_test(std::string_view name, const TireSize& size);

}  // namespace tiretherm::input
