// SPDX-License-Identifier: BSD-3-Clause
// Logs as CSV text with units in the headings, as the truths write them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "two_node/programme_truth.hpp"
#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

/// A column of a log, `name [unit]`, with the digits that it is written with.
struct Column {
    std::string heading;
    int digits = 2;
    std::vector<double> value;
};

/// One line of headings, then numbers, as loggers write them.
[[nodiscard]] std::string written(const std::vector<Column>& columns);
/// @errors std::runtime_error names the file that cannot be written
void write(const std::filesystem::path& file, const std::vector<Column>& columns);

/// A run of the bench: what was logged of its inputs and what its sensors gave. @param trace K
[[nodiscard]] std::vector<Column> bench_columns(const Programme& programme, const BenchTrace& trace);

}  // namespace hidden_effects
