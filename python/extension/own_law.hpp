// SPDX-License-Identifier: BSD-3-Clause
// An effect that is written in Python.
#pragma once

#include <memory>
#include <string>

#include <pybind11/pybind11.h>

#include "physics/effect.hpp"

namespace tiretherm::python {

/// The heat of a law of Python, law(signal, T) with T [nodes] K. It gives the heat that the whole place would take if it were at that
/// temperature, one value for each node, W, or these and their derivatives in W/K; without them the law is called a second time, for the
/// difference. Nodes have their share of it. A copy is let go under the GIL.
/// @errors what the law raises; ValueError for other shapes, with the effect's name
[[nodiscard]] std::shared_ptr<const physics::OwnLaw> own_law(const std::string& name, const pybind11::object& law);

}  // namespace tiretherm::python
