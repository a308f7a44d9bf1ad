// SPDX-License-Identifier: BSD-3-Clause
// Parts of a study's report that have a file of their own.
#pragma once

#include <string>
#include <vector>

#include "post/study/study_report.hpp"

namespace tiretherm::post {

constexpr std::size_t most_rows = 24;  ///< of a table on a study's page

/// An object of what was varied in a run. @param grid_only without what was drawn
[[nodiscard]] Value study_values(const diagnosis::StudyRecord& study, std::size_t run, bool grid_only);
/// "81.0", or "failed" where no run came to its end. @param hottest degC, coldest first
[[nodiscard]] std::string median_text(const std::vector<double>& hottest);
/// A row for each point of the grid: of a curve, or what its samples give.
[[nodiscard]] DataTable study_points(const diagnosis::StudyRecord& study);
/// The answer of a study: how many samples pass the critical temperature and how they spread, or from where to where a grid goes.
[[nodiscard]] std::vector<std::string> study_headline(const diagnosis::StudyRecord& study);
/// The linear regression at each point of the grid, where a page holds them.
[[nodiscard]] ReportSection drivers_section(const diagnosis::StudyRecord& study);

}  // namespace tiretherm::post
