// SPDX-License-Identifier: BSD-3-Clause
// Laser spot: q = absorptivity P/(pi radius^2) on a disc, or 2 absorptivity P/(pi w^2) exp(-2 r^2/w^2) (thesis
// III.1.1); absorbed at the surface or over a depth by Beer's law.

#include <array>
#include <cmath>
#include <numbers>

#include "mesh/probe.hpp"
#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { radius, absorptivity, depth };
enum : std::size_t { profile };

constexpr std::array parameters{
    ParameterSpec{"radius", "m", 5.6419e-3, 1e-6, 1.0, "radius of the disc, or 1/e2 radius of the Gaussian; 1 cm2"},
    ParameterSpec{"absorptivity", "1", 1.0, 0.0, 1.0, "share of the light that is absorbed"},
    ParameterSpec{"depth", "m", 0.0, 0.0, 1.0, "1/e depth of absorption; 0: at the surface"},
};
constexpr std::array plausible{
    PlausibleRange{"radius", 2e-4, 0.02, "laser spots of bench tests 0.4 to 40 mm across; the thesis 1 cm2; recalled",
                   "the spot can be seen: measure it"},
    PlausibleRange{"absorptivity", 0.85, 1.0, "black rubber 0.90 to 0.97 in the near infrared, recalled",
                   "black rubber reflects less than that: the power or the conductivity is off"},
    PlausibleRange{
        "depth", 0.0, 3e-4, "carbon black stops light within 0.1 mm, recalled",
        "light does not get that deep into filled rubber: the surface conducts otherwise, or the camera is not sharp"},
};
constexpr std::array<std::string_view, 2> profiles{"disc", "gaussian"};
constexpr std::array choices{Choice{"profile", profiles, "uniform over a disc, or Gaussian"}};
constexpr std::array<std::string_view, 1> reads{"laser_power"};
constexpr std::array<std::string_view, 1> patches{"top"};

void place(const PlacementContext& context, ActiveEffect& active) {
    active.nodes.clear();
    active.weights.clear();
    const mesh::Mesh& mesh = context.mesh;
    const double spot = active[radius] * context.material_model.laser_spot_scale;
    if (mesh.grid && mesh.grid->size(0) == 1 && mesh.grid->size(1) == 1) {  // layers: the light is spread evenly
        spread_over_patches(context, active);
        return;
    }
    for (const int patch : active.patches) {
        const bool disc = active.choices[profile] == 0;
        std::vector<double> share =
            disc ? mesh::disc_overlap(mesh, patch, spot) : mesh::gaussian_overlap(mesh, patch, spot);
        if (disc) {
            for (double& s : share) {
                s /= std::numbers::pi * spot * spot;
            }
        }
        const std::vector<mesh::PatchFace>& faces = mesh.patches[static_cast<std::size_t>(patch)].faces;
        for (std::size_t f = 0; f < faces.size(); ++f) {
            if (share[f] == 0.0) {
                continue;
            }
            if (active[depth] == 0.0 || !mesh.grid) {
                active.nodes.push_back(faces[f].node);
                active.weights.push_back(share[f]);
                continue;
            }
            // Beer's law down the column of cells; what reaches the inner face stays in the last cell.
            const mesh::Grid& grid = *mesh.grid;
            const int below = grid.size(0) * grid.size(1);
            for (int k = 0; k < grid.size(2); ++k) {
                const auto at = static_cast<std::size_t>(k);
                const double in = std::exp(-grid.edge[2][at] / active[depth]);
                const double out = k + 1 == grid.size(2) ? 0.0 : std::exp(-grid.edge[2][at + 1] / active[depth]);
                active.nodes.push_back(faces[f].cell + k * below);
                active.weights.push_back(share[f] * (in - out));
            }
        }
    }
}

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    out[0] = active[absorptivity] * point.inputs.laser_power;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        terms.heat(m.active.nodes[i], m.coefficients[0] * m.active.weights[i]);
    }
}

}  // namespace

extern const Effect laser;
const Effect laser{
    .id = "laser",
    .kind = EffectKind::source,
    .equation = "q = absorptivity P / (pi radius^2) on a disc, or 2 absorptivity P/(pi w^2) exp(-2 r^2/w^2)",
    .source = "thesis III.1.1 (spot of 1 cm2, 0 to 3 W)",
    .valid = "rubber that does not char: below some 200 degC",
    .meaning =
        "Light of a laser absorbed about x = y = 0 of the outer surface. The part of the spot outside the mesh "
        "is lost: a quarter of a specimen takes a quarter of the power.",
    .parameters = parameters,
    .plausible = plausible,
    .choices = choices,
    .reads = reads,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 1,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
