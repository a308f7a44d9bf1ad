// SPDX-License-Identifier: BSD-3-Clause
// Hot spots over a run; passing times by linear interpolation.

#include "solver/hot_spot/hot_spot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/index.hpp"
#include "physics/bracket.hpp"

namespace tiretherm::solver {

HotSpotHistory::HotSpotHistory(const mesh::Mesh& mesh, Critical critical)
    : critical_(std::move(critical)), finder_(mesh, critical_.nodes) {}

void HotSpotHistory::take(const Snapshot& snapshot) {
    const HotSpotFinder::Found found = finder_.find(snapshot.temperature);
    now_.time.push_back(snapshot.time);
    now_.temperature.push_back(found.temperature);
    now_.found.push_back(found);
    double surface = std::numeric_limits<double>::quiet_NaN();
    if (critical_.channel >= 0) {
        surface = snapshot.channels[at(critical_.channel)];
    } else if (!critical_.surface.nodes.empty()) {
        surface = critical_.surface(snapshot.temperature);
    }
    now_.surface.push_back(surface);
    if (rows() == 1 || found.temperature > now_.temperature[now_.hottest_row] + creeping_rise) {
        now_.hottest_row = rows() - 1;
        now_.hottest_place = finder_.functional(snapshot.temperature);
    }
}

void HotSpotHistory::visit(Archive& archive) { archive.grown(now_); }

double passing_time(std::span<const double> time, std::span<const double> value, double level) {
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i] >= level) {
            const double before = i > 0 ? value[i - 1] : level;
            return i == 0 ? time[0] : time[i - 1] + (time[i] - time[i - 1]) * (level - before) / (value[i] - before);
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

double value_at(std::span<const double> time, std::span<const double> value, double t) {
    return physics::bracket(time, t).between([&](std::size_t i) { return value[i]; });
}

}  // namespace tiretherm::solver
