// SPDX-License-Identifier: BSD-3-Clause
// The session of interface/tiretherm.h as a class of Python.
#pragma once

#include <pybind11/pybind11.h>

namespace tiretherm::python {

/// Adds the class to the module.
void define_session(pybind11::module_& module);

}  // namespace tiretherm::python
