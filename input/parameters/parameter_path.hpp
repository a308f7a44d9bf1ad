// SPDX-License-Identifier: BSD-3-Clause
// The address of one value of a case: what [[parameter]], [[vary]], [[draw]], [[uncertain]] and fitted cases share.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/toml/toml_table.hpp"
#include "input/toml/tree.hpp"
#include "solver/sensitivity/free_parameter.hpp"

namespace tiretherm::input {

/// The keys that lead from the root of a case to one of its values: "drive.speed", "effects.air_convection.lambda_h",
/// "effects.still_air.h_by_patch.beads". In a list whose tables have names, the name is the key:
/// "material.tread rubber.density". The same path finds the value in the document of the case, changes it there, and leads
/// to the number of the problem that a fit may move (see resolve).
struct ParameterPath {
    TomlPath keys;  ///< at least two

    /// Splits a text at its dots, those within a name of the document's lists excepted.
    /// @returns nothing after an error: an empty key, or one key alone
    [[nodiscard]] static std::optional<ParameterPath> parse(const LocatedString& text, const TomlValue& document,
                                                            InputErrors& errors);
    /// Where a number of a problem stands in its case. An initial temperature belongs to [initial] of the case or of a run.
    [[nodiscard]] static ParameterPath of(const solver::Problem& problem, const solver::FreeParameter& number);
    /// Where a number of an effect that is on stands: the value that counts everywhere.
    [[nodiscard]] static ParameterPath of(const physics::ActiveEffect& active, std::size_t parameter);

    /// "effects.air_convection.lambda_h", as messages show it and `parse` takes it.
    [[nodiscard]] std::string text() const;
    /// A law k(T) or c(T), which is addressed by its values at temperatures: the key `at` of a [[parameter]].
    [[nodiscard]] bool is_law() const;

    [[nodiscard]] const TomlValue* find(const TomlValue& document) const { return input::find(document, keys); }
    bool set(TomlValue& document, const TomlValue& value, InputErrors& errors) const {
        return input::set(document, keys, value, errors);
    }
};

/// The ending of a key whose values differ from place to place: "_by_patch" of "h_by_patch".
[[nodiscard]] std::string key_ending(physics::Scope scope);
/// All places of a kind, in the order of their indices. Of channels those of cameras as well, behind the sensors.
[[nodiscard]] std::vector<std::string> place_names(const solver::Problem& problem, physics::Scope scope);

/// What a case calls a channel: by its own name, or by its camera's. @param channel index into Problem::channels
[[nodiscard]] std::string sensor_of(const solver::Problem& problem, int channel);

/// An effect of the catalogue or one number of it, as `[diagnose] candidates` names it: "radiation",
/// "sliding_friction.partition"; or by its path, "effects.sliding_friction.partition".
struct CatalogueEntry {
    const physics::Effect* effect = nullptr;
    std::optional<std::size_t> parameter{};  ///< all numbers of the effect where it is empty

    [[nodiscard]] bool includes(const physics::Effect& other, std::size_t number) const {
        return effect == &other && parameter.value_or(number) == number;
    }
    [[nodiscard]] std::string text() const;
};
/// @returns nothing where the catalogue has no such effect or number
[[nodiscard]] std::optional<CatalogueEntry> find_in_catalogue(std::string_view text);

}  // namespace tiretherm::input
