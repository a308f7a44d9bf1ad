// SPDX-License-Identifier: BSD-3-Clause
// One hour of driving with inputs logged every second, on a section of 24 x 64 cells, error-controlled to 0.05 K: beside
// the same hour at constant inputs, which costs what the field alone asks for. Counters: steps, and the shares of the
// wall time.
#include "benchmarks/ratio.hpp"
#include "benchmarks/rolling_section.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::benchmarks {

namespace {

void run(benchmark::State& state, void (*drive)(solver::Problem&)) {
    solver::Problem problem = rolling_section();
    drive(problem);
    solver::MarchReport report;
    for (auto _ : state) {
        report = solver::run(problem, [](const solver::Snapshot&) { return true; });
        if (!report.status.ok()) {
            state.SkipWithError(report.status.message.c_str());
        }
    }
    state.counters["steps"] = static_cast<double>(report.steps);
    state.counters["rejected"] = static_cast<double>(report.rejected);
    state.counters["factors"] = static_cast<double>(report.factorisations);
    state.counters["newton"] = static_cast<double>(report.newton_iterations);
    state.counters["linear"] = static_cast<double>(report.linear_iterations);
    const char* parts[] = {"assembly_s", "factor_s", "solve_s", "output_s"};
    for (std::size_t i = 0; i < 4; ++i) {
        state.counters[parts[i]] = report.seconds[i];
    }
}

void hour_at_constant_inputs(benchmark::State& state) { run(state, drive_constant); }
void hour_of_logged_driving(benchmark::State& state) { run(state, drive_logged); }

BENCHMARK(hour_at_constant_inputs)->Unit(benchmark::kMillisecond);
BENCHMARK(hour_of_logged_driving)->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace tiretherm::benchmarks

int main(int argc, char** argv) { return tiretherm::benchmarks::main_with_ratios(argc, argv); }
