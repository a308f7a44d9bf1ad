// SPDX-License-Identifier: BSD-3-Clause
// Seeds, hidden effects and noise of the shipped logs of the two-node bench and of the laser's specimen.

#include "two_node/shipped_truth.hpp"

#include <cmath>

#include "numerics/random_truth.hpp"

namespace hidden_effects {

namespace {

constexpr Noise camera{.standard_deviation = 0.5};
constexpr Noise probe{.standard_deviation = 0.3};

void add(std::vector<double>& values, const std::vector<double>& noise) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] += noise[i];
    }
}

/// Three runs of one bench, each from its own programme and its own temperatures, 2 K about the air's.
std::vector<ShippedLog> runs_of(Bench bench, std::uint64_t seed, const std::string& name) {
    std::vector<ShippedLog> logs;
    for (std::uint64_t run = 1; run <= 3; ++run) {
        const Programme programme = draw_programme(100 * seed + run, 4.0);
        Random random(100 * seed + 50 + run);
        bench.surface_start = programme.air_temperature.front() + 2.0 * random.normal();
        bench.bulk_start = programme.air_temperature.front() + 2.0 * random.normal();
        BenchTrace trace = drive_bench(bench, programme);
        add(trace.surface, draw_noise(camera, programme.time, random));
        add(trace.bulk, draw_noise(probe, programme.time, random));
        logs.push_back({"practice/" + name + std::to_string(run) + ".csv", bench_columns(programme, trace)});
    }
    return logs;
}

}  // namespace

std::vector<ShippedLog> bench_logs() {
    std::vector<ShippedLog> logs = runs_of({.lambda_h = 1.05, .lambda_sel = 0.93}, 1, "run");
    const Bench leaking{
        .lambda_h = 0.96, .lambda_sel = 1.06, .causes = {{"sidewall_convection", {{"conductance", 0.8}}}}};
    for (ShippedLog& log : runs_of(leaking, 2, "puzzle")) {
        logs.push_back(std::move(log));
    }
    return logs;
}

LaserSpecimen shipped_specimen() {
    return {.K1 = {0.50, 0.95, 1.30},
            .K2 = {0.066, 0.075, 0.082},
            .h_top = 11.0,
            .h_bottom = 8.5,
            .air = 23.0,
            .start = 23.0,
            .absorptivity = 0.95,
            .power = 1.0,
            .spot = 5.60e-3};
}

std::vector<ShippedLog> laser_logs() {
    struct Shot {
        std::string name;
        double power;  ///< W
        double start;  ///< degC
    };
    std::vector<double> times;
    for (int i = 0; i <= 180; ++i) {
        times.push_back(5.0 * i);
    }
    std::vector<ShippedLog> logs;
    std::uint64_t seed = 301;
    for (const Shot& shot :
         {Shot{"half_watt", 0.5, 23.4}, Shot{"one_and_a_half_watts", 1.5, 22.7}, Shot{"three_watts", 3.0, 23.2}}) {
        LaserSpecimen specimen = shipped_specimen();
        specimen.power = shot.power;
        specimen.start = shot.start;
        LaserTrace trace = heat_with_laser(specimen, times);
        Random random(seed++);
        add(trace.spot_mean, draw_noise(camera, times, random));
        add(trace.inner_centre, draw_noise(probe, times, random));
        const std::vector<double> power(times.size(), shot.power);
        const std::vector<double> air(times.size(), specimen.air);
        logs.push_back({"laser/identify_" + shot.name + ".csv",
                        {{"time [s]", 0, times},
                         {"laser_power [W]", 2, power},
                         {"air_temperature [degC]", 1, air},
                         {"spot_mean_temperature [degC]", 2, trace.spot_mean},
                         {"inner_liner_temperature [degC]", 2, trace.inner_centre}}});
    }
    return logs;
}

}  // namespace hidden_effects
