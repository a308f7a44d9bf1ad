// SPDX-License-Identifier: BSD-3-Clause
// Measured values of a case beside what its run gives.
#pragma once

#include <string>
#include <vector>

#include "post/report/history.hpp"
#include "solver/problem.hpp"

namespace tiretherm::post {

/// A measured value or range beside the simulated one.
struct Comparison {
    std::size_t channel = 0;  ///< index into problem.channels
    double time = 0.0;        ///< s
    bool at_end = false;      ///< the time is the end of the run
    double simulated = 0.0;   ///< K, at that time
    double low = 0.0;         ///< K, measured
    double high = 0.0;        ///< K, measured; equal to low for a single number
    double difference = 0.0;  ///< K, simulated - measured, from the nearest end of a range; 0 inside it
    std::string source;
};

/// All measured values that the run reached, in the order of the channels.
/// @param history at least one row
[[nodiscard]] std::vector<Comparison> compare(const solver::Problem& problem, const History& history);

}  // namespace tiretherm::post
