// SPDX-License-Identifier: BSD-3-Clause
// Reads a case as it is simulated: one run of it, or that of each corner.

#include "input/runs/reader.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "input/cameras/camera.hpp"
#include "input/files/run_name.hpp"
#include "input/runs/runs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace fs = std::filesystem;

std::string case_name(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
    // From the last folder of that name on: a case of the library is called the same wherever the library lies.
    fs::path below;
    bool found = false;
    for (const fs::path& part : whole.parent_path()) {
        if (part == "cases") {
            found = true;
            below.clear();
        } else if (found) {
            below /= part;
        }
    }
    return ((found ? below : fs::path()) / plain_stem(whole)).generic_string();
}

namespace {

/// What a user calls the runs of a case: the recording at all corners, then each run by its name.
std::vector<std::string> names_to_choose(const std::vector<MeasuredRun>& runs) {
    std::vector<std::string> names;
    for (const MeasuredRun& run : runs) {
        if (!run.corner.empty()) {
            names.push_back(run.recording);
        }
    }
    const std::vector<std::string> each = names_of(runs);
    names.insert(names.end(), each.begin(), each.end());
    return unique(names);
}

/// The run of this name, or the recording of this name at all corners: they are taken out. @param name empty: the first
std::vector<RunOfCase> choose(Runs& runs, const std::string& name, bool is_named) {
    std::vector<RunOfCase> chosen;
    std::vector<MeasuredRun>& all = runs.experiment.runs;
    for (MeasuredRun& run : all) {
        const bool at_corner = !run.corner.empty();
        const bool is_chosen = name.empty()
                                   ? (at_corner ? run.recording == all.front().recording : &run == &all.front())
                                   : run.name == name || (at_corner && run.recording == name);
        if (is_chosen) {
            chosen.push_back({.name = is_named || at_corner ? run.name : "",
                              .corner = run.corner,
                              .problem = std::move(run.problem),
                              .laps = run.laps});
            const std::size_t index = static_cast<std::size_t>(&run - all.data());
            std::ranges::copy_if(runs.experiment.parameters, std::back_inserter(chosen.back().parameters),
                                 [&](const solver::FreeParameter& number) { return number.belongs_to(index); });
            take_away_cameras(chosen.back().problem);
        }
    }
    return chosen;
}

Reading read_case(const fs::path& file, const std::string* text, const std::string* run) {
    InputErrors errors;
    std::optional<solver::Problem> problem;
    Reading reading;
    if (const std::optional<TomlValue> document = read_document(file, errors, text)) {
        Runs runs =
            read_runs(*document, case_name(file), {}, run != nullptr ? ReadMode::planned : ReadMode::measured, errors);
        const TomlValue* tables = document->find("run");
        const std::string asked = run != nullptr ? *run : "";
        if (tables != nullptr) {
            reading.runs = names_of(runs.experiment.runs);
            reading.run = asked.empty() && !reading.runs.empty() ? reading.runs.front() : asked;
        }
        const std::vector<std::string> names = tables != nullptr || !runs.corners.empty()
                                                   ? names_to_choose(runs.experiment.runs)
                                                   : std::vector<std::string>{};
        if (!asked.empty() && std::ranges::find(names, asked) == names.end()) {
            errors.add(tables != nullptr ? tables->place : SourceLocation{.file = document->place.file},
                       fmt::format("the case has no run \"{}\"", asked), suggest(asked, names, "runs"));
        }
        problem = asked.empty() ? std::move(runs.problem) : runs.problem_of(asked);
        static_cast<CaseFindings&>(reading) = runs;
        if (run != nullptr && errors.count() == 0) {
            reading.chosen = choose(runs, asked, tables != nullptr);
        }
    }
    reading.take(errors);
    if (reading.errors.empty()) {
        take_away_cameras(*problem);
        reading.problem = std::move(problem);
    }
    return reading;
}

}  // namespace

std::vector<RunOfCase> runs_of_document(const TomlValue& document, const fs::path& file, const std::string& run,
                                        InputErrors& errors) {
    Runs runs = read_runs(document, case_name(file), {}, ReadMode::planned, errors);
    return errors.count() == 0 ? choose(runs, run, document.find("run") != nullptr) : std::vector<RunOfCase>{};
}

Reading read_case(const fs::path& file) { return read_case(file, nullptr, nullptr); }

Reading read_case(const fs::path& file, const std::string& text) { return read_case(file, &text, nullptr); }

Reading read_case_run(const fs::path& file, const std::string& run) { return read_case(file, nullptr, &run); }

std::string render(const CaseFindings& reading) {
    std::string text;
    for (const InputError& error : reading.errors) {
        text += render(error);
    }
    for (const std::string& warning : reading.warnings) {
        text += fmt::format("warning: {}\n", warning);
    }
    return text;
}

}  // namespace tiretherm::input
