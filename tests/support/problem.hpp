// SPDX-License-Identifier: BSD-3-Clause
// What the tests share: problems put together by hand, and runs that must close their energy balance.
#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"
#include "mesh/probe.hpp"
#include "solver/time_integration/march.hpp"

/// What tests share: problems put together by hand, runs that must close their energy balance, exact solutions and
/// independent integrators. Headers only.
namespace tiretherm::support {

/// A material with the same conductivity in all directions.
inline physics::Material material(const physics::Curve& conductivity, double density,
                                  const physics::Curve& heat_capacity) {
    return {.name = "rubber",
            .density = density,
            .heat_capacity = heat_capacity,
            .conductivity = {conductivity, conductivity, conductivity}};
}

inline physics::Material material(double conductivity, double density, double heat_capacity) {
    return material(physics::Curve::constant(conductivity), density, physics::Curve::constant(heat_capacity));
}

using Numbers = std::initializer_list<std::pair<std::string_view, double>>;

/// Adds an effect to a problem whose mesh, materials and tire are in place.
/// @param patches where it acts; empty: its standard patches
inline void switch_on(solver::Problem& problem, const physics::Effect& effect, Numbers numbers = {},
                      std::initializer_list<std::string_view> patches = {}) {
    physics::ActiveEffect active = physics::activate(effect, problem.mesh);
    for (const auto& [key, value] : numbers) {
        const int index = physics::find_parameter(effect, key);
        ASSERT_GE(index, 0) << effect.id << " has no parameter " << key;
        active.parameters[static_cast<std::size_t>(index)] = value;
    }
    if (patches.size() > 0) {
        active.patches.clear();
        for (const std::string_view name : patches) {
            ASSERT_GE(problem.mesh.find_patch(name), 0) << "the mesh has no patch " << name;
            active.patches.push_back(problem.mesh.find_patch(name));
        }
    }
    solver::switch_on(problem, std::move(active), 293.15);
}

inline void switch_on(solver::Problem& problem, std::string_view id, Numbers numbers = {},
                      std::initializer_list<std::string_view> patches = {}) {
    const physics::Effect* effect = physics::find_effect(id);
    ASSERT_NE(effect, nullptr) << "there is no effect " << id;
    switch_on(problem, *effect, numbers, patches);
}

/// Takes another option of a choice of the effect that was switched on last.
inline void choose(solver::Problem& problem, std::string_view key, int option) {
    physics::ActiveEffect& active = problem.effects.back();
    const int choice = physics::find_choice(*active.effect, key);
    ASSERT_GE(choice, 0) << active.effect->id << " has no choice " << key;
    active.choices[static_cast<std::size_t>(choice)] = option;
}

inline const physics::Signal& signal(std::string_view name) { return *physics::find_signal(name); }

inline void hold(solver::Problem& problem, std::string_view name, double value) {
    problem.input_signals.add(signal(name), value);
}

/// A schedule: the step ends on each of its points.
inline void schedule(solver::Problem& problem, std::string_view name, std::vector<double> time,
                     std::vector<double> value) {
    problem.input_signals.add(
        solver::Series{.signal = &signal(name), .time = std::move(time), .value = std::move(value), .logged = false});
}

/// A logger's samples: steps may span them.
inline void log(solver::Problem& problem, std::string_view name, std::vector<double> time, std::vector<double> value) {
    problem.input_signals.add(
        solver::Series{.signal = &signal(name), .time = std::move(time), .value = std::move(value), .logged = true});
}

inline void start_at(solver::Problem& problem, double temperature) {
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), temperature);
}

inline void read(solver::Problem& problem, std::string_view name, mesh::Functional where) {
    problem.channels.push_back({.name = std::string(name), .meaning = "", .where = std::move(where)});
}

/// Heat stored beside heat attributed, of the heat turned over: what every run of these tests must keep to (DESIGN.md
/// section 5). Sums of some 1e4 cells and 1e3 steps in double precision stay two digits below it.
inline constexpr double energy_closure = 1e-10;

/// Runs a problem, which must be sound, end well and close its energy balance.
inline solver::MarchReport run_closed(const solver::Problem& problem, const solver::Observer& observer = nullptr) {
    EXPECT_EQ(solver::defects(problem), std::vector<std::string>{});
    solver::MarchReport report = solver::run(problem, observer);
    if (!report.status.ok()) {
        throw std::runtime_error(report.status.message);  // fails the test: nothing can be read from this run
    }
    EXPECT_LE(report.energy_closure, energy_closure) << problem.title;
    return report;
}

/// One row for every reported time: the channels and the stored heat.
struct History {
    std::vector<double> time;
    std::vector<std::vector<double>> channels;
    std::vector<double> stored;
    solver::MarchReport report;
};

inline History record(const solver::Problem& problem) {
    History history;
    history.report = run_closed(problem, [&](const solver::Snapshot& now) {
        history.time.push_back(now.time);
        history.channels.emplace_back(now.channels.begin(), now.channels.end());
        history.stored.push_back(now.stored);
        return true;
    });
    return history;
}

/// The whole field at the end of a run. @returns [n_nodes] K
inline std::vector<double> final_field(const solver::Problem& problem) {
    std::vector<double> field;
    const solver::MarchReport report = run_closed(problem, [&](const solver::Snapshot& now) {
        field.assign(now.temperature.begin(), now.temperature.end());
        return true;
    });
    return field;
}

}  // namespace tiretherm::support
