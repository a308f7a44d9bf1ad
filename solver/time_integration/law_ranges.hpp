// SPDX-License-Identifier: BSD-3-Clause
// Where the temperatures of a run left the ranges of its materials' laws, in sentences.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "physics/effect_classes.hpp"

namespace tiretherm::solver {

/// Temperatures between which a layer stayed. K
struct LayerExtremes {
    double coldest;
    double hottest;
};

/// Where a run left the range of a law.
struct RangeWarning {
    std::string law{};           ///< the law and its range: the same words in all runs of a case
    std::string what{"it was"};  ///< what left it
    double coldest = 0.0;        ///< K, reached
    double hottest = 0.0;        ///< K

    /// "...; it was between 20.0 and 131.5 degC"
    [[nodiscard]] std::string text() const;
    friend bool operator==(const RangeWarning&, const RangeWarning&) = default;
};

/// A warning for every material whose k(T) or c(T) is held outside a range that its layers left, and one for rubber
/// above 150 degC, where it reverts. @param extremes [n_layers]
[[nodiscard]] std::vector<RangeWarning> law_range_warnings(const mesh::Mesh& mesh,
                                                           const physics::MaterialModel& material_model,
                                                           std::span<const LayerExtremes> extremes);

}  // namespace tiretherm::solver
