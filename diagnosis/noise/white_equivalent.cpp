// SPDX-License-Identifier: BSD-3-Clause
// Sums the autocorrelations of each channel's noise in closed form.

#include "diagnosis/noise/white_equivalent.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::diagnosis {

Covariance white_equivalent(const Covariance& covariance, std::span<const Block> blocks) {
    Covariance white = covariance;
    for (std::size_t c = 0; c < white.channels.size(); ++c) {
        Noise& noise = white.channels[c];
        const double interval = median_interval(blocks, static_cast<int>(c));
        double sum = 1.0;
        if (noise.correlation_time > 0.0 && interval > 0.0) {
            const double rho = std::exp(-interval / noise.correlation_time);
            sum = noise.white_share + (1.0 - noise.white_share) * (1.0 + rho) / (1.0 - rho);
        }
        noise = {.sigma = noise.sigma * std::sqrt(sum)};
    }
    return white;
}

}  // namespace tiretherm::diagnosis
