// SPDX-License-Identifier: BSD-3-Clause
// Finds saturated plateaus, repeated frames and temperatures that look like a wrong unit.

#include "input/cameras/frame_warnings.hpp"
#include "physics/celsius.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

/// Of the hottest value: one pixel has it by chance, several in several frames do not.
constexpr std::size_t a_plateau = 10;
// Beyond these, degC, a temperature of a specimen is probably in another unit.
constexpr double too_cold = -50.0;
constexpr double too_hot = 500.0;

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

void FrameChecks::take(const std::vector<double>& kelvin) {
    std::size_t here = 0;
    bool higher = false;
    for (const double value : kelvin) {
        if (std::isnan(value)) {
            continue;
        }
        coldest_ = std::min(coldest_, value);
        if (value > hottest_) {
            hottest_ = value;
            higher = true;
            here = 0;
        }
        here += value == hottest_ ? 1 : 0;
    }
    if (higher) {
        at_hottest_ = in_frames_ = 0;
    }
    at_hottest_ += here;
    in_frames_ += here > 1 ? 1 : 0;
    repeated_ += frames_ > 0 && std::ranges::equal(kelvin, last_, same) ? 1 : 0;
    last_ = kelvin;
    ++frames_;
}

std::vector<std::string> FrameChecks::warnings(const MeasuredFrames& frames, std::size_t outside) const {
    std::vector<std::string> found;
    const auto say = [&](const std::string& sentence) {
        found.push_back(fmt::format("{}: {}", frames.camera, sentence));
    };
    if (at_hottest_ >= a_plateau && in_frames_ > 1) {
        say(fmt::format(
            "its hottest value, {:.2f} degC, stands {} times, several times in each of {} frames: the camera "
            "may be saturated there; a wider range, or leave those pixels or frames out",
            celsius(hottest_), at_hottest_, in_frames_));
    }
    if (repeated_ > 0) {
        say(fmt::format("{} of {} frames equal the one before, to the last digit", repeated_, frames_));
    }
    if (celsius(coldest_) < too_cold || celsius(hottest_) > too_hot) {
        say(fmt::format("temperatures go from {:.1f} to {:.1f} degC: is the unit right?", celsius(coldest_),
                        celsius(hottest_)));
    }
    if (frames.dead > 0) {
        say(fmt::format("{} of {} detectors have no value in some frame and count as dead", frames.dead,
                        frames.detectors.rows * frames.detectors.columns));
    }
    if (frames.beside > 0) {
        say(fmt::format("{} of {} detectors look beside the specimen, or over its edge, and are masked", frames.beside,
                        frames.detectors.rows * frames.detectors.columns));
    }
    if (outside > 0) {
        say(fmt::format("{} frames lie outside of the run and are left out", outside));
    }
    return found;
}

}  // namespace tiretherm::input
