// SPDX-License-Identifier: BSD-3-Clause
// What a run cost: cells, steps, factorisations, time by part.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "post/report/table.hpp"
#include "post/run/run_sections.hpp"

namespace tiretherm::post {

ReportSection cost_section(const RunRecord& run) {
    const solver::MarchReport& report = run.report;
    const mesh::Mesh& mesh = run.problem.mesh;
    const bool round = mesh.is_axisymmetric();
    std::string layers;
    for (const std::string& name : mesh.layers) {
        layers += (layers.empty() ? "" : ", ") + name;
    }
    const auto in_groups = [](auto n) { return grouped(static_cast<double>(n)); };
    DataTable table;
    const auto add = [&](const char* name, std::string text) {
        table.add({page_only("", name), page_only("", std::move(text))});
    };
    add("mesh", fmt::format("{}{}, {} cells, layers {}", mesh.kind, round ? " about its axis" : "",
                            grouped(mesh.n_cells), layers));
    if (run.problem.settings.steady) {
        add("steps", fmt::format("steady state; {} factorisations, {} Newton iterations",
                                 in_groups(report.factorisations), in_groups(report.newton_iterations)));
    } else {
        add("steps", fmt::format("{}, {} rejected, {} factorisations", in_groups(report.steps),
                                 in_groups(report.rejected), in_groups(report.factorisations)));
    }
    add("solver", report.linear_solver);
    std::string time = fmt::format("{:.3f} s", run.seconds);
    if (report.simulated > 0.0 && run.seconds > 0.0) {
        const double ratio = report.simulated / run.seconds;
        time += fmt::format(" for {:.6g} s, {} x real time", report.simulated,
                            ratio < 10.0 ? fmt::format("{:.2g}", ratio) : grouped(ratio));
    }
    constexpr std::array parts{"assembly", "factor", "solve", "output"};
    for (std::size_t i = 0; i < std::min(parts.size(), report.seconds.size()); ++i) {
        time += fmt::format("{}{} {:.3f}", i == 0 ? "; " : ", ", parts[i], report.seconds[i]);
    }
    add("time", time);
    return {"Cost", std::move(table)};
}

}  // namespace tiretherm::post
