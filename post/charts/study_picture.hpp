// SPDX-License-Identifier: BSD-3-Clause
// The picture of a study: the hottest temperature against what was varied.
#pragma once

#include <filesystem>

#include "diagnosis/study/study_record.hpp"

namespace tiretherm::post {

/// Whether there is anything to draw: something varies, and a run has come to its end.
[[nodiscard]] bool has_study_picture(const diagnosis::StudyRecord& study);

/// The hottest temperature of the runs against what was varied. With two or more sides of the grid a map of the first two,
/// a panel for each value of the others where these are few; with one a curve; with samples alone their distribution. At
/// points with samples the median, on a curve also the range that holds nine tenths of them.
/// @pre has_study_picture(study)   @errors FileError
void draw_study(const std::filesystem::path& path, const diagnosis::StudyRecord& study);

}  // namespace tiretherm::post
