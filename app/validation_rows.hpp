#pragma once

#include <vector>

#include "app/validation_runs.hpp"
#include "cases/validation.hpp"
#include "post/validation_table.hpp"

namespace tiretherm::app {

/// The numbers of a table beside what the runs say, in the units that users see.
[[nodiscard]] std::vector<post::ValidationRow> validation_rows(const cases::Validation& table,
                                                               const RunResults& results);

}  // namespace tiretherm::app
