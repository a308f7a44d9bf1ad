// SPDX-License-Identifier: BSD-3-Clause
// A lap that is driven several times before a run.
#pragma once

#include "solver/user_effect.hpp"

namespace tiretherm::input {

/// The first lap of a run, which goes before it so many times.
struct RepeatedLap {
    double from = 0.0;  ///< s
    double to = 0.0;    ///< s
    int times = 0;

    /// By how much the run starts before its first sample. @returns s
    [[nodiscard]] double lead() const { return times * (to - from); }
    /// A signal with the lap before it, as often as it is driven. @param known time ascending
    [[nodiscard]] solver::SignalHistory before(solver::SignalHistory known) const;
};

}  // namespace tiretherm::input
