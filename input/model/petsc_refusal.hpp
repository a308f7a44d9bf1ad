// SPDX-License-Identifier: BSD-3-Clause
// PETSc's linear solver serves one simulation at a time.
#pragma once

#include "input/text/input_error.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

/// For cases whose runs are simulated side by side, on threads of one process: PETSc has one state for all of them, so a case
/// that asks for its solver is refused. @param document the whole case
void refuse_petsc(const TomlValue& document, InputErrors& errors);

}  // namespace tiretherm::input
