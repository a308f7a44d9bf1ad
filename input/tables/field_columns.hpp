// SPDX-License-Identifier: BSD-3-Clause
// Columns or datasets that a field file of a structural code may have, with unit and range.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// A column, or dataset, that a field of a structural code may have.
struct FieldColumn {
    std::string_view name;
    QuantitySpec spec;
    std::string_view usual_unit;
    Purpose purpose = Purpose::point;
};
[[nodiscard]] std::span<const FieldColumn> field_columns();
/// @pre there is one of the name
[[nodiscard]] const FieldColumn& field_column(std::string_view name);

/// How to write its unit. @param in_text into a heading; otherwise into an attribute
[[nodiscard]] std::string unit_remedy(const FieldColumn& column, bool in_text);

}  // namespace tiretherm::input
