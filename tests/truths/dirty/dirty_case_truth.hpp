// SPDX-License-Identifier: BSD-3-Clause
// A set of dirty data as files: the case as its user would write it, logs, and the answer.
#pragma once

#include <filesystem>
#include <string>

#include "dirty/dirty_set_truth.hpp"

namespace hidden_effects {

/// The base model as a case of the program: two nodes, or layers of so many cells.
/// @param fine with the grid that resolves the tread
[[nodiscard]] std::string dirty_case(const DirtySet& set, bool fine);
/// The tire that the case includes.
[[nodiscard]] std::string dirty_tire_table();
/// What is hidden and how large, true numbers, sensors: JSON.
[[nodiscard]] std::string dirty_answer(const DirtySet& set);
/// tire.toml, case.toml, fine.toml, run1.csv ..., kept.csv, perfect1.csv ... (the same runs with true inputs and
/// instruments without fault) and answer.json.
/// @errors std::runtime_error names the file that cannot be written
void write_dirty_set(const DirtySet& set, const std::filesystem::path& folder);

}  // namespace hidden_effects
