// SPDX-License-Identifier: BSD-3-Clause
// Records what a call tells; progress and sensors of Python get the GIL for as long as they take.

#include "python/extension/outcome.hpp"

#include <exception>
#include <utility>

#include <pybind11/stl.h>

#include "post/page/html_page.hpp"
#include "python/extension/interruption.hpp"
#include "python/extension/values.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::python {

namespace py = pybind11;

namespace {

/// Also keeps rows in Python's arrays.
class RunRecorder final : public calls::Recorder {
public:
    RunRecorder(const Manner& manner, post::ProgressLine::Listener progress)
        : Recorder(manner.quiet, std::move(progress)), manner_(&manner) {}

    void begin(const input::RunOfCase& run) override {
        runs.push_back(std::make_shared<RecordedRun>(run, manner_->sensors));
    }
    void row(const solver::Snapshot& row) override { runs.back()->take(row); }
    void end(const calls::SimulatedRun& run) override { runs.back()->end(run); }

    std::vector<std::shared_ptr<RecordedRun>> runs{};

private:
    const Manner* manner_;
};

}  // namespace

Outcome make(const Manner& manner, const std::function<int(calls::Caller&)>& call) {
    std::exception_ptr raised;
    const auto tell = [&](const std::string& line, double /*share*/) {
        if (raised) {
            return;
        }
        const py::gil_scoped_acquire gil;
        try {
            manner.progress(line);
        } catch (...) {
            raised = std::current_exception();
            solver::stop_after(0.0);
        }
    };
    const bool has_progress = manner.progress && !manner.progress.is_none();
    RunRecorder recorder(manner, has_progress ? post::ProgressLine::Listener(tell) : nullptr);
    Outcome outcome;
    {
        const py::gil_scoped_release released;
        const Interruption interruption(manner.by_signal);
        recorder.make([&](calls::Caller& caller) {
            try {
                return call(caller);
            } catch (const py::error_already_set&) {
                raised = std::current_exception();
                return static_cast<int>(calls::Exit::input_error);
            }
        });
        outcome.signalled = interruption.was_signalled();
    }
    if (raised) {
        std::rethrow_exception(raised);
    }
    static_cast<calls::Outcome&>(outcome) = std::move(recorder.outcome());
    outcome.runs = std::move(recorder.runs);
    return outcome;
}

void Outcome::define(py::module_& module) {
    py::class_<Outcome> outcome(module, "Outcome");
    outcome.def_readonly("exit", &Outcome::exit);
    outcome.def_readonly("signalled", &Outcome::signalled);
    outcome.def_readonly("refused", &Outcome::refused);
    outcome.def_readonly("remedy", &Outcome::remedy);
    outcome.def_readonly("warnings", &Outcome::warnings);
    outcome.def_readonly("notes", &Outcome::notes);
    outcome.def_readonly("text", &Outcome::text);
    outcome.def_readonly("runs", &Outcome::runs);
    outcome.def_property_readonly("findings", [](const Outcome& self) { return findings_of(self.errors); });
    outcome.def_property_readonly("has_page", [](const Outcome& self) { return self.page.has_value(); });
    outcome.def_property_readonly(
        "data", [](const Outcome& self) { return self.page ? object_of(self.page->data) : py::none(); });
    outcome.def("page_text", [](const Outcome& self) { return self.page ? post::page_text(*self.page, false) : ""; });
    outcome.def(
        "page_html",
        [](const Outcome& self, const std::string& kind, const std::string& source) {
            return self.page ? post::html_page(*self.page, {.kind = kind, .source = source}) : "";
        },
        py::arg("kind"), py::arg("source"));
}

}  // namespace tiretherm::python
