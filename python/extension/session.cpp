// SPDX-License-Identifier: BSD-3-Clause
// Calls the C interface; its results become exceptions.

#include "python/extension/session.hpp"

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <tiretherm.h>

namespace tiretherm::python {

namespace py = pybind11;

namespace {

class Session {
public:
    explicit Session(const std::string& case_file) {
        std::array<char, 16384> message{};
        session_.reset(tiretherm_open(case_file.c_str(), message.data(), message.size()));
        if (!session_) {
            throw std::invalid_argument(message.data());
        }
        read_outputs();
    }

    void set(int input, double value) { check(tiretherm_set_input(session_.get(), input, value)); }
    void set(const py::dict& inputs) {
        for (const auto& [name, value] : inputs) {
            const auto text = py::cast<std::string>(name);
            const int input = tiretherm_find_input(text.c_str());
            if (input < 0) {
                throw py::key_error(text);
            }
            set(input, py::cast<double>(value));
        }
    }
    /// @param count of equal steps
    void step(double dt, int count) {
        {
            const py::gil_scoped_release released;
            for (int i = 0; i < count; ++i) {
                check(tiretherm_step(session_.get(), dt));
            }
        }
        read_outputs();
    }

    static void define(py::module_& module);

private:
    struct Close {
        void operator()(tiretherm_session* session) const { tiretherm_close(session); }
    };

    void read_outputs() {
        outputs_.resize(static_cast<std::size_t>(tiretherm_output_count(session_.get())));
        for (std::size_t i = 0; i < outputs_.size(); ++i) {
            outputs_[i] = tiretherm_output(session_.get(), static_cast<int>(i));
        }
    }
    void check(int result) const {
        if (result == TIRETHERM_BAD_ARGUMENT) {
            throw std::invalid_argument(tiretherm_message(session_.get()));
        }
        if (result != TIRETHERM_OK) {
            throw std::runtime_error(tiretherm_message(session_.get()));
        }
    }
    [[nodiscard]] py::list outputs() const {
        py::list list;
        for (int i = 0; i < tiretherm_output_count(session_.get()); ++i) {
            list.append(
                py::make_tuple(tiretherm_output_name(session_.get(), i), tiretherm_output_unit(session_.get(), i)));
        }
        return list;
    }

    std::unique_ptr<tiretherm_session, Close> session_;
    std::vector<double> outputs_;  ///< [outputs] SI; never another size, so that arrays may look at it
};

void Session::define(py::module_& module) {
    py::class_<Session> session(module, "Session");
    session.def(py::init<const std::string&>(), py::arg("case_file"));
    session.def("set", py::overload_cast<int, double>(&Session::set), py::arg("input"), py::arg("value"));
    session.def("set", py::overload_cast<const py::dict&>(&Session::set), py::arg("inputs"));
    session.def("step", &Session::step, py::arg("dt"), py::arg("count"));
    session.def_property_readonly("outputs", &Session::outputs);
    session.def_property_readonly("values", [](py::object self) {
        const auto& values = self.cast<const Session&>().outputs_;
        return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data(), self);
    });
    session.def_property_readonly("time", [](const Session& self) { return tiretherm_time(self.session_.get()); });
    session.def_property_readonly("temperature", [](const Session& self) {
        return py::array_t<double>(static_cast<py::ssize_t>(tiretherm_temperature_count(self.session_.get())),
                                   tiretherm_temperatures(self.session_.get()));
    });
    session.def_static("inputs", [] {
        py::list list;
        for (int i = 0; i < tiretherm_input_count(); ++i) {
            list.append(py::make_tuple(tiretherm_input_name(i), tiretherm_input_unit(i)));
        }
        return list;
    });
}

}  // namespace

void define_session(py::module_& module) { Session::define(module); }

}  // namespace tiretherm::python
