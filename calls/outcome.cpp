// SPDX-License-Identifier: BSD-3-Clause
// Copies what a call tells; nobody else looks at it meanwhile.

#include "calls/outcome.hpp"

#include <exception>
#include <utility>

#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "solver/channel_unit.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

Recorder::Recorder(bool quiet, post::ProgressLine::Listener progress) : Caller(quiet), progress_(std::move(progress)) {}

void Recorder::refuse(const std::vector<std::string>& sentences, const std::string& remedy) {
    outcome_.refused = sentences;
    outcome_.remedy = remedy;
}

void Recorder::refuse(const input::CaseFindings& findings, const std::string& consequence) {
    outcome_.refused = {consequence};
    outcome_.errors = findings.errors;
    outcome_.warnings = findings.warnings;
}

post::ProgressLine Recorder::progress_line(bool silent) const {
    return progress_ && !silent ? post::ProgressLine(progress_) : Caller::progress_line(silent);
}

void Recorder::make(const std::function<int(Caller&)>& call) {
    try {
        outcome_.exit = call(*this);
    } catch (const solver::Interrupted&) {
        refuse(stop_sentence() + " while " + now_done(), "");
        outcome_.exit = stop_exit();
    } catch (const std::exception& error) {
        const Failure failure = failure_of(error);
        refuse(failure.sentence, failure.remedy);
        outcome_.exit = Exit::input_error;
    }
}

RecordedRows::RecordedRows(const input::RunOfCase& run) : name(run.name), corner(run.corner) {
    for (const solver::Channel& channel : run.problem.channels) {
        channels.push_back({.name = channel.name,
                            .unit = std::string(solver::unit_of(channel.quantity)),
                            .shown = solver::shown_unit(channel.quantity).name,
                            .meaning = channel.meaning});
    }
}

void RecordedRows::take(const solver::Snapshot& row) {
    time.push_back(row.time);
    values.insert(values.end(), row.channels.begin(), row.channels.end());
}

}  // namespace tiretherm::calls
