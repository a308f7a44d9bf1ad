// SPDX-License-Identifier: BSD-3-Clause
// How a page calls the parts and the points of a study.
#pragma once

#include <cstddef>
#include <string>

#include "diagnosis/study/study_record.hpp"

namespace tiretherm::post {

/// "belt edge above 110 degC"; without the number where it differs between runs.
[[nodiscard]] std::string part_text(const diagnosis::StudyRecord& study, std::size_t part);

/// "speed = 80 km/h, camber = 2 deg": the values of a point of the grid.
[[nodiscard]] std::string point_text(const diagnosis::StudyRecord& study, std::size_t point);

}  // namespace tiretherm::post
