// SPDX-License-Identifier: BSD-3-Clause
// How many simulations a diagnosis still needs: as many as it takes where nothing more is found, and where all that is allowed is.
#pragma once

#include <cstddef>

#include "diagnosis/remarks/stage.hpp"

namespace tiretherm::diagnosis {

/// Additions of one search at most.
inline constexpr std::size_t most_additions = 5;

/// What the course of a diagnosis depends on.
struct Course {
    long runs = 0;
    long recordings = 0;
    long channels = 0;
    long alone = 0;      ///< candidates that are simulated for their signatures one by one
    long together = 0;   ///< others
    long richer = 0;     ///< meshes to be searched on beside this one
    long additions = 0;  ///< that the search has accepted
};

/// @param now what is being done; itself it may be over at once, or take all of its time
[[nodiscard]] WorkAhead work_ahead(const Course& course, const Activity& now);

}  // namespace tiretherm::diagnosis
