// SPDX-License-Identifier: BSD-3-Clause
// What 16 sensitivities cost on a section of 24 x 64 cells: an hour at constant inputs and ten minutes under a rough log,
// each alone over its steps, with the derivatives of its channels with 16 numbers, and with those of one sum of its channels
// with the heat of every step and node. The ratios to the run alone are the figures.
#include <cmath>
#include <string_view>
#include <vector>

#include "benchmarks/ratio.hpp"
#include "benchmarks/rolling_section.hpp"
#include "mesh/probe.hpp"
#include "solver/sensitivity/adjoint_record.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::benchmarks {

namespace {

solver::FreeParameter number(const solver::Problem& problem, std::string_view effect, std::string_view key) {
    solver::FreeParameter parameter{
        .name = std::string(key), .unit = {}, .layers = {}, .knots = {}, .nodes = {}, .runs = {}};
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        if (problem.effects[e].effect->id == effect) {
            parameter.effect = e;
            parameter.parameter = static_cast<std::size_t>(physics::find_parameter(*problem.effects[e].effect, key));
        }
    }
    return parameter;
}

solver::FreeParameter law(solver::FreeParameter::Kind kind, std::vector<int> layers, std::vector<double> knots,
                          std::size_t knot) {
    return {.name = "law",
            .unit = {},
            .kind = kind,
            .layers = std::move(layers),
            .knots = std::move(knots),
            .knot = knot,
            .nodes = {},
            .runs = {}};
}

/// Scales of every effect, conductivities and heat capacities of the layers, the start.
std::vector<solver::FreeParameter> sixteen(const solver::Problem& problem) {
    using Kind = solver::FreeParameter::Kind;
    const std::vector<double> knots{313.15, 363.15, 413.15};
    solver::FreeParameter start{
        .name = "start", .unit = "K", .kind = Kind::initial, .layers = {}, .knots = {}, .nodes = {}, .runs = {}};
    for (int node = 0; node < problem.mesh.n_nodes; ++node) {
        start.nodes.push_back(node);
    }
    return {number(problem, "strain_energy_loss", "lambda_srf"),
            number(problem, "strain_energy_loss", "lambda_blk"),
            number(problem, "strain_energy_loss", "tan_delta_a"),
            number(problem, "sliding_friction", "partition"),
            number(problem, "air_convection", "lambda_h"),
            number(problem, "air_convection", "exponent"),
            number(problem, "road_contact", "Hc"),
            number(problem, "sidewall_convection", "conductance"),
            number(problem, "inner_gas", "liner"),
            law(Kind::conductivity, {0}, knots, 0),
            law(Kind::conductivity, {0}, knots, 1),
            law(Kind::conductivity, {0}, knots, 2),
            law(Kind::conductivity, {1, 3, 4}, {363.15}, 0),
            law(Kind::heat_capacity, {0}, {363.15}, 0),
            law(Kind::heat_capacity, {1, 3, 4}, {363.15}, 0),
            start};
}

solver::Problem problem_of(void (*drive)(solver::Problem&), double end) {
    solver::Problem problem = rolling_section();
    drive(problem);
    problem.settings.end = end;
    for (const mesh::Region& region : problem.mesh.regions) {
        problem.channels.push_back({.name = region.name, .meaning = "", .where = region.mean});
    }
    return problem;
}

std::vector<double> times_until(double end) {
    std::vector<double> times;
    for (double t = 0.0; t <= end; t += 2.0) {
        times.push_back(t);
    }
    return times;
}

void run(benchmark::State& state, void (*drive)(solver::Problem&), double end, bool with_slopes) {
    const solver::Problem problem = problem_of(drive, end);
    const std::vector<double> times = times_until(end);
    const std::vector<solver::FreeParameter> parameters = sixteen(problem);
    std::vector<double> values;
    for (const solver::FreeParameter& parameter : parameters) {
        values.push_back(solver::value_of(problem, parameter));
    }
    const std::vector<double> steps = solver::predict(problem, {.times = times}).step_ends;
    solver::PredictionRequest request{.times = times, .step_ends = steps, .tolerance = 1e-3};
    if (with_slopes) {
        request.parameters = parameters;
        request.values = values;
    }
    for (auto _ : state) {
        const solver::Prediction prediction = solver::predict(problem, request);
        if (!prediction.status.ok()) {
            state.SkipWithError(prediction.status.message.c_str());
        }
    }
    state.counters["steps"] = static_cast<double>(steps.size());
}

void run_with_adjoint(benchmark::State& state, void (*drive)(solver::Problem&), double end) {
    const solver::Problem problem = problem_of(drive, end);
    const std::vector<double> times = times_until(end);
    const std::vector<double> steps = solver::predict(problem, {.times = times}).step_ends;
    const std::vector<double> weights(times.size() * problem.channels.size(), 1.0);
    double sum = 0.0;
    for (auto _ : state) {
        solver::AdjointRecord record(problem, times, steps);
        if (!record.status().ok()) {
            state.SkipWithError(record.status().message.c_str());
            return;
        }
        record.backward(
            1, weights, [&](std::size_t, std::span<const double> slopes) { sum += slopes.front(); }, 1e-3);
    }
    benchmark::DoNotOptimize(sum);
    state.counters["steps"] = static_cast<double>(steps.size());
}

void constant_alone(benchmark::State& state) { run(state, drive_constant, 3600.0, false); }
void constant_with_16(benchmark::State& state) { run(state, drive_constant, 3600.0, true); }
void constant_adjoint(benchmark::State& state) { run_with_adjoint(state, drive_constant, 3600.0); }
void logged_alone(benchmark::State& state) { run(state, drive_logged, 600.0, false); }
void logged_with_16(benchmark::State& state) { run(state, drive_logged, 600.0, true); }
void logged_adjoint(benchmark::State& state) { run_with_adjoint(state, drive_logged, 600.0); }

BENCHMARK(constant_alone)->Unit(benchmark::kMillisecond);
BENCHMARK(constant_with_16)->Unit(benchmark::kMillisecond);
BENCHMARK(constant_adjoint)->Unit(benchmark::kMillisecond);
BENCHMARK(logged_alone)->Unit(benchmark::kMillisecond);
BENCHMARK(logged_with_16)->Unit(benchmark::kMillisecond);
BENCHMARK(logged_adjoint)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace tiretherm::benchmarks

int main(int argc, char** argv) { return tiretherm::benchmarks::main_with_ratios(argc, argv); }
