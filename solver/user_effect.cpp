// SPDX-License-Identifier: BSD-3-Clause
// Effects that a user writes: their signals as tables, their places, and what can be wrong with them.
#include "solver/user_effect.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "physics/user_effect_place.hpp"

namespace tiretherm::solver {

namespace {

/// How long a jump of a signal takes, since a table has one value at a time: at most this, s, and this share of the
/// time to the next point.
constexpr double jump_width = 1e-3;
constexpr double jump_share = 1e-3;

double width_of_jump(const SignalHistory& history, std::size_t point) {
    const double t = history.time[point];
    const auto next = std::upper_bound(history.time.begin(), history.time.end(), t);
    return next == history.time.end() ? jump_width : std::min(jump_width, jump_share * (*next - t));
}

/// The points that count, a jump as a short ramp whose two ends are in `stops`.
SignalHistory tidy(const SignalHistory& history, std::vector<double>& stops) {
    SignalHistory kept;
    for (std::size_t i = 0; i < history.time.size(); ++i) {
        if (!std::isfinite(history.value[i]) || !std::isfinite(history.time[i])) {
            continue;
        }
        double t = history.time[i];
        if (!kept.time.empty() && t <= kept.time.back()) {
            if (history.value[i] == kept.value.back()) {
                continue;
            }
            stops.push_back(kept.time.back());
            t = kept.time.back() + width_of_jump(history, i);
            stops.push_back(t);
        }
        kept.time.push_back(t);
        kept.value.push_back(history.value[i]);
    }
    return kept;
}

/// A signal as an effect's table, against the time since the run's start; the steps see its points.
physics::Curve table_of(const SignalHistory& history, InputSignals& input_signals) {
    std::vector<double> stops;
    SignalHistory kept = tidy(history, stops);
    input_signals.add_sample_times(kept.time);
    input_signals.add_break_times(stops);
    for (double& t : kept.time) {
        t = input_signals.at(t, JumpSide::before).time;
    }
    return physics::Curve::table(std::move(kept.time), std::move(kept.value));
}

std::vector<int> nodes_of(const Problem& problem, const UserEffect& user_effect) {
    std::vector<int> nodes;
    for (const std::string& place : user_effect.places) {
        for (const int node : physics::nodes_of_place(problem.mesh, place)) {
            if (std::ranges::find(nodes, node) == nodes.end()) {
                nodes.push_back(node);
            }
        }
    }
    return nodes;
}

/// @param negative why no value may be below 0; empty: it may  @returns whether one is
bool check_history(const SignalHistory& history, std::string_view what, std::string_view negative,
                   std::vector<UserEffectDefect>& found) {
    if (history.time.size() != history.value.size() || !std::ranges::is_sorted(history.time)) {
        found.push_back({fmt::format("the times of {} go backwards, or are not as many as its values", what)});
        return false;
    }
    const auto finite = [](double value) { return std::isfinite(value); };
    if (std::ranges::none_of(history.value, finite)) {
        found.push_back({fmt::format("{} is not a finite number at any time", what)});
        return false;
    }
    const auto below = std::ranges::find_if(history.value, [](double value) { return value < 0.0; });
    if (negative.empty() || below == history.value.end()) {
        return false;
    }
    const double t = history.time[static_cast<std::size_t>(below - history.value.begin())];
    found.push_back({fmt::format("{} is {:.6g} at {:.6g} s: {}", what, *below, t, negative)});
    return true;
}

}  // namespace

std::vector<UserEffectDefect> defects(const Problem& problem, const UserEffect& user_effect) {
    std::vector<UserEffectDefect> found;
    if (user_effect.name.empty() || physics::find_effect(user_effect.name) != nullptr ||
        find_user_effect(problem, user_effect.name) < problem.effects.size()) {
        found.push_back({fmt::format("the name \"{}\" is empty or taken", user_effect.name)});
    }
    for (const std::string& place : user_effect.places) {
        if (physics::nodes_of_place(problem.mesh, place).empty()) {
            found.push_back({fmt::format("the mesh has no region, layer, zone or patch \"{}\"", place)});
        }
    }
    const std::vector<int> nodes = nodes_of(problem, user_effect);
    if (user_effect.places.empty()) {
        found.push_back({"it acts nowhere"});
    } else if (!nodes.empty() && physics::shares_of_nodes(problem.mesh, problem.materials, nodes).empty()) {
        found.push_back({"its places are surfaces and volumes, which cannot share by area and by heat capacity"});
    }
    if (check_history(user_effect.signal, "the signal", user_effect.exchange ? "a conductance cannot be negative" : "",
                      found)) {
        found.back().is_negative_signal = true;
    }
    if (user_effect.exchange && !user_effect.surroundings.time.empty()) {
        check_history(user_effect.surroundings, "the temperature of the surroundings", "no temperature in kelvin",
                      found);
    }
    if (!std::isfinite(user_effect.amount) || (user_effect.exchange && user_effect.amount < 0.0)) {
        found.push_back(
            {fmt::format("{} is no {}", user_effect.amount, user_effect.exchange ? "conductance" : "heat")});
    }
    return found;
}

std::size_t add_user_effect(Problem& problem, const UserEffect& user_effect) {
    if (const std::vector<UserEffectDefect> found = defects(problem, user_effect); !found.empty()) {
        throw std::invalid_argument(fmt::format("{}: {}", user_effect.name, found.front().what));
    }
    physics::ActiveEffect active =
        physics::activate(*physics::find_effect(user_effect.exchange ? "own_exchange" : "own_source"), problem.mesh);
    active.name = user_effect.name;
    active.parameters.front() = user_effect.amount;
    active.nodes = nodes_of(problem, user_effect);
    active.tables[0] = table_of(user_effect.signal, problem.input_signals);
    if (user_effect.exchange && !user_effect.surroundings.time.empty()) {
        active.tables[1] = table_of(user_effect.surroundings, problem.input_signals);
    }
    return switch_on(problem, std::move(active), 0.0);
}

std::size_t find_user_effect(const Problem& problem, std::string_view name) {
    const auto found = std::ranges::find_if(problem.effects, [&](const physics::ActiveEffect& active) {
        return !active.name.empty() && active.name == name;
    });
    return static_cast<std::size_t>(found - problem.effects.begin());
}

bool give_law(Problem& problem, std::string_view name, std::shared_ptr<const physics::OwnLaw> law) {
    const std::size_t e = find_user_effect(problem, name);
    if (e == problem.effects.size() || problem.effects[e].effect->id != "own_source") {
        return false;
    }
    problem.effects[e].law = std::move(law);
    return true;
}

void take_laws(const Problem& from, Problem& to) {
    for (const physics::ActiveEffect& active : from.effects) {
        if (active.law) {
            static_cast<void>(give_law(to, active.name, active.law));
        }
    }
}

}  // namespace tiretherm::solver
