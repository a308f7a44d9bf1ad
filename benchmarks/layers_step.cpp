// SPDX-License-Identifier: BSD-3-Clause
// One real-time step of 100 cells through the thickness, against the least that any implicit solver must do: one
// factorisation and one solve of a tridiagonal system by Thomas's algorithm.
#include <vector>

#include "benchmarks/ratio.hpp"
#include "mesh/builders.hpp"
#include "solver/time_integration/session.hpp"

namespace tiretherm::benchmarks {

namespace {

constexpr int cells = 100;

void thomas_factor_and_solve(benchmark::State& state) {
    std::vector<double> lower(cells, -1.0);
    std::vector<double> diagonal(cells, 2.5);
    std::vector<double> upper(cells, -1.0);
    std::vector<double> right(cells, 1.0);
    std::vector<double> ratio(cells);
    std::vector<double> x(cells);
    for (auto _ : state) {
        benchmark::DoNotOptimize(diagonal.data());
        ratio[0] = upper[0] / diagonal[0];
        x[0] = right[0] / diagonal[0];
        for (std::size_t i = 1; i < cells; ++i) {
            const double pivot = diagonal[i] - lower[i] * ratio[i - 1];
            ratio[i] = upper[i] / pivot;
            x[i] = (right[i] - lower[i] * x[i - 1]) / pivot;
        }
        for (std::size_t i = cells - 1; i-- > 0;) {
            x[i] -= ratio[i] * x[i + 1];
        }
        benchmark::DoNotOptimize(x.data());
    }
}

void session_step(benchmark::State& state) {
    solver::Problem problem;
    problem.mesh =
        mesh::build(mesh::Layers{.area = 0.47, .stack = {{.name = "rubber", .thickness = 0.012, .cells = cells}}});
    const physics::Curve k = physics::Curve::constant(0.29);
    problem.materials = {{.name = "rubber",
                          .density = 1100.0,
                          .heat_capacity = physics::Curve::constant(1800.0),
                          .conductivity = {k, k, k}}};
    for (const char* id : {"conduction", "air_convection", "road_contact", "strain_energy_loss", "sliding_friction"}) {
        solver::switch_on(problem, physics::activate(*physics::find_effect(id), problem.mesh), 300.0);
    }
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), 300.0);
    const physics::Inputs inputs{
        .speed = 30.0, .vertical_load = 4000.0, .air_temperature = 296.15, .road_temperature = 300.0};
    if (state.range(0) == 1) {
        problem.settings.method = solver::Method::backward_euler;
    }
    solver::Session session(problem, inputs);
    for (auto _ : state) {
        if (!session.advance(0.001, inputs).ok()) {
            state.SkipWithError("the step failed");
        }
    }
}

BENCHMARK(thomas_factor_and_solve);
BENCHMARK(session_step)->ArgName("backward_euler")->Arg(0)->Arg(1);

}  // namespace

}  // namespace tiretherm::benchmarks

int main(int argc, char** argv) { return tiretherm::benchmarks::main_with_ratios(argc, argv); }
