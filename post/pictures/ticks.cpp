// SPDX-License-Identifier: BSD-3-Clause
// Chooses the step of an axis and the number of decimals of its labels.

#include "post/pictures/ticks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tiretherm::post {

std::string Ticks::label(double value) const {
    // 0 is not "-0".
    return fmt::format("{:.{}f}", value == 0.0 ? 0.0 : value, decimals);
}

Ticks ticks(double low, double high, int about) {
    Ticks result;
    if (!(high > low)) {
        return {{low}, 1};
    }
    const double rough = (high - low) / about;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double mantissa = rough / power;
    const double round = mantissa <= 1.0   ? 1.0
                         : mantissa <= 2.0 ? 2.0
                         : mantissa <= 2.5 ? 2.5
                         : mantissa <= 5.0 ? 5.0
                                           : 10.0;
    const double step = round * power;
    const double slack = 1e-9 * step;
    const int digits = round == 2.5 ? 1 : 0;
    result.decimals = std::max(0, digits - static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const auto first = std::ceil((low - slack) / step);
    for (int i = 0; (first + i) * step <= high + slack; ++i) {
        result.values.push_back((first + i) * step);
    }
    return result;
}

}  // namespace tiretherm::post
