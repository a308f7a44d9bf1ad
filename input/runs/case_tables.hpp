// SPDX-License-Identifier: BSD-3-Clause
// All tables of a case that make the problem of one run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "input/cameras/camera.hpp"
#include "input/drive/drive.hpp"
#include "input/model/materials.hpp"
#include "input/model/size_limits.hpp"
#include "input/vehicle/read_vehicle.hpp"

namespace tiretherm::input {

/// A case as it was read for one run: sound only where there is no error. Its stock points into the document.
struct CaseTables {
    solver::Problem problem{};
    std::vector<Stock> stock{};
    std::vector<Camera> cameras{};
    SizeLimits limits{};
    DrivenSpan span{};
    std::shared_ptr<const CarMotion> car{};  ///< of the log
    double course_agrees = 0.0;              ///< with the turns that [vehicle] takes: as MotionHistory has it
};

/// Reads the tables in the order in which one may refer to another: each reader takes what those before it have found.
/// @param run that is measured, null: none  @param car as another tire of it has found its motion; null: none
[[nodiscard]] CaseTables read_tables(TomlTable& root, const std::string& name, const RunInputs* run,
                                     std::shared_ptr<const CarMotion> car);

/// Columns that are read beside inputs and sensors: those that user effects and [vehicle] follow.
[[nodiscard]] std::vector<std::string> followed_columns(const TomlValue& document);

}  // namespace tiretherm::input
