// SPDX-License-Identifier: BSD-3-Clause
// First-order uncertainty of a hot spot: its slopes with uncertain parameters, the share of each in the variance, and
// the probability of exceeding a temperature.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "solver/problem.hpp"
#include "solver/sensitivity/free_parameter.hpp"
#include "solver/status.hpp"

namespace tiretherm::solver {

/// The hottest place of a run and its time. At the peak the temperature does not change with either of them, so that the
/// peak's slope with a parameter is that of the temperature at this place and time.
struct HotPlace {
    mesh::Functional where{};
    double time = 0.0;  ///< s
};

/// Temperatures at the hottest places, and their slopes.
struct PlaceSlopes {
    Status status{};
    std::vector<double> temperature{};  ///< [places] K
    std::vector<double> slope{};        ///< [parameters][places] K per unit of the parameter
    std::vector<double> step_ends{};    ///< s: the steps taken
    std::vector<std::string>
        non_smooth_parameters{};  ///< parameters at a switch or a clamp, where the slope is that of one side
};

/// The places' temperatures in a run, with their exact slopes by all parameters: the tangent of the run.
/// @param step_ends to take, so that neighbouring problems differ smoothly; empty: as the error control chooses
[[nodiscard]] PlaceSlopes place_slopes(const Problem& problem, std::span<const HotPlace> places,
                                       std::span<const FreeParameter> parameters = {},
                                       std::span<const double> step_ends = {});

/// An uncertain parameter and what one standard deviation of it does.
struct Driver {
    std::string name{};
    std::string unit{};
    double value = 0.0;               ///< in `unit`
    double standard_deviation = 0.0;  ///< in `unit`
    double kelvin = 0.0;              ///< K, of the hot spot for one standard deviation more
    /// K, by how much the mean of the hot spots one standard deviation above and below lies over that in the middle:
    /// what a linear model leaves out. NaN where the slope is a tangent and it was not evaluated.
    double nonlinearity = 0.0;
};

/// Drivers of one hot spot together: independent, each normal, and the hot spot linear in them.
struct Spread {
    std::vector<Driver> drivers{};    ///< the strongest first
    double mean = 0.0;                ///< K
    double standard_deviation = 0.0;  ///< K

    /// Share of the variance that a driver brings.
    [[nodiscard]] double share(std::size_t driver) const;
    /// Probability that the hot spot is above a temperature.
    [[nodiscard]] double chance_above(double temperature) const;
};

/// @param mean K, of the hot spot where every parameter has its expected value
[[nodiscard]] Spread spread_of(std::vector<Driver> drivers, double mean);

}  // namespace tiretherm::solver
