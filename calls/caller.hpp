// SPDX-License-Identifier: BSD-3-Clause
// Who makes a call: the command line, or the Python package. A call does its work and tells here what comes of it.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "input/runs/reader.hpp"
#include "post/report/progress.hpp"
#include "post/report/report.hpp"
#include "solver/time_integration/march.hpp"

/// What run, compare, identify, diagnose and study do, from reading the case to writing the files.
namespace tiretherm::calls {

struct SimulatedRun;

/// How a call ends; the exit code of the program.
enum Exit : int { done = 0, input_error = 1, numerical_failure = 2, interrupted = 130 };

/// Takes the results and messages of a call, which is made in one thread.
class Caller {
public:
    /// @param quiet shows no progress
    explicit Caller(bool quiet) : quiet_(quiet) {}
    virtual ~Caller() = default;
    Caller(const Caller&) = delete;
    Caller& operator=(const Caller&) = delete;

    [[nodiscard]] bool is_quiet() const { return quiet_; }

    /// Why there is no result. @param sentences without their full stops  @param remedy of the last, or empty
    virtual void refuse(const std::vector<std::string>& sentences, const std::string& remedy) = 0;
    void refuse(const std::string& sentence, const std::string& remedy) { refuse(std::vector{sentence}, remedy); }
    /// The same of errors in the case. @param consequence "nothing was run"
    virtual void refuse(const input::CaseFindings& findings, const std::string& consequence) = 0;
    /// The result.
    virtual void take(const post::Report& page) = 0;
    /// A text that was asked for in the place of the page.
    virtual void take(const std::string& text) = 0;
    /// What went wrong with a result that is there. @param remedy what to do, or empty
    virtual void complain(const std::string& sentence, const std::string& remedy) = 0;
    /// What somebody who waits should know. @param sentence without its full stop
    virtual void note(const std::string& sentence) = 0;

    /// The line of progress. @param silent there is nothing to show
    [[nodiscard]] virtual post::ProgressLine progress_line(bool silent) const {
        return post::ProgressLine(stderr, quiet_ || silent);
    }
    [[nodiscard]] post::ProgressLine progress_line() const { return progress_line(false); }

    /// For a caller that wants a run's rows as they are made: begin, rows and end of each tire.
    virtual void begin(const input::RunOfCase& /*run*/) {}
    virtual void row(const solver::Snapshot& /*row*/) {}
    virtual void end(const SimulatedRun& /*run*/) {}

private:
    bool quiet_;
};

}  // namespace tiretherm::calls
