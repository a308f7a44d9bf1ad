// SPDX-License-Identifier: BSD-3-Clause
// Integrates the section bench by RODAS between samples and switches, and reads its sensors.

#include "section/section_truth.hpp"

#include "section/section_heat_truth.hpp"
#include "two_node/sensors_truth.hpp"

namespace hidden_effects {

namespace {

using Weights = std::vector<std::vector<double>>;

/// What the sensors show at every sample, from one uniform temperature on.
SectionTrace drive(SectionHeat& heat, Sensors sensors, std::size_t n_sensors, const SectionBench& bench,
                   const SectionProgramme& programme, double tolerance) {
    std::vector<double> T(heat.shape().n_nodes(), bench.start);
    T.back() = bench.gas_start > 0.0 ? bench.gas_start : programme.air_temperature.front();
    Rodas rodas(heat, T, programme.time.front(), tolerance);
    sensors.start(sensors.now(T, {}, programme.air_temperature.front()));
    SectionTrace trace{.channel = Weights(n_sensors)};
    const auto read = [&] {
        for (std::size_t c = 0; c < n_sensors; ++c) {
            trace.channel[c].push_back(sensors.shown(c));
        }
    };
    read();
    for (std::size_t i = 0; i + 1 < programme.time.size(); ++i) {
        const auto air = [&](double t) {
            const double share = (t - programme.time[i]) / (programme.time[i + 1] - programme.time[i]);
            return programme.air_temperature[i] +
                   share * (programme.air_temperature[i + 1] - programme.air_temperature[i]);
        };
        const auto now = [&] {
            const std::vector<double> rate = sensors.lags() ? rodas.rate() : std::vector<double>{};
            return sensors.now(rodas.temperature(), rate, air(rodas.time()));
        };
        for (const double stop : heat.stops(i)) {
            heat.move_to(i, rodas.time(), stop);
            while (rodas.time() < stop) {
                const double from = rodas.time();
                const std::vector<Sensors::Course> begin = now();
                rodas.step(stop);
                sensors.follow(rodas.time() - from, begin, now());
            }
        }
        read();
    }
    trace.n_steps = rodas.n_steps();
    return trace;
}

}  // namespace

SectionTrace drive_section(const SectionBench& bench, const SectionProgramme& programme,
                           const SectionResolution& resolution) {
    const SectionCauses causes = gather_section({}, section_channels, bench.causes);
    SectionHeat heat(bench, causes, programme, resolution.refinement, Strip::section);
    const SectionShape& shape = heat.shape();
    std::vector<double> gas(shape.n_nodes(), 0.0);
    gas[shape.gas()] = 1.0;
    const Weights places{shape.crown_surface, shape.at(-shoulder_middle, 0.010), shape.at(shoulder_middle, 0.010),
                         shape.at(0.0, section_depth), gas};
    return drive(heat, {places, causes.reading}, places.size(), bench, programme, resolution.tolerance);
}

SectionTrace drive_layers(const SectionBench& bench, const SectionProgramme& programme,
                          const SectionResolution& resolution) {
    const SectionCauses causes = gather_section({.liner = 0.0, .rim = 0.0}, layers_channels, bench.causes);
    SectionProgramme upright = programme;
    upright.camber.assign(programme.time.size(), 0.0);
    SectionHeat heat(bench, causes, upright, resolution.refinement, Strip::layers);
    const SectionShape& shape = heat.shape();
    const Weights places{shape.surface, shape.at(0.0, 0.010), shape.liner};
    return drive(heat, {places, causes.reading}, places.size(), bench, upright, resolution.tolerance);
}

}  // namespace hidden_effects
