#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { factor, length, exponent };

constexpr std::array parameters{
    Parameter{"factor", "1", 1.32, 0.0, 100.0,
              "h in W/(m2 K) at 1 K and 1 m; 1.32 for a horizontal cylinder or plate facing up", false, 0.0},
    Parameter{"length", "m", 0.66, 1e-4, 10.0, "diameter of the tire or size of the heated spot"},
    Parameter{"exponent", "1", 0.25, 0.0, 1.0, "exponent of (T_surf - T_air) / length; 1/4 in laminar flow"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 2> patches{"outside", "top"};

void drive(const ActiveEffect& /*active*/, const Driving& driving, std::span<double> out) {
    // Buoyancy counts only at rest: a rolling tire's own wind sweeps the plume away.
    out[0] = std::abs(driving.inputs.speed) <= standing_speed ? 1.0 : 0.0;
    out[1] = driving.inputs.air_temperature;
}

void speak(const Moment& m, Terms& terms) {
    const double T_air = m.intensities[1];
    for (std::size_t p = 0; p < m.active.patches.size(); ++p) {
        const double n = m.active.on_patch(exponent, p);
        const double scale = m.intensities[0] * m.active.on_patch(factor, p);
        for (const mesh::PatchFace& face : m.mesh.patches[static_cast<std::size_t>(m.active.patches[p])].faces) {
            const double above = m.temperature[static_cast<std::size_t>(face.node)] - T_air;
            const double G = scale * face.area * std::pow(std::abs(above) / m.active.on_patch(length, p), n);
            terms.exchange(face.node, G, T_air, above != 0.0 ? n * G / above : 0.0);
        }
    }
}

}  // namespace

extern const Effect natural_convection;
const Effect natural_convection{
    .id = "natural_convection",
    .kind = Kind::loss,
    .equation = "q = 1.32 (|T_surf - T_air|/D)^0.25 A (T_air - T_surf), at rest only",
    .source =
        "simplified laminar relations for air at atmospheric pressure: McAdams, Heat Transmission, 3rd ed. 1954, ch. 7",
    .meaning = "Buoyant air on a tire or specimen at rest; grows weakly with the temperature difference.",
    .parameters = parameters,
    .reads = reads,
    .patches = patches,
    .n_intensities = 2,
    .drive = drive,
    .speak = speak,
};

}  // namespace tiretherm::physics::effects
