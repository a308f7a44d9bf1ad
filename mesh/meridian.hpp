// SPDX-License-Identifier: BSD-3-Clause
// Outer profile of a tire's cross-section as circular arcs without kinks, mirrored about the centre plane; the
// coordinate is the arc length s.
#pragma once

#include <vector>

namespace tiretherm::mesh {

/// The outer profile of a tire's cross-section from the crown's centre to a bead, as circular arcs that join without a
/// kink; the other side is its mirror image. The arc length s is 0 at the centre plane, negative outboard, positive
/// inboard.
class Meridian {
public:
    struct Arc {
        double length = 0.0;     ///< m, > 0
        double curvature = 0.0;  ///< 1/m, how fast the profile turns towards the bead; 0: straight
    };

    /// @param radius m, of the crown's centre about the tire's axis  @param arcs from the centre outwards; beyond the
    ///        last one the profile goes straight on
    Meridian(double radius, std::vector<Arc> arcs);

    struct ProfilePoint {
        double lateral = 0.0;  ///< m from the centre plane, negative outboard
        double radius = 0.0;   ///< m from the tire's axis
        double turn = 0.0;     ///< rad between the profile and the axis, 0 at the crown's centre, negative outboard
    };
    [[nodiscard]] ProfilePoint at(double s) const;
    /// The place `depth` m inside of the profile along its normal.
    [[nodiscard]] ProfilePoint inside(double s, double depth) const;
    /// Mean radius over a stretch; times 2 pi and its length, the area of the ring that it sweeps.
    [[nodiscard]] double mean_radius(double from, double to) const;

private:
    double radius_;
    std::vector<Arc> arcs_;
};

}  // namespace tiretherm::mesh
