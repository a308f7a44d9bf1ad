// SPDX-License-Identifier: BSD-3-Clause
// Looks for numbers that several runs share, for corners without readings and for corners with effects of their own.

#include "input/runs/run_being_read.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"

namespace tiretherm::input {

void warn_of_shared_numbers(const TomlValue& document, const RunsBeingRead& runs, InputErrors& errors) {
    const TomlValue* numbers = document.find("measured");
    const auto sharing = std::ranges::count_if(runs, [](const std::unique_ptr<RunBeingRead>& one) {
        const bool own = one->table.table != nullptr && one->table.table->find("measured") != nullptr;
        return !own && !one->run.numbers.empty();
    });
    if (numbers != nullptr && sharing > 1) {
        errors.warn(numbers->place,
                    "the [[measured]] values of the case apply to each of {} runs: give them to the run "
                    "in which they were measured",
                    sharing);
    }
}

void leave_out_idle_corners(RunsBeingRead& runs, InputErrors& errors) {
    std::vector<std::string> recordings;
    for (const auto& one : runs) {
        if (!one->table.corner.empty() &&
            (recordings.empty() ||
             recordings.back() != one->table.recording)) {  // the corners of a run follow each other
            recordings.push_back(one->table.recording);
        }
    }
    for (const std::string& recording : recordings) {
        std::vector<std::string> idle;
        const RunBeingRead* measuring = nullptr;
        const RunBeingRead* last = nullptr;
        for (const auto& one : runs) {
            if (one->table.recording == recording) {
                last = one.get();
                measuring = one->has_readings() ? one.get() : measuring;
                if (!one->has_readings()) {
                    idle.push_back(one->table.corner);
                }
            }
        }
        if (measuring == nullptr) {
            errors.add(last->table.place, fmt::format("no corner of the run {} measures anything", recording),
                       "map columns to sensors in [[corner]]: columns = { COLUMN = \"SENSOR\" }");
        } else if (!idle.empty()) {
            errors.warn(last->table.place, "the run {} measures nothing at {}: left out", recording, listed(idle));
            std::erase_if(runs, [&](const std::unique_ptr<RunBeingRead>& one) {
                return one->table.recording == recording && !one->has_readings();
            });
        }
    }
}

void check_same_effects(const RunsBeingRead& runs, InputErrors& errors) {
    const auto titles = [](const RunBeingRead& one) {
        std::vector<std::string> names;
        for (const physics::ActiveEffect& active : one.tables.problem.effects) {
            names.emplace_back(active.title());
        }
        return names;
    };
    for (const auto& one : runs) {
        const TomlValue* effects =
            one->table.corner_table != nullptr ? one->table.corner_table->find("effects") : nullptr;
        if (effects != nullptr && titles(*one) != titles(*runs.front())) {
            errors.add(
                effects->place,
                fmt::format("the corner {} has other effects than {}", one->table.corner, runs.front()->table.corner),
                "switch effects on and off in [effects] of the case; a corner gives their values");
        }
    }
}

}  // namespace tiretherm::input
