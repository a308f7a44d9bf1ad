// SPDX-License-Identifier: BSD-3-Clause
// Steps the disc's temperature by its exact solution over each interval.

#include "physics/vehicle/brake.hpp"

#include <cmath>

namespace tiretherm::physics {

std::vector<double> brake_temperature(const Brake& brake, std::span<const double> time, std::span<const double> power,
                                      std::span<const double> air) {
    std::vector<double> T;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (i == 0) {
            T.push_back(air[0]);
            continue;
        }
        const double P = 0.5 * (power[i - 1] + power[i]);
        const double T_air = 0.5 * (air[i - 1] + air[i]);
        const double interval = time[i] - time[i - 1];
        if (brake.cooling > 0.0) {
            const double end = T_air + P / brake.cooling;
            T.push_back(end + (T.back() - end) * std::exp(-brake.cooling * interval / brake.heat_capacity));
        } else {
            T.push_back(T.back() + P * interval / brake.heat_capacity);
        }
    }
    return T;
}

}  // namespace tiretherm::physics
