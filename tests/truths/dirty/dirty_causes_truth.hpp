// SPDX-License-Identifier: BSD-3-Clause
// The causes that a set of dirty data may hide.
#pragma once

#include <string>
#include <vector>

#include "dirty/dirty_set_truth.hpp"
#include "numerics/random_truth.hpp"

namespace hidden_effects {

/// Words of all causes: physical ones, wrong inputs, imperfect sensors.
[[nodiscard]] const std::vector<std::string>& dirty_cause_words();
/// Whether the set can have it: its base model, its sensors and the causes that it has already.
[[nodiscard]] bool dirty_cause_fits(const DirtySet& set, const std::string& word);
/// Puts a cause of random size into the set's world. @param strength 0 to 1, of the largest size
void add_dirty_cause(DirtySet& set, const std::string& word, double strength, Random& random);

}  // namespace hidden_effects
