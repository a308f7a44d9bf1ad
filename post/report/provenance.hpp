// SPDX-License-Identifier: BSD-3-Clause
// Where results come from: program version and case text, stored with every result file.
#pragma once

#include <string>

namespace tiretherm::post {

/// Where results come from, so that a file found later explains itself.
struct Provenance {
    std::string version;    ///< of tiretherm
    std::string case_file;  ///< path as the user gave it
    std::string case_text;  ///< the case as it was read; empty if unknown
};

}  // namespace tiretherm::post
