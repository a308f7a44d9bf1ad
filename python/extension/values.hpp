// SPDX-License-Identifier: BSD-3-Clause
// Values of the libraries as objects of Python. All functions need the GIL.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "input/text/input_error.hpp"
#include "post/report/value.hpp"

namespace tiretherm::python {

/// Numbers, texts, lists and dicts, as json.loads gives them; a number that is not finite stays one.
[[nodiscard]] pybind11::object object_of(const post::Value& value);

/// code, message, file, line, column, remedy and source of each error.
[[nodiscard]] pybind11::list findings_of(const std::vector<input::InputError>& errors);

/// An array that looks at the numbers of `owner` and keeps it alive; it cannot be written to.
/// @param shape its product is the number of values
template <typename Number>
[[nodiscard]] pybind11::array view(const std::vector<Number>& values, std::vector<pybind11::ssize_t> shape,
                                   const pybind11::object& owner) {
    pybind11::array array(pybind11::dtype::of<Number>(), std::move(shape), values.data(), owner);
    array.attr("flags").attr("writeable") = false;
    return array;
}

}  // namespace tiretherm::python
