// SPDX-License-Identifier: BSD-3-Clause
// Pixels as the fourth root of the mean of T^4 over their footprint, and derivatives with respect to temperatures and
// to the parameters of the pose.

#include "diagnosis/observations/images.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::diagnosis {

namespace {

physics::CameraPose pose_in(const solver::Problem& problem, const input::MeasuredFrames& frames) {
    return physics::pose_of(problem.effects[frames.pose]);
}

double fourth(double T) { return (T * T) * (T * T); }

std::vector<mesh::Functional> look(const input::MeasuredFrames& frames, const solver::Problem& problem,
                                   const physics::CameraPose& pose) {
    const physics::SeenSurface surface(problem.mesh, frames.patch);
    return physics::over_pixels(surface, frames.detectors, pose, frames.pixels);
}

}  // namespace

ImageBands bands_of(const input::MeasuredFrames& frames) {
    std::vector<std::pair<int, int>> place;
    for (const physics::BinnedPixel& pixel : frames.pixels) {
        place.emplace_back(pixel.row, pixel.column);
    }
    return ImageBands(place);
}

ImageView::ImageView(const input::MeasuredFrames& frames, const solver::Problem& problem)
    : channels_(frames.channels), pixels_(look(frames, problem, pose_in(problem, frames))) {}

ImageView ImageView::slope(const input::MeasuredFrames& frames, const solver::Problem& problem, std::size_t number) {
    // Between two nodes the temperature is straight: over a small part of a pixel its slope would jump from node to node.
    constexpr double part = 0.1;
    physics::ActiveEffect pose = problem.effects[frames.pose];
    const double pitch = std::min(frames.detectors.pitch_x, frames.detectors.pitch_y) * frames.bin;
    const bool turns = pose.effect->parameters[number].unit == "rad";
    const double extent = pitch * std::max(frames.rows, frames.columns) / 2.0;
    const double step = turns ? part * pitch / extent : part * pitch;
    const double here = pose.parameters[number];
    const double low = std::max(here - step, pose.effect->parameters[number].low);
    pose.parameters[number] = here + step;
    const std::vector<mesh::Functional> above = look(frames, problem, physics::pose_of(pose));
    pose.parameters[number] = low;
    const std::vector<mesh::Functional> below = look(frames, problem, physics::pose_of(pose));
    ImageView view;
    view.channels_ = frames.channels;
    const double width = here + step - low;
    for (std::size_t i = 0; i < above.size(); ++i) {
        mesh::Functional& pixel = view.pixels_.emplace_back();
        for (std::size_t k = 0; k < above[i].nodes.size(); ++k) {
            pixel.add(above[i].nodes[k], above[i].weights[k] / width);
        }
        for (std::size_t k = 0; k < below[i].nodes.size(); ++k) {
            pixel.add(below[i].nodes[k], -below[i].weights[k] / width);
        }
    }
    return view;
}

void ImageView::read(std::span<const double> channels, std::span<double> pixels) const {
    const std::span<const double> seen = channels_.of(channels);
    std::ranges::transform(pixels_, pixels.begin(), [&](const mesh::Functional& pixel) {
        double sum = 0.0;
        for (std::size_t k = 0; k < pixel.nodes.size(); ++k) {
            sum += pixel.weights[k] * fourth(seen[static_cast<std::size_t>(pixel.nodes[k])]);
        }
        return std::sqrt(std::sqrt(sum));
    });
}

void ImageView::follow(std::span<const double> channels, std::span<const double> changes,
                       std::span<const double> pixels, std::span<double> out) const {
    const std::span<const double> seen = channels_.of(channels);
    const std::span<const double> moved = channels_.of(changes);
    for (std::size_t p = 0; p < pixels_.size(); ++p) {
        const mesh::Functional& pixel = pixels_[p];
        double sum = 0.0;
        for (std::size_t k = 0; k < pixel.nodes.size(); ++k) {
            const auto node = static_cast<std::size_t>(pixel.nodes[k]);
            const double share = seen[node] / pixels[p];
            sum += pixel.weights[k] * share * share * share * moved[node];
        }
        out[p] = sum;
    }
}

void ImageView::turn(std::span<const double> channels, std::span<const double> pixels, std::span<double> out) const {
    const std::span<const double> seen = channels_.of(channels);
    for (std::size_t p = 0; p < pixels_.size(); ++p) {
        double sum = 0.0;
        for (std::size_t k = 0; k < pixels_[p].nodes.size(); ++k) {
            sum += pixels_[p].weights[k] * fourth(seen[static_cast<std::size_t>(pixels_[p].nodes[k])]);
        }
        out[p] = sum / (4.0 * pixels[p] * pixels[p] * pixels[p]);
    }
}

std::vector<std::array<double, 2>> middles_of(const input::MeasuredFrames& frames, const solver::Problem& problem) {
    const physics::CameraPose pose = pose_in(problem, frames);
    std::vector<std::array<double, 2>> all;
    for (const physics::BinnedPixel& pixel : frames.pixels) {
        std::array<double, 2> sum{};
        for (const int detector : pixel.detectors) {
            const auto [x, y] = physics::middle_of(frames.detectors, pose, detector / frames.detectors.columns,
                                                   detector % frames.detectors.columns);
            sum[0] += x / static_cast<double>(pixel.detectors.size());
            sum[1] += y / static_cast<double>(pixel.detectors.size());
        }
        all.push_back(sum);
    }
    return all;
}

}  // namespace tiretherm::diagnosis
