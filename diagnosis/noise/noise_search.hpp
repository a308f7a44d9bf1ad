// SPDX-License-Identifier: BSD-3-Clause
// Newton's method for the correlation time and the white share of one channel's noise, within bounds.
#pragma once

#include "diagnosis/noise/noise_likelihood.hpp"

namespace tiretherm::diagnosis {

/// Correlation times that a channel's data may have.
struct NoiseBounds {
    double shortest = 0.0;  ///< s
    double longest = 0.0;   ///< s
};

/// The noise of a channel that suits it best, and how well that is known.
struct NoiseOptimum {
    NoiseLikelihood::Trial best;
    double sigma_deviation = 0.0;   ///< NaN: not determined
    double rho_1s_deviation = 0.0;  ///< NaN: not determined
};

/// Newton's method over the logarithm of the correlation time and the white share, with sigma at its best for each, from
/// the channel's noise of now or from the best of a coarse grid.
[[nodiscard]] NoiseOptimum search_noise(const NoiseLikelihood& likelihood, std::size_t channel,
                                        const NoiseBounds& bounds, bool from_now);

}  // namespace tiretherm::diagnosis
