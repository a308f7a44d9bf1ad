// SPDX-License-Identifier: BSD-3-Clause
// Collects the corners with a significant bias by phase and sign, and finds the group that they make up.

#include "diagnosis/compare/corner_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "input/drive/corner.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double significant = 2.0;  ///< standard deviations: 95 %

/// The group that just these of all the corners are; empty where they are none.
std::string group_made_up(const std::vector<std::string>& some, const std::vector<std::string>& all) {
    if (some.size() == all.size()) {
        return "all";
    }
    using input::CornerGroup;
    for (const CornerGroup kind : {CornerGroup::axle, CornerGroup::side}) {
        const std::string group = input::group_of(some.front(), kind);
        const auto is_member = [&](const std::string& corner) { return input::group_of(corner, kind) == group; };
        if (some.size() > 1 && std::ranges::all_of(some, is_member) &&
            std::ranges::count_if(all, is_member) == std::ssize(some)) {
            return group;
        }
    }
    return {};
}

}  // namespace

std::vector<CommonBias> common_biases(std::span<const CornerFigures> corners) {
    std::vector<CommonBias> found;
    for (const Phase phase : phases) {
        std::vector<std::string> all;
        std::array<CommonBias, 2> by_sign{CommonBias{.phase = phase}, CommonBias{.phase = phase}};
        for (const CornerFigures& corner : corners) {
            const auto one = std::ranges::find(corner.phases, phase, &PhaseFigures::phase);
            if (one == corner.phases.end()) {
                continue;
            }
            all.push_back(corner.corner);
            const double bias = one->figures.bias;
            if (std::abs(bias) <= significant * one->figures.bias_deviation) {
                continue;
            }
            CommonBias& common = by_sign[bias > 0.0 ? 0 : 1];
            const bool first = common.corners.empty();
            common.least = first || std::abs(bias) < std::abs(common.least) ? bias : common.least;
            common.most = first || std::abs(bias) > std::abs(common.most) ? bias : common.most;
            common.share += one->share;
            common.corners.push_back(corner.corner);
        }
        for (CommonBias& common : by_sign) {
            if (all.size() > 1 && !common.corners.empty()) {
                common.share /= static_cast<double>(common.corners.size());
                common.group = group_made_up(common.corners, all);
                found.push_back(std::move(common));
            }
        }
    }
    std::ranges::stable_sort(found, std::ranges::greater{}, &CommonBias::share);
    return found;
}

}  // namespace tiretherm::diagnosis
