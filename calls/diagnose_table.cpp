// SPDX-License-Identifier: BSD-3-Clause
// Reads a table of measured numbers, diagnoses one model by it and writes diagnosis.json and the page.

#include "calls/diagnose_table.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "calls/caller.hpp"
#include "calls/doing.hpp"
#include "diagnosis/quoted/quoted_diagnosis.hpp"
#include "input/files/run_name.hpp"
#include "input/text/suggestions.hpp"
#include "input/validation/validation.hpp"
#include "post/quoted/quoted_report.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

namespace {

constexpr const char* consequence = "nothing was diagnosed";

/// Index of the model that is asked for. Says what is wrong with the call and returns nothing.
std::optional<std::size_t> model_of(const MeasuredCall& call, const input::ValidationReading& reading,
                                    const std::string& wanted, Caller& caller) {
    if (!call.data.empty()) {
        caller.refuse("a table of measured numbers has no place for --data",
                      "name a case with [[run]] to diagnose a log, or call it without --data");
        return std::nullopt;
    }
    if (!reading.table) {
        caller.refuse(input::CaseFindings{.errors = reading.errors, .warnings = reading.warnings}, consequence);
        return std::nullopt;
    }
    std::vector<std::string> keys;
    std::vector<std::string> measured;
    for (std::size_t m = 0; m < reading.table->models.size(); ++m) {
        keys.push_back(reading.table->models[m].key);
        if (std::ranges::any_of(reading.table->numbers, [&](const input::ValidationNumber& number) {
                return number.is_measured && number.models[m].has_value();
            })) {
            measured.push_back(keys.back());
        }
    }
    const std::string& model = wanted.empty() ? keys.front() : wanted;
    const auto found = std::ranges::find(keys, model);
    if (found == keys.end()) {
        caller.refuse(fmt::format("{} has no model \"{}\"", call.case_file, model),
                      input::suggest(model, keys, "models"));
        return std::nullopt;
    }
    if (std::ranges::find(measured, model) == measured.end()) {
        caller.refuse(fmt::format("{}: no measured number is read from the model {}", call.case_file, model),
                      measured.empty() ? "" : fmt::format("take --model {}", fmt::join(measured, " or --model ")));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - keys.begin());
}

}  // namespace

int diagnose_table(const MeasuredCall& call, const TableOptions& options, Caller& caller) {
    const input::ValidationReading reading =
        while_reading(call.case_file, [&] { return input::read_validation(call.case_file); });
    const std::optional<std::size_t> model = model_of(call, reading, options.model, caller);
    if (!model) {
        return Exit::input_error;
    }
    const std::filesystem::path directory = folder_of(call, "out/" + input::plain_stem(call.case_file));
    const std::vector<std::string> names = post::quoted_names();
    now_doing(fmt::format("diagnosing {} and writing to {}", call.case_file, directory.string()));
    std::vector<std::string> inputs{call.case_file};
    for (const input::ValidationRun& run : reading.table->runs) {
        if (std::ranges::find(inputs, run.file.string()) == inputs.end()) {
            inputs.push_back(run.file.string());
        }
    }
    const auto folder = open_output(directory, inputs, names, consequence, caller);
    if (!folder) {
        return Exit::input_error;
    }
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    SimulationCount count(caller);
    diagnosis::quoted::Trials trials(*reading.table, *model, options.threads, count.shown());
    const auto stopped = [&] {
        count.wipe();
        return was_stopped(consequence, caller);
    };
    if (solver::stop_requested() && stopped()) {
        return stop_exit();
    }
    const diagnosis::quoted::QuotedDiagnosis result =
        diagnosis::quoted::diagnose_quoted(*reading.table, trials, *model);
    count.wipe();
    if (solver::stop_requested() && stopped()) {
        return stop_exit();
    }
    const std::vector<std::string> failures = trials.failures();
    post::QuotedRecord record{.result = result,
                              .title = reading.table->title,
                              .table = call.case_file,
                              .model = reading.table->models[*model].name,
                              .seconds = std::chrono::duration<double>(Clock::now() - begin).count(),
                              .warnings = reading.warnings};
    record.warnings.insert(record.warnings.end(), failures.begin(), failures.end());
    const auto page = write_measured_page(
        call, *folder, names, "diagnose", caller,
        [&](const std::filesystem::path& stage) { return post::write_quoted(record, stage); },
        [&](const auto& files) { return post::quoted_report(record, files); });
    if (!page) {
        return Exit::input_error;
    }
    if (options.markdown) {
        caller.take(post::quoted_markdown(record));
    } else {
        caller.take(*page);
    }
    return failures.empty() ? Exit::done : Exit::numerical_failure;
}

}  // namespace tiretherm::calls
