// SPDX-License-Identifier: BSD-3-Clause
// Implements the steps that calls with measured data share.

#include "calls/measured_call.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "calls/caller.hpp"
#include "calls/doing.hpp"
#include "diagnosis/compare/camera_rings.hpp"
#include "diagnosis/observations/thinning.hpp"
#include "input/studies/case_values.hpp"
#include "post/page/html_page.hpp"
#include "post/report/remark_text.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

std::optional<input::ExperimentReading> read_measured(const MeasuredCall& call, const char* consequence, Caller& caller,
                                                      input::ReadMode mode) {
    input::ExperimentReading reading =
        while_reading(call.case_file, [&] { return input::read_experiment(call.case_file, call.data_files(), mode); });
    if (!reading.experiment) {
        caller.refuse(reading, consequence);
        return std::nullopt;
    }
    return reading;
}

input::ExperimentReading read_corrected(const MeasuredCall& call, const input::MeshChange& mesh) {
    input::ExperimentReading reading = input::read_experiment(
        call.case_file, call.data_files(), input::ReadMode::measured, mesh, call.corrections.columns);
    if (reading.experiment) {
        diagnosis::mirror_inputs(*reading.experiment, call.corrections.mirrored);
    }
    return reading;
}

namespace {

diagnosis::DataFaults find_faults(const MeasuredCall& call, const input::Experiment& as_taken) {
    const auto read_again = [&](const diagnosis::DataCorrections& corrections) -> std::optional<input::Experiment> {
        MeasuredCall corrected = call;
        corrected.corrections = corrections;
        std::optional<input::Experiment> again = read_corrected(corrected).experiment;
        diagnosis::Remarks said_before;
        return again ? std::optional(diagnosis::thinned(diagnosis::in_rings(std::move(*again), said_before)).experiment)
                     : std::nullopt;
    };
    return diagnosis::find_data_faults(as_taken, read_again);
}

}  // namespace

diagnosis::DataFaults correct_data(MeasuredCall& call, input::ExperimentReading& reading,
                                   const input::Experiment& as_taken) {
    diagnosis::DataFaults faults = find_faults(call, as_taken);
    if (!faults.found.empty()) {
        call.corrections = faults.corrections;
        std::vector<std::string> warnings = std::move(reading.warnings);  // of the headings as they are
        reading = read_corrected(call);
        reading.warnings = std::move(warnings);
    }
    return faults;
}

std::vector<std::string> wrong_labels(const MeasuredCall& call, const input::Experiment& experiment) {
    diagnosis::Remarks said_elsewhere;
    const diagnosis::Thinned thinned = diagnosis::thinned(diagnosis::in_rings(experiment, said_elsewhere));
    std::vector<std::string> sentences;
    for (const diagnosis::DataFault& fault : find_faults(call, thinned.experiment).found) {
        sentences.push_back(post::text_of(fault.remark));
    }
    return sentences;
}

bool has_free_parameters(const MeasuredCall& call, const input::Experiment& experiment, Caller& caller) {
    if (!experiment.parameters.empty()) {
        return true;
    }
    caller.refuse(fmt::format("{}: no parameter of the case is free", call.case_file),
                  "name those to be fitted: [[parameter]], see cases/README.md");
    return false;
}

std::optional<std::vector<std::filesystem::path>> write_measured(
    post::OutputFolder& folder, const std::vector<std::string>& stale, Caller& caller,
    const std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)>& write) {
    std::vector<std::filesystem::path> files;
    if (!write_output(folder, stale, caller, [&] { files = folder.homes(write(folder.stage())); })) {
        return std::nullopt;
    }
    return files;
}

std::unique_ptr<post::PredictionJournal> open_journal(const MeasuredCall& call, post::OutputFolder& folder,
                                                      const std::string& command, const std::vector<std::string>& files,
                                                      Caller& caller) {
    auto journal = std::make_unique<post::PredictionJournal>(
        folder, command + ".simulations", call_identity(files, {command, call.case_file}), call.fresh);
    if (journal->is_damaged()) {
        tell_of_damage("the simulations that are not whole are made again", caller);
    }
    if (const std::size_t n = journal->found(); n > 0) {
        tell_of_continuation(fmt::format("{} {} kept", n, n == 1 ? "simulation is" : "simulations are"), caller);
    }
    return journal;
}

int report_failure(const solver::Status& status, post::OutputFolder& folder, const post::PredictionJournal& journal,
                   const std::string& consequence, Caller& caller) {
    if (status.outcome != solver::Outcome::stopped) {
        caller.refuse(status.message, consequence);
        return Exit::numerical_failure;
    }
    const std::string what = solver::is_time_up() ? stop_sentence() + " before there was an answer" : status.message;
    const std::string kept = kept_for_next_call(folder, journal);
    caller.refuse(what, kept.empty() ? consequence : fmt::format("{}; {}", consequence, kept));
    tell_of_journal(journal, caller);
    return stop_exit();
}

std::string kept_for_next_call(post::OutputFolder& folder, const post::PredictionJournal& journal) {
    if (journal.size() == 0) {
        return {};
    }
    folder.keep_journals();
    const bool has_new = journal.size() > journal.found();
    return fmt::format("{} {} kept in {}, {}", journal.size(),
                       journal.size() == 1 ? "simulation is" : "simulations are", folder.path().string(),
                       has_new
                           ? "the same call goes on from there"
                           : "none of them new: what comes next takes longer than this call had, so give it more time");
}

void tell_of_journal(const post::PredictionJournal& journal, Caller& caller) {
    if (journal.lacked_room()) {
        caller.note(
            "the disk is nearly full: not all simulations were kept for a call that goes on; the answer is not "
            "affected");
    }
}

std::filesystem::path folder_of(const MeasuredCall& call, const std::filesystem::path& standard) {
    return call.directory.empty() ? standard : std::filesystem::path(call.directory);
}

std::optional<post::Report> write_measured_page(
    const MeasuredCall& call, post::OutputFolder& folder, const std::vector<std::string>& stale,
    const std::string& kind, Caller& caller,
    const std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)>& write,
    const std::function<post::Report(const std::vector<std::filesystem::path>&)>& report) {
    std::optional<post::Report> page;
    const auto written = write_measured(folder, stale, caller, [&](const std::filesystem::path& stage) {
        std::vector<std::filesystem::path> files = write(stage);
        if (!call.no_report) {
            std::ranges::copy(post::page_files(stage), std::back_inserter(files));
        }
        page = report(folder.homes(files));
        if (!call.no_report) {
            post::write_page(stage, *page,
                             {.kind = kind,
                              .source = call.case_file,
                              .files = folder.inputs(),
                              .case_values = kind == "compare" ? input::case_values(call.case_file)
                                                               : decltype(post::PageOrigin::case_values){}});
        }
        return files;
    });
    return written ? std::move(page) : std::nullopt;
}

}  // namespace tiretherm::calls
