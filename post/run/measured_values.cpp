// SPDX-License-Identifier: BSD-3-Clause
// Measured values of a case beside what its run gives.
#include "post/run/measured_values.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::post {

std::vector<Comparison> compare(const solver::Problem& problem, const History& history) {
    std::vector<Comparison> found;
    const double reached = history.time().back();
    const double slack = 1e-9 * std::max(1.0, std::abs(reached));
    for (std::size_t c = 0; c < problem.channels.size(); ++c) {
        for (const solver::Measured& measured : problem.measured) {
            if (measured.channel != problem.channels[c].name || measured.time > reached + slack) {
                continue;
            }
            const double simulated = history.at(c, measured.time);
            found.push_back({.channel = c,
                             .time = measured.time,
                             .at_end = std::abs(measured.time - reached) <= slack,
                             .simulated = simulated,
                             .low = measured.low,
                             .high = measured.high,
                             .difference = simulated - std::clamp(simulated, measured.low, measured.high),
                             .source = measured.source});
        }
    }
    return found;
}

}  // namespace tiretherm::post
