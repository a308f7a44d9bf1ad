// SPDX-License-Identifier: BSD-3-Clause
// Seeds and parameters of the shipped logs of the laser bench, and the columns of a log.

#include "laser/laser_logs_truth.hpp"

#include "numerics/random_truth.hpp"

namespace hidden_effects {

std::vector<Column> laser_columns(const LaserProgramme& programme, const LaserBenchTrace& trace) {
    std::vector<Column> columns{
        {"time [s]", 0, programme.time},
        {"laser_power [W]", 2, programme.power},
        {"air_temperature [degC]", 1, std::vector<double>(programme.time.size(), programme.air)},
        {"lamp [-]", 3, programme.lamp}};
    for (std::size_t c = 0; c < laser_channels.size(); ++c) {
        columns.push_back({std::string(laser_channels[c]) + " [degC]", 2, trace.channel[c]});
    }
    return columns;
}

LaserBench shipped_laser_bench() { return {.absorptivity = 0.95, .h_top = 11.5, .h_bottom = 8.5}; }

std::vector<ShippedLog> laser_bench_logs() {
    std::vector<ShippedLog> logs;
    for (std::uint64_t run = 1; run <= 3; ++run) {
        const LaserProgramme programme = draw_laser_programme(500 + run);
        Random random(550 + run);
        LaserBench bench = shipped_laser_bench();
        bench.start = programme.air + 0.7 * random.normal();
        LaserBenchTrace trace = drive_laser(bench, programme);
        for (std::size_t c = 0; c < laser_channels.size(); ++c) {
            const std::vector<double> noise =
                draw_noise({.standard_deviation = laser_noise[c]}, programme.time, random);
            for (std::size_t i = 0; i < noise.size(); ++i) {
                trace.channel[c][i] += noise[i];
            }
        }
        logs.push_back({"practice/laser_run" + std::to_string(run) + ".csv", laser_columns(programme, trace)});
    }
    return logs;
}

}  // namespace hidden_effects
