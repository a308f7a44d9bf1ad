// SPDX-License-Identifier: BSD-3-Clause
// Random numbers by seed, the same on every standard library: evenly, by decades, whole, and orders of things.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace tiretherm::support {

/// Random numbers that are the same on every standard library.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}

    [[nodiscard]] double between(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
    }
    /// Every decade alike.
    [[nodiscard]] double decades(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    /// @returns low, low + 1, ... or high
    [[nodiscard]] int whole(int low, int high) {
        return std::min(high, static_cast<int>(std::floor(between(low, high + 1.0))));
    }
    [[nodiscard]] bool chance(double probability) { return between(0.0, 1.0) < probability; }
    [[nodiscard]] std::vector<std::size_t> order(std::size_t n) {
        std::vector<std::size_t> result(n);
        std::iota(result.begin(), result.end(), std::size_t{0});
        for (std::size_t i = n; i > 1; --i) {
            std::swap(result[i - 1], result[static_cast<std::size_t>(whole(0, static_cast<int>(i) - 1))]);
        }
        return result;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace tiretherm::support
