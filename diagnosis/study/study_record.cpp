// SPDX-License-Identifier: BSD-3-Clause
// Failed runs of a study, column headings, and the search for varied quantities that changed nothing.

#include "diagnosis/study/study_record.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace tiretherm::diagnosis {

namespace {

/// Whether two runs came to the same, to the last digit.
bool same(const StudyOutcome& a, const StudyOutcome& b) {
    return a.hottest == b.hottest && a.channel_final == b.channel_final && a.channel_max == b.channel_max;
}

}  // namespace

std::string StudyColumn::heading() const {
    return !is_number ? key : fmt::format("{} [{}]", key, unit.empty() ? "-" : unit);
}

std::vector<std::size_t> StudyRecord::failed() const {
    std::vector<std::size_t> found;
    for (std::size_t r = 0; r < outcomes.size(); ++r) {
        if (!outcomes[r].ok()) {
            found.push_back(r);
        }
    }
    return found;
}

Remarks left_ranges(const std::vector<std::vector<solver::RangeWarning>>& of_runs) {
    struct Left {
        solver::RangeWarning reached;
        std::size_t runs = 0;
    };
    std::vector<Left> laws;
    for (const std::vector<solver::RangeWarning>& of_run : of_runs) {
        for (const solver::RangeWarning& warning : of_run) {
            auto known = std::ranges::find(laws, warning.law, [](const Left& left) { return left.reached.law; });
            if (known == laws.end()) {
                known = laws.insert(laws.end(), {warning, 0});
            }
            // Which layers it was may differ from run to run.
            known->reached.what = known->reached.what == warning.what ? warning.what : "they were";
            known->reached.coldest = std::min(known->reached.coldest, warning.coldest);
            known->reached.hottest = std::max(known->reached.hottest, warning.hottest);
            ++known->runs;
        }
    }
    Remarks all;
    for (const Left& left : laws) {
        all.push_back(
            remark::left_range(left.reached.text(), static_cast<long>(left.runs), static_cast<long>(of_runs.size())));
    }
    return all;
}

Remarks StudyRecord::left_ranges() const {
    std::vector<std::vector<solver::RangeWarning>> of_runs;
    std::ranges::transform(outcomes, std::back_inserter(of_runs), &StudyOutcome::warnings);
    return diagnosis::left_ranges(of_runs);
}

std::vector<std::string> StudyRecord::without_effect() const {
    std::vector<std::string> idle;
    // A step along a side of the grid is so many runs long.
    std::size_t step = outcomes.size();
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const std::size_t round = step;
        step /= sides[side];
        bool differs = sides[side] < 2;
        for (std::size_t r = 0; r + step < outcomes.size() && !differs; ++r) {
            differs = r % round + step < round && !same(outcomes[r], outcomes[r + step]);
        }
        if (!differs) {
            idle.push_back(columns[side].key);
        }
    }
    return idle;
}

}  // namespace tiretherm::diagnosis
