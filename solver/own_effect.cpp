#include "solver/own_effect.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "physics/own_place.hpp"

namespace tiretherm::solver {

namespace {

/// How long a jump of a course takes, since a table has one value at a time. s
constexpr double jump_width = 1e-3;

/// The points that count, a jump as a short ramp whose two ends are in `stops`.
Course tidy(const Course& course, std::vector<double>& stops) {
    Course kept;
    for (std::size_t i = 0; i < course.time.size(); ++i) {
        if (!std::isfinite(course.value[i]) || !std::isfinite(course.time[i])) {
            continue;
        }
        double t = course.time[i];
        if (!kept.time.empty() && t <= kept.time.back()) {
            if (course.value[i] == kept.value.back()) {
                continue;
            }
            stops.push_back(kept.time.back());
            t = kept.time.back() + jump_width;
            stops.push_back(t);
        }
        kept.time.push_back(t);
        kept.value.push_back(course.value[i]);
    }
    return kept;
}

/// The same input with more points on it, so that the steps see them: the straight lines stay as they are.
void add_points(Drive& drive, const std::vector<double>& times, bool logged) {
    const std::vector<double>& known = logged ? drive.samples() : drive.stops();
    std::vector<double> missing;
    std::ranges::set_difference(times, known, std::back_inserter(missing));
    if (missing.empty()) {
        return;
    }
    // A constant input stays one. A series takes its own points along.
    const auto series = drive.series();
    const auto is_constant = [&](const physics::Signal& signal) {
        return drive.gives(signal) &&
               std::ranges::none_of(series, [&](const Series& s) { return s.signal == &signal; });
    };
    const auto constant = std::ranges::find_if(physics::signals(), is_constant);
    Series carrier{.signal = &physics::signals().front(), .time = times, .value = {}, .logged = logged};
    if (constant != physics::signals().end()) {
        carrier.signal = &*constant;
    } else if (!series.empty()) {
        carrier.signal = series.front().signal;
        carrier.time.clear();
        std::ranges::set_union(series.front().time, times, std::back_inserter(carrier.time));
    }
    for (std::size_t i = 0; i < carrier.time.size(); ++i) {
        const bool after = i > 0 && carrier.time[i] == carrier.time[i - 1];
        carrier.value.push_back(drive.at(carrier.time[i], after ? Limit::after : Limit::before).*
                                (carrier.signal->member));
    }
    drive.add(std::move(carrier));
}

/// A course as an effect's table, against the time since the run's start.
physics::Curve table_of(const Course& course, Drive& drive) {
    std::vector<double> stops;
    Course kept = tidy(course, stops);
    add_points(drive, kept.time, true);
    std::ranges::sort(stops);
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    add_points(drive, stops, false);
    for (double& t : kept.time) {
        t = drive.at(t, Limit::before).time;
    }
    return physics::Curve::table(std::move(kept.time), std::move(kept.value));
}

std::vector<int> nodes_of(const Problem& problem, const OwnEffect& own) {
    std::vector<int> nodes;
    for (const std::string& place : own.places) {
        for (const int node : physics::nodes_of_place(problem.mesh, place)) {
            if (std::ranges::find(nodes, node) == nodes.end()) {
                nodes.push_back(node);
            }
        }
    }
    return nodes;
}

void object_to_course(const Course& course, std::string_view what, double low, std::vector<std::string>& found) {
    if (course.time.size() != course.value.size() || !std::ranges::is_sorted(course.time)) {
        found.push_back(fmt::format("the times of {} go backwards, or are not as many as its values", what));
        return;
    }
    const auto finite = [](double value) { return std::isfinite(value); };
    if (std::ranges::none_of(course.value, finite)) {
        found.push_back(fmt::format("{} has no value", what));
        return;
    }
    const auto below = std::ranges::find_if(course.value, [&](double value) { return value < low; });
    if (below != course.value.end()) {
        const double t = course.time[static_cast<std::size_t>(below - course.value.begin())];
        found.push_back(fmt::format("{} is {:.6g} at {:.6g} s: {}", what, *below, t,
                                    low == 0.0 && what != "the temperature of the surroundings"
                                        ? "a conductance cannot be negative"
                                        : "no temperature in kelvin"));
    }
}

}  // namespace

std::vector<std::string> objections(const Problem& problem, const OwnEffect& own) {
    std::vector<std::string> found;
    if (own.name.empty() || physics::find_effect(own.name) != nullptr ||
        find_own_effect(problem, own.name) < problem.effects.size()) {
        found.push_back(fmt::format("the name \"{}\" is empty or taken", own.name));
    }
    for (const std::string& place : own.places) {
        if (physics::nodes_of_place(problem.mesh, place).empty()) {
            found.push_back(fmt::format("the mesh has no region, layer, zone or patch \"{}\"", place));
        }
    }
    const std::vector<int> nodes = nodes_of(problem, own);
    if (own.places.empty()) {
        found.emplace_back("it acts nowhere");
    } else if (!nodes.empty() && physics::shares_of_nodes(problem.mesh, problem.materials, nodes).empty()) {
        found.emplace_back("its places are surfaces and volumes, which cannot share by area and by heat capacity");
    }
    object_to_course(own.course, "the signal", own.exchange ? 0.0 : -std::numeric_limits<double>::infinity(), found);
    if (own.exchange && !own.surroundings.time.empty()) {
        object_to_course(own.surroundings, "the temperature of the surroundings", 0.0, found);
    }
    if (!std::isfinite(own.amount) || (own.exchange && own.amount < 0.0)) {
        found.push_back(fmt::format("{} is no {}", own.amount, own.exchange ? "conductance" : "heat"));
    }
    return found;
}

std::size_t add_own_effect(Problem& problem, const OwnEffect& own) {
    if (const std::vector<std::string> found = objections(problem, own); !found.empty()) {
        throw std::invalid_argument(fmt::format("{}: {}", own.name, found.front()));
    }
    physics::ActiveEffect active =
        physics::activate(*physics::find_effect(own.exchange ? "own_exchange" : "own_source"), problem.mesh);
    active.name = own.name;
    active.parameters.front() = own.amount;
    active.nodes = nodes_of(problem, own);
    active.tables[0] = table_of(own.course, problem.drive);
    if (own.exchange && !own.surroundings.time.empty()) {
        active.tables[1] = table_of(own.surroundings, problem.drive);
    }
    return switch_on(problem, std::move(active), 0.0);
}

std::size_t find_own_effect(const Problem& problem, std::string_view name) {
    const auto found = std::ranges::find_if(problem.effects, [&](const physics::ActiveEffect& active) {
        return !active.name.empty() && active.name == name;
    });
    return static_cast<std::size_t>(found - problem.effects.begin());
}

}  // namespace tiretherm::solver
