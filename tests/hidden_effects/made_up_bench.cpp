// SPDX-License-Identifier: BSD-3-Clause
// Draws programme, parameters and noise from a seed and writes the logs that the program then reads.

#include "hidden_effects/made_up_bench.hpp"

#include <stdexcept>

#include "input/measurements/measured_bench.hpp"
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

}  // namespace

MadeUpBench make_up_bench(std::uint64_t seed, double interval, const Maker& maker, const std::vector<Cause>& causes) {
    Random random(seed);
    MadeUpBench made;
    made.lambda_h = 1.0 + 0.07 * random.normal();
    made.lambda_sel = 1.0 + 0.07 * random.normal();
    for (std::uint64_t run = 1; run <= 3; ++run) {
        const Programme programme = maker(10 * seed + run, interval);
        made.surface_start.push_back(2.0 * random.normal());
        made.bulk_start.push_back(2.0 * random.normal());
        const double air = programme.air_temperature.front();
        // A local error of 1e-6 K is a hundred-thousandth of the noise.
        BenchTrace trace = drive_bench({.lambda_h = made.lambda_h,
                                        .lambda_sel = made.lambda_sel,
                                        .surface_start = air + made.surface_start.back(),
                                        .bulk_start = air + made.bulk_start.back(),
                                        .causes = causes},
                                       programme, 1e-6);
        add(trace.surface, draw_noise(camera, programme.time, random));
        add(trace.bulk, draw_noise(probe, programme.time, random));
        made.logs.push_back(bench_columns(programme, trace));
    }
    return made;
}

double MadeUpBench::truth_of(const tiretherm::solver::FreeParameter& parameter) const {
    if (!parameter.runs.empty()) {
        const std::size_t run = parameter.runs.front();
        return parameter.name.starts_with("initial surface") ? surface_start[run] : bulk_start[run];
    }
    if (parameter.name == "air_convection.lambda_h") {
        return lambda_h;
    }
    if (parameter.name == "strain_energy_loss.tan_delta_a") {
        return 2.14e15 * lambda_sel;
    }
    if (parameter.name.starts_with("link.conductivity")) {
        return 0.29 + 0.00943 * (parameter.knots.front() - 293.15);
    }
    throw std::invalid_argument("the bench has no " + parameter.name);
}

tiretherm::input::Experiment read_with(const std::filesystem::path& file,
                                       const std::vector<std::vector<Column>>& logs) {
    namespace input = tiretherm::input;
    const input::Written scratch;
    std::vector<std::filesystem::path> data;
    for (const std::vector<Column>& log : logs) {
        data.push_back(scratch.add("run" + std::to_string(data.size() + 1) + ".csv", written(log)));
    }
    input::ExperimentReading reading = input::read_experiment(file, data);
    if (!reading.experiment) {
        throw std::runtime_error(input::error_report(reading));
    }
    return std::move(*reading.experiment);
}

std::filesystem::path practice_case() {
    return tiretherm::input::source_folder() / "cases/practice/two_node_bench.toml";
}

}  // namespace hidden_effects
