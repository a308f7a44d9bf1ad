// SPDX-License-Identifier: BSD-3-Clause
// Pixel footprints by quadrature: three Gauss-Legendre points across a pixel and three Gauss-Hermite points across the
// Gaussian blur, in each direction.

#include "physics/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiretherm::physics {

namespace {

constexpr std::array pose_parameters{
    ParameterSpec{"x", "m", 0.0, -0.1, 0.1, "where the image's centre lies on the specimen, along the columns"},
    ParameterSpec{"y", "m", 0.0, -0.1, 0.1, "where the image's centre lies on the specimen, along the rows"},
    ParameterSpec{"rotation", "rad", 0.0, -3.2, 3.2, "of the image about its centre"},
    ParameterSpec{"blur", "m", 0.0, 0.0, 0.1, "full width at half maximum of the optics' blur on the specimen"},
};
const Effect pose_effect{
    .id = "camera_pose",
    .kind = EffectKind::sensor,
    .equation = "pixel = mean of T over its square, smeared by a Gaussian",
    .source = "definition",
    .meaning = "Where a camera's image lies on a specimen, and how sharp it is.",
    .parameters = pose_parameters,
    .model = SensorModel{},  // it moves the places that the pixels read, before a run
};

/// Places and weights of a rule across one direction.
struct QuadratureRule {
    std::vector<double> at;
    std::vector<double> weight;
};

/// Across a pixel: a flat window of the pitch, smeared by a Gaussian.
QuadratureRule across(double pitch, double blur) {
    const double legendre = 0.5 * std::sqrt(0.6) * pitch;
    const QuadratureRule window{.at = {-legendre, 0.0, legendre}, .weight = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0}};
    if (blur <= 0.0) {
        return window;
    }
    const double sigma = blur / (2.0 * std::sqrt(2.0 * std::numbers::ln2));
    const double hermite = std::sqrt(3.0) * sigma;
    QuadratureRule rule;
    for (std::size_t i = 0; i < window.at.size(); ++i) {
        for (const auto& [shift, share] : {std::pair{-hermite, 1.0 / 6.0}, {0.0, 4.0 / 6.0}, {hermite, 1.0 / 6.0}}) {
            rule.at.push_back(window.at[i] + shift);
            rule.weight.push_back(window.weight[i] * share);
        }
    }
    return rule;
}

/// The rules of a camera, which all its pixels share.
struct Footprint {
    Footprint(const Detectors& detectors, const CameraPose& pose)
        : x(across(detectors.pitch_x, pose.blur)),
          y(across(detectors.pitch_y, pose.blur)),
          cosine(std::cos(pose.rotation)),
          sine(std::sin(pose.rotation)) {}

    template <typename Visit>
    void visit(const std::array<double, 2>& middle, const Visit& place) const {
        for (std::size_t i = 0; i < x.at.size(); ++i) {
            for (std::size_t j = 0; j < y.at.size(); ++j) {
                place(middle[0] + x.at[i] * cosine - y.at[j] * sine, middle[1] + x.at[i] * sine + y.at[j] * cosine,
                      x.weight[i] * y.weight[j]);
            }
        }
    }

    QuadratureRule x;
    QuadratureRule y;
    double cosine;
    double sine;
};

mesh::Functional gathered(std::vector<double>& weights) {
    mesh::Functional result;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] != 0.0) {
            result.nodes.push_back(static_cast<int>(i));
            result.weights.push_back(weights[i]);
            weights[i] = 0.0;
        }
    }
    return result;
}

}  // namespace

const Effect& camera_pose() { return pose_effect; }

CameraPose pose_of(const ActiveEffect& active) {
    return {.x = active[0], .y = active[1], .rotation = active[2], .blur = active[3]};
}

std::array<double, 2> middle_of(const Detectors& detectors, const CameraPose& pose, int row, int column) {
    const double u = (column - 0.5 * (detectors.columns - 1)) * detectors.pitch_x;
    const double v = (row - 0.5 * (detectors.rows - 1)) * detectors.pitch_y;
    const double c = std::cos(pose.rotation);
    const double s = std::sin(pose.rotation);
    return {pose.x + u * c - v * s, pose.y + u * s + v * c};
}

bool can_be_seen(const mesh::Mesh& mesh, int patch) {
    if (!mesh.grid || patch < 0 || mesh.stack) {
        return false;
    }
    const std::string& name = mesh.patches[static_cast<std::size_t>(patch)].name;
    return name == "top" || name == "bottom";
}

SeenSurface::SeenSurface(const mesh::Mesh& mesh, int patch) {
    const mesh::Grid& grid = *mesh.grid;
    const auto line = [&](std::size_t axis) {
        return Line{.centre = grid.centre[axis],
                    .low = grid.edge[axis].front(),
                    .high = grid.edge[axis].back(),
                    .mirror = grid.mirror[axis]};
    };
    round_ = grid.metric == mesh::Metric::axisymmetric;
    x_ = line(0);
    y_ = line(1);
    const bool outer = mesh.patches[static_cast<std::size_t>(patch)].name == "top";
    const mesh::Side side = outer ? mesh::Side::z_min : mesh::Side::z_max;
    for (int j = 0; j < grid.size(1); ++j) {
        for (int i = 0; i < grid.size(0); ++i) {
            nodes_.push_back(grid.surface_node(side, i, j, 0));
        }
    }
}

bool SeenSurface::contains(double x, double y) const {
    const auto within = [](const Line& line, double s) {
        const double slack = 1e-9 * (line.high - line.low);
        const double place = line.mirror ? line.low + std::abs(s - line.low) : s;
        return place >= line.low - slack && place <= line.high + slack;
    };
    return round_ ? within(x_, std::hypot(x, y)) : within(x_, x) && within(y_, y);
}

SeenSurface::Pair SeenSurface::between(const Line& line, double s) {
    const std::vector<double>& c = line.centre;
    if (c.size() == 1) {
        return {.index = {0, 0}, .weight = {1.0, 0.0}};
    }
    s = line.mirror ? line.low + std::abs(s - line.low) : s;
    if (line.mirror && s < c[0]) {
        const double s0 = c[0] - line.low;
        const double s1 = c[1] - line.low;
        const double w = ((s - line.low) * (s - line.low) - s0 * s0) / (s1 * s1 - s0 * s0);
        return {.index = {0, 1}, .weight = {1.0 - w, w}};
    }
    const auto above = std::ranges::upper_bound(c, s) - c.begin();
    const auto right = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, std::ssize(c) - 1));
    const double w = (s - c[right - 1]) / (c[right] - c[right - 1]);
    return {.index = {right - 1, right}, .weight = {1.0 - w, w}};
}

void SeenSurface::add(double x, double y, double weight, std::vector<double>& weights) const {
    const Pair along = between(x_, round_ ? std::hypot(x, y) : x);
    const Pair other = round_ ? Pair{.index = {0, 0}, .weight = {1.0, 0.0}} : between(y_, y);
    for (std::size_t b = 0; b < 2; ++b) {
        for (std::size_t a = 0; a < 2; ++a) {
            weights[along.index[a] + x_.centre.size() * other.index[b]] += weight * along.weight[a] * other.weight[b];
        }
    }
}

mesh::Functional over_pixel(const SeenSurface& surface, const Detectors& detectors, const CameraPose& pose, int row,
                            int column) {
    return over_pixels(surface, detectors, pose,
                       {{.row = row, .column = column, .detectors = {row * detectors.columns + column}}})
        .front();
}

bool sees_specimen(const SeenSurface& surface, const Detectors& detectors, const CameraPose& pose, int row,
                   int column) {
    const Footprint footprint(detectors, pose);
    const std::array<double, 2> middle = middle_of(detectors, pose, row, column);
    bool inside = true;
    footprint.visit(middle, [&](double x, double y, double) { inside = inside && surface.contains(x, y); });
    for (const double i : {-0.5, 0.5}) {
        for (const double j : {-0.5, 0.5}) {
            const double u = i * detectors.pitch_x;
            const double v = j * detectors.pitch_y;
            inside = inside && surface.contains(middle[0] + u * footprint.cosine - v * footprint.sine,
                                                middle[1] + u * footprint.sine + v * footprint.cosine);
        }
    }
    return inside;
}

std::vector<mesh::Functional> over_pixels(const SeenSurface& surface, const Detectors& detectors,
                                          const CameraPose& pose, const std::vector<BinnedPixel>& pixels) {
    const Footprint footprint(detectors, pose);
    std::vector<double> weights(surface.nodes().size(), 0.0);
    std::vector<mesh::Functional> all;
    all.reserve(pixels.size());
    for (const BinnedPixel& pixel : pixels) {
        const double share = 1.0 / static_cast<double>(pixel.detectors.size());
        for (const int detector : pixel.detectors) {
            const auto middle = middle_of(detectors, pose, detector / detectors.columns, detector % detectors.columns);
            footprint.visit(middle,
                            [&](double x, double y, double weight) { surface.add(x, y, share * weight, weights); });
        }
        all.push_back(gathered(weights));
    }
    return all;
}

}  // namespace tiretherm::physics
