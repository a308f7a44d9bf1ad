// SPDX-License-Identifier: BSD-3-Clause
// Hot spots over a run; passing times by linear interpolation.

#include "solver/hot_spot/hot_spot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/index.hpp"

namespace tiretherm::solver {

HotSpotHistory::HotSpotHistory(const mesh::Mesh& mesh, Critical critical)
    : critical_(std::move(critical)), finder_(mesh, critical_.nodes) {}

void HotSpotHistory::take(const Snapshot& snapshot) {
    const HotSpotFinder::Found found = finder_.find(snapshot.temperature);
    time_.push_back(snapshot.time);
    temperature_.push_back(found.temperature);
    found_.push_back(found);
    double surface = std::numeric_limits<double>::quiet_NaN();
    if (critical_.channel >= 0) {
        surface = snapshot.channels[at(critical_.channel)];
    } else if (!critical_.surface.nodes.empty()) {
        surface = critical_.surface(snapshot.temperature);
    }
    surface_.push_back(surface);
    if (rows() == 1 || found.temperature > temperature_[hottest_row_] + creeping_rise) {
        hottest_row_ = rows() - 1;
        hottest_place_ = finder_.functional(snapshot.temperature);
    }
}

void HotSpotHistory::visit(Archive& archive) {
    std::size_t n = rows();
    archive.whole(n);
    if (archive.is_reading()) {
        n = std::min(n, archive.left());  // of a damaged archive, which will be refused
    }
    found_.resize(n);
    for (std::vector<double>* values : {&time_, &temperature_, &surface_}) {
        values->resize(n);
        archive(*values);
    }
    for (HotSpotFinder::Found& found : found_) {
        archive(found.temperature);
        archive.whole(found.node);
        for (double& coordinate : found.point) {
            archive(coordinate);
        }
    }
    archive.whole(hottest_row_);
    std::size_t places = hottest_place_.nodes.size();
    archive.whole(places);
    places = archive.is_reading() ? std::min(places, archive.left()) : places;
    hottest_place_.nodes.resize(places);
    hottest_place_.weights.resize(places);
    for (int& node : hottest_place_.nodes) {
        archive.whole(node);
    }
    archive(hottest_place_.weights);
}

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
    const auto above = static_cast<std::size_t>(std::ranges::upper_bound(time, t) - time.begin());
    if (above == 0 || above == time.size()) {
        return value[above == 0 ? 0 : time.size() - 1];
    }
    const double share = (t - time[above - 1]) / (time[above] - time[above - 1]);
    return (1.0 - share) * value[above - 1] + share * value[above];
}

}  // namespace tiretherm::solver
