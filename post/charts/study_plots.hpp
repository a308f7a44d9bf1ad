// SPDX-License-Identifier: BSD-3-Clause
// The three kinds of study picture, for the file that chooses between them: map, curve and histogram.
#pragma once

#include <filesystem>

#include "diagnosis/study/study_record.hpp"

/// The pictures of a study, by what varies in it.
namespace tiretherm::post {

/// Two or more sides: filled colours over the first two, isotherms between the runs.
void draw_study_map(const std::filesystem::path& path, const diagnosis::StudyRecord& study);
/// One side: a curve through the runs, with samples a band about their median.
void draw_study_curve(const std::filesystem::path& path, const diagnosis::StudyRecord& study);
/// No side: how the samples are distributed.
void draw_study_histogram(const std::filesystem::path& path, const diagnosis::StudyRecord& study);

}  // namespace tiretherm::post
