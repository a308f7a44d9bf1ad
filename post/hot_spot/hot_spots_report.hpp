// SPDX-License-Identifier: BSD-3-Clause
// The hot spots of a run as a part of its report, as a table and as a picture.
#pragma once

#include <filesystem>
#include <string>

#include "diagnosis/hot_spot/hot_spots.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// "step 3 (160 km/h, 5580 N), 4.2 min into it"; "at 160 km/h and 5580 N" where there are no steps.
[[nodiscard]] std::string moment_text(const diagnosis::TestMoment& moment);
/// "64.1 %"; "less than 1 %", "more than 99 %": assumed spreads on a straight line say no more of the tails.
[[nodiscard]] std::string probability_text(double probability);

/// What is said of each: how hot, where, when passed or what is left, step by step, what drives it.
[[nodiscard]] ReportSection hot_spots_section(const diagnosis::HotSpots& hot_spots, const mesh::Mesh& mesh);
/// "spots", an object each, and "notes". Temperatures in degC, speeds in km/h, times in s.
[[nodiscard]] Value hot_spots_data(const diagnosis::HotSpots& hot_spots, const mesh::Mesh& mesh);

/// The histories, a row for each row of the run. @errors FileError
void write_hot_spots_csv(const std::filesystem::path& path, const diagnosis::HotSpots& hot_spots,
                         const solver::Problem& problem);

}  // namespace tiretherm::post
