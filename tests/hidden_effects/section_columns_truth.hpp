#pragma once

#include <vector>

#include "section_truth.hpp"
#include "table_truth.hpp"

namespace hidden_effects {

/// A run of the section's bench: what was logged of its inputs and what its sensors gave. @param trace K
[[nodiscard]] std::vector<Column> section_columns(const SectionProgramme& programme, const SectionTrace& trace);

}  // namespace hidden_effects
