// SPDX-License-Identifier: BSD-3-Clause
// The tire's numbers as the thesis prints them, and the balance of both lumps with every cause.

#include "two_node/bench_equations_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

using std::numbers::pi;

// The tire, 225/50 R17: every number as the thesis prints it.
constexpr double width = 0.225;
constexpr double height = 0.1125;
constexpr double radius = 0.3308;
constexpr double tread = 0.012;
constexpr double sidewall = 0.009;
constexpr double area = 2.0 * pi * radius * width;
constexpr double heat_capacity = 1100.0 * area * tread * 1800.0;  ///< J/K, of both nodes
constexpr double surface_share = 0.15;
constexpr double gas_capacity = 70.0;  ///< J/K

/// The inputs at one moment.
struct Now {
    double t, V, Fz, alpha, Fy, T_air, T_road, throttle;
};

Now at(const Programme& p, std::size_t i, double t) {
    const double s = (t - p.time[i]) / (p.time[i + 1] - p.time[i]);
    const auto line = [&](const std::vector<double>& x) { return x[i] + s * (x[i + 1] - x[i]); };
    return {t,
            line(p.speed),
            line(p.vertical_load),
            line(p.slip_angle),
            line(p.lateral_force),
            line(p.air_temperature),
            line(p.road_temperature),
            line(p.throttle)};
}

/// Heat of cyclic deformation without any cause, W.
double strain_energy_loss(const Now& in, double T_bulk) {
    const double length = 0.160 - 2.0 * 0.160 / (1.0 + std::exp(0.35e-3 * in.Fz));
    const double deflection = 4.2e-6 * in.Fz / height;
    const double ratio = (width * tread + 2.0 * sidewall * (height - tread)) / (width * height);
    const double frequency = in.V / (2.0 * pi * 0.3483 * std::pow(in.Fz, -0.009));
    const double decades = std::log10(frequency / 52.0);
    const double T_equivalent = T_bulk + 101.6 * decades / (-8.86 - decades);
    const double x = (T_equivalent + 4989.0) / 882.0;
    const double loss_tangent = 2.14e15 * std::exp(-x * x);
    const double energy_per_passage = in.Fz * deflection * ratio * height * loss_tangent;
    return energy_per_passage * (2.0 * pi * radius / length) * frequency;
}

/// Film to the air, W/m2K, before its scale.
double film(const Causes& causes, double V, double T_surface) {
    const double length = 1.0 / (1.0 / (2.0 * radius) + 1.0 / width);
    const auto forced = [&](double speed) { return 0.025 / length * 0.318 * std::pow(speed * length / 1.5e-5, 0.571); };
    const double by_speed = V > 0.0 ? forced(25.0) * std::pow(V / 25.0, causes.convection) : 0.0;
    return std::max(30.0, by_speed + 8.59e-11 * std::exp(0.0879 * T_surface));
}

/// What a camera with a wrong emissivity shows of a surface.
double seen(const Causes& causes, double T_surface, double T_air) {
    const double e = causes.surface.emissivity;
    return std::pow(e * std::pow(T_surface, 4) + (1.0 - e) * std::pow(T_air, 4), 0.25);
}

double shown(const Reading& reading, double temperature) {
    const double shifted = temperature + reading.kelvin;
    return shifted + reading.excess * (shifted - celsius - 25.0);
}

}  // namespace

BenchState BenchEquations::start() const {
    const double T_air = programme_.air_temperature.front();
    const double camera = seen(causes_, bench_.surface_start, T_air);
    return {bench_.surface_start, bench_.bulk_start, T_air, T_air, camera, bench_.bulk_start};
}

BenchState BenchEquations::rate(std::size_t i, double t, const BenchState& y) const {
    const Now in = at(programme_, i, t);
    const double since = (t - programme_.time.front()) / 3600.0;
    const double T_air = in.T_air + causes_.air_rate * since;
    const double T_road = in.T_road + causes_.road_rate * since;

    const double contact = 2.333e-6 * in.Fz;
    const double to_road = 500.0 * contact * (T_road - y[surface]);
    const double to_air = bench_.lambda_h * film(causes_, in.V, y[surface]) * (area - contact) * (T_air - y[surface]);
    const double k = causes_.conductivity * (0.29 + 0.00943 * (y[bulk] - celsius - 20.0));
    const double from_bulk = k / 0.010 * area * (y[bulk] - y[surface]);

    const bool rolls = in.V > 0.1 && in.Fz > 1.0;
    double loss = rolls ? bench_.lambda_sel * strain_energy_loss(in, y[bulk]) : 0.0;
    if (rolls) {
        const double over = std::max(0.0, 3.6 * in.V - causes_.critical);
        loss *= std::exp(causes_.loss_slope * (y[bulk] - celsius - 60.0)) * std::pow(in.Fz / 4500.0, causes_.load) *
                (1.0 + causes_.wave * over * over) * std::pow(y[pressure_gas] / 294.15, -causes_.pressure);
    }
    const double sliding = in.V * std::tan(std::abs(in.alpha));
    const double friction = 0.6 * (1.0 + causes_.partition * sliding) * causes_.slip * std::abs(in.Fy) * sliding;

    BenchState dy{};
    dy[surface] =
        (surface_share * loss + friction + from_bulk + to_air + to_road + causes_.surface_watts * in.throttle) /
        (surface_share * heat_capacity);
    dy[bulk] = ((1.0 - surface_share) * loss - from_bulk + causes_.sidewall * (T_air - y[bulk]) -
                causes_.liner * (y[bulk] - y[gas]) + causes_.cornering * in.Fy * in.Fy * in.V +
                causes_.bulk_watts * in.throttle) /
               ((1.0 - surface_share) * heat_capacity * causes_.capacity);
    dy[gas] = (causes_.liner * (y[bulk] - y[gas]) - causes_.rim * (y[gas] - T_air)) / gas_capacity;
    dy[pressure_gas] = (9.0 * (y[bulk] - y[pressure_gas]) - 4.0 * (y[pressure_gas] - T_air)) / gas_capacity;
    const double lag_s = causes_.surface.tau;
    const double lag_b = causes_.bulk.tau;
    dy[surface_sensor] = lag_s > 0.0 ? (seen(causes_, y[surface], in.T_air) - y[surface_sensor]) / lag_s : 0.0;
    dy[bulk_sensor] = lag_b > 0.0 ? (y[bulk] - y[bulk_sensor]) / lag_b : 0.0;
    return dy;
}

std::vector<double> BenchEquations::stops(std::size_t i) const {
    std::vector<double> out{programme_.time[i + 1]};
    const auto crossing = [&](const std::vector<double>& x, double level) {
        if ((x[i] - level) * (x[i + 1] - level) < 0.0) {
            out.push_back(programme_.time[i] +
                          (programme_.time[i + 1] - programme_.time[i]) * (level - x[i]) / (x[i + 1] - x[i]));
        }
    };
    crossing(programme_.speed, 0.1);
    crossing(programme_.speed, causes_.critical / 3.6);
    crossing(programme_.vertical_load, 1.0);
    crossing(programme_.slip_angle, 0.0);
    crossing(programme_.lateral_force, 0.0);
    std::sort(out.begin(), out.end());
    return out;
}

double BenchEquations::surface_reading(std::size_t i, const BenchState& y) const {
    const bool lags = causes_.surface.tau > 0.0;
    const double camera = lags ? y[surface_sensor] : seen(causes_, y[surface], programme_.air_temperature[i]);
    return shown(causes_.surface, camera);
}

double BenchEquations::bulk_reading(const BenchState& y) const {
    return shown(causes_.bulk, causes_.bulk.tau > 0.0 ? y[bulk_sensor] : y[bulk]);
}

}  // namespace hidden_effects
