// SPDX-License-Identifier: BSD-3-Clause
// The address of one value of a case: what [[parameter]], [[vary]], [[draw]], [[uncertain]] and fitted cases share.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "input/toml/toml_table.hpp"
#include "input/toml/tree.hpp"

namespace tiretherm::input {

/// The keys that lead from the root of a case to one of its values: "drive.speed", "effects.air_convection.lambda_h",
/// "effects.still_air.h_by_patch.beads". In a list whose tables have names, the name is the key:
/// "material.tread rubber.density". The same path finds the value in the document of the case, changes it there, and leads
/// to the number of the problem that a fit may move (see ParameterKind).
struct ParameterPath {
    TomlPath keys;  ///< at least two

    /// Splits a text at its dots, those within a name of the document's lists excepted.
    /// @returns nothing after an error: an empty key, or one key alone
    [[nodiscard]] static std::optional<ParameterPath> parse(const LocatedString& text, const TomlValue& document,
                                                            InputErrors& errors);
    /// A path of keys that the program knows.
    [[nodiscard]] static ParameterPath of(std::initializer_list<std::string_view> keys);

    /// "effects.air_convection.lambda_h", as messages show it and `parse` takes it.
    [[nodiscard]] std::string text() const;
    /// A law k(T) or c(T), which is addressed by its values at temperatures: the key `at` of a [[parameter]].
    [[nodiscard]] bool is_law() const;

    [[nodiscard]] const TomlValue* find(const TomlValue& document) const { return input::find(document, keys); }
    bool set(TomlValue& document, const TomlValue& value, InputErrors& errors) const {
        return input::set(document, keys, value, errors);
    }
    /// The same in a document that is laid over a case: in lists, the tables that the path names are made as well.
    /// @errors std::logic_error where the path meets a value
    void put(TomlValue& over, TomlValue value) const;
};

}  // namespace tiretherm::input
