// SPDX-License-Identifier: BSD-3-Clause
// Finds pixels on a level by the local gradient, and places for the labels away from one another and from the frame.

#include "post/pictures/isotherms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tiretherm::post {

namespace {

constexpr double line_width = 1.6;  // px

}  // namespace

double Raster::distance(int x, int y, double level) const {
    const int left = std::max(x - 1, 0);
    const int right = std::min(x + 1, width - 1);
    const int up = std::max(y - 1, 0);
    const int down = std::min(y + 1, height - 1);
    const double slope = std::hypot((at(right, y) - at(left, y)) / std::max(right - left, 1),
                                    (at(x, down) - at(x, up)) / std::max(down - up, 1));
    const bool flat = slope <= 1e-6 * (high - low);
    return flat ? std::numeric_limits<double>::max() : std::abs(at(x, y) - level) / slope;
}

Colour level_ink(const Raster& raster, double level) {
    return luminance(heat_colour(raster.share(level))) > 0.4 ? colour(0x000000) : colour(0xffffff);
}

std::vector<Colour> shade(const Raster& raster, std::span<const double> levels) {
    std::vector<Colour> result;
    result.reserve(raster.value.size());
    for (int y = 0; y < raster.height; ++y) {
        for (int x = 0; x < raster.width; ++x) {
            const double value = raster.at(x, y);
            const Colour base = heat_colour(raster.share(value));
            const auto nearest = std::min_element(levels.begin(), levels.end(), [&](double a, double b) {
                return std::abs(a - value) < std::abs(b - value);
            });
            double cover = 0.0;
            if (nearest != levels.end()) {
                cover = std::clamp(0.5 * line_width + 0.5 - raster.distance(x, y, *nearest), 0.0, 1.0);
            }
            result.push_back(cover > 0.0 ? mix(base, level_ink(raster, *nearest), 0.55 * cover) : base);
        }
    }
    return result;
}

std::vector<LevelMark> level_marks(const Raster& raster, std::span<const double> levels, double room) {
    std::vector<LevelMark> marks;
    // From the hottest down: the small rings have the least choice.
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
        LevelMark best{.level = *level, .place = {}};
        double best_score = 0.0;
        for (int y = 0; y < raster.height; y += 2) {
            for (int x = raster.width / 6; x < raster.width; x += 2) {
                const bool far = std::abs(raster.at(x, y) - *level) > 0.05 * (raster.high - raster.low);
                if (far || raster.distance(x, y, *level) > 1.0) {
                    continue;
                }
                const double to_frame = std::min({raster.width - 1 - x, 2 * y, 2 * (raster.height - 1 - y)});
                double free = to_frame;
                for (const LevelMark& other : marks) {
                    free = std::min(free, std::hypot(x - other.place.x, y - other.place.y));
                }
                // Beyond twice the room nothing is gained by distance; then the right is better than the left.
                const double score = free < room ? 0.0 : std::min(free, 2.0 * room) + 0.1 * x;
                if (score > best_score) {
                    best_score = score;
                    best.place = {.x = static_cast<double>(x), .y = static_cast<double>(y)};
                }
            }
        }
        if (best_score > 0.0) {
            marks.push_back(best);
        }
    }
    return marks;
}

}  // namespace tiretherm::post
