// SPDX-License-Identifier: BSD-3-Clause
// A call made from Python: what it came to, and how it is made without the GIL.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "calls/outcome.hpp"
#include "python/extension/recorded_run.hpp"

namespace tiretherm::python {

/// What a call came to. Which exception that is in Python is for its layer there to say.
struct Outcome : calls::Outcome {
    bool signalled = false;  ///< Ctrl-C came
    std::vector<std::shared_ptr<RecordedRun>> runs{};

    static void define(pybind11::module_& module);
};

/// How a call is made.
struct Manner {
    bool by_signal = false;       ///< Ctrl-C ends it: in the main thread
    bool quiet = true;            ///< no line of progress on stderr
    pybind11::object progress{};  ///< callable of a text, or None
    std::vector<OwnSensor> sensors{};
};

/// Makes a call without the GIL. @errors what a callable of Python raises
[[nodiscard]] Outcome make(const Manner& manner, const std::function<int(calls::Caller&)>& call);

}  // namespace tiretherm::python
