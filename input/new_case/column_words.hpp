// SPDX-License-Identifier: BSD-3-Clause
// Guesses what a column of a log may be from the words of its heading, and what a unit may mean that nobody knows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/case_text/mesh_template.hpp"
#include "input/tables/columns.hpp"
#include "input/text/column_names.hpp"

namespace tiretherm::input {

/// Something that a column may be: the time, an input or what a sensor reads.
struct ColumnMeaning {
    std::string name;
    QuantitySpec spec;
    bool is_input = false;
    bool is_sensor = false;
    bool any_unit = false;  ///< only whether there is something counts
};

/// All that a column may be: the time first, inputs, sensors of a mesh, signals of a car.
[[nodiscard]] std::vector<ColumnMeaning> meanings_of(const MeshTemplate& mesh);
/// The meaning of a name; null: none.
[[nodiscard]] const ColumnMeaning* find_meaning(const std::vector<ColumnMeaning>& meanings, std::string_view name);
/// Whether a column that counts in any unit is in a unit of pressure.
[[nodiscard]] bool is_pressure(const Heading& heading);

/// The unit that messages would write for a quantity: km/h, N, degC.
[[nodiscard]] std::string usual_unit(const QuantitySpec& spec);

/// What a column may be, by the words of its heading among those of a unit that suits; null: no guess.
[[nodiscard]] const ColumnMeaning* guess_meaning(const Heading& heading, const std::vector<ColumnMeaning>& meanings);

}  // namespace tiretherm::input
