// SPDX-License-Identifier: BSD-3-Clause
// Heat of cyclic deformation, distributed by mass and weights: SEL = Fz eps (A_CS/A_VC) H tan delta(T_bulk, f) (2 pi
// R0/l) V/(2 pi R_R) (thesis (36)-(49), errata E1, E2, E3, E7, E8).

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "physics/bracket.hpp"
#include "physics/celsius.hpp"
#include "physics/spread.hpp"
#include "physics/tire_laws/kraus.hpp"
#include "physics/tire_laws/measured_loss.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t {
    lambda_srf,
    lambda_blk,
    tan_delta_a,
    tan_delta_b,
    tan_delta_c,
    f0,
    C1,
    C2,
    strain_energy_share,
    loss_tangent_share,
    belt_edge_gain,
    belt_edge_place,
    belt_edge_width,
    tan_delta_peak,
    kraus_amplitude,
    kraus_strain,
    kraus_exponent,
    kraus_reference
};
enum : std::size_t { temperature, speed_of };
enum : std::size_t { profile, tan_delta };

constexpr std::array parameters{
    ParameterSpec{"lambda_srf", "1", 1.0, 0.0, 10.0, "scale of the loss in the surface layer, lambda_SELsrf"},
    ParameterSpec{"lambda_blk", "1", 1.0, 0.0, 10.0, "scale of the loss in all layers below, lambda_SELblk"},
    ParameterSpec{"tan_delta_a", "1", 2.14e15, 0.0, 1e30, "a of the Gaussian loss tangent (49)"},
    ParameterSpec{"tan_delta_b", "K", -4989.0, -1e5, 1e5, "b of the Gaussian loss tangent (49), in kelvin"},
    ParameterSpec{"tan_delta_c", "K", 882.0, 1e-3, 1e5, "c of the Gaussian loss tangent (49)", true},
    ParameterSpec{"f0", "Hz", 52.0, 1e-3, 1e6, "frequency at which the compound was characterised"},
    ParameterSpec{"C1", "1", -8.86, -100.0, -0.1, "WLF constant C1 of (48)"},
    ParameterSpec{"C2", "K", 101.6, 0.1, 1000.0, "WLF constant C2 of (48)", true},
    ParameterSpec{"strain_energy_share", "1", 1.0, 0.0, 1e3,
                  "strain energy per mass beside that of other layers and zones; the thesis strains all alike"},
    ParameterSpec{"loss_tangent_share", "1", 1.0, 0.0, 1e3,
                  "loss tangent beside that of other layers and zones; the thesis knows one compound"},
    ParameterSpec{"belt_edge_gain", "1", 0.0, 0.0, 100.0,
                  "loss per mass at the belt's edges over that elsewhere, less 1; none in the thesis"},
    ParameterSpec{"belt_edge_place", "1", 0.8, 0.0, 1.0, "where the belt ends, as a share of half the tread's width"},
    ParameterSpec{"belt_edge_width", "m", 0.010, 1e-4, 1.0, "distance over which the excess falls to 1/e"},
    ParameterSpec{"tan_delta_peak", "K", 265.15, 0.0, 1000.0,
                  "equivalent temperature of the loss tangent's peak (thesis V), below which it falls as it rose; 0 K "
                  "lets the Gaussian (49) rise on"},
    ParameterSpec{
        "kraus_amplitude", "1", 0.0, 0.0, 100.0,
        "how far the loss at kraus_strain rises above that of small strains (Kraus); 0: the strain has no say"},
    ParameterSpec{"kraus_strain", "1", 0.02, 1e-6, 10.0, "strain of the largest loss modulus, some per cent"},
    ParameterSpec{"kraus_exponent", "1", 0.6, 0.01, 3.0, "m of Kraus; 0.5 to 0.7 in many compounds (recalled)"},
    ParameterSpec{"kraus_reference", "1", 0.1, 1e-6, 10.0,
                  "strain at which the loss tangent was characterised, deflection over section height"},
};
constexpr std::string_view above =
    "the loss compensates for a missing heat source: try cornering_loss, drum_curvature or load_exponent_of_loss, or "
    "run diagnose";
constexpr std::string_view below =
    "the loss compensates for a missing heat path: try sidewall_convection or inner_gas, or run diagnose";
constexpr std::array plausible{
    PlausibleRange{"lambda_srf", 0.6, 1.5,
                   "thesis VI.1: 0.95 to 1.1 for six tires on drums; widened for other compounds, recalled",
                   "the loss of a tire is known better than that from its rolling resistance: another source or loss "
                   "of heat is missing",
                   SensorKind::any, above, below},
    PlausibleRange{"lambda_blk", 0.6, 1.5,
                   "thesis VI.1: 0.95 to 1.1 for six tires on drums; widened for other compounds, recalled",
                   "the loss of a tire is known better than that from its rolling resistance: another source or loss "
                   "of heat is missing",
                   SensorKind::any, above, below},
    PlausibleRange{"tan_delta_a", 1.2e15, 3.0e15,
                   "rolling resistance of car tires 0.65 to 1.2 % (classes of UN R117, recalled), where the thesis's "
                   "2.14e15 makes 1.08 %",
                   "with the thesis's b and c it makes a rolling resistance that no car tire has: another source or "
                   "loss of heat is missing",
                   SensorKind::any, above, below},
};
constexpr std::array<std::string_view, 2> temperatures{"bulk_mean", "local"};
constexpr std::array<std::string_view, 2> speeds{"wheel", "vehicle"};
constexpr std::array choices{
    Choice{"temperature", temperatures,
           "which temperature softens the loss tangent: the bulk's mean, as with two nodes, or that of each cell"},
    Choice{"speed", speeds,
           "at which speed the tire is deformed: that of the wheel's rotation, V (1 + slip_ratio) or V + slip_speed, "
           "of which a locked wheel has none, or V, as in the thesis's (45)"}};
constexpr std::array tables{
    Table{"profile", "m", "1",
          "weight of the loss along the meridian, such as the contact pressure, against the arc "
          "length from the centre plane (negative outboard); without it even"},
    Table{"tan_delta", "K", "1", "loss tangent at f0 against the temperature, in the place of the Gaussian (49)"}};
constexpr std::array scopes{Scope::layer, Scope::zone};
constexpr std::array<std::string_view, 2> reads{"speed", "vertical_load"};
constexpr std::array<std::string_view, 3> may_read{"inflation_pressure", "slip_ratio", "slip_speed"};

constexpr std::array of_compound{tan_delta_a, tan_delta_b, tan_delta_c, tan_delta_peak};

/// That of a layer's compound.
LossTangent loss_tangent(const ActiveEffect& active, int layer) {
    return {.a = active.at(tan_delta_a, Scope::layer, layer),
            .b = active.at(tan_delta_b, Scope::layer, layer),
            .c = active.at(tan_delta_c, Scope::layer, layer),
            .f0 = active[f0],
            .C1 = active[C1],
            .C2 = active[C2],
            .peak = active.at(tan_delta_peak, Scope::layer, layer)};
}

bool has_own_compounds(const ActiveEffect& active) {
    return !active.tables[tan_delta] && std::ranges::any_of(active.overrides, [](const ActiveEffect::Override& other) {
        return std::ranges::count(of_compound, other.parameter) > 0;
    });
}

/// Loss tangent and its slope at an equivalent temperature. 1, 1/K
struct TanDelta {
    double value = 0.0;
    double slope = 0.0;
};
TanDelta tan_delta_at(const ActiveEffect& active, int layer, double T_eq) {
    if (const std::optional<Curve>& table = active.tables[tan_delta]) {
        return {.value = table->value(T_eq), .slope = table->slope(T_eq)};
    }
    const LossTangent law = loss_tangent(active, layer);
    const double value = law.value(T_eq);
    return {.value = value, .slope = value * law.log_slope(T_eq)};
}

/// How the loss follows the strain, over that at the reference strain (Kraus).
double strain_factor(const ActiveEffect& active, const Tire& tire, const Inputs& inputs) {
    const KrausLaw law{active[kraus_amplitude], active[kraus_strain], active[kraus_exponent]};
    if (law.amplitude == 0.0) {
        return 1.0;
    }
    const double deflection = std::max(0.0, tire.unloaded_radius - tire.loaded_radius(inputs));
    return law.loss(deflection / tire.section_height) / law.loss(active[kraus_reference]);
}

/// Shares in every cell, by mass times the weights of its layer, its zone and its place along the meridian; they sum to
/// 1 before the scales. The skew is taken about its own mean, so that moving heat sideways keeps the total.
void place(const PlacementContext& context, ActiveEffect& active) {
    const mesh::Mesh& mesh = context.mesh;
    active.nodes.clear();
    active.weights.clear();
    active.skew.clear();
    const double edge = mesh.is_section() ? active[belt_edge_place] * half_tread(mesh) : 0.0;
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        const auto c = static_cast<std::size_t>(cell);
        const int layer = mesh.layer[c];
        double weight = mesh.volume[c] * context.material_model.materials[static_cast<std::size_t>(layer)].density;
        for (const std::size_t share : {strain_energy_share, loss_tangent_share}) {
            weight *= active.at(share, Scope::layer, layer);
            weight *= mesh.zone[c] < 0 ? 1.0 : active.at(share, Scope::zone, mesh.zone[c]);
        }
        if (mesh.is_section()) {
            const double s = along_meridian(mesh, cell);
            const double beside = (std::abs(s) - edge) / active[belt_edge_width];
            weight *= 1.0 + active[belt_edge_gain] * std::exp(-beside * beside);
            weight *= active.tables[profile] ? active.tables[profile]->value(s) : 1.0;
        }
        active.nodes.push_back(cell);
        active.weights.push_back(weight);
        active.skew.push_back(towards_outside(mesh, cell));
    }
    normalise(active);
    if (active.field) {
        active.weights = active.field->weights.front();
    }
    double mean = 0.0;
    for (std::size_t i = 0; i < active.nodes.size(); ++i) {
        mean += active.weights[i] * active.skew[i];
    }
    for (double& skew : active.skew) {
        skew -= mean;
    }
}

/// Intensities: the power per unit of loss tangent, or the measured or the file's power; with it the shift of the
/// temperature and the skew, each times the power. Then, where they are, the power by frames of a field, and the
/// measured power at the table's temperatures of the bulk.
enum : std::size_t { whole, shifted, skewed, framed };
constexpr std::size_t tabled = framed + most_frames;

bool gives_watts(const ActiveEffect& active) { return active.field && !active.field->watts.empty(); }

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    Inputs in = point.inputs;
    if (active.choices[speed_of] == 1) {
        in.slip_ratio = in.slip_speed = 0.0;
    }
    std::ranges::fill(out, 0.0);
    if (gives_watts(active)) {
        out[whole] = 1.0;
        active.field->watts_at(in.time, out.size() > framed ? out.subspan(framed, most_frames) : out.first(1));
        return;
    }
    double power = strain_power(point.tire, in) * strain_factor(active, point.tire, in) * point.laws.loss;
    if (active.total) {
        const bool touches = point.tire.touches(in.vertical_load);
        const auto measured = [&](double T) { return touches ? active.total->power(in, T) * point.laws.loss : 0.0; };
        const std::vector<double>& at = active.total->bulk_temperatures;
        for (std::size_t i = 0; i < at.size() && at.size() > 1; ++i) {
            out[tabled + i] = measured(at[i]);
        }
        power = measured(at.empty() ? 0.0 : at.front());
    }
    out[whole] = power;
    if (power > 0.0) {
        const double frequency = point.tire.revolutions(in);
        out[shifted] = power * (loss_tangent(active, 0).shift(frequency) + point.laws.loss_shift);
        out[skewed] = power * point.laws.loss_skew;
    }
    if (out.size() > framed && active.field) {
        active.field->shares_at(in.time, out.subspan(framed, most_frames));
        for (double& share : out.subspan(framed, most_frames)) {
            share *= power;
        }
    }
}

/// The measured power at the bulk's temperature over that which `whole` stands for, in the place of a loss tangent.
TanDelta relative_measured(const EvaluationState& m, double T_bulk) {
    const std::vector<double>& at = m.active.total->bulk_temperatures;
    if (at.size() < 2) {
        return {.value = 1.0};
    }
    const auto P = [&](std::size_t i) { return m.coefficients[tabled + i] / m.coefficients[whole]; };
    const Bracket b = bracket(at, T_bulk);
    const double slope = b.below == b.above ? 0.0 : (P(b.above) - P(b.below)) / (at[b.above] - at[b.below]);
    return {.value = P(b.below) + slope * (T_bulk - at[b.below]), .slope = slope};
}

/// Shares a power out by weights; however it is shared, the total is the law's.
void share_out(const EvaluationState& m, double power, const std::vector<double>& weights, Terms& terms) {
    const auto bulk = m.mesh.find_region("bulk");
    const double shift = m.coefficients[shifted] / m.coefficients[whole];
    const double skew = m.coefficients[skewed] / m.coefficients[whole];
    const bool local = m.active.choices[temperature] == 1 && !m.active.total;
    const bool by_layer = has_own_compounds(m.active) && !m.active.total;
    double factor = power;
    for (const LossFactor& f : m.loss_factors) {
        factor *= f.value;
    }
    const double T_bulk = m.region_mean[static_cast<std::size_t>(bulk)];
    const double T_mean = T_bulk + shift;
    // A shoulder can give no more than it has; where the skew asks for that, the others give it all the same.
    double kept = 0.0;
    for (std::size_t i = 0; i < m.active.nodes.size() && skew != 0.0; ++i) {
        kept += weights[i] * std::max(0.0, 1.0 + skew * m.active.skew[i]);
    }
    factor /= skew != 0.0 ? kept : 1.0;
    TanDelta relative = m.active.total ? relative_measured(m, T_bulk) : tan_delta_at(m.active, 0, T_mean);
    int layer_of_relative = 0;
    const double of_surface = m.active[m.mesh.layers.size() > 1 ? lambda_srf : lambda_blk];
    const double of_bulk = m.active[lambda_blk];
    if (!local && !by_layer && m.loss_factors.empty()) {
        const auto share = [&](std::size_t i) {
            const bool at_surface = m.mesh.layer[static_cast<std::size_t>(m.active.nodes[i])] == 0;
            const double skewed_share = skew == 0.0 ? 1.0 : std::max(0.0, 1.0 + skew * m.active.skew[i]);
            return weights[i] * skewed_share * (at_surface ? of_surface : of_bulk);
        };
        terms.share_out(m.active.nodes, share, factor * relative.value, bulk, factor * relative.slope);
        return;
    }
    for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
        const int node = m.active.nodes[i];
        const int layer = m.mesh.layer[static_cast<std::size_t>(node)];
        const double share =
            weights[i] * std::max(0.0, 1.0 + skew * m.active.skew[i]) * (layer == 0 ? of_surface : of_bulk);
        if (local) {
            relative = tan_delta_at(m.active, layer, m.temperature[static_cast<std::size_t>(node)] + shift);
        } else if (by_layer && layer != layer_of_relative) {
            relative = tan_delta_at(m.active, layer, T_mean);
            layer_of_relative = layer;
        }
        const double loss = factor * relative.value;
        if (local) {
            terms.heat(node, share * loss, share * factor * relative.slope);
        } else {
            terms.heat(node, share * loss);
            terms.add_source_derivative(node, bulk, share * factor * relative.slope);
        }
        for (const LossFactor& f : m.loss_factors) {
            terms.add_source_derivative(node, f.region, share * loss / f.value * f.dvalue_dT_mean);
        }
    }
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const bool by_frames = m.coefficients.size() > framed && m.active.field;
    const std::size_t frames = by_frames ? m.active.field->frames() : 1;
    for (std::size_t k = 0; k < frames; ++k) {
        const double power = m.coefficients[by_frames ? framed + k : whole];
        const std::vector<double>& weights = by_frames ? m.active.field->weights[k] : m.active.weights;
        if (power <= 0.0) {
            continue;
        }
        if (!gives_watts(m.active)) {
            share_out(m, power, weights, terms);
            continue;
        }
        for (std::size_t i = 0; i < m.active.nodes.size(); ++i) {
            terms.heat(m.active.nodes[i], power * weights[i]);
        }
    }
}

double share_of_reference_pressure(const ActiveEffect& /*active*/, const Tire& tire, const Inputs& inputs) {
    return tire.reference_pressure > 0.0 ? inputs.inflation_pressure / tire.reference_pressure : 0.0;
}

/// Speeds and loads of the thesis's drums; pressures of the tests of SAE J2452 (recalled).
constexpr std::array compared{
    ComparedRange{"speed", 40.0 / 3.6, 150.0 / 3.6}, ComparedRange{"vertical_load", 3000.0, 8000.0},
    ComparedRange{"", 0.5, 1.7, "compared", "times its reference pressure", share_of_reference_pressure}};

/// Below its peak the loss tangent is a mirror image.
std::string range_warning(const ActiveEffect& active, double coldest, double /*hottest*/) {
    const bool mirrors = !active.tables[tan_delta] && !active.total && active[tan_delta_peak] > active[tan_delta_b];
    if (!mirrors || coldest >= active[tan_delta_peak]) {
        return {};
    }
    return fmt::format(
        "strain_energy_loss: below {:.4g} degC the loss tangent is the mirror image of what it is above, not measured: "
        "give a table tan_delta of the compound",
        celsius(active[tan_delta_peak]));
}

}  // namespace

extern const Effect strain_energy_loss;
const Effect strain_energy_loss{
    .id = "strain_energy_loss",
    .kind = EffectKind::source,
    .on = true,
    .equation =
        "SEL = Fz eps (A_CS/A_VC) H tan delta(T_bulk, f) (2 pi R0/l) f, f = Omega/(2 pi) = V (1 + slip_ratio)/(2 pi "
        "R_R)",
    .source =
        "thesis (36)-(49), errata E1, E2, E3, E7, E8; strain: Kraus, J. Appl. Polym. Sci.: Appl. Polym. Symp. 39, "
        "1984; "
        "pressure: SAE J2452 (exponent recalled)",
    .valid =
        "40 to 150 km/h, 3 to 8 kN and a bulk of 20 to 120 degC, where the thesis's law was compared with drums (8 to "
        "30 % of error); the cold branch below -8 degC is a mirror image, not measured, and a parabola rounds the peak "
        "where it and the Gaussian meet, within 8 K of it; pressures of 0.5 to 1.7 times "
        "the reference; deflections below 40 % of the section's height",
    .meaning =
        "Heat of cyclic deformation, shared over the cells by mass and by the weights of layers, zones and the "
        "place along the meridian; however it is shared, the total is the law's. tan delta is taken at the bulk's mean "
        "temperature unless it is to be local; none where the wheel does not turn or without load. Below "
        "tan_delta_peak the loss tangent falls again: the Gaussian, fitted above 0 degC, would rise without end in the "
        "cold. The loss falls with the inflation pressure, (p/reference_pressure)^-pressure_exponent_of_loss of "
        "[tire], where the pressure is given (SAE J2452). tan_delta_a, _b, _c and _peak may differ by layer, one "
        "compound each; Kraus's law lets the loss follow the strain. "
        "A field of a structural code may replace the weights, or the loss itself; a drum's table (total) or SAE J2452 "
        "coefficients (coastdown) the total, scaled by the lambdas and by laws that scale the loss.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .choices = choices,
    .tables = tables,
    .scopes = scopes,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .model =
        HeatEffect{
            .by_deformation = true,
            .n_coefficients = 3,
            .field = FieldOf::loss,
            .frame_coefficients = most_frames + most_temperatures,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
            .range_warning = range_warning,
        },
};

}  // namespace tiretherm::physics::effects
