// SPDX-License-Identifier: BSD-3-Clause
// Thermal camera over a flat specimen: pose, detector array, and for each pixel the weighted mean of surface nodes that
// it measures.
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/effect.hpp"

namespace tiretherm::physics {

/// Where the image lies on the surface, in the mesh's own coordinates.
struct CameraPose {
    double x = 0.0;         ///< m, of the image's centre
    double y = 0.0;         ///< m
    double rotation = 0.0;  ///< rad, of the image about its centre, from x towards y
    double blur = 0.0;      ///< m, full width at half maximum of the Gaussian that smears a point; 0: sharp
};

/// Numbers of a camera's pose as a problem holds them, in the order of CameraPose: so a fit may move them. It does nothing
/// to a run.
[[nodiscard]] const Effect& camera_pose();
[[nodiscard]] CameraPose pose_of(const ActiveEffect& active);

/// The array of detectors, projected onto the surface: columns run along x, rows along y.
struct Detectors {
    int rows = 0;
    int columns = 0;
    double pitch_x = 0.0;  ///< m, from column to column
    double pitch_y = 0.0;  ///< m, from row to row
};
/// Middle of a pixel on the surface. @returns x, y in m
[[nodiscard]] std::array<double, 2> middle_of(const Detectors& detectors, const CameraPose& pose, int row, int column);

/// The outer or inner face of a block or a disc, between whose nodes the temperature is interpolated as at a point:
/// straight, an even parabola about the axis and about planes of symmetry, straight on beyond the outermost nodes.
class SeenSurface {
public:
    /// @pre can_be_seen
    SeenSurface(const mesh::Mesh& mesh, int patch);

    [[nodiscard]] const std::vector<int>& nodes() const { return nodes_; }
    /// Whether a place lies on the specimen. @param x, y m
    [[nodiscard]] bool contains(double x, double y) const;
    /// Adds the temperature at a place. @param weights [n_nodes] of the nodes, in their order
    void add(double x, double y, double weight, std::vector<double>& weights) const;

private:
    struct Line {
        std::vector<double> centre;
        double low = 0.0;
        double high = 0.0;
        bool mirror = false;
    };
    struct Pair {
        std::array<std::size_t, 2> index{};
        std::array<double, 2> weight{};
    };
    [[nodiscard]] static Pair between(const Line& line, double s);

    bool round_ = false;
    Line x_;  ///< or the radius
    Line y_;
    std::vector<int> nodes_;  ///< x runs fastest
};
/// Whether a patch is the outer or inner face of a block or a disc.
[[nodiscard]] bool can_be_seen(const mesh::Mesh& mesh, int patch);

/// Mean over the square of a pixel, smeared by the blur, of the temperature interpolated between the nodes: exact for
/// polynomials of x and y up to the fifth degree but for the mesh's own error, three points of Gauss and Legendre across
/// the pixel and three of Gauss and Hermite across the blur, each way.
/// @returns a functional whose nodes count those of the surface
[[nodiscard]] mesh::Functional over_pixel(const SeenSurface& surface, const Detectors& detectors,
                                          const CameraPose& pose, int row, int column);
/// Whether all of the pixel's footprint lies on the specimen.
[[nodiscard]] bool sees_specimen(const SeenSurface& surface, const Detectors& detectors, const CameraPose& pose,
                                 int row, int column);

/// A pixel of a binned image: the mean of some detectors.
struct BinnedPixel {
    int row = 0;  ///< of the binned image
    int column = 0;
    std::vector<int> detectors;  ///< row * columns + column of each
};
/// What each pixel averages. @returns [n_pixels] functionals whose nodes count those of the surface
[[nodiscard]] std::vector<mesh::Functional> over_pixels(const SeenSurface& surface, const Detectors& detectors,
                                                        const CameraPose& pose, const std::vector<BinnedPixel>& pixels);

}  // namespace tiretherm::physics
