// SPDX-License-Identifier: BSD-3-Clause
// Converts the thesis's spreadsheet of ten sheets (thesis V.4 to V.7) into a case of the two-node model.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// A parameter of the sheets and its place in the case.
struct SheetMapped {
    std::string sheet;
    std::string parameter;
    std::string key;    ///< "tire.tread_thickness"; of a list "material.density", "sensor.cornering_stiffness"
    std::string value;  ///< as the sheet gives it
    bool is_number = false;
    double number = 0.0;
    std::string unit;  ///< empty for a text or a switch
};

/// A parameter of the sheets without a place in the case, and why.
struct SheetUnmapped {
    std::string sheet;
    std::string parameter;
    std::string value;
    std::string reason;
};

/// What the case needs and the sheets do not say.
struct SheetMissing {
    std::string key;
    std::string value;  ///< as the case writes it; empty where the program's own default does it
    std::string reason;
    std::string sheet;  ///< where it would stand; empty for what has no place in the sheets
    std::string parameter;
};

/// The case that a spreadsheet makes. There is a text exactly when there is no error.
struct SheetCase {
    std::string text;
    std::vector<std::string> sheets;
    std::vector<SheetMapped> mapped;
    std::vector<SheetUnmapped> unmapped;
    std::vector<SheetMissing> missing;
    std::vector<InputError> errors;
    std::vector<std::string> warnings;
};

/// Turns the thesis's spreadsheet of ten sheets into a case file of the two-node model, thesis V.4 to V.7. The text depends
/// on what the sheets say alone, not on the format of the file. Never throws on account of what a user wrote.
/// @param path an .xls or .xlsx workbook, or a folder with a CSV file for each sheet
[[nodiscard]] SheetCase convert_sheet(const std::filesystem::path& path);

}  // namespace tiretherm::input
