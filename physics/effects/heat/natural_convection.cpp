// SPDX-License-Identifier: BSD-3-Clause
// Buoyant air, at rest only: q = scale h A (T_air - T_surf), h = 1.32 (|T_surf - T_air|/D)^0.25 (McAdams 1954) or the
// correlation for a horizontal cylinder (Churchill & Chu 1975).

#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { factor, length, exponent, scale };
enum : std::size_t { law };

constexpr std::array parameters{
    ParameterSpec{"factor", "1", 1.32, 0.0, 100.0,
                  "h in W/(m2 K) at 1 K and 1 m; 1.32 for a horizontal cylinder or plate facing up"},
    ParameterSpec{"length", "m", 0.66, 1e-4, 10.0, "diameter of the tire or size of the heated spot"},
    ParameterSpec{"exponent", "1", 0.25, 0.0, 1.0, "exponent of (T_surf - T_air) / length; 1/4 in laminar flow"},
    ParameterSpec{"scale", "1", 1.0, 0.0, 10.0, "factor on either law", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"scale", 0.0, 2.0, "correlations for plates and cylinders differ by 20 to 50 %; recalled",
                   "a draught, or another loss of heat"},
};
constexpr std::array<std::string_view, 2> laws{"power", "churchill_chu"};
constexpr std::array choices{
    Choice{"law", laws, "factor (dT/length)^exponent, or Churchill and Chu's correlation for a horizontal cylinder"}};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"outside", "top"};

void evaluate_coefficients(const ActiveEffect& /*active*/, const OperatingPoint& point, std::span<double> out) {
    // Buoyancy counts only at rest: a rolling tire's own wind sweeps the plume away.
    out[0] = std::abs(point.inputs.speed) <= standing_speed ? 1.0 : 0.0;
    out[1] = point.inputs.air_temperature;
}

/// A coefficient and its derivative with the temperature difference, which is not 0.
struct FilmCoefficient {
    double h;      ///< W/(m2 K)
    double dh_dT;  ///< W/(m2 K2)
};

FilmCoefficient power_law(double above, double factor, double length, double exponent) {
    const double h = factor * std::pow(std::abs(above) / length, exponent);
    return {h, exponent * h / above};
}

/// Nu = (0.60 + 0.387 Ra^(1/6) / (1 + (0.559/Pr)^(9/16))^(8/27))^2, Ra = g dT D^3/(T_air nu alpha); air at 300 K.
FilmCoefficient churchill_chu(double above, double T_air, double diameter) {
    constexpr double k = 0.0263;         // W/(m K)
    constexpr double nu = 1.589e-5;      // m2/s
    constexpr double alpha = 2.25e-5;    // m2/s
    constexpr double gravity = 9.80665;  // m/s2
    const double rayleigh = gravity * std::abs(above) * std::pow(diameter, 3) / (T_air * nu * alpha);
    const double spread = std::pow(1.0 + std::pow(0.559 * alpha / nu, 9.0 / 16.0), 8.0 / 27.0);
    const double term = 0.387 * std::pow(rayleigh, 1.0 / 6.0) / spread;
    const double root = 0.60 + term;
    return {k / diameter * root * root, k / diameter * 2.0 * root * term / (6.0 * above)};
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const double T_air = m.coefficients[1];
    for (std::size_t p = 0; p < m.active.patches.size(); ++p) {
        const double size = m.active.on_patch(length, p);
        for (const mesh::PatchFace& face : m.mesh.patches[static_cast<std::size_t>(m.active.patches[p])].faces) {
            const double above = m.temperature[static_cast<std::size_t>(face.node)] - T_air;
            if (above == 0.0) {
                continue;
            }
            const FilmCoefficient film = m.active.choices[law] == 0 ? power_law(above, m.active.on_patch(factor, p),
                                                                                size, m.active.on_patch(exponent, p))
                                                                    : churchill_chu(above, T_air, size);
            const double per_h = m.coefficients[0] * m.active.on_patch(scale, p) * face.area;
            terms.exchange(face.node, per_h * film.h, T_air, per_h * film.dh_dT);
        }
    }
}

}  // namespace

extern const Effect natural_convection;
const Effect natural_convection{
    .id = "natural_convection",
    .kind = EffectKind::loss,
    .equation =
        "q = scale h A (T_air - T_surf), h = 1.32 (|T_surf - T_air|/D)^0.25 or of Churchill and Chu, at rest only",
    .source =
        "simplified laminar relations for air at atmospheric pressure: McAdams, Heat Transmission, 3rd ed. 1954, "
        "ch. 7; Churchill & Chu, Int. J. Heat Mass Transfer 18, 1975, 1049",
    .valid = "surfaces 5 to 100 K above the air, laminar (Gr Pr of 1e4 to 1e9); at rest",
    .meaning = "Buoyant air on a tire or specimen at rest; grows weakly with the temperature difference.",
    .parameters = parameters,
    .plausible = plausible,
    .choices = choices,
    .reads = reads,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 2,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
