// SPDX-License-Identifier: BSD-3-Clause
// Runs a case many times on a grid or with random draws, in several threads; runs that are already
// there are kept.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "calls/build_identity.hpp"
#include "calls/calls.hpp"
#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "calls/study_merge.hpp"
#include "diagnosis/study/study_runs.hpp"
#include "input/runs/runs.hpp"
#include "input/studies/study.hpp"
#include "post/report/progress.hpp"
#include "post/report/remark_text.hpp"
#include "post/study/study_files.hpp"
#include "post/study/study_journal.hpp"
#include "post/study/study_report.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

namespace {

using Clock = std::chrono::steady_clock;

/// What a part's call has to say: its files come with the merge.
post::Report part_report(const diagnosis::StudyPart& part, const diagnosis::StudyResults& results, std::size_t runs,
                         const StudyOptions& options) {
    return {.title = fmt::format("Part {}: {} runs are done, {} of them were kept. When all parts are:", part.text(),
                                 runs, results.kept),
            .lead = {fmt::format("  tiretherm study {} --merge{}", options.study_file,
                                 options.directory.empty() ? "" : " --out " + options.directory)},
            .data = {{"part", part.index},
                     {"of", part.count},
                     {"runs", runs},
                     {"kept", results.kept},
                     {"made", results.done - results.kept}}};
}

/// The failure that a call ends with whose runs did not all come to an end.
/// @param outcomes [n_runs], of which those of the part are looked at  @param runs of the part
int report_failed(std::span<const diagnosis::StudyOutcome> outcomes, const diagnosis::StudyPart& part, std::size_t runs,
                  const std::filesystem::path& directory, Caller& caller) {
    std::vector<std::size_t> failed;
    for (std::size_t run = 0; run < outcomes.size(); ++run) {
        if (part.has(run) && !outcomes[run].ok()) {
            failed.push_back(run);
        }
    }
    if (failed.empty()) {
        return Exit::done;
    }
    caller.complain(fmt::format("{} of {} runs failed, the first is run {}: {}", failed.size(), runs,
                                failed.front() + 1, outcomes[failed.front()].failure),
                    "the others are in " + directory.string());
    return Exit::numerical_failure;
}

/// Puts the runs of all parts into the journal. @returns false after a report where they do not fit together
bool merges(const input::Study& study, const std::filesystem::path& whole, post::StudyJournal& journal,
            Caller& caller) {
    try {
        const std::vector<std::string> problems = merge_parts(study, whole, build_identity(), journal);
        if (!problems.empty()) {
            caller.refuse(problems, "nothing was written; what the parts have is kept");
        }
        return problems.empty();
    } catch (const std::runtime_error& error) {
        caller.refuse(error.what(), "nothing was merged; call again when it has ended");
        return false;
    }
}

/// Adds what the runs themselves give reason to warn of; writes the files and prints the page.
/// @param kept a sentence on what a call that failed leaves  @returns false after a report where a file cannot be written
bool write_page(diagnosis::StudyRecord& record, post::StudyCall call, post::StudyFiles& files,
                const post::OutputFolder& folder, const std::string& kept, Caller& caller) {
    std::ranges::move(post::texts_of(record.left_ranges()), std::back_inserter(record.warnings));
    for (const std::string& key : record.without_effect()) {
        record.warnings.push_back(fmt::format("\"{}\" changed nothing: no effect that is on looks at it", key));
    }
    post::Report page;
    try {
        files.write(record, [&](const std::vector<std::filesystem::path>& named) {
            call.files = named;
            page = post::study_report(record, call);
            return page;
        });
    } catch (const std::runtime_error& error) {
        caller.refuse(folder.in_place(error.what()), kept);
        return false;
    }
    caller.take(page);
    return true;
}

}  // namespace

int study(const StudyOptions& options, Caller& caller) {
    input::StudyReading reading =
        while_reading(options.study_file, [&] { return input::read_study(options.study_file); });
    if (was_stopped("nothing was run", caller)) {
        return Exit::interrupted;
    }
    if (!reading.study) {
        caller.refuse(input::CaseFindings{.errors = reading.errors, .warnings = reading.warnings}, "nothing was run");
        return Exit::input_error;
    }
    const input::Study& study = *reading.study;
    const auto part = options.part.empty() ? diagnosis::StudyPart{} : *diagnosis::StudyPart::parse(options.part);
    const std::filesystem::path whole =
        options.directory.empty() ? "out/" + input::case_name(study.file) : options.directory;
    const std::filesystem::path directory = options.part.empty() ? whole : whole / part.folder();
    const auto folder = open_output(directory, reading.files, post::StudyFiles::names(), "nothing was run", caller);
    if (!folder) {
        return Exit::input_error;
    }
    std::optional<post::StudyFiles> files;
    std::optional<post::StudyJournal> journal;
    try {
        files.emplace(*folder, !options.no_report);
        journal.emplace(files->journal(), study.channels.size(), build_identity(), options.fresh);
    } catch (const std::runtime_error& error) {
        caller.refuse(error.what(), "nothing was run; choose another directory with --out");
        return Exit::input_error;
    }
    const std::size_t runs = part.size(study.runs.size());
    if (options.merge && !merges(study, whole, *journal, caller)) {
        return Exit::input_error;
    }
    now_doing(fmt::format("making the runs of {} and writing to {}", options.study_file, directory.string()));
    const Clock::time_point begin = Clock::now();
    diagnosis::StudyResults results;
    {
        post::ProgressLine line = caller.progress_line();
        std::optional<std::size_t> kept;
        const auto show = [&](std::size_t done) {
            kept = kept.value_or(done - 1);
            line.show({.done = done, .total = runs, .kept = *kept});
        };
        results = diagnosis::run_study(study, *journal, options.threads, show, part);
    }
    const std::string kept = fmt::format("{} of {} runs are kept in {}; the same call goes on from there", results.done,
                                         runs, directory.string());
    if (!results.error.empty()) {
        caller.refuse(results.error, kept);
        return Exit::input_error;
    }
    if (results.done < runs) {
        caller.refuse("stopped", kept);
        return Exit::interrupted;
    }
    if (!options.part.empty()) {
        caller.take(part_report(part, results, runs, options));
        return report_failed(results.outcomes, part, runs, directory, caller);
    }
    const post::StudyCall call{.kept = results.kept,
                               .outdated = journal->outdated(),
                               .damaged = journal->damaged(),
                               .seconds = std::chrono::duration<double>(Clock::now() - begin).count(),
                               .run_seconds = results.run_seconds,
                               .threads = post::threads_used(options.threads, study.runs.size() - results.kept),
                               .files = {}};
    diagnosis::StudyRecord record = post::study_record(study, std::move(results.outcomes));
    record.warnings = std::move(reading.warnings);
    if (!write_page(record, call, *files, *folder, kept, caller)) {
        return Exit::input_error;
    }
    return report_failed(record.outcomes, part, runs, directory, caller);
}

}  // namespace tiretherm::calls
