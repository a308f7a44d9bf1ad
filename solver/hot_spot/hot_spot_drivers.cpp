// SPDX-License-Identifier: BSD-3-Clause
// Slopes from one tangent run that reads the temperature at the fixed hottest places; the variances of independent
// parameters add up.

#include "solver/hot_spot/hot_spot_drivers.hpp"

#include <algorithm>
#include <cmath>

#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::solver {

namespace {

/// The problem with nothing read but the places.
Problem read_at(Problem problem, std::span<const HotPlace> places) {
    problem.channels.clear();
    problem.measured.clear();
    for (physics::ActiveEffect& active : problem.effects) {
        active.channels.clear();
    }
    for (const HotPlace& place : places) {
        problem.channels.push_back({.name = "hot spot", .meaning = "", .where = place.where});
    }
    return problem;
}

}  // namespace

PlaceSlopes place_slopes(const Problem& problem, std::span<const HotPlace> places,
                         std::span<const FreeParameter> parameters, std::span<const double> step_ends) {
    const Problem read = read_at(problem, places);
    std::vector<double> times;
    for (const HotPlace& place : places) {
        times.push_back(place.time);
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<double> values;
    for (const FreeParameter& parameter : parameters) {
        values.push_back(value_of(read, parameter));
    }
    Prediction prediction =
        predict(read, {.times = times, .parameters = parameters, .values = values, .step_ends = step_ends});
    PlaceSlopes found{.status = std::move(prediction.status)};
    found.step_ends = std::move(prediction.step_ends);
    found.non_smooth_parameters = std::move(prediction.non_smooth_parameters);
    if (!found.status.ok()) {
        return found;
    }
    const auto row = [&](std::size_t p) {
        return static_cast<std::size_t>(std::ranges::find(times, places[p].time) - times.begin());
    };
    for (std::size_t p = 0; p < places.size(); ++p) {
        found.temperature.push_back(prediction.at(row(p), p));
    }
    for (std::size_t j = 0; j < parameters.size(); ++j) {
        for (std::size_t p = 0; p < places.size(); ++p) {
            found.slope.push_back(prediction.slope_at(j, row(p), p));
        }
    }
    return found;
}

double Spread::share(std::size_t driver) const {
    return standard_deviation > 0.0 ? std::pow(drivers[driver].kelvin / standard_deviation, 2) : 0.0;
}

double Spread::chance_above(double temperature) const {
    if (!(standard_deviation > 0.0)) {
        return mean > temperature ? 1.0 : 0.0;
    }
    return 0.5 * std::erfc((temperature - mean) / (standard_deviation * std::sqrt(2.0)));
}

Spread spread_of(std::vector<Driver> drivers, double mean) {
    Spread spread{.drivers = std::move(drivers), .mean = mean};
    double variance = 0.0;
    for (const Driver& driver : spread.drivers) {
        variance += driver.kelvin * driver.kelvin;
    }
    spread.standard_deviation = std::sqrt(variance);
    std::ranges::stable_sort(spread.drivers,
                             [](const Driver& a, const Driver& b) { return std::abs(a.kelvin) > std::abs(b.kelvin); });
    return spread;
}

}  // namespace tiretherm::solver
