// SPDX-License-Identifier: BSD-3-Clause
// Calls the readers of all tables in the order in which one may refer to another.

#include "input/runs/reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/drive/corner.hpp"
#include "input/effects/user_effects.hpp"
#include "input/files/run_name.hpp"
#include "input/model/problem_builder.hpp"
#include "input/runs/runs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/document.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

namespace fs = std::filesystem;

std::string case_name(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
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

/// A run that is too long or too finely stored, where the rest of the case is sound: otherwise its size is not known.
void check_size(const TomlTable& root, const ProblemBuilder& builder) {
    if (root.errors().count() > 0) {
        return;
    }
    if (const std::optional<SizeExcess> excess = excess_of(builder.problem, builder.limits)) {
        const TomlValue* time = root.content().find("time");
        const TomlValue* value = time != nullptr ? time->find(excess->key) : nullptr;
        root.errors().add(value != nullptr  ? value->place
                          : time != nullptr ? time->place
                                            : root.place(),
                          excess->what, excess->remedy);
    }
}

}  // namespace

void read_tables(TomlTable& root, ProblemBuilder& builder) {
    solver::Problem& problem = builder.problem;
    problem.title = root.text("title").value_or(problem.name);
    for (const LocatedString& source : root.texts("sources")) {
        problem.sources.push_back(source.text);
    }
    // A later table may refer to an earlier one: patches and layers of the mesh, channels, the run's start and end.
    builder.followed = followed_names(root.content());
    add_vehicle_columns(root.content(), builder.followed);
    builder.case_file = root.place().file;
    builder.limits = read_limits(root);
    read_tire(root, builder);
    read_materials(root, builder);
    read_mesh(root, builder);
    read_drive(root, builder);
    read_vehicle(root, builder);
    settle_tire(root, builder);
    read_effects(root, builder);
    read_time_settings(root, builder);
    read_fields(root, builder);
    read_travelling(root, builder);
    read_user_effects(root, builder);
    read_initial(root, builder);
    read_sensors(root, builder);
    read_cameras(root, builder);
    bind_readings(root, builder);
    read_measured(root, builder);
    check_laws(root, builder);
    check_size(root, builder);
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

/// The run of this name, or the recording of this name at all corners. @param name empty: the first
std::vector<RunOfCase> choose(const Runs& runs, const std::string& name, bool is_named) {
    std::vector<RunOfCase> chosen;
    const std::vector<MeasuredRun>& all = runs.experiment.runs;
    for (const MeasuredRun& run : all) {
        const bool at_corner = !run.corner.empty();
        const bool is_chosen = name.empty()
                                   ? (at_corner ? run.recording == all.front().recording : &run == &all.front())
                                   : run.name == name || (at_corner && run.recording == name);
        if (is_chosen) {
            chosen.push_back({.name = is_named || at_corner ? run.name : "",
                              .corner = run.corner,
                              .problem = run.problem,
                              .laps = run.laps});
            take_away_cameras(chosen.back().problem);
        }
    }
    return chosen;
}

Reading read_case(const fs::path& file, const std::string* text, const std::string* run) {
    InputErrors errors;
    std::optional<solver::Problem> problem;
    std::size_t corners = 0;
    Reading reading;
    if (const std::optional<TomlValue> document = read_document(file, errors, text)) {
        const Runs runs =
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
        problem = runs.problem_of(asked);
        corners = runs.corners.size();
        reading.data_warnings = runs.data_warnings;
        reading.limits = runs.limits;
        reading.plies = runs.plies;
        if (run != nullptr && errors.count() == 0) {
            reading.chosen = choose(runs, asked, tables != nullptr);
        }
    }
    reading.errors = errors.in_order();
    reading.warnings = render(errors.warnings(), corners);
    reading.files = errors.files();
    if (reading.errors.empty()) {
        take_away_cameras(*problem);
        reading.problem = std::move(problem);
    }
    return reading;
}

}  // namespace

std::vector<RunOfCase> runs_of_document(const TomlValue& document, const fs::path& file, const std::string& run,
                                        InputErrors& errors) {
    const Runs runs = read_runs(document, case_name(file), {}, ReadMode::planned, errors);
    return errors.count() == 0 ? choose(runs, run, document.find("run") != nullptr) : std::vector<RunOfCase>{};
}

Reading read_case(const fs::path& file) { return read_case(file, nullptr, nullptr); }

Reading read_case(const fs::path& file, const std::string& text) { return read_case(file, &text, nullptr); }

Reading read_case_run(const fs::path& file, const std::string& run) { return read_case(file, nullptr, &run); }

std::string render(const Reading& reading) {
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
