// SPDX-License-Identifier: BSD-3-Clause
// The extension module _tiretherm: the calls of the program, without the command line. The package tiretherm is what users see.

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "calls/calls.hpp"
#include "calls/doing.hpp"
#include "input/runs/reader.hpp"
#include "input/runs/runs.hpp"
#include "input/studies/case_values.hpp"
#include "input/text/quantity.hpp"
#include "input/text/units.hpp"
#include "python/extension/interruption.hpp"
#include "python/extension/outcome.hpp"
#include "python/extension/own_law.hpp"
#include "python/extension/session.hpp"
#include "python/extension/values.hpp"

namespace tiretherm::python {

namespace py = pybind11;

namespace {

Manner manner_of(bool by_signal, bool quiet, py::object progress) {
    return {.by_signal = by_signal, .quiet = quiet, .progress = std::move(progress)};
}

calls::MeasuredCall measured_call(std::string case_file, std::vector<std::string> data, std::string directory,
                                  bool fresh, bool no_report) {
    return {.case_file = std::move(case_file),
            .data = std::move(data),
            .directory = std::move(directory),
            .fresh = fresh,
            .no_report = no_report};
}

/// Reads a case as run does. @returns its errors and warnings
py::tuple check(const std::string& case_file, const std::string& run) {
    input::Reading reading;
    {
        const py::gil_scoped_release released;
        reading = input::read_case_run(case_file, run);
    }
    return py::make_tuple(findings_of(reading.errors), reading.warnings, reading.runs);
}

/// The factor and the offset from a unit to another. @errors ValueError
std::pair<double, double> conversion(const std::string& from, const std::string& to) {
    const auto found = input::conversion(from, to, input::Scale::absolute);
    if (const auto* known = std::get_if<input::Conversion>(&found)) {
        return {known->factor, known->offset};
    }
    throw py::value_error("\"" + from + "\" cannot be converted to \"" + to + "\"");
}

void define_calls(py::module_& module) {
    using namespace pybind11::literals;
    module.def(
        "run",
        [](std::string case_file, std::string run, std::string directory, double field_interval, bool fresh,
           bool what_if, std::vector<std::string> changes, std::vector<std::pair<std::string, py::object>> sensors,
           const std::map<std::string, py::object>& laws, bool by_signal, bool quiet, py::object progress) {
            calls::RunOptions options{.case_file = std::move(case_file),
                                      .run = std::move(run),
                                      .directory = directory,
                                      .field_interval = field_interval,
                                      .in_memory = directory.empty(),
                                      .fresh = fresh,
                                      .what_if = what_if,
                                      .changes = std::move(changes),
                                      .switched = {}};
            for (const auto& [source, law] : laws) {
                options.laws[source] = own_law(source, law);
            }
            Manner manner = manner_of(by_signal, quiet, std::move(progress));
            for (auto& [name, read] : sensors) {
                manner.sensors.push_back({.name = std::move(name), .read = std::move(read)});
            }
            return make(manner, [&](calls::Caller& caller) { return calls::run(options, caller); });
        },
        "case_file"_a, "run"_a, "directory"_a, "field_interval"_a, "fresh"_a, "what_if"_a, "changes"_a, "sensors"_a,
        "laws"_a, "by_signal"_a, "quiet"_a, "progress"_a);
    module.def(
        "compare",
        [](std::string case_file, std::vector<std::string> data, std::string directory, bool no_report, bool by_signal,
           bool quiet, py::object progress) {
            const calls::MeasuredCall call =
                measured_call(std::move(case_file), std::move(data), std::move(directory), false, no_report);
            return make(manner_of(by_signal, quiet, std::move(progress)),
                        [&](calls::Caller& caller) { return calls::compare(call, caller); });
        },
        "case_file"_a, "data"_a, "directory"_a, "no_report"_a, "by_signal"_a, "quiet"_a, "progress"_a);
    module.def(
        "identify",
        [](std::string case_file, std::vector<std::string> data, std::string directory, bool fresh, bool no_report,
           bool profile, bool plan, std::string leave_out, double correlation_time, bool by_signal, bool quiet,
           py::object progress) {
            calls::IdentifyOptions options;
            static_cast<calls::MeasuredCall&>(options) =
                measured_call(std::move(case_file), std::move(data), std::move(directory), fresh, no_report);
            options.profile = profile;
            options.plan = plan;
            options.leave_out = std::move(leave_out);
            options.correlation_time = correlation_time;
            return make(manner_of(by_signal, quiet, std::move(progress)),
                        [&](calls::Caller& caller) { return calls::identify(options, caller); });
        },
        "case_file"_a, "data"_a, "directory"_a, "fresh"_a, "no_report"_a, "profile"_a, "plan"_a, "leave_out"_a,
        "correlation_time"_a, "by_signal"_a, "quiet"_a, "progress"_a);
    module.def(
        "diagnose",
        [](std::string case_file, std::vector<std::string> data, std::string directory, bool fresh, bool no_report,
           double time_limit, bool by_run, bool no_by_run, bool by_signal, bool quiet, py::object progress) {
            calls::DiagnoseOptions options;
            static_cast<calls::MeasuredCall&>(options) =
                measured_call(std::move(case_file), std::move(data), std::move(directory), fresh, no_report);
            options.time_limit = time_limit;
            options.by_run = by_run;
            options.no_by_run = no_by_run;
            return make(manner_of(by_signal, quiet, std::move(progress)),
                        [&](calls::Caller& caller) { return calls::diagnose(options, {}, caller); });
        },
        "case_file"_a, "data"_a, "directory"_a, "fresh"_a, "no_report"_a, "time_limit"_a, "by_run"_a, "no_by_run"_a,
        "by_signal"_a, "quiet"_a, "progress"_a);
    module.def(
        "study",
        [](std::string study_file, std::string directory, unsigned threads, bool fresh, bool no_report, bool by_signal,
           bool quiet, py::object progress) {
            const calls::StudyOptions options{.study_file = std::move(study_file),
                                              .directory = std::move(directory),
                                              .threads = threads,
                                              .part = {},
                                              .merge = false,
                                              .fresh = fresh,
                                              .no_report = no_report};
            return make(manner_of(by_signal, quiet, std::move(progress)),
                        [&](calls::Caller& caller) { return calls::study(options, caller); });
        },
        "study_file"_a, "directory"_a, "threads"_a, "fresh"_a, "no_report"_a, "by_signal"_a, "quiet"_a, "progress"_a);
}

}  // namespace

PYBIND11_MODULE(_tiretherm, module) {
    using namespace pybind11::literals;
    module.attr("version") = TIRETHERM_VERSION;
    module.def("check", &check, "case_file"_a, "run"_a);
    module.def(
        "case_name", [](const std::string& file) { return input::case_name(file); }, "file"_a);
    module.def(
        "case_values", [](const std::string& file) { return input::case_values(file); }, "file"_a);
    module.def("conversion", &conversion, "from"_a, "to"_a);
    module.def("stop", &Interruption::stop_all);
    RecordedRun::define(module);
    Outcome::define(module);
    define_session(module);
    define_calls(module);
}

}  // namespace tiretherm::python
