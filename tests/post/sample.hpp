// SPDX-License-Identifier: BSD-3-Clause
// A small case and hand-made snapshots with a known linear field, shared by the tests of post/.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mesh/builders.hpp"
#include "post/run/run_report.hpp"
#include "solver/time_integration/march.hpp"
#include "tests/post/scratch.hpp"

/// What the tests of post/ share: a small case and moments of it that no solver made.
namespace tiretherm::sample {

inline mesh::Mesh axisymmetric() {
    return mesh::build(mesh::Axisymmetric{.radius = {{.to = 0.02, .cells = 4}},
                                          .stack = {{.name = "tread", .thickness = 0.008, .cells = 4},
                                                    {.name = "bulk", .thickness = 0.004, .cells = 2}}});
}

/// Two layers under a laser, 24 cells, two channels with a measured value each.
inline solver::Problem problem(mesh::Mesh mesh = axisymmetric()) {
    solver::Problem problem;
    problem.name = "sample/spot";
    problem.title = "A warm spot";
    problem.sources = {"A thesis, chapter III", "A paper"};
    problem.mesh = std::move(mesh);
    problem.materials.resize(problem.mesh.layers.size());
    for (physics::Material& material : problem.materials) {
        material.conductivity.fill(physics::Curve::constant(0.3));
    }
    for (const char* id : {"conduction", "laser", "still_air"}) {
        problem.effects.push_back(physics::activate(*physics::find_effect(id), problem.mesh));
    }
    problem.settings.end = 60.0;
    problem.channels = {{.name = "spot", .meaning = "outer surface, mean over the spot", .where = {{0}, {1.0}}},
                        {.name = "liner", .meaning = "", .where = {{1}, {1.0}}}};
    problem.measured = {{.channel = "spot", .time = 60.0, .low = 358.15, .high = 358.15, .source = "camera"},
                        {.channel = "liner", .time = 30.0, .low = 310.15, .high = 320.15, .source = "thermocouple"}};
    return problem;
}

/// 26.85 degC at the outer surface, 2 K more each millimetre deeper, and one more each second: straight in depth, so
/// that interpolation is exact.
inline double warmth(double depth, double time) { return 300.0 + 2000.0 * depth + time; }

/// A moment and the arrays that its spans look at.
class Moment {
public:
    Moment(const solver::Problem& problem, double time, std::vector<double> channels, bool field)
        : channels_(std::move(channels)), watts_{0.0, 1.0, -0.25}, joules_{0.0, time, -0.1 * time} {
        for (const mesh::Point& centre : problem.mesh.centre) {
            temperature_.push_back(warmth(centre[2], time));
        }
        snapshot = {.time = time,
                    .temperature = temperature_,
                    .channels = channels_,
                    .watts = watts_,
                    .joules = joules_,
                    .stored = 0.9 * time,
                    .field = field};
    }
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;

    solver::Snapshot snapshot;

private:
    std::vector<double> temperature_;
    std::vector<double> channels_;
    std::vector<double> watts_;
    std::vector<double> joules_;
};

/// Rows at 0, 30 and 60 s.
inline post::History history(const solver::Problem& problem) {
    post::History history;
    history.take(Moment(problem, 0.0, {296.15, 296.15}, true).snapshot);
    history.take(Moment(problem, 30.0, {353.15, 303.15}, false).snapshot);
    history.take(Moment(problem, 60.0, {370.65, 313.15}, true).snapshot);
    return history;
}

inline solver::MarchReport report() {
    solver::MarchReport report;
    report.simulated = 60.0;
    report.steps = 1234;
    report.rejected = 5;
    report.factorisations = 6;
    report.linear_solver = "CHOLMOD simplicial, 99 entries in the factor";
    report.watts = {0.0, 1.0, -0.25};
    report.joules = {0.0, 60.0, -6.0};
    report.law_watts.assign(3, std::numeric_limits<double>::quiet_NaN());  // none of the three is a law
    report.stored = 54.0;
    report.energy_closure = 1.25e-13;
    report.effective_two_node_conductance = 0.125;
    report.hottest = {.temperature = 370.65, .time = 60.0, .node = 24};  // first node of the outer surface
    report.coldest = {.temperature = 296.15, .time = 0.0, .node = 23};   // last cell
    report.channel_final = {370.65, 313.15};
    report.channel_min = {296.15, 296.15};
    report.channel_max = {370.65, 313.15};
    report.warnings = {{.law = "air_convection is known up to 50 degC", .coldest = 293.15, .hottest = 330.15}};
    report.seconds = {0.001, 0.002, 0.003, 0.004};
    return report;
}

/// A crown, flat at 300 mm, and two sidewalls that turn by a quarter circle: 6 columns of 3 cells.
inline mesh::Mesh section() {
    mesh::Section d;
    d.meridian = mesh::Meridian(0.3, {{0.06, 0.0}, {0.08, 1.5707963267948966 / 0.08}});
    d.layers = {{"tread", 0.008, 2}, {"liner", 0.002, 1}};
    d.zones = {{"outside_sidewall", 0.08, 2, 1.0, {0, 1}, false},
               {"crown", 0.12, 2, 1.0, {0, 1}},
               {"inside_sidewall", 0.08, 2, 1.0, {0, 1}, false}};
    return mesh::build(d);
}

}  // namespace tiretherm::sample
