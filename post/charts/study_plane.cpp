// SPDX-License-Identifier: BSD-3-Clause
// Collects the median temperatures of a plane and interpolates them bilinearly onto pixels.

#include "post/charts/study_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr std::size_t most_panels = 6;

double median_at(const StudyRecord& study, std::size_t point) {
    const std::vector<double> hottest = hottest_at(study, point);
    return hottest.empty() ? std::numeric_limits<double>::quiet_NaN() : quantile(hottest, 0.5);
}

/// A side's places in ascending order.
StudyAxis ascending(const StudyAxis& axis) {
    StudyAxis sorted = axis;
    const std::vector<std::size_t> order = axis.order();
    for (std::size_t i = 0; i < order.size(); ++i) {
        sorted.at[i] = axis.at[order[i]];
        sorted.labels[i] = axis.labels[order[i]];
    }
    return sorted;
}

/// @param corner point of the grid at which the two sides have their first values
StudyPlane plane_at(const StudyRecord& study, std::size_t side_x, std::size_t side_y, std::size_t corner) {
    StudyAxis x = study_axis(study, side_x);
    StudyAxis y = study_axis(study, side_y);
    if (!x.is_number || !y.is_number) {
        x = x.in_steps();
        y = y.in_steps();
    }
    StudyPlane plane{.x = ascending(x), .y = ascending(y), .title = {}, .value = {}};
    for (const std::size_t i : x.order()) {
        for (const std::size_t j : y.order()) {
            plane.value.push_back(median_at(study, corner + i * stride(study, side_x) + j * stride(study, side_y)));
        }
    }
    for (std::size_t side = 0; side < study.sides.size(); ++side) {
        if (side != side_x && side != side_y) {
            plane.title.push_back(
                fmt::format("{} = {}", study.columns[side].key, study.columns[side].texts[corner * study.samples]));
        }
    }
    return plane;
}

/// Between which places a value lies, and how far from the first; words belong to the nearest.
struct Between {
    std::size_t first;
    std::size_t second;
    double share;
};
Between find(const StudyAxis& axis, double value) {
    if (!axis.is_number) {
        const auto nearest =
            static_cast<std::size_t>(std::clamp(std::lround(value), 0L, static_cast<long>(axis.at.size()) - 1));
        return {nearest, nearest, 0.0};
    }
    const auto next = std::upper_bound(axis.at.begin() + 1, axis.at.end() - 1, value);
    const auto second = static_cast<std::size_t>(next - axis.at.begin());
    const double width = axis.at[second] - axis.at[second - 1];
    return {second - 1, second, width > 0.0 ? std::clamp((value - axis.at[second - 1]) / width, 0.0, 1.0) : 0.0};
}

}  // namespace

Raster rasterise(const StudyPlane& plane, int width, int height, double low, double high) {
    Raster raster{.width = width, .height = height, .value = {}, .low = low, .high = high};
    const auto value = [&](std::size_t i, std::size_t j) {
        return std::isfinite(plane.at(i, j)) ? plane.at(i, j) : low;
    };
    std::vector<Between> columns;
    for (int px = 0; px < width; ++px) {
        columns.push_back(find(plane.x, plane.x.low + (px + 0.5) / width * (plane.x.high - plane.x.low)));
    }
    for (int row = 0; row < height; ++row) {
        const Between y = find(plane.y, plane.y.high - (row + 0.5) / height * (plane.y.high - plane.y.low));
        for (const Between& x : columns) {
            const double lower = (1.0 - x.share) * value(x.first, y.first) + x.share * value(x.second, y.first);
            const double upper = (1.0 - x.share) * value(x.first, y.second) + x.share * value(x.second, y.second);
            raster.value.push_back((1.0 - y.share) * lower + y.share * upper);
        }
    }
    return raster;
}

std::vector<StudyPlane> study_planes(const StudyRecord& study, bool& more) {
    const std::vector<std::size_t> wide = wide_sides(study);
    std::vector<std::size_t> corners{0};
    for (std::size_t k = 2; k < wide.size(); ++k) {
        std::vector<std::size_t> next;
        for (const std::size_t corner : corners) {
            for (std::size_t i = 0; i < study.sides[wide[k]]; ++i) {
                next.push_back(corner + i * stride(study, wide[k]));
            }
        }
        corners = std::move(next);
    }
    more = corners.size() > most_panels;
    corners.resize(more ? 1 : corners.size());
    std::vector<StudyPlane> planes;
    for (const std::size_t corner : corners) {
        planes.push_back(plane_at(study, wide[0], wide[1], corner));
    }
    return planes;
}

}  // namespace tiretherm::post
