// SPDX-License-Identifier: BSD-3-Clause
// Simulates the changed runs in parallel and says of which values nothing follows, and why.

#include "diagnosis/study/what_if.hpp"

#include <algorithm>
#include <cmath>

#include "input/text/word_lists.hpp"
#include "mesh/parallel.hpp"
#include "solver/time_integration/run_to_end.hpp"

namespace tiretherm::diagnosis {

namespace {

struct Task {
    const solver::Problem* problem;
    std::size_t run;
};

void fill(WhatIfRow& row, const solver::RunEnd& end, const solver::MarchReport& base) {
    row.failure = end.failure;
    if (!end.failure.empty()) {
        return;
    }
    if (end.report.channel_max.size() != base.channel_max.size()) {
        row.has_other_sensors = true;
        return;
    }
    row.hottest = end.report.hottest.temperature - base.hottest.temperature;
    for (std::size_t c = 0; c < base.channel_max.size(); ++c) {
        row.highest.push_back(end.report.channel_max[c] - base.channel_max[c]);
        row.end.push_back(end.report.channel_final[c] - base.channel_final[c]);
    }
}

/// Why a value moves nothing.
Remark reason(const std::string& key, const solver::Problem& problem) {
    const std::string_view signal = std::string_view(key).substr(key.find('.') + 1);
    if (!key.starts_with("drive.") || physics::find_signal(signal) == nullptr) {
        return remark::no_effect_looks_at_it();
    }
    if (const std::vector<std::string> readers = input::readers_of(problem, signal); !readers.empty()) {
        return remark::may_read_it(input::listed(readers));
    }
    const std::vector<std::string> others = input::would_read(problem, signal);
    return others.empty() ? remark::no_effect_reads_it() : remark::others_would_read_it(input::listed(others));
}

}  // namespace

bool WhatIfRow::moves_nothing() const {
    const auto is_zero = [](double difference) { return difference == 0.0; };
    return has_values() && is_zero(hottest) && std::ranges::all_of(highest, is_zero) &&
           std::ranges::all_of(end, is_zero);
}

WhatIf what_if(const std::vector<input::ChangedRuns>& changes, const std::vector<const solver::Problem*>& base,
               const std::vector<const solver::MarchReport*>& reports) {
    WhatIf answer;
    std::vector<Task> tasks;
    for (const input::ChangedRuns& change : changes) {
        if (!change.nothing_to_change.empty()) {
            const Remark remark = remark::nothing_to_change(change.key, change.nothing_to_change);
            if (std::ranges::find(answer.remarks, remark) == answer.remarks.end()) {
                answer.remarks.push_back(remark);
            }
        }
        for (std::size_t r = 0; r < std::min(change.runs.size(), base.size()); ++r) {
            tasks.push_back({.problem = &change.runs[r].problem, .run = r});
            answer.rows.push_back({.key = change.key,
                                   .change = change.change,
                                   .run = change.runs[r].name,
                                   .corner = change.runs[r].corner});
        }
    }
    const auto make = [&](std::size_t i) {
        const solver::RunEnd end = solver::run_to_end(*tasks[i].problem, [](const solver::Snapshot&) {});
        fill(answer.rows[i], end, *reports[tasks[i].run]);
    };
    in_parallel(tasks.size(), make);
    std::vector<std::string> keys;
    for (const WhatIfRow& row : answer.rows) {
        const auto moves = [&](const WhatIfRow& other) { return other.key == row.key && !other.moves_nothing(); };
        if (std::ranges::find(keys, row.key) == keys.end() && std::ranges::none_of(answer.rows, moves)) {
            keys.push_back(row.key);
            answer.remarks.push_back(remark::moves_nothing(row.key, {reason(row.key, *base.front())}));
        }
    }
    return answer;
}

}  // namespace tiretherm::diagnosis
