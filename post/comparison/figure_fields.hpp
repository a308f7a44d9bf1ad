// SPDX-License-Identifier: BSD-3-Clause
// Figures of differences as fields of a table.
#pragma once

#include "diagnosis/compare/comparison.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// A difference in the unit of its channel.
[[nodiscard]] Cell cell(const diagnosis::ComparedChannel& channel, double difference);
/// Samples, bias with its standard deviation, rms and scatter. @param with_scatter it stands on the page as well
[[nodiscard]] DataTable::Row figures(const diagnosis::ComparedChannel& channel, const diagnosis::Figures& f,
                                     bool with_scatter);
[[nodiscard]] DataTable::Row joined(DataTable::Row row, const DataTable::Row& rest);

}  // namespace tiretherm::post
