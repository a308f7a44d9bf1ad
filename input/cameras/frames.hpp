// SPDX-License-Identifier: BSD-3-Clause
// Reads the camera frames of a measured run, which [[run]] names with the key `frames`.
#pragma once

#include "input/cameras/camera.hpp"
#include "input/drive/drive.hpp"
#include "input/drive/run_table.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::input {

/// What the cameras gave in a run: opens the files of frames that it names, masks what is dead or beside the specimen,
/// bins, and says what is suspicious about them.
/// @param inputs of the run, null: none is measured  @param warnings out, sentences
void read_frames(const RunTable& table, const RunInputs* inputs, const std::vector<Camera>& cameras,
                 const solver::Problem& problem, InputErrors& errors, MeasuredRun& run,
                 std::vector<InputWarning>& warnings);

}  // namespace tiretherm::input
