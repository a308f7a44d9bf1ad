#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { lambda_srf, lambda_blk, tan_delta_a, tan_delta_b, tan_delta_c, f0, C1, C2 };

constexpr std::array parameters{
    Parameter{"lambda_srf", "1", 1.0, 0.0, 10.0, "scale of the loss in the surface layer, lambda_SELsrf"},
    Parameter{"lambda_blk", "1", 1.0, 0.0, 10.0, "scale of the loss in all layers below, lambda_SELblk"},
    Parameter{"tan_delta_a", "1", 2.14e15, 0.0, 1e30, "a of the Gaussian loss tangent (49)"},
    Parameter{"tan_delta_b", "K", -4989.0, -1e5, 1e5, "b of the Gaussian loss tangent (49), in kelvin"},
    Parameter{"tan_delta_c", "K", 882.0, 1e-3, 1e5, "c of the Gaussian loss tangent (49), in kelvin"},
    Parameter{"f0", "Hz", 52.0, 1e-3, 1e6, "frequency at which the compound was characterised"},
    Parameter{"C1", "1", -8.86, -100.0, -0.1, "WLF constant C1 of (48)"},
    Parameter{"C2", "K", 101.6, 0.1, 1000.0, "WLF constant C2 of (48), a difference of temperature"},
};
constexpr std::array<std::string_view, 2> reads{"speed", "vertical_load"};

LossTangent loss_tangent(const ActiveEffect& active) {
    return {.a = active[tan_delta_a],
            .b = active[tan_delta_b],
            .c = active[tan_delta_c],
            .f0 = active[f0],
            .C1 = active[C1],
            .C2 = active[C2]};
}

/// Shares by mass, in every cell; they sum to 1 before the scales.
void place(const Setting& setting, ActiveEffect& active) {
    active.nodes.clear();
    active.weights.clear();
    double total = 0.0;
    for (int cell = 0; cell < setting.mesh.n_cells; ++cell) {
        const auto c = static_cast<std::size_t>(cell);
        const auto layer = static_cast<std::size_t>(setting.mesh.layer[c]);
        active.nodes.push_back(cell);
        active.weights.push_back(setting.mesh.volume[c] * setting.materials[layer].density);
        total += active.weights.back();
    }
    for (double& weight : active.weights) {
        weight /= total;
    }
}

void drive(const ActiveEffect& active, const Tire& tire, const Inputs& inputs, std::span<double> out) {
    const double power = strain_power(tire, inputs.speed, inputs.vertical_load);
    out[0] = power;
    out[1] =
        power > 0.0 ? power * loss_tangent(active).shift(tire.revolutions(inputs.speed, inputs.vertical_load)) : 0.0;
}

void speak(const Moment& m, Terms& terms) {
    const double power = m.intensities[0];
    if (power <= 0.0) {
        return;
    }
    const int bulk = m.mesh.find_region("bulk");
    const LossTangent law = loss_tangent(m.active);
    const double T_eq = m.region_mean[static_cast<std::size_t>(bulk)] + m.intensities[1] / power;
    const double loss = power * law.value(T_eq);
    const double slope = loss * law.log_slope(T_eq);
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        const int node = m.active.nodes[i];
        const bool at_surface = m.mesh.layer[static_cast<std::size_t>(node)] == 0 && m.mesh.layers.size() > 1;
        const double share = m.active.weights[i] * m.active[at_surface ? lambda_srf : lambda_blk];
        terms.heat(node, share * loss);
        terms.heat_follows(node, bulk, share * slope);
    }
}

}  // namespace

extern const Effect strain_energy_loss;
const Effect strain_energy_loss{
    .id = "strain_energy_loss",
    .kind = Kind::source,
    .on = true,
    .equation = "SEL = Fz eps (A_CS/A_VC) H tan delta(T_bulk, f) (2 pi R0/l) V/(2 pi R_R)",
    .source = "thesis (36)-(49), errata E1, E2, E3, E7, E8",
    .meaning =
        "Heat of cyclic deformation, shared over the cells by mass; tan delta is taken at the bulk's mean "
        "temperature; none at rest or without load.",
    .parameters = parameters,
    .choices = {},
    .reads = reads,
    .needs_tire = true,
    .patches = {},
    .n_intensities = 2,
    .place = place,
    .drive = drive,
    .speak = speak,
    .gives_derivatives = true,
};

}  // namespace tiretherm::physics::effects
