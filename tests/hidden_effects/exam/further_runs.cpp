// SPDX-License-Identifier: BSD-3-Clause
// Turns a manoeuvre of the program into a drive of the truth, and goes from diagnosis to run to diagnosis.

#include "hidden_effects/exam/further_runs.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hidden_effects/exam/exam_evaluation.hpp"

namespace hidden_effects {

namespace {

namespace input = tiretherm::input;
using tiretherm::diagnosis::Diagnosis;

/// Between the first two samples of a data set.
double interval_of(const ExamDataSet& data_set) {
    const std::vector<double>& time = data_set.runs.programmes.front().time;
    return time[1] - time[0];
}

Stage stage_of(const ExamDataSet& data_set, const Diagnosis& found) {
    return {.told_apart = found.told_apart, .mark = mark_of(data_set, found)};
}

/// The manoeuvre to be driven next; null: none.
const input::Manoeuvre* next_of(const std::vector<input::Manoeuvre>& possible, const Diagnosis& found, Choice choice,
                                Random& random) {
    if (possible.empty()) {
        return nullptr;
    }
    if (choice == Choice::blind) {
        return &possible[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(possible.size())))];
    }
    if (found.next.empty()) {
        return nullptr;
    }
    return &*std::ranges::find(possible, found.next.front().name, &input::Manoeuvre::name);
}

}  // namespace

Drive drive_of(const input::Manoeuvre& manoeuvre, double interval) {
    Drive drive;
    for (double t = manoeuvre.start; t <= manoeuvre.end; t += interval) {
        const tiretherm::physics::Inputs asked = manoeuvre.inputs.at(t, tiretherm::solver::JumpSide::after);
        drive.time.push_back(t);
        drive.speed.push_back(asked.speed);
        drive.vertical_load.push_back(asked.vertical_load);
        drive.slip_angle.push_back(asked.slip_angle);
    }
    return drive;
}

std::vector<Stage> diagnose_with_further_runs(ExamDataSet data_set, Choice choice, int most) {
    const std::vector<input::Manoeuvre> possible = read_data_set(data_set).possible;
    const double interval = interval_of(data_set);
    Random random(4000037ULL * data_set.seed);
    const bool plans = choice == Choice::planned;
    Diagnosis found = diagnose_data_set(data_set, {.only_verdict = !plans});
    std::vector<Stage> stages{stage_of(data_set, found)};
    while (std::ssize(stages) <= most) {
        const input::Manoeuvre* const next =
            found.hypotheses.size() == 1 ? nullptr : next_of(possible, found, choice, random);
        if (next == nullptr) {
            stages.push_back({.mark = stages.back().mark});
            continue;
        }
        const double promised = plans ? found.next.front().then : 0.0;
        add_run(data_set, drive_of(*next, interval));
        found = diagnose_data_set(data_set, {.only_verdict = !plans || std::ssize(stages) == most});
        stages.push_back(stage_of(data_set, found));
        stages.back().manoeuvre = next->name;
        stages.back().promised = promised;
    }
    return stages;
}

std::vector<Row> rows_of(const std::vector<std::vector<Stage>>& stages, Choice choice) {
    std::vector<Row> rows;
    for (std::size_t further = 0; further < stages.front().size(); ++further) {
        std::vector<Mark> marks;
        std::ranges::transform(stages, std::back_inserter(marks),
                               [&](const std::vector<Stage>& one) { return one[further].mark; });
        for (Row& row : rows_of(marks)) {
            row.group = fmt::format("{} {} runs", further, choice == Choice::planned ? "planned" : "blind");
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

std::string course_of(const std::vector<Stage>& stages) {
    const Mark& first = stages.front().mark;
    std::string text = fmt::format("seed {}, {}, nearest other misses {:.1f} sigma\n", first.seed, first.answer,
                                   first.apart.value_or(0.0));
    for (const Stage& stage : stages) {
        if (!stage.manoeuvre.empty()) {
            text += fmt::format("    + {} ({:.1f} sigma)\n", stage.manoeuvre, stage.promised);
        }
        if (&stage == &stages.front() || !stage.manoeuvre.empty()) {
            text += fmt::format("  {}{}: {}, {:.1f} s\n", stage.mark.only_right ? "= " : "", stage.mark.verdict,
                                stage.mark.set.empty() ? stage.mark.first : stage.mark.set, stage.mark.seconds);
            text += stage.told_apart.empty() ? "" : fmt::format("    of {}\n", fmt::join(stage.told_apart, " | "));
        }
    }
    return text;
}

}  // namespace hidden_effects
