// SPDX-License-Identifier: BSD-3-Clause
// The reference of all keys of a case, as their descriptions say: the page docs/case-reference.md and the text of
// `tiretherm keys`.
#pragma once

#include <string>
#include <vector>

#include "input/schema/all_tables.hpp"

namespace tiretherm::post {

/// A page for docs/, with a table of keys for each table of a case.
[[nodiscard]] std::string case_reference_markdown(const std::vector<input::TableKeys>& tables);

/// One table for the terminal.
[[nodiscard]] std::string case_table_text(const input::TableKeys& table);

/// A line for each table.
[[nodiscard]] std::string case_tables_text(const std::vector<input::TableKeys>& tables);

/// What a table is called in a file: "[mesh]", "[[sensor]]", "top of the case".
[[nodiscard]] std::string heading_of(const input::TableKeys& table);

}  // namespace tiretherm::post
