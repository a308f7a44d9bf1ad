// SPDX-License-Identifier: BSD-3-Clause
// Reduces the images of a camera to a few channels, the mean temperatures of rings about the origin of the specimen, so
// that a diagnosis can use them.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// The experiment with each camera as a few ordinary channels: the means of its pixels over three rings about the origin of the
/// specimen, "camera 1" the innermost, with the pose that the case states. A diagnosis holds hundreds of signatures
/// against every row; a specimen that is round about its spot shows nothing in an image that its rings do not show.
/// What the pose's numbers are is not asked any more.
/// @param remarks out, what was made of each camera, a sentence each
[[nodiscard]] input::Experiment in_rings(input::Experiment experiment, Remarks& remarks);

}  // namespace tiretherm::diagnosis
