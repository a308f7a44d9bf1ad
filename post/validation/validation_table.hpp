// SPDX-License-Identifier: BSD-3-Clause
// Renders a validation table as text, Markdown and JSON.
#pragma once

#include <string>

#include "diagnosis/validation/validation_table.hpp"

namespace tiretherm::post {

/// For reading on a terminal. @param bold headings in bold  @returns lines, each ended by a newline
[[nodiscard]] std::string validation_text(const diagnosis::ValidationRecord& record, bool bold);
/// The table and the figures under it for a README.
[[nodiscard]] std::string validation_markdown(const diagnosis::ValidationRecord& record);
/// One JSON object: numbers, summary, runs, seconds, energy_closure, warnings.
[[nodiscard]] std::string validation_json(const diagnosis::ValidationRecord& record);

}  // namespace tiretherm::post
