// SPDX-License-Identifier: BSD-3-Clause
// Calls a law of Python under the GIL, once at each evaluation of the heat balance.

#include "python/extension/own_law.hpp"

#include <cstddef>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>

namespace tiretherm::python {

namespace py = pybind11;

namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A temperature beyond which no law is looked at, for its derivative. K
constexpr double step = 1e-3;

/// One value for each node, or for all of them.
Array values_of(const std::string& name, const py::object& given, py::ssize_t n) {
    const Array values = Array::ensure(given);
    if (!values) {
        PyErr_Clear();
        throw py::value_error(fmt::format("the law of {} gives no numbers", name));
    }
    if (values.size() != 1 && values.size() != n) {
        throw py::value_error(
            fmt::format("the law of {} gives {} values; its place has {} nodes", name, values.size(), n));
    }
    return values;
}

double at(const Array& values, std::size_t i) { return values.data()[values.size() == 1 ? 0 : i]; }

void add_terms(const std::string& name, const py::object& law, const physics::EvaluationState& m,
               physics::Terms& terms) {
    const std::vector<int>& nodes = m.active.nodes;
    const auto n = static_cast<py::ssize_t>(nodes.size());
    const double signal = m.coefficients[0];
    const py::gil_scoped_acquire gil;
    const auto temperatures = [&](double shift) {
        Array T(n);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            T.mutable_data()[i] = m.temperature[static_cast<std::size_t>(nodes[i])] + shift;
        }
        return T;
    };
    py::object watts = law(signal, temperatures(0.0));
    py::object slope = py::none();
    if (py::isinstance<py::tuple>(watts) && py::len(watts) == 2) {
        slope = watts[py::int_(1)];
        watts = py::object(watts[py::int_(0)]);
    }
    const Array here = values_of(name, watts, n);
    const bool is_difference = slope.is_none();
    const Array there = values_of(name, is_difference ? py::object(law(signal, temperatures(step))) : slope, n);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double share = m.active.weights[i];
        const double dwatts_dT = is_difference ? (at(there, i) - at(here, i)) / step : at(there, i);
        terms.heat(nodes[i], share * at(here, i), share * dwatts_dT);
    }
}

}  // namespace

std::shared_ptr<const physics::OwnLaw> own_law(const std::string& name, const py::object& law) {
    return std::make_shared<const physics::OwnLaw>(physics::OwnLaw{
        [name, law](const physics::EvaluationState& m, physics::Terms& terms) { add_terms(name, law, m, terms); }});
}

}  // namespace tiretherm::python
