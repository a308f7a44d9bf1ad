// SPDX-License-Identifier: BSD-3-Clause
// An FMU as a file: an archive with the shared object, the session that it loads, the description and pages for people.
#pragma once

#include <filesystem>
#include <string>

#include "post/fmu/fmu_description.hpp"

namespace tiretherm::post {

/// What is packed besides what every FMU has.
struct FmuParts {
    FmiVersion version = FmiVersion::fmi2;
    std::string case_text;  ///< the case with all that it includes
};

/// What came of it.
struct PackedFmu {
    FmuContent content;
    std::string bytes;  ///< the file; the same for the same case and program
};

/// @errors std::runtime_error: the shared object of the program is not there; its what() says where it was looked for
[[nodiscard]] PackedFmu pack_fmu(const solver::SessionModel& model, const FmuParts& parts);

}  // namespace tiretherm::post
