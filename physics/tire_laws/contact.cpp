// SPDX-License-Identifier: BSD-3-Clause
// Closed forms with e^tau erfc(sqrt tau), which is replaced by its asymptotic series for large tau; for small tau a
// Taylor series avoids cancellation.

#include "physics/tire_laws/contact.hpp"

#include <cmath>
#include <numbers>

namespace tiretherm::physics {

double scaled_erfc(double x) {
    if (x < 20.0) {
        return std::exp(x * x) * std::erfc(x);
    }
    // The asymptotic series; at 20 the first term left out is 105/16 x^-8 = 3e-10.
    const double y = 1.0 / (x * x);
    return std::numbers::inv_sqrtpi / x * (1.0 - y * (0.5 - y * (0.75 - y * 1.875)));
}

double ContactOfHalfSpaces::mean_conductance(double duration) const {
    const double root = interface_h * (1.0 / effusivity_a + 1.0 / effusivity_b) * std::sqrt(duration);  // sqrt(tau)
    if (root < 1e-3) {
        // 1 - 4 sqrt(tau)/(3 sqrt(pi)) + tau/2; the closed form would lose its digits to cancellation.
        return interface_h * (1.0 - root * (4.0 / 3.0 * std::numbers::inv_sqrtpi - 0.5 * root));
    }
    return interface_h * (scaled_erfc(root) - 1.0 + 2.0 * root * std::numbers::inv_sqrtpi) / (root * root);
}

double ContactOfHalfSpaces::conductance_at(double since) const {
    const double root = interface_h * (1.0 / effusivity_a + 1.0 / effusivity_b) * std::sqrt(since);
    const double left = scaled_erfc(root);  // of the difference between the two surfaces
    return interface_h * left / (1.0 - effusivity_b / (effusivity_a + effusivity_b) * (1.0 - left));
}

double ContactOfHalfSpaces::kept_heat_at(double since, SlidingHeat enters) const {
    if (enters == SlidingHeat::between) {
        return 1.0 + conductance_at(since) * 2.0 * std::sqrt(since) * std::numbers::inv_sqrtpi / effusivity_a;
    }
    const double beta = interface_h * (1.0 / effusivity_a + 1.0 / effusivity_b);
    const double root = beta * std::sqrt(since);
    const double gone = 1.0 - scaled_erfc(root);
    const double taken = effusivity_b / (effusivity_a + effusivity_b) * gone;
    const double warming =
        taken / interface_h + (2.0 * root * std::numbers::inv_sqrtpi - gone) / (beta * (effusivity_a + effusivity_b));
    return 1.0 - taken + conductance_at(since) * warming;
}

}  // namespace tiretherm::physics
