// SPDX-License-Identifier: BSD-3-Clause
// Writes a first case from a tire's size, or from the columns of a data logger's file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/new_case/drum_tests.hpp"
#include "input/new_case/log_columns.hpp"
#include "input/tire_property_file/tire_size.hpp"

namespace tiretherm::input {

/// What a new case is to be about.
struct NewCaseRequest {
    TireSize size;                               ///< of no use to a specimen
    bool size_is_assumed = false;                ///< nobody named it
    std::optional<double> inflation_pressure{};  ///< Pa above the atmosphere; none: by the kind of tire
    std::string mesh{};                          ///< one of mesh_template_names(); empty: by the log
    std::optional<std::filesystem::path> log{};
    std::optional<DrumTest> test{};  ///< of a size, on a cross-section
    bool literature = false;         ///< conductivities of literature in the place of K1 and K2, on a cross-section
    std::vector<GivenUnit> units{};  ///< of columns of the log
    std::filesystem::path target;    ///< where the case will be: paths in it are written from its folder
};

/// A value that the case has and nobody gave.
struct AssumedValue {
    std::string key;    ///< "drive.speed"
    std::string value;  ///< as the case writes it, without quotation marks
    std::string reason;
};

/// What a further step needs, and what to do about it.
struct MissingPart {
    std::string what;
    std::string remedy;
};

/// The case that was made. There is a text exactly when there is no error.
struct NewCase {
    std::string text;
    std::string unread;     ///< why the case does not read the log, a sentence; empty: it does, or there is none
    std::string mesh;       ///< in words: "a cross-section"
    std::string mesh_name;  ///< as the option takes it: "section"
    std::optional<Log> log;
    std::vector<AssumedValue> assumed;
    std::vector<MissingPart> missing;
    std::vector<InputError> errors;     ///< of the log; of the case, where its values do not make a tire
    std::vector<std::string> warnings;  ///< of the reader, and what is suspicious in the log
    std::vector<std::string> files;     ///< that were read of the log: itself, and what stands beside it
};

/// Makes the text of a case that runs as it is, and reads it as `tiretherm run` would. Writes no file. Never throws on
/// account of what a user wrote.
[[nodiscard]] NewCase make_new_case(const NewCaseRequest& request);

}  // namespace tiretherm::input
