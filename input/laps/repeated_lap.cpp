// SPDX-License-Identifier: BSD-3-Clause
// Copies the samples of a lap to earlier times.

#include "input/laps/repeated_lap.hpp"

#include <algorithm>

namespace tiretherm::input {

solver::SignalHistory RepeatedLap::before(solver::SignalHistory known) const {
    if (times == 0) {
        return known;
    }
    const auto begin = std::ranges::lower_bound(known.time, from) - known.time.begin();
    const auto end = std::ranges::lower_bound(known.time, to) - known.time.begin();
    solver::SignalHistory led;
    for (int k = times; k > 0; --k) {
        const double earlier = k * (to - from);
        for (auto i = begin; i < end; ++i) {
            led.time.push_back(known.time[static_cast<std::size_t>(i)] - earlier);
            led.value.push_back(known.value[static_cast<std::size_t>(i)]);
        }
    }
    led.time.insert(led.time.end(), known.time.begin(), known.time.end());
    led.value.insert(led.value.end(), known.value.begin(), known.value.end());
    return led;
}

}  // namespace tiretherm::input
