// SPDX-License-Identifier: BSD-3-Clause
// Stores the channel values and the watts of each snapshot and interpolates linearly between rows.

#include "post/report/history.hpp"

#include <algorithm>

#include "physics/bracket.hpp"

namespace tiretherm::post {

void History::take(const solver::Snapshot& snapshot) {
    width_ = snapshot.channels.size();
    time_.push_back(snapshot.time);
    value_.insert(value_.end(), snapshot.channels.begin(), snapshot.channels.end());
    effects_ = snapshot.watts.size();
    watts_.insert(watts_.end(), snapshot.watts.begin(), snapshot.watts.end());
    joules_.insert(joules_.end(), snapshot.joules.begin(), snapshot.joules.end());
}

std::vector<double> History::watts(std::size_t effect) const {
    std::vector<double> result;
    if (effect < effects_ && watts_.size() == rows() * effects_) {
        for (std::size_t row = 0; row < rows(); ++row) {
            result.push_back(watts_[row * effects_ + effect]);
        }
    }
    return result;
}

std::vector<double> History::channel(std::size_t index) const {
    std::vector<double> result;
    for (std::size_t row = 0; row < rows(); ++row) {
        result.push_back(value(row, index));
    }
    return result;
}

double History::at(std::size_t channel, double t) const {
    return physics::bracket(time_, t).between([&](std::size_t row) { return value(row, channel); });
}

}  // namespace tiretherm::post
