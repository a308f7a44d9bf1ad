// SPDX-License-Identifier: BSD-3-Clause
// Columns of a log of the section bench.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "numerics/table_truth.hpp"
#include "section/section_truth.hpp"

namespace hidden_effects {

/// A run of the section's bench, or of another with its inputs: what was logged of them and what its sensors gave.
/// @param trace K  @param channels names of its channels
[[nodiscard]] std::vector<Column> section_columns(const SectionProgramme& programme, const SectionTrace& trace,
                                                  std::span<const std::string_view> channels = section_channels);

}  // namespace hidden_effects
