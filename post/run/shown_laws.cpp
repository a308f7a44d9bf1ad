// SPDX-License-Identifier: BSD-3-Clause
// Laws at round loads up to one and a half times the highest of the drive, and their charts.

#include "post/run/shown_laws.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "post/page/charts.hpp"
#include "post/run/tire_laws.hpp"

namespace tiretherm::post {

namespace {

/// The inputs at which the laws are shown: those of the start at another load, at the pressure where the laws hold.
physics::Inputs at_load(const solver::Problem& problem, double load) {
    physics::Inputs inputs = problem.input_signals.at(problem.settings.start, solver::JumpSide::after);
    inputs.vertical_load = load;
    inputs.camber = 0.0;
    if (problem.tire.reference_pressure > 0.0) {
        inputs.inflation_pressure = problem.tire.reference_pressure;
    }
    return inputs;
}

/// Loads of a smooth curve. N
std::vector<double> fine_loads(double highest) {
    std::vector<double> loads;
    for (int i = 1; i <= 120; ++i) {
        loads.push_back(highest * i / 120.0);
    }
    return loads;
}

}  // namespace

std::vector<double> shown_loads(const solver::Problem& problem) {
    double highest = problem.input_signals.constants().vertical_load;
    for (const solver::Series& series : problem.input_signals.series()) {
        if (series.signal->member == &physics::Inputs::vertical_load && !series.value.empty()) {
            highest = std::max(highest, *std::ranges::max_element(series.value));
        }
    }
    highest *= 1.5;
    for (const ShownLaw& law : shown_laws) {
        if (const std::optional<physics::Curve>& measured = problem.handling.measured.*law.measured) {
            highest = std::max(highest, measured->table_x().back());
        }
    }
    for (const physics::StiffnessPoint& point : problem.handling.measured.cornering_stiffness) {
        highest = std::max(highest, point.load);
    }
    constexpr double thesis_load = 4000.0;  // N, where the drive has none
    const double step = round_step((highest > 0.0 ? highest : thesis_load) / 6.0);
    std::vector<double> loads;
    for (int i = 1; i <= 6; ++i) {
        loads.push_back(i * step);
    }
    return loads;
}

StiffnessMap stiffness_map(const solver::Problem& problem) {
    const std::optional<physics::GridTable>& table = problem.handling.stiffness_table;
    const auto axis = [&](double physics::Inputs::*input, std::vector<double> standard) {
        const physics::GridTable::Axis* found = table ? table->find(input) : nullptr;
        return found != nullptr ? found->at : standard;
    };
    return {.loads = axis(&physics::Inputs::vertical_load, shown_loads(problem)),
            .temperatures = axis(nullptr, {273.15, 293.15, 313.15, 333.15, 353.15, 373.15, 393.15})};
}

double shown_stiffness(const solver::Problem& problem, double load, double T) {
    return problem.handling.cornering_stiffness(problem.tire, at_load(problem, load), T);
}

void add_law_charts(ReportSection& section, const solver::Problem& problem) {
    const std::vector<double> loads = fine_loads(shown_loads(problem).back());
    const std::vector<double> shown_x = scaled(loads, 1e-3);
    for (std::size_t i = 0; i < shown_laws.size();) {
        const std::string title = shown_laws[i].chart;
        LineChart chart("load", "kN", 0.0, shown_x.back());
        for (; i < shown_laws.size() && shown_laws[i].chart == title; ++i) {
            const ShownLaw& law = shown_laws[i];
            chart.add_panel(law.name, law.unit);
            std::vector<double> values;
            std::ranges::transform(loads, std::back_inserter(values),
                                   [&](double load) { return law.factor * (problem.tire.*law.law)(load); });
            chart.add_curve(law.name, law.name, CurveRole::line, shown_x, values);
            if (const std::optional<physics::Curve>& points = problem.handling.measured.*law.measured) {
                const auto x = points->table_x();
                const auto y = points->table_y();
                chart.add_curve(fmt::format("{}, measured", law.name), law.name, CurveRole::points,
                                scaled({x.begin(), x.end()}, 1e-3), scaled({y.begin(), y.end()}, law.factor));
            }
        }
        section.chart(title + " against load", "The law of the case, and what [tire.measured] gives.", chart.data());
    }
}

void add_stiffness_chart(ReportSection& section, const solver::Problem& problem) {
    const StiffnessMap map = stiffness_map(problem);
    const std::vector<double> loads = fine_loads(std::max(map.loads.back(), shown_loads(problem).back()));
    const std::vector<double> shown_x = scaled(loads, 1e-3);
    LineChart chart("load", "kN", 0.0, shown_x.back());
    chart.add_panel("cornering stiffness", "kN/rad");
    const auto at = [](double T) { return fmt::format("{:.4g} °C", celsius(T)); };
    for (const double T : map.temperatures) {
        std::vector<double> values;
        std::ranges::transform(loads, std::back_inserter(values),
                               [&](double load) { return 1e-3 * shown_stiffness(problem, load, T); });
        chart.add_curve(at(T), at(T), CurveRole::line, shown_x, values);
    }
    std::map<double, std::array<std::vector<double>, 2>> measured;  // load and stiffness by temperature
    for (const physics::StiffnessPoint& point : problem.handling.measured.cornering_stiffness) {
        auto& [x, y] = measured[point.temperature];
        x.push_back(1e-3 * point.load);
        y.push_back(1e-3 * point.stiffness);
    }
    for (const auto& [T, points] : measured) {
        chart.add_curve("measured at " + at(T), at(T), CurveRole::points, points[0], points[1]);
    }
    section.chart("Cornering stiffness against load",
                  "At temperatures of the bulk. As numbers: " + std::string(stiffness_name) + ".", chart.data());
}

}  // namespace tiretherm::post
