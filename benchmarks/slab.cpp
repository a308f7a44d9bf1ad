// SPDX-License-Identifier: BSD-3-Clause
// A rubber slab under a laser (3-D, k of temperature), the same mesh and physics solved twice in one run: by tiretherm,
// and by SUNDIALS CVODE (BDF, unpreconditioned GMRES) on a right-hand side written out by hand over the same cells and
// faces. Both report the error of the spot's centre at 600 s against the converged value (113.937 degC, from Richardson
// extrapolation) in percent of its rise; the ratio is fair when both stay below half a percent.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spgmr.h>

#include "benchmarks/ratio.hpp"
#include "mesh/builders.hpp"
#include "mesh/probe.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::benchmarks {

namespace {

constexpr double T_air = 296.15;
constexpr double h = 10.0;
constexpr double spot_radius = 5.6419e-3;  // a disc of 1 cm2
constexpr double heat_per_volume = 1100.0 * 1800.0;
constexpr double reference_rise = 113.937 - 23.0;

physics::Material rubber(double k20, double slope) {
    const physics::Curve k = physics::Curve::quadratic_about(293.15, k20, slope, 0.0);
    return {.name = "rubber",
            .density = 1100.0,
            .heat_capacity = physics::Curve::constant(1800.0),
            .conductivity = {k, k, k}};
}

solver::Problem slab() {
    solver::Problem problem;
    const std::vector<mesh::Segment> side{{.to = 0.00564, .cells = 10}, {.to = 0.03, .cells = 10, .ratio = 6.0}};
    problem.mesh = mesh::build(mesh::Block{.x = side,
                                           .y = side,
                                           .stack = {{.name = "tread", .thickness = 0.003, .cells = 8, .ratio = 4.0},
                                                     {.name = "bulk", .thickness = 0.012, .cells = 30, .ratio = 0.7}}});
    problem.materials = {rubber(0.29, 0.0094), rubber(0.060, 0.0002)};
    for (const char* id : {"conduction", "laser", "still_air"}) {
        solver::switch_on(problem, physics::activate(*physics::find_effect(id), problem.mesh), T_air);
    }
    problem.input_signals.add(*physics::find_signal("laser_power"), 1.0);
    problem.input_signals.add(*physics::find_signal("air_temperature"), T_air);
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), T_air);
    problem.settings.end = 600.0;
    problem.settings.tolerance = 0.2;
    problem.channels = {{.name = "top", .meaning = "", .where = mesh::at_point(problem.mesh, {0.0, 0.0, 0.0})}};
    return problem;
}

double error_percent(double T_top) { return 100.0 * std::abs(T_top - 273.15 - 23.0 - reference_rise) / reference_rise; }

/// The right-hand side by hand: one loop over inner faces, one over the two cooled surfaces, one over the spot.
struct Diffusion {
    explicit Diffusion(const solver::Problem& problem)
        : mesh(problem.mesh), k_now(static_cast<std::size_t>(mesh.n_cells)) {
        laser.assign(static_cast<std::size_t>(mesh.n_nodes), 0.0);
        const int top = mesh.find_patch("top");
        const std::vector<double> lit = mesh::disc_overlap(mesh, top, spot_radius);
        for (std::size_t f = 0; f < lit.size(); ++f) {
            const int node = mesh.patches[static_cast<std::size_t>(top)].faces[f].node;
            laser[static_cast<std::size_t>(node)] = lit[f] / (std::numbers::pi * spot_radius * spot_radius);
        }
        for (const mesh::Face& face : mesh.faces) {
            (face.b < mesh.n_cells ? inner : outer).push_back(face);
        }
    }

    [[nodiscard]] double k(int cell, double T) const {
        return mesh.layer[static_cast<std::size_t>(cell)] == 0 ? 0.29 + 0.0094 * (T - 293.15)
                                                               : 0.060 + 0.0002 * (T - 293.15);
    }

    void operator()(const double* T, double* rate) {
        for (int i = 0; i < mesh.n_cells; ++i) {
            k_now[static_cast<std::size_t>(i)] = k(i, T[i]);
            rate[i] = 0.0;
        }
        for (const mesh::Face& face : inner) {
            const double flux = face.area * (T[face.b] - T[face.a]) /
                                (face.half_a / k_now[static_cast<std::size_t>(face.a)] +
                                 face.half_b / k_now[static_cast<std::size_t>(face.b)]);
            rate[face.a] += flux;
            rate[face.b] -= flux;
        }
        for (const mesh::Face& face : outer) {
            const double G = face.area * k_now[static_cast<std::size_t>(face.a)] / face.half_a;
            rate[face.a] += G * (surface(face, T[face.a]) - T[face.a]);
        }
        for (int i = 0; i < mesh.n_cells; ++i) {
            rate[i] /= heat_per_volume * mesh.volume[static_cast<std::size_t>(i)];
        }
    }

    /// A surface without capacity takes the temperature that balances it.
    [[nodiscard]] double surface(const mesh::Face& face, double T_cell) const {
        const double G = face.area * k(face.a, T_cell) / face.half_a;
        return (G * T_cell + h * face.area * T_air + laser[static_cast<std::size_t>(face.b)]) / (G + h * face.area);
    }

    const mesh::Mesh& mesh;
    std::vector<mesh::Face> inner;
    std::vector<mesh::Face> outer;
    std::vector<double> laser;  ///< [n_nodes] W of the 1 W
    std::vector<double> k_now;
};

double by_cvode(const solver::Problem& problem) {
    Diffusion f(problem);
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    N_Vector state = N_VNew_Serial(problem.mesh.n_cells, context);
    N_VConst(T_air, state);
    void* memory = CVodeCreate(CV_BDF, context);
    CVodeInit(
        memory,
        [](realtype, N_Vector T, N_Vector rate, void* user) {
            (*static_cast<Diffusion*>(user))(N_VGetArrayPointer(T), N_VGetArrayPointer(rate));
            return 0;
        },
        0.0, state);
    CVodeSetUserData(memory, &f);
    CVodeSStolerances(memory, 1e-4, 1e-2);
    SUNLinearSolver linear = SUNLinSol_SPGMR(state, SUN_PREC_NONE, 30, context);
    CVodeSetLinearSolver(memory, linear, nullptr);
    CVodeSetMaxNumSteps(memory, 100000);
    double reached = 0.0;
    CVode(memory, 600.0, state, &reached, CV_NORMAL);

    const double* T = N_VGetArrayPointer(state);
    std::vector<double> nodes(static_cast<std::size_t>(problem.mesh.n_nodes));
    std::copy(T, T + problem.mesh.n_cells, nodes.begin());
    for (const mesh::Face& face : f.outer) {
        nodes[static_cast<std::size_t>(face.b)] = f.surface(face, T[face.a]);
    }
    CVodeFree(&memory);
    SUNLinSolFree(linear);
    N_VDestroy(state);
    SUNContext_Free(&context);
    return problem.channels[0].where(nodes);
}

void slab_by_tiretherm(benchmark::State& state) {
    const solver::Problem problem = slab();
    double top = 0.0;
    for (auto _ : state) {
        top = solver::run(problem, nullptr).channel_final[0];
    }
    state.counters["error_%"] = error_percent(top);
}

void slab_by_cvode(benchmark::State& state) {
    const solver::Problem problem = slab();
    double top = 0.0;
    for (auto _ : state) {
        top = by_cvode(problem);
    }
    state.counters["error_%"] = error_percent(top);
}

BENCHMARK(slab_by_tiretherm)->Unit(benchmark::kMillisecond)->Iterations(1)->Repetitions(3)->ReportAggregatesOnly();
BENCHMARK(slab_by_cvode)->Unit(benchmark::kMillisecond)->Iterations(1)->Repetitions(3)->ReportAggregatesOnly();

}  // namespace

}  // namespace tiretherm::benchmarks

int main(int argc, char** argv) { return tiretherm::benchmarks::main_with_ratios(argc, argv); }
