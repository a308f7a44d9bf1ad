// SPDX-License-Identifier: BSD-3-Clause
// Records what a call tells; progress and sensors of Python get the GIL for as long as they take.

#include "python/extension/outcome.hpp"

#include <algorithm>
#include <exception>
#include <string_view>

#include <pybind11/stl.h>

#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "post/page/html_page.hpp"
#include "post/report/file.hpp"
#include "python/extension/interruption.hpp"
#include "python/extension/values.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::python {

namespace py = pybind11;

namespace {

/// A stream whose lines go to a callable of Python.
class ProgressStream {
public:
    explicit ProgressStream(const py::object& to) : to_(to) {
        const cookie_io_functions_t functions{.read = nullptr, .write = &write, .seek = nullptr, .close = nullptr};
        stream_ = fopencookie(this, "w", functions);
        setvbuf(stream_, nullptr, _IOFBF, BUFSIZ);
    }
    ~ProgressStream() { std::fclose(stream_); }
    ProgressStream(const ProgressStream&) = delete;
    ProgressStream& operator=(const ProgressStream&) = delete;

    [[nodiscard]] std::FILE* stream() const { return stream_; }
    void raise() const {
        if (raised_) {
            std::rethrow_exception(raised_);
        }
    }

private:
    /// The line between the marks that rewrite it on a terminal.
    static ssize_t write(void* cookie, const char* bytes, std::size_t size) {
        auto& self = *static_cast<ProgressStream*>(cookie);
        std::string_view line(bytes, size);
        line.remove_prefix(std::min(line.find_first_not_of('\r'), line.size()));
        line = line.substr(0, line.find('\033'));
        if (!line.empty() && !self.raised_) {
            const py::gil_scoped_acquire gil;
            try {
                self.to_(line);
            } catch (...) {
                self.raised_ = std::current_exception();
                solver::stop_after(0.0);
            }
        }
        return static_cast<ssize_t>(size);
    }

    const py::object& to_;
    std::FILE* stream_ = nullptr;
    std::exception_ptr raised_{};
};

class Recorder final : public calls::Caller {
public:
    using Caller::refuse;

    Recorder(const Manner& manner, std::FILE* progress) : Caller(manner.quiet), manner_(&manner), progress_(progress) {}

    void refuse(const std::vector<std::string>& sentences, const std::string& remedy) override {
        outcome_.refused = sentences;
        outcome_.remedy = remedy;
    }
    void refuse(const input::CaseFindings& findings, const std::string& consequence) override {
        outcome_.refused = {consequence};
        outcome_.errors = findings.errors;
        outcome_.warnings = findings.warnings;
    }
    void take(const post::Report& page) override { outcome_.page = page; }
    void take(const std::string& text) override { outcome_.text = text; }
    void complain(const std::string& sentence, const std::string& remedy) override { refuse(sentence, remedy); }
    void note(const std::string& sentence) override { outcome_.notes.push_back(sentence); }
    [[nodiscard]] post::ProgressLine progress_line(bool silent) const override {
        return progress_ != nullptr && !silent ? post::ProgressLine(progress_, post::ProgressLine::Kind::rewritten)
                                               : Caller::progress_line(silent);
    }

    void begin(const input::RunOfCase& run) override {
        outcome_.runs.push_back(std::make_shared<RecordedRun>(run, manner_->sensors));
    }
    void row(const solver::Snapshot& row) override { outcome_.runs.back()->take(row); }
    void end(const calls::SimulatedRun& run) override { outcome_.runs.back()->end(run); }

    [[nodiscard]] Outcome& outcome() { return outcome_; }

private:
    const Manner* manner_;
    std::FILE* progress_;
    Outcome outcome_;
};

int guarded(const std::function<int(calls::Caller&)>& call, Recorder& recorder) {
    try {
        return call(recorder);
    } catch (const py::error_already_set&) {
        throw;
    } catch (const solver::Interrupted&) {
        recorder.refuse(calls::stop_sentence() + " while " + calls::now_done(), "");
        return calls::stop_exit();
    } catch (const std::exception& error) {
        const calls::Failure failure = calls::failure_of(error);
        recorder.refuse(failure.sentence, failure.remedy);
        return calls::Exit::input_error;
    }
}

}  // namespace

Outcome make(const Manner& manner, const std::function<int(calls::Caller&)>& call) {
    const bool has_progress = manner.progress && !manner.progress.is_none();
    std::optional<ProgressStream> progress;
    if (has_progress) {
        progress.emplace(manner.progress);
    }
    Recorder recorder(manner, progress ? progress->stream() : nullptr);
    {
        const py::gil_scoped_release released;
        const Interruption interruption(manner.by_signal);
        recorder.outcome().exit = guarded(call, recorder);
        recorder.outcome().signalled = interruption.was_signalled();
    }
    if (progress) {
        progress->raise();
    }
    return std::move(recorder.outcome());
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
