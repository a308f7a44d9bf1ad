// SPDX-License-Identifier: BSD-3-Clause
// How a run answers to changes of single values of its case.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "input/studies/what_if.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::diagnosis {

/// A change and what it does to one run: differences to the run as it stands. SI
struct WhatIfRow {
    std::string key;
    std::string change;
    std::string run{};
    std::string corner{};
    std::string failure{};           ///< of the solver; empty: the run came to its end
    bool has_other_sensors = false;  ///< than the case: there is nothing to compare
    double hottest = 0.0;            ///< K, of the hottest place
    std::vector<double> highest{};   ///< [n_channels] of the maximum
    std::vector<double> end{};       ///< [n_channels] of the last value

    [[nodiscard]] bool has_values() const { return failure.empty() && !has_other_sensors; }
    [[nodiscard]] bool moves_nothing() const;
};

struct WhatIf {
    std::vector<WhatIfRow> rows;
    Remarks remarks;  ///< values that move nothing or are not there
};

/// Simulates all changed runs, several at a time. An end that is asked for leaves out the rest.
/// @param base [runs] of the case as it stands  @param reports [runs] what they came to
[[nodiscard]] WhatIf what_if(const std::vector<input::ChangedRuns>& changes,
                             const std::vector<const solver::Problem*>& base,
                             const std::vector<const solver::MarchReport*>& reports);

}  // namespace tiretherm::diagnosis
