// SPDX-License-Identifier: BSD-3-Clause
// The table [tire] as it was read.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "input/measurements/driven_signals.hpp"
#include "input/toml/toml_table.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// A law of the load: its table in [tire] and in [tire.measured], and a number that describes it otherwise.
struct LoadLaw {
    std::string_view name;
    std::optional<physics::Curve> physics::Tire::*member;
    std::optional<physics::Curve> physics::MeasuredLaws::*measured;
    QuantitySpec value;
    std::string_view number;  ///< a key of [tire]
};
[[nodiscard]] std::span<const LoadLaw> load_laws();

struct TireTable {
    bool given = false;
    bool has_density = false;  ///< in [tire], not only by a material
    physics::Tire tire{};      ///< as far as it could be read
    physics::Handling handling{};
};

[[nodiscard]] TireTable read_tire(TomlTable& root);

/// Whether the tire's laws follow the pressure, and warnings about inputs outside their range.
void settle_tire(TomlTable& root, bool has_tire, const GivenSignals& given, solver::Problem& problem);

}  // namespace tiretherm::input
