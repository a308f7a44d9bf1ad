// SPDX-License-Identifier: BSD-3-Clause
// The runs of a study as tables: CSV text and HDF5 file.
#pragma once

#include <filesystem>
#include <string>

#include "diagnosis/study/study_record.hpp"

namespace tiretherm::post {

/// The runs of a study as CSV, a row each: its number, what was varied in it, how it ended, the hottest place, each channel
/// at its end and at its extremes. Units stand in the headings; the cells behind a failure are empty.
[[nodiscard]] std::string study_csv(const diagnosis::StudyRecord& study);

/// The same as HDF5, SI units, arrays [runs]; NaN behind a failure. What was varied is in the unit in which the user
/// wrote it.   @errors FileError
void write_study_hdf5(const std::filesystem::path& path, const diagnosis::StudyRecord& study);

}  // namespace tiretherm::post
