// SPDX-License-Identifier: BSD-3-Clause
// The loss modulus of Kraus.
#include "physics/tire_laws/kraus.hpp"

#include <cmath>

namespace tiretherm::physics {

double KrausLaw::loss(double e) const {
    const double x = std::pow(e / strain, exponent);
    return 1.0 + amplitude * 2.0 * x / (1.0 + x * x);
}

}  // namespace tiretherm::physics
