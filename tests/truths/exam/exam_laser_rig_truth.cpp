// SPDX-License-Identifier: BSD-3-Clause
// The bench of a laser, cases/practice/laser_bench.md, as a rig of the exam.
#include <algorithm>
#include <utility>

#include "exam/exam_rig_truth.hpp"
#include "laser/laser_logs_truth.hpp"
#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

/// The page fixes its length and its samples.
RigProgramme draw_laser(std::uint64_t seed, double /*interval*/) {
    LaserProgramme drawn = draw_laser_programme(seed);
    RigProgramme programme;
    programme.air_temperature.assign(drawn.time.size(), drawn.air + celsius);
    programme.time = std::move(drawn.time);
    programme.laser_power = std::move(drawn.power);
    programme.throttle = std::move(drawn.lamp);
    return programme;
}

LaserProgramme as_laser(const RigProgramme& programme) {
    return {.time = programme.time,
            .power = programme.laser_power,
            .lamp = programme.throttle,
            .air = programme.air_temperature.front() - celsius};
}

RigTrace drive_of_laser(std::span<const double> numbers, const std::vector<Cause>& causes,
                        const RigProgramme& programme, double tolerance) {
    const LaserBench bench{.absorptivity = numbers[0],
                           .h_top = numbers[1],
                           .h_bottom = numbers[2],
                           .start = numbers[3] - celsius,
                           .causes = causes};
    const LaserBenchTrace trace = drive_laser(bench, as_laser(programme), {.refinement = 1, .tolerance = tolerance});
    return {trace.channel.begin(), trace.channel.end()};
}

std::vector<Column> log_laser(const RigProgramme& programme, const RigTrace& trace) {
    LaserBenchTrace of_laser;
    std::ranges::copy(trace, of_laser.channel.begin());
    return laser_columns(as_laser(programme), of_laser);
}

}  // namespace

// The inner face belongs to the layer `bulk`: heat that enters there may be called by either name.
const Rig& laser_rig() {
    static const Rig rig{.name = "laser",
                         .case_file = "laser_bench.toml",
                         .of_bench = {{.name = "absorptivity", .expected = 0.93, .prior = 0.03, .spread = 0.02},
                                      {.name = "h_top", .expected = 10.0, .prior = 3.0, .spread = 1.5},
                                      {.name = "h_bottom", .expected = 10.0, .prior = 3.0, .spread = 1.5}},
                         .of_run = {{.name = "start", .prior = 1.0, .spread = 0.7}},
                         .channels = rig_channels(laser_channels, laser_noise),
                         .variants = &laser_variants(),
                         .sources = {{.id = "unknown_lamp", .place = "bottom", .or_at = {"bulk"}, .signal = "lamp"},
                                     {.id = "unknown_lamp", .place = "bottom", .or_at = {"bulk"}, .signal = "time"}},
                         .draw = draw_laser,
                         .drive = drive_of_laser,
                         .log = log_laser,
                         .interval = 5.0,
                         .tolerance = 1e-3,
                         .oracle_error = 1e-3,
                         .size_error = 0.05,
                         .costly = true};
    return rig;
}

}  // namespace hidden_effects
