// SPDX-License-Identifier: BSD-3-Clause
// Draws the laser programme and integrates the specimen with causes and sensors, stopping at every sample.

#include "laser/laser_bench_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "laser/laser_causes_truth.hpp"
#include "laser/laser_elements_truth.hpp"
#include "numerics/random_truth.hpp"
#include "numerics/rodas_truth.hpp"
#include "numerics/units_truth.hpp"
#include "two_node/sensors_truth.hpp"

namespace hidden_effects {

namespace {

constexpr double stated_radius = 5.6419e-3;

/// A conductivity that is a straight line through 20 and 90 degC, with what the causes make of it.
Conductivity conductivity(double at_20, double at_90, double scale, double slope) {
    const double by_T = (at_90 - at_20) / 70.0 + slope * at_20;
    const auto value = [&](double T) { return scale * (at_20 + by_T * (T - 20.0)); };
    return {value(40.0), value(90.0), value(140.0)};
}

LaserSpecimen specimen_of(const LaserBench& bench, const LaserCauses& causes, double air) {
    return {.K1 = conductivity(0.29, 0.95, causes.conductivity[0], causes.conductivity_slope[0]),
            .K2 = conductivity(0.060, 0.075, causes.conductivity[1], causes.conductivity_slope[1]),
            .h_top = bench.h_top,
            .h_bottom = bench.h_bottom,
            .air = air,
            .spot = causes.spot * stated_radius,
            .outer_heat_capacity_scale = causes.capacity[0],
            .inner_heat_capacity_scale = causes.capacity[1],
            .emissivity = causes.emissivity,
            .natural_convection = causes.natural};
}

class LaserBenchHeat : public HeatSystem {
public:
    LaserBenchHeat(const LaserElements& elements, const LaserBench& bench, const LaserCauses& causes,
                   const LaserProgramme& programme, const LaserSpecimen& specimen)
        : elements_(elements),
          causes_(causes),
          programme_(programme),
          absorptivity_(bench.absorptivity),
          light_(elements.mean_over(true, 0.0, specimen.spot)),
          inner_(elements.mean_over(false, 0.0, specimen.radius)) {}

    void move_to(std::size_t interval) { interval_ = interval; }

    [[nodiscard]] BandMatrix capacity() const override { return elements_.capacity(); }
    [[nodiscard]] std::size_t n_couplings() const override { return 0; }
    void heat(double t, std::span<const double> T, std::span<double> f, BandMatrix* band,
              std::vector<Coupling>* /*couplings*/) const override {
        elements_.heat(T, f, band);
        const double share =
            (t - programme_.time[interval_]) / (programme_.time[interval_ + 1] - programme_.time[interval_]);
        const auto line = [&](const std::vector<double>& x) {
            return x[interval_] + share * (x[interval_ + 1] - x[interval_]);
        };
        const double hours = (t - programme_.time.front()) / 3600.0;
        const double light =
            absorptivity_ * causes_.absorbed * std::exp(-causes_.fall * hours) * line(programme_.power);
        const double inside = causes_.lamp_watts * line(programme_.lamp) + causes_.hourly_watts * hours;
        // The elements count watts per radian.
        for (std::size_t n = 0; n < f.size(); ++n) {
            f[n] += (light * light_[n] + inside * inner_[n]) / (2.0 * std::numbers::pi);
        }
    }

private:
    const LaserElements& elements_;
    const LaserCauses& causes_;
    const LaserProgramme& programme_;
    double absorptivity_;
    std::vector<double> light_;  ///< of a watt, by the nodes of the spot
    std::vector<double> inner_;  ///< of a watt, by the nodes of the inner face
    std::size_t interval_ = 0;
};

std::vector<double> at_node(const LaserElements& elements, std::size_t node) {
    std::vector<double> weights(elements.n_nodes(), 0.0);
    weights[node] = 1.0;
    return weights;
}

}  // namespace

LaserProgramme draw_laser_programme(std::uint64_t seed) {
    Random random(seed);
    LaserProgramme programme{
        .time = {}, .power = {}, .lamp = {}, .air = std::round(random.uniform(200.0, 260.0)) / 10.0};
    double power = 0.0;
    double next = 30.0;
    double from = random.uniform();
    double to = random.uniform();
    double from_time = 0.0;
    double to_time = random.uniform(30.0, 120.0);
    for (double t = 0.0; t <= 1200.0; t += 5.0) {
        programme.time.push_back(t);
        programme.power.push_back(power);
        if (t >= next) {
            power = random.uniform() < 0.15 ? 0.0 : std::round(random.uniform(20.0, 150.0)) / 100.0;
            next = t + 5.0 * std::round(random.uniform(12.0, 60.0));
        }
        while (t > to_time) {
            from_time = to_time;
            from = to;
            to_time += random.uniform(30.0, 120.0);
            to = random.uniform();
        }
        const double lamp = from + (to - from) * (t - from_time) / (to_time - from_time);
        programme.lamp.push_back(std::round(1000.0 * lamp) / 1000.0);
    }
    return programme;
}

LaserBenchTrace drive_laser(const LaserBench& bench, const LaserProgramme& programme,
                            const LaserResolution& resolution) {
    const LaserCauses causes = gather_laser(bench.causes);
    const LaserSpecimen specimen = specimen_of(bench, causes, programme.air);
    const LaserElements elements(specimen, resolution.refinement);
    LaserBenchHeat heat(elements, bench, causes, programme, specimen);
    Rodas rodas(heat, std::vector<double>(elements.n_nodes(), bench.start), programme.time.front(),
                resolution.tolerance);
    std::vector<std::vector<double>> places{at_node(elements, elements.node_on_axis(true)),
                                            elements.mean_over(true, 0.0, stated_radius),
                                            at_node(elements, elements.node_on_axis(false))};
    Sensors sensors(std::move(places), {causes.reading.begin(), causes.reading.end()});
    const auto now = [&] {
        std::vector<double> T = rodas.temperature();
        std::transform(T.begin(), T.end(), T.begin(), [](double degrees) { return degrees + celsius; });
        return sensors.now(T, sensors.lags() ? rodas.rate() : std::vector<double>{}, programme.air + celsius);
    };
    sensors.start(now());
    LaserBenchTrace trace;
    const auto read = [&] {
        for (std::size_t c = 0; c < laser_channels.size(); ++c) {
            trace.channel[c].push_back(sensors.shown(c) - celsius);
        }
    };
    read();
    for (std::size_t i = 0; i + 1 < programme.time.size(); ++i) {
        heat.move_to(i);
        while (rodas.time() < programme.time[i + 1]) {
            const double from = rodas.time();
            const std::vector<Sensors::Course> begin = now();
            rodas.step(programme.time[i + 1]);
            sensors.follow(rodas.time() - from, begin, now());
        }
        read();
    }
    trace.n_steps = rodas.n_steps();
    return trace;
}

}  // namespace hidden_effects
