// SPDX-License-Identifier: BSD-3-Clause
// Reader of TYDEX/ADAMS tire property files (.tir): Magic Formula MF 5.2 and MF 6.1 in pure slip, in SI units.
#pragma once

#include <filesystem>
#include <optional>

#include "input/toml/document.hpp"
#include "physics/tire_laws/magic_formula.hpp"

namespace tiretherm::input {

/// A tire of a TYDEX/ADAMS property file (`.tir`), in SI units.
struct TirFile {
    physics::MagicFormula law;
    double unloaded_radius = 0.0;  ///< m
    double width = 0.0;            ///< m
    bool is_left = false;          ///< TYRESIDE = 'LEFT': the shifts are those of a tire on the left

    /// The law of the tire on the right of a car: the mirror image of what was measured on the left.
    [[nodiscard]] physics::MagicFormula law_on_the_right() const;

    struct LoadRange {
        double low = 0.0;   ///< N, FZMIN
        double high = 0.0;  ///< N, FZMAX
    };
    std::optional<LoadRange> vertical_range;  ///< where the coefficients were fitted
};

/// Reads the coefficients of pure slip and the dimensions. FITTYP 5, 6 and 21, and PROPERTY_FILE_FORMAT = 'PAC2002'
/// without one, are MF 5.2; 61 and 62 are MF 6.1.
/// [UNITS] holds for dimensions, loads and speeds; the coefficients are pure or per radian whatever it says. Warned of:
/// coefficients of pure slip that are unknown or that the version does not use, and terms of the pressure without NOMPRES.
/// Those of combined slip and moments are passed over. Signs and sizes that no tire has are errors. Without longitudinal coefficients F_x is 0, with a warning.
/// @param mentioned where the path was written; its file is -1 for one that the user named
/// @returns nothing after an error; all errors of the file are reported
[[nodiscard]] std::optional<TirFile> read_tir_file(const std::filesystem::path& path, const SourceLocation& mentioned,
                                                   InputErrors& errors);

}  // namespace tiretherm::input
