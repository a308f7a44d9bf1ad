// SPDX-License-Identifier: BSD-3-Clause
// All that a session needs, as a value that can be stored and taken up by a program that reads no cases: an FMU.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/sensitivity/free_parameter.hpp"

namespace tiretherm::solver {

/// A problem with the inputs it begins with and the numbers of it that may be moved while it runs.
struct SessionModel {
    Problem problem;        ///< its input signals are not used
    physics::Inputs start;  ///< the inputs at the beginning, time 0
    std::vector<FreeParameter> parameters{};

    /// Signals that its effects and channels look at, as far as the start gives them: only these make a difference as inputs.
    [[nodiscard]] std::vector<const physics::Signal*> inputs() const;
};

/// The numbers by which a session's values are called from outside: 0 is the time, then inputs, parameters and outputs follow each
/// other.
struct ValueNumbers {
    explicit ValueNumbers(const SessionModel& model)
        : first_parameter(first_input + model.inputs().size()),
          first_output(first_parameter + model.parameters.size()),
          end(first_output + model.problem.channels.size()) {}

    static constexpr std::size_t first_input = 1;
    std::size_t first_parameter;
    std::size_t first_output;
    std::size_t end;
};

/// The problem under the inputs of its start; of the parameters those that act in a session are kept: numbers by which a log's
/// inputs are computed have nothing to act on.
[[nodiscard]] SessionModel session_model(const Problem& problem, const std::vector<FreeParameter>& parameters);

/// As bytes, with a checksum, for programs of the same build. What only files of results need is left out.
[[nodiscard]] std::string to_bytes(const SessionModel& model);
/// @errors std::runtime_error: the bytes are damaged, or of another build
[[nodiscard]] SessionModel session_model_from(std::string_view bytes);

/// 32 hexadecimal digits that belong to these bytes alone.
[[nodiscard]] std::string token_of(std::string_view bytes);

}  // namespace tiretherm::solver
