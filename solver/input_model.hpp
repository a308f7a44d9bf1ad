// SPDX-License-Identifier: BSD-3-Clause
// A model that computes inputs of a run from numbers that a fit may move, as a car's mass makes the loads of its wheels.
#pragma once

#include <span>
#include <vector>

#include "solver/digest.hpp"
#include "solver/input_signals.hpp"

namespace tiretherm::solver {

/// Computes some inputs of a run. It never changes: what moves are its numbers, which belong to the problem.
class InputModel {
public:
    InputModel() = default;
    InputModel(const InputModel&) = default;
    InputModel(InputModel&&) = default;
    InputModel& operator=(const InputModel&) = default;
    InputModel& operator=(InputModel&&) = default;
    virtual ~InputModel() = default;

    /// Puts the inputs that it computes in the place of those that are there. @param numbers SI, as many as it has
    virtual void apply(std::span<const double> numbers, InputSignals& into) const = 0;
    /// The inputs that it computes.
    [[nodiscard]] virtual std::vector<const physics::Signal*> signals() const = 0;
    /// What its inputs follow besides the numbers.
    virtual void add_to(Digest& digest) const = 0;
};

}  // namespace tiretherm::solver
