// SPDX-License-Identifier: BSD-3-Clause
// Evaluates loss, film, contact, friction and gas at a moment, with the exact Jacobian as band and couplings.

#include "section/section_heat_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

using std::numbers::pi;
constexpr double width = 0.225;
constexpr double height = 0.1125;
constexpr double radius = 0.3308;
constexpr double thickness = 0.012;
constexpr double stefan_boltzmann = 5.670374419e-8;

double dot(const std::vector<double>& weights, std::span<const double> T) {
    return std::inner_product(weights.begin(), weights.end(), T.begin(), 0.0);
}

/// Forced part of the film, W/m2K, with an exponent that gives the same at 25 m/s.
double forced_film(double V, double exponent) {
    const double length = 1.0 / (1.0 / (2.0 * radius) + 1.0 / width);
    const double at_25 = 0.025 / length * 0.318 * std::pow(25.0 * length / 1.5e-5, 0.571);
    return V > 0.0 ? at_25 * std::pow(V / 25.0, exponent) : 0.0;
}

}  // namespace

SectionInputs SectionHeat::inputs(double t) const {
    const SectionProgramme& p = programme_;
    const std::size_t i = interval_;
    const double share = (t - p.time[i]) / (p.time[i + 1] - p.time[i]);
    const auto line = [&](const std::vector<double>& x) { return x[i] + share * (x[i + 1] - x[i]); };
    const double hours = (t - p.time.front()) / 3600.0;
    return {.V = line(p.speed),
            .Fz = line(p.vertical_load),
            .alpha = line(p.slip_angle),
            .Fy = line(p.lateral_force),
            .camber = line(p.camber),
            .T_air = line(p.air_temperature) + causes_.air_rate * hours,
            .T_road = line(p.road_temperature) + causes_.road_rate * hours,
            .throttle = line(p.throttle)};
}

void SectionHeat::move_to(std::size_t i, double from, double to) {
    interval_ = i;
    const SectionInputs in = inputs(0.5 * (from + to));
    rolls_ = in.V > 0.1 && in.Fz > 1.0;
}

std::vector<double> SectionHeat::stops(std::size_t i) const {
    const SectionProgramme& p = programme_;
    std::vector<double> out{p.time[i + 1]};
    const auto crossing = [&](const std::vector<double>& x, double level) {
        if ((x[i] - level) * (x[i + 1] - level) < 0.0) {
            out.push_back(p.time[i] + (p.time[i + 1] - p.time[i]) * (level - x[i]) / (x[i + 1] - x[i]));
        }
    };
    crossing(p.speed, 0.1);
    crossing(p.vertical_load, 1.0);
    crossing(p.slip_angle, 0.0);
    crossing(p.lateral_force, 0.0);
    std::sort(out.begin(), out.end());
    return out;
}

SectionHeat::Loss SectionHeat::loss(const SectionInputs& in, double T_bulk, double T_gas) const {
    if (!rolls_) {
        return {};
    }
    const double length = 0.160 - 2.0 * 0.160 / (1.0 + std::exp(0.35e-3 * in.Fz));
    const double ratio = (width * thickness + 2.0 * thickness * (height - thickness)) / (width * height);
    const double frequency = in.V / (2.0 * pi * 0.3483 * std::pow(in.Fz, -0.009));
    const double decades = std::log10(frequency / 52.0);
    const double x = (T_bulk + 101.6 * decades / (-8.86 - decades) + 4989.0) / 882.0;
    const double per_length = in.Fz * (4.2e-6 * in.Fz / height) * ratio * height * 2.14e15 * std::exp(-x * x);
    const double law = per_length * (2.0 * pi * radius / length) * frequency;
    const double changed = std::exp(causes_.loss_slope * (T_bulk - celsius - 60.0)) *
                           std::pow(in.Fz / 4500.0, causes_.load) * std::pow(T_gas / 294.15, -causes_.pressure);
    return {.watts = bench_.lambda_sel * law * changed,
            .by_bulk = causes_.loss_slope - 2.0 * x / 882.0,
            .by_gas = -causes_.pressure / T_gas};
}

void SectionHeat::add_tread(const SectionInputs& in, std::span<const double> T, std::span<double> f,
                            BandMatrix* band) const {
    const double contact = in.Fz > 1.0 ? 2.333e-6 * in.Fz : 0.0;
    const double free_share = (2.0 * pi * radius * width - contact) / shape_.tread_area * bench_.lambda_h;
    const double road = 500.0 * contact / shape_.tread_area;
    const double forced = forced_film(in.V, causes_.convection);
    const double grey = causes_.emissivity * stefan_boltzmann;
    for (const SectionShape::SurfacePoint& point : shape_.tread) {
        double Ts = 0.0;
        for (std::size_t a = 0; a < 3; ++a) {
            Ts += point.shape[a] * T[point.node[a]];
        }
        const double exponential = 8.59e-11 * std::exp(0.0879 * Ts);
        const bool floored = forced + exponential < 30.0;
        const double h = floored ? 30.0 : forced + exponential;
        const double flux = free_share * h * (in.T_air - Ts) + road * (in.T_road - Ts) +
                            grey * (std::pow(in.T_air, 4) - std::pow(Ts, 4));
        const double by_T = free_share * ((floored ? 0.0 : 0.0879 * exponential) * (in.T_air - Ts) - h) - road -
                            4.0 * grey * std::pow(Ts, 3);
        for (std::size_t a = 0; a < 3; ++a) {
            f[point.node[a]] += point.area * point.shape[a] * flux;
            for (std::size_t b = 0; band != nullptr && b < 3; ++b) {
                band->at(point.node[a], point.node[b]) += point.area * point.shape[a] * point.shape[b] * by_T;
            }
        }
    }
}

void SectionHeat::heat(double t, std::span<const double> T, std::span<double> f, BandMatrix* band,
                       std::vector<Coupling>* couplings) const {
    const SectionInputs in = inputs(t);
    const SectionShape& m = shape_;
    const double T_gas = T[m.gas()];
    const Loss made = loss(in, dot(m.carcass, T), T_gas);
    const double skew = causes_.camber * in.camber;
    if (std::abs(skew) > 1.0) {
        throw std::invalid_argument("the camber takes more from a shoulder than it makes");
    }
    const double sliding = in.V * std::tan(std::abs(in.alpha));
    const double friction =
        in.Fz > 1.0 ? 0.6 * (1.0 + causes_.partition * sliding) * causes_.slip * std::abs(in.Fy) * sliding : 0.0;
    const double cornering = causes_.cornering * in.Fy * in.Fy * in.V;
    m.conduction.multiply(T, f);
    for (std::size_t n = 0; n < f.size(); ++n) {
        f[n] = -f[n] + made.watts * (m.loss[n] + skew * m.loss_skew[n]) + friction * m.surface[n] +
               cornering * m.carcass[n] + m.sidewalls[n] * in.T_air + causes_.liner * m.liner[n] * T_gas +
               in.throttle * (causes_.shoulder_watts * m.inside_shoulder[n] + causes_.crown_watts * m.crown[n] +
                              causes_.surface_watts * m.surface[n]);
    }
    // Where nothing leaves for the gas, the node is that of inflation_pressure_rise, which follows the bulk at no cost.
    const bool meets_liner = causes_.liner > 0.0;
    const double to_gas = meets_liner ? causes_.liner : 9.0;
    const double to_rim = meets_liner ? causes_.rim : 4.0;
    const std::vector<double>& warms_gas = meets_liner ? m.liner : m.carcass;
    f[m.gas()] += to_gas * (dot(warms_gas, T) - T_gas) + to_rim * (in.T_air - T_gas);
    add_tread(in, T, f, band);
    if (band != nullptr) {
        band->add(-1.0, m.conduction);
        band->at(m.gas(), m.gas()) -= to_gas + to_rim;
    }
    if (couplings != nullptr) {
        Coupling& bulk = (*couplings)[0];
        Coupling& gas = (*couplings)[1];
        Coupling& liner = (*couplings)[2];
        bulk.v = m.carcass;
        gas.v[m.gas()] = 1.0;
        liner.u[m.gas()] = to_gas;
        liner.v = warms_gas;
        for (std::size_t n = 0; n < f.size(); ++n) {
            const double share = made.watts * (m.loss[n] + skew * m.loss_skew[n]);
            bulk.u[n] = share * made.by_bulk;
            gas.u[n] = share * made.by_gas + causes_.liner * m.liner[n];
        }
    }
}

}  // namespace hidden_effects
