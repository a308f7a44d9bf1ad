#include "section_truth.hpp"

#include "section_heat_truth.hpp"
#include "sensors_truth.hpp"

namespace hidden_effects {

namespace {

Sensors sensors_of(const SectionCauses& causes, const SectionShape& shape) {
    std::vector<double> gas(shape.n_nodes(), 0.0);
    gas[shape.gas()] = 1.0;
    return {{shape.crown_surface, shape.at(-shoulder_middle, 0.010), shape.at(shoulder_middle, 0.010),
             shape.at(0.0, section_depth), gas},
            {causes.reading.begin(), causes.reading.end()}};
}

}  // namespace

SectionTrace drive_section(const SectionBench& bench, const SectionProgramme& programme,
                           const SectionResolution& resolution) {
    const SectionCauses causes = gather_section(bench.causes);
    SectionHeat heat(bench, causes, programme, resolution.refinement);
    std::vector<double> T(heat.shape().n_nodes(), bench.start);
    T.back() = bench.gas_start > 0.0 ? bench.gas_start : programme.air_temperature.front();
    Rodas rodas(heat, T, programme.time.front(), resolution.tolerance);
    Sensors sensors = sensors_of(causes, heat.shape());
    sensors.start(sensors.now(T, {}, programme.air_temperature.front()));
    SectionTrace trace;
    const auto read = [&] {
        for (std::size_t c = 0; c < section_channels.size(); ++c) {
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
        for (const double stop : heat.stops(i)) {
            heat.move_to(i, rodas.time(), stop);
            while (rodas.time() < stop) {
                const double from = rodas.time();
                std::vector<Sensors::Course> begin(section_channels.size());
                if (sensors.lags()) {
                    begin = sensors.now(rodas.temperature(), rodas.rate(), air(from));
                }
                rodas.step(stop);
                const std::vector<double> rate = sensors.lags() ? rodas.rate() : std::vector<double>{};
                sensors.follow(rodas.time() - from, begin, sensors.now(rodas.temperature(), rate, air(rodas.time())));
            }
        }
        read();
    }
    trace.n_steps = rodas.n_steps();
    return trace;
}

}  // namespace hidden_effects
