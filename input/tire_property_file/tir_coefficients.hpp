// SPDX-License-Identifier: BSD-3-Clause
// Magic Formula coefficients and scaling factors of pure slip in a TYDEX/ADAMS property file, MF 5.2 or MF 6.1.
#pragma once

#include "input/tire_property_file/tir_lines.hpp"
#include "physics/tire_laws/magic_formula.hpp"

namespace tiretherm::input {

/// Reads the coefficients and scaling factors of pure slip into `law`, whose version is set. Errors are a missing
/// coefficient without which there is no force, and one that stands in two sections; one that is unknown, or that the
/// version does not use, is warned of.
void read_tir_coefficients(const TirLines& lines, const SourceLocation& whole, physics::MagicFormula& law,
                           InputErrors& errors);

/// Reports that a key is missing. @param section where it belongs
void require_tir_key(const TirLines& lines, const SourceLocation& whole, std::string_view key, std::string_view section,
                     InputErrors& errors);

}  // namespace tiretherm::input
