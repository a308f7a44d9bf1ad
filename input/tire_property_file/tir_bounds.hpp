// SPDX-License-Identifier: BSD-3-Clause
// Signs and sizes that the numbers of a .tir file may have.
#pragma once

#include "input/tire_property_file/tir_lines.hpp"

namespace tiretherm::input {

/// Reports every coefficient and scaling factor of pure slip with a sign or a size that no tire's has, with its line.
void check_tir_bounds(const TirLines& lines, InputErrors& errors);

}  // namespace tiretherm::input
