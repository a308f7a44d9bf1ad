// SPDX-License-Identifier: BSD-3-Clause
// The list [[material]] as it was read, and checks of its laws over the temperatures of the case.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "input/materials/cord_rubber.hpp"
#include "input/toml/toml_table.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// A material of the case, whether or not a layer is made of it.
struct Stock {
    physics::Material material;
    const TomlValue* table = nullptr;
    std::optional<CordRubberPly> ply{};  ///< of cords in rubber: its conductivities follow from them
    bool used =
        false;  ///< a layer is made of it, the stiffness of the belt follows it, or plies are whose rubber it is
};

[[nodiscard]] std::vector<Stock> read_materials(TomlTable& root);
[[nodiscard]] std::vector<std::string> names_of_materials(const std::vector<Stock>& all);

/// The material of a name, which is used then; null after an error.
[[nodiscard]] const Stock* use_material(const LocatedString& name, std::vector<Stock>& stock, InputErrors& errors);
/// The one that a key names.
[[nodiscard]] const Stock* read_material(TomlTable& table, std::string_view key, std::vector<Stock>& stock);

/// Laws must be positive wherever the run is sure to go: between the coldest and the hottest temperature that the case
/// gives. Where they would fail on the way up to 150 degC, a warning.
void check_laws(TomlTable& root, const solver::Problem& problem, const std::vector<Stock>& stock);

}  // namespace tiretherm::input
