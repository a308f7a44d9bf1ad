// SPDX-License-Identifier: BSD-3-Clause
// How a step or a run ended, with a message that names place, effect and time of a failure.
#pragma once

#include <cstdint>
#include <string>

namespace tiretherm::solver {

/// How a run or a step ended. A failure names the place: the message says cell, layer, effect and time.
enum class Outcome : std::uint8_t {
    done,
    not_converged,
    not_finite,
    negative_conductance,
    not_positive_definite,
    step_too_small,
    stopped,
    foreign_checkpoint
};

struct Status {
    Outcome outcome = Outcome::done;
    std::string message;  ///< empty when done

    [[nodiscard]] bool ok() const { return outcome == Outcome::done; }
};

}  // namespace tiretherm::solver
