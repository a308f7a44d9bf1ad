// SPDX-License-Identifier: BSD-3-Clause
// A parameter that fits and sensitivities may move: a parameter of an effect, the value of k(T) or c(T) at a
// temperature, an initial temperature, or a number by which inputs are computed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "solver/problem.hpp"

namespace tiretherm::solver {

/// A parameter of a problem that may be moved: where it stands, and what is known of it beforehand.
struct FreeParameter {
    enum class Kind : std::uint8_t {
        effect,             ///< a parameter of an effect that is on, everywhere or at one place
        conductivity,       ///< a law k(T) of layers, by its value at a temperature
        heat_capacity,      ///< a law c(T) of layers, by its value at a temperature
        link_conductivity,  ///< the law k(T) of the links between lumps, by its value at a temperature
        initial,            ///< the initial temperature of some nodes, as a shift of what the case says
        input               ///< a number of the model that computes inputs
    };

    std::string name;  ///< "air_convection.lambda_h", "tread.conductivity at 90 degC", "initial"
    std::string unit;  ///< UDUNITS; values are in this unit (K for a shift of temperatures)
    Kind kind = Kind::effect;

    /// A parameter of the same effect that moves in proportion.
    struct Companion {
        std::size_t parameter = 0;
        double factor = 1.0;  ///< its value over the parameter's
    };
    std::size_t effect = 0;     ///< index into Problem::effects
    std::size_t parameter = 0;  ///< of the effect, or index into Problem::input_numbers
    std::vector<Companion> companions{};
    bool everywhere = true;  ///< otherwise at `scope`, `place`
    physics::Scope scope = physics::Scope::patch;
    int place = -1;

    std::vector<int> layers;    ///< that share the law; of conductivity and heat capacity
    std::vector<double> knots;  ///< K; with one knot its value scales the law, with two or three it bends it
    std::size_t knot = 0;       ///< whose value this is

    std::vector<int> nodes;         ///< of an initial temperature
    std::vector<std::size_t> runs;  ///< indices of the measured runs that it belongs to; empty: all of them

    double prior = 0.0;                                                   ///< expected value
    double standard_deviation = std::numeric_limits<double>::infinity();  ///< of the prior; infinite: none
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    /// Whether a measured run follows it. @param run index of the run
    [[nodiscard]] bool belongs_to(std::size_t run) const {
        return runs.empty() || std::ranges::find(runs, run) != runs.end();
    }
};

/// The law k(T) or c(T) of which the parameter is a value; null for other parameters and where there is no link.
[[nodiscard]] const physics::Curve* law_of(const Problem& problem, const FreeParameter& parameter);
/// The value that the problem has now; 0 of a shift.
[[nodiscard]] double value_of(const Problem& problem, const FreeParameter& parameter);
/// Moves a parameter of the problem from one value to another. Moves of several parameters commute.
/// @param from the value before, @param to after, in the parameter's unit
void move(Problem& problem, const FreeParameter& parameter, double from, double to);
/// How far to move it for a difference quotient: small beside any value of it that matters.
[[nodiscard]] double typical_step(const FreeParameter& parameter, double value);

}  // namespace tiretherm::solver
