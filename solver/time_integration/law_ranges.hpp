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

/// A sentence for every material whose k(T) or c(T) is held outside a range that its layers left, and one for rubber
/// above 150 degC, where it reverts. @param extremes [n_layers]
[[nodiscard]] std::vector<std::string> law_range_warnings(const mesh::Mesh& mesh,
                                                          const physics::MaterialModel& material_model,
                                                          std::span<const LayerExtremes> extremes);

}  // namespace tiretherm::solver
