// SPDX-License-Identifier: BSD-3-Clause
// A call of another program, Python's or one in C: what it came to, and the rows of its runs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "calls/calls.hpp"

namespace tiretherm::calls {

/// What a call came to.
struct Outcome {
    int exit = Exit::done;
    std::vector<std::string> refused{};  ///< why there is no result, sentences without their full stops
    std::string remedy{};
    std::vector<input::InputError> errors{};  ///< of the case
    std::vector<std::string> warnings{};      ///< that came with them
    std::vector<std::string> notes{};
    std::optional<post::Report> page{};
    std::string text{};  ///< in the place of the page
};

/// Keeps what a call tells.
class Recorder : public Caller {
public:
    using Caller::refuse;

    /// @param progress takes the line of progress; empty: on stderr, unless it is quiet
    explicit Recorder(bool quiet, post::ProgressLine::Listener progress = {});

    void refuse(const std::vector<std::string>& sentences, const std::string& remedy) override;
    void refuse(const input::CaseFindings& findings, const std::string& consequence) override;
    void take(const post::Report& page) override { outcome_.page = page; }
    void take(const std::string& text) override { outcome_.text = text; }
    void complain(const std::string& sentence, const std::string& remedy) override { refuse(sentence, remedy); }
    void note(const std::string& sentence) override { outcome_.notes.push_back(sentence); }
    [[nodiscard]] post::ProgressLine progress_line(bool silent) const override;

    /// Makes the call. An exception that it throws becomes a sentence.
    void make(const std::function<int(Caller&)>& call);
    [[nodiscard]] Outcome& outcome() { return outcome_; }

private:
    post::ProgressLine::Listener progress_;
    Outcome outcome_;
};

/// One tire's run in SI and kelvin, as it is made.
struct RecordedRows {
    explicit RecordedRows(const input::RunOfCase& run);
    void take(const solver::Snapshot& row);

    struct Channel {
        std::string name;
        std::string unit;
        std::string shown;  ///< unit on pages
        std::string meaning;
    };
    std::string name;    ///< of the run
    std::string corner;  ///< of a car
    std::vector<Channel> channels;
    std::vector<double> time{};    ///< [rows] s
    std::vector<double> values{};  ///< [rows][channels] SI
};

}  // namespace tiretherm::calls
