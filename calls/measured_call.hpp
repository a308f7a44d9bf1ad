// SPDX-License-Identifier: BSD-3-Clause
// Options and steps that compare, identify and diagnose share: case file, measured data and output directory.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "calls/output.hpp"
#include "diagnosis/data_faults/data_faults.hpp"
#include "diagnosis/detect/score_test_data.hpp"
#include "input/runs/read_experiment.hpp"
#include "post/report/prediction_journal.hpp"
#include "post/report/progress.hpp"
#include "post/report/report.hpp"
#include "post/report/stage_text.hpp"

namespace tiretherm::calls {

/// A call that compares a case with measured runs: the options that compare, identify and diagnose share.
struct MeasuredCall {
    std::string case_file;
    std::vector<std::string> data;
    std::string directory;
    bool fresh = false;  ///< of identify and diagnose
    bool no_report = false;
    diagnosis::DataCorrections corrections{};  ///< of labels that were found to be wrong

    [[nodiscard]] std::vector<std::filesystem::path> data_files() const { return {data.begin(), data.end()}; }
};

/// Reads the case and its runs; reports every error. @param consequence of errors, "nothing was fitted"
/// @returns nothing when there are any
[[nodiscard]] std::optional<input::ExperimentReading> read_measured(const MeasuredCall& call, const char* consequence,
                                                                    Caller& caller,
                                                                    input::ReadMode mode = input::ReadMode::measured);

/// Reads the case with its runs as they are corrected.
[[nodiscard]] input::ExperimentReading read_corrected(const MeasuredCall& call, const input::MeshChange& mesh = {});

/// Looks for wrong labels of the data: units, exchanged columns. Where there are some they stand in `call.corrections`, and what was
/// read is read again without them. @param as_taken the experiment as it is going to be fitted
[[nodiscard]] diagnosis::DataFaults correct_data(MeasuredCall& call, input::ExperimentReading& reading,
                                                 const input::Experiment& as_taken);

/// The sentences of what that finds, where the data are going to be taken as they are.
[[nodiscard]] std::vector<std::string> wrong_labels(const MeasuredCall& call, const input::Experiment& experiment);

/// Whether the case has any parameter to fit; reports it when not.
[[nodiscard]] bool has_free_parameters(const MeasuredCall& call, const input::Experiment& experiment, Caller& caller);

/// Says on stderr what is being done and counts simulations for a person who waits.
class SimulationCount {
public:
    explicit SimulationCount(const Caller& caller) : line_(caller.progress_line()) {}

    [[nodiscard]] std::function<void(long)> shown() {
        return [this](long simulations) { show({}, simulations); };
    }
    /// The same with what is being done, and what is left of it.
    [[nodiscard]] diagnosis::Progress stages() {
        return [this](const diagnosis::Activity& stage, long simulations) { show(stage, simulations); };
    }
    void wipe() { line_.wipe(); }

private:
    void show(const diagnosis::Activity& stage, long simulations) {
        if (simulations < of_this_) {  // another diagnosis, of a run alone
            of_others_ += of_this_;
        }
        of_this_ = simulations;
        const long done = of_others_ + simulations;
        if (stage.doing != doing_ || stage.number != number_) {
            at_begin_ = done;
        }
        if (stage.doing != doing_ || stage.number < number_) {
            doing_ = stage.doing;
            begun_ = post::ProgressLine::wall_clock();
        }
        number_ = stage.number;
        const auto total = [&](long ahead) {  // what was ahead of this piece may be exceeded by it
            return static_cast<std::size_t>(stage.ahead.most > 0 ? std::max(at_begin_ + ahead, done) : 0);
        };
        line_.show({.stage = {.doing = post::text_of(stage),
                              .of = stage.of,
                              .number = stage.number,
                              .count = stage.is_counted() ? stage.count : 0,
                              .elapsed = post::ProgressLine::wall_clock() - begun_},
                    .done = static_cast<std::size_t>(done),
                    .total = total(stage.ahead.least),
                    .at_most = total(stage.ahead.most),
                    .thing = "simulation"});
    }

    post::ProgressLine line_;
    diagnosis::Work doing_ = diagnosis::Work::none;
    std::size_t number_ = 0;
    long of_this_ = 0;    ///< simulations of the diagnosis that goes on
    long of_others_ = 0;  ///< and of those before it
    long at_begin_ = 0;   ///< of all, when this piece began
    double begun_ = 0.0;  ///< s of wall time, when this stage began
};

/// Simulations that an interrupted call of the same kind has kept; tells of them.
/// @param command "identify"
[[nodiscard]] std::unique_ptr<post::PredictionJournal> open_journal(const MeasuredCall& call,
                                                                    post::OutputFolder& folder,
                                                                    const std::string& command,
                                                                    const std::vector<std::string>& files,
                                                                    Caller& caller);
/// Leaves the simulations to the next call. @returns a sentence about them without full stop; empty where there are none
[[nodiscard]] std::string kept_for_next_call(post::OutputFolder& folder, const post::PredictionJournal& journal);
/// Says where the journal had no room, which changes no answer.
void tell_of_journal(const post::PredictionJournal& journal, Caller& caller);
/// Reports how a fit or a diagnosis failed or was stopped, and what of it is kept. @param consequence "nothing was fitted"
/// @returns the exit code
[[nodiscard]] int report_failure(const solver::Status& status, post::OutputFolder& folder,
                                 const post::PredictionJournal& journal, const std::string& consequence,
                                 Caller& caller);

/// Where the call's files go: where it says, otherwise to `standard`.
[[nodiscard]] std::filesystem::path folder_of(const MeasuredCall& call, const std::filesystem::path& standard);

/// Lets files be written and moved into place together; reports when that cannot be done.
/// @param stale names of files of an earlier call that these do away with
/// @param write files to a directory, to return their paths   @returns nothing when a file could not be written
[[nodiscard]] std::optional<std::vector<std::filesystem::path>> write_measured(
    post::OutputFolder& folder, const std::vector<std::string>& stale, Caller& caller,
    const std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)>& write);

/// The same with the files of the page, unless they are refused.
/// @param kind "compare"  @param write as above  @param report of the files in their place
/// @returns the page; nothing when a file could not be written
[[nodiscard]] std::optional<post::Report> write_measured_page(
    const MeasuredCall& call, post::OutputFolder& folder, const std::vector<std::string>& stale,
    const std::string& kind, Caller& caller,
    const std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)>& write,
    const std::function<post::Report(const std::vector<std::filesystem::path>&)>& report);

}  // namespace tiretherm::calls
