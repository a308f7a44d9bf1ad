// SPDX-License-Identifier: BSD-3-Clause
// A case with one of its values moved: "drive.camber=+0.5 deg".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "input/runs/reader.hpp"

namespace tiretherm::input {

/// The runs of a case with one value changed.
struct ChangedRuns {
    std::string key;                  ///< "drive.camber", as the user wrote it
    std::string change;               ///< "+0.5 deg", "-10 %" or, in the place of the value, "on"
    std::vector<RunOfCase> runs{};    ///< those of the case in their order; empty where there are none
    std::string nothing_to_change{};  ///< why not, the rest of a sentence about the key; empty otherwise
    std::vector<InputError> errors{};
};

/// Pressure, camber, air and road, each up and down by what a day brings.
[[nodiscard]] std::vector<std::string> standard_changes();

/// Runs of a case with a value changed. With a sign the change is added to the value, with % in its share; without one it takes its
/// place. What would leave the possible range of an input is an error. An input of the tire ("drive.speed") is moved in all of its course, be it of a log, computed from the car's motion or
/// constant; every other value is one of the case's file. The start stays as it is, unless it is the value.
/// @param chosen of the case as it stands  @param text "KEY=CHANGE"; "KEY=+-CHANGE" are two
[[nodiscard]] std::vector<ChangedRuns> change_runs(const std::filesystem::path& file, const std::string& run,
                                                   const std::vector<RunOfCase>& chosen, const std::string& text);

/// The effects of a problem that read an input, by their names.
[[nodiscard]] std::vector<std::string> readers_of(const solver::Problem& problem, std::string_view signal);
/// The effects of the catalogue that would read it, were they on.
[[nodiscard]] std::vector<std::string> would_read(const solver::Problem& problem, std::string_view signal);

}  // namespace tiretherm::input
