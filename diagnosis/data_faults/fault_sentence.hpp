// SPDX-License-Identifier: BSD-3-Clause
// What is said of a fault of the data: which columns, what they are read as, where to correct it.
#pragma once

#include "diagnosis/data_faults/data_faults.hpp"

namespace tiretherm::diagnosis {

/// The sentence of a fault, with file, line of the headings and the key that corrects the reading.
/// @param experiment as it was read, with the fault
[[nodiscard]] Remark sentence_of(const DataFault& fault, const input::Experiment& experiment);

}  // namespace tiretherm::diagnosis
