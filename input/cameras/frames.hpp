#pragma once

#include "input/model/draft.hpp"
#include "input/measurements/experiment.hpp"
#include "input/measurements/run_table.hpp"

namespace tiretherm::input {

/// What the cameras gave in a run: opens the files of frames that it names, masks what is dead or beside the specimen,
/// bins, and says what is suspicious about them.
/// @param findings out, sentences
void read_frames(const RunTable& table, const Draft& draft, Mistakes& mistakes, MeasuredRun& run,
                 std::vector<std::string>& findings);

}  // namespace tiretherm::input
