// SPDX-License-Identifier: BSD-3-Clause
// Looks for the word in [time], whether or not the program was built with PETSc.

#include "input/model/petsc_refusal.hpp"

namespace tiretherm::input {

void refuse_petsc(const TomlValue& document, InputErrors& errors) {
    const TomlValue* solver = document.find({"time", "linear_solver"});
    if (solver != nullptr && solver->text == "petsc") {
        errors.add(solver->place,
                   "PETSc solves for one simulation at a time, and this command makes several side by side",
                   "leave linear_solver out here, unset = [\"time.linear_solver\"] in a case that includes this one; "
                   "run takes PETSc");
    }
}

}  // namespace tiretherm::input
