// SPDX-License-Identifier: BSD-3-Clause
// Axisymmetric biquadratic finite elements for the laser's specimen.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "laser/laser_truth.hpp"
#include "numerics/band_truth.hpp"

namespace hidden_effects {

/// The laser's specimen in biquadratic finite elements: capacity M, heat f(T) that the nodes take up, and its
/// derivative. Nodes are numbered down the depth first.
class LaserElements {
public:
    LaserElements(const LaserSpecimen& specimen, int refinement);

    [[nodiscard]] std::size_t n_nodes() const { return r_.size() * z_.size(); }
    [[nodiscard]] std::size_t reach() const { return 2 * z_.size() + 2; }
    [[nodiscard]] BandMatrix capacity() const;
    /// f(T), W per radian, and unless it is null df/dT.
    void heat(std::span<const double> temperature, std::span<double> f, BandMatrix* slope) const;
    /// Weights of the nodes of a face in its mean over a ring.
    [[nodiscard]] std::vector<double> mean_over(bool outer_face, double from, double to) const;
    [[nodiscard]] std::size_t node_on_axis(bool outer_face) const { return outer_face ? 0 : z_.size() - 1; }

private:
    static constexpr std::size_t n_points = 9;
    /// One point of quadrature in an element.
    struct Point {
        double weight = 0.0;  ///< r dr dz
        std::array<double, 9> shape{};
        std::array<double, 9> by_r{};
        std::array<double, 9> by_z{};
    };
    struct Element {
        std::array<std::size_t, 9> node{};
        std::array<Point, n_points> point;
        bool outer = false;  ///< of the outer layer
    };
    struct FacePoint {
        std::array<std::size_t, 3> node{};
        std::array<double, 3> shape{};
        double weight = 0.0;  ///< r dr
        double h = 0.0;
        double emissivity = 0.0;
        double natural = 0.0;
        double light = 0.0;  ///< W/m2
    };

    [[nodiscard]] std::size_t node(std::size_t i, std::size_t j) const { return i * z_.size() + j; }
    void add_element(std::size_t i, std::size_t j);
    void add_face(std::size_t i, bool outer_face);

    LaserSpecimen specimen_;
    std::vector<double> r_;  ///< m, of the nodes, three to an element
    std::vector<double> z_;
    std::vector<Element> elements_;
    std::vector<FacePoint> faces_;
    std::array<std::array<double, 3>, 2> law_{};  ///< k about 90 degC: value, slope, curvature / 2
};

}  // namespace hidden_effects
