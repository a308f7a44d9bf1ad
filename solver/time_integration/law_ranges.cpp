// SPDX-License-Identifier: BSD-3-Clause
// Compares the extremes of each layer with the ranges of its laws; layers of one material share a sentence.

#include "solver/time_integration/law_ranges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "physics/celsius.hpp"

namespace tiretherm::solver {

namespace {

/// Sulphur-cured rubber loses its cross-links: reversion, at 140 to 160 degC within hours (recalled).
constexpr double reversion = zero_celsius + 150.0;
constexpr double allowance = 1e-6;  // K

std::string degrees(double kelvin) {
    const double celsius = kelvin - zero_celsius;
    return std::abs(celsius) < 1e5 ? fmt::format("{:.1f}", celsius) : fmt::format("{:.3g}", celsius);
}

}  // namespace

std::string RangeWarning::text() const {
    return fmt::format("{}; {} between {} and {} degC", law, what, degrees(coldest), degrees(hottest));
}

std::vector<RangeWarning> law_range_warnings(const mesh::Mesh& mesh, const physics::MaterialModel& material_model,
                                             std::span<const LayerExtremes> extremes) {
    std::vector<RangeWarning> warnings;
    const auto add = [&](RangeWarning warning) {
        if (std::ranges::count(warnings, warning) == 0) {
            warnings.push_back(std::move(warning));
        }
    };
    for (std::size_t layer = 0; layer < extremes.size(); ++layer) {
        const physics::Material& material = material_model.materials[layer];
        LayerExtremes all = extremes[layer];
        for (std::size_t other = 0; other < extremes.size(); ++other) {
            if (material_model.materials[other] == material) {
                all.coldest = std::min(all.coldest, extremes[other].coldest);
                all.hottest = std::max(all.hottest, extremes[other].hottest);
            }
        }
        struct Law {
            std::string_view what;
            const physics::Curve& curve;
            bool is_known = false;  ///< as another one
        };
        const physics::Curve& through = material.along(mesh::Axis::through);
        const physics::Curve& meridian = material.along(mesh::Axis::meridian);
        const physics::Curve& around = material.along(mesh::Axis::circumference);
        for (const Law& law :
             {Law{"conductivity", through}, Law{"conductivity along the meridian", meridian, meridian == through},
              Law{"conductivity along the circumference", around, around == through},
              Law{"heat capacity", material.heat_capacity}}) {
            const auto range = law.curve.range();
            if (range && !law.is_known &&
                (all.coldest < (*range)[0] - allowance || all.hottest > (*range)[1] + allowance)) {
                add({.law =
                         fmt::format("the {} of \"{}\" is known from {:.4g} to {:.4g} degC and held beyond", law.what,
                                     material.name, (*range)[0] - zero_celsius, (*range)[1] - zero_celsius),
                     .coldest = all.coldest,
                     .hottest = all.hottest});
            }
        }
    }
    std::vector<std::string> reverting;
    LayerExtremes all{.coldest = std::numeric_limits<double>::infinity(), .hottest = 0.0};
    for (std::size_t layer = 0; layer < extremes.size(); ++layer) {
        if (extremes[layer].hottest > reversion) {
            reverting.push_back(mesh.layers[layer]);
            all.coldest = std::min(all.coldest, extremes[layer].coldest);
            all.hottest = std::max(all.hottest, extremes[layer].hottest);
        }
    }
    if (!reverting.empty()) {
        add({.law = "above 150 degC vulcanised rubber reverts (its cross-links break), and no law here knows that",
             .what = fmt::format("{} {}", fmt::join(reverting, ", "), reverting.size() == 1 ? "was" : "were"),
             .coldest = all.coldest,
             .hottest = all.hottest});
    }
    return warnings;
}

}  // namespace tiretherm::solver
