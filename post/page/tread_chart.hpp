// SPDX-License-Identifier: BSD-3-Clause
// The surface of a ring's tread at several moments, unrolled, for the page's chart with a slider.
#pragma once

#include <span>
#include <string>

#include "post/page/moments.hpp"
#include "solver/problem.hpp"

namespace tiretherm::post {

/// Keeps the temperatures of the faces of the outer surface: angle in the frame of the rubber across, meridian down.
class TreadFrames {
public:
    /// @pre problem.mesh.is_ring()   @param problem lives longer
    explicit TreadFrames(const solver::Problem& problem) : problem_(&problem) {}

    /// A field that is stored. @param time s  @param temperature [n_nodes] K
    void take(double time, std::span<const double> temperature) { moments_.take(moment_of(time, temperature)); }
    /// The last moment first; with the place of the contact at each moment, if one goes round.
    [[nodiscard]] Value chart() const;
    [[nodiscard]] std::string caption() const;

private:
    [[nodiscard]] Moment moment_of(double time, std::span<const double> temperature) const;

    const solver::Problem* problem_;
    Moments moments_;
};

}  // namespace tiretherm::post
