// SPDX-License-Identifier: BSD-3-Clause
// Runs a problem from its start to its end or to its steady state; snapshots go to an observer, totals into a report.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "solver/problem.hpp"
#include "solver/status.hpp"
#include "solver/time_integration/checkpoint.hpp"
#include "solver/time_integration/law_ranges.hpp"

namespace tiretherm::solver {

/// The state at a moment that is being reported. Spans live only during the call.
struct Snapshot {
    double time = 0.0;                    ///< s
    std::span<const double> temperature;  ///< [n_nodes] K
    std::span<const double> channels;     ///< [n_channels] K
    std::span<const double> watts;        ///< [n_effects] W at that time (not scaled by symmetry)
    std::span<const double> joules;       ///< [n_effects] J since the start
    double stored = 0.0;                  ///< J since the start
    bool field = false;                   ///< true when the field is due for storing (first and last always)
};

/// What a run reports besides the snapshots.
struct MarchReport {
    Status status;
    double simulated = 0.0;  ///< s
    long steps = 0;
    long rejected = 0;
    long newton_iterations = 0;
    long linear_iterations = 0;
    long factorisations = 0;
    std::string linear_solver;   ///< "CHOLMOD supernodal, 560 000 entries in the factor", "CG, incomplete Cholesky"
    std::vector<double> watts;   ///< [n_effects] W at the end
    std::vector<double> joules;  ///< [n_effects] J
    /// [n_effects] W at the end that a property modifier adds to the heat of others; NaN for every other effect
    std::vector<double> law_watts;
    double stored = 0.0;          ///< J
    double energy_closure = 0.0;  ///< |stored - sum of joules| over the heat turned over (sum of |watts| dt)
    double effective_two_node_conductance =
        0.0;  ///< W/K at the end, see Stepper::effective_two_node_conductance; NaN where it has no meaning
    struct Extreme {
        double temperature = 0.0;  ///< K
        double time = 0.0;         ///< s
        int node = -1;
    };
    /// The peak between the centres of cells, see HotSpotFinder, at the step that first came within `creeping_rise` of the
    /// highest.
    Extreme hottest;
    std::vector<double> hottest_field;  ///< [n_nodes] K, at that time
    Extreme coldest;
    std::vector<double> channel_final;  ///< [n_channels] K
    std::vector<double> channel_min;
    std::vector<double> channel_max;
    std::vector<RangeWarning> warnings;
    std::vector<double> seconds;  ///< [assembly, factor, solve, output] wall time
};

/// Called at the start, at every output time and at the end; returns false to stop the run (outcome `stopped`).
using Observer = std::function<bool(const Snapshot&)>;

/// Runs a problem from its start to its end, or to its steady state.
/// @param continuation checkpoints; a steady state has none. A resumed run does not report rows again that were
///        reported before its checkpoint.
[[nodiscard]] MarchReport run(const Problem& problem, const Observer& observer, const Continuation& continuation = {});

}  // namespace tiretherm::solver
