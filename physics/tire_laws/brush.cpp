// SPDX-License-Identifier: BSD-3-Clause
// Closed forms under the parabolic pressure; the sliding power integrates friction times the sliding of a bristle's tip
// per metre of rolling.

#include "physics/tire_laws/brush.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::physics {

double Brush::full_sliding_slip() const { return 3.0 * friction * load / stiffness(); }

double Brush::adhesion_end(double slip) const {
    const double limit = full_sliding_slip();
    return std::abs(slip) >= limit ? half_length : half_length * (2.0 * std::abs(slip) / limit - 1.0);
}

double Brush::force(double slip) const {
    const double limit = full_sliding_slip();
    if (std::abs(slip) >= limit) {
        return std::copysign(friction * load, slip);
    }
    const double u = std::abs(slip) / limit;
    return stiffness() * slip * (1.0 - u + u * u / 3.0);  // 3 mu Fz / sigma_sl = C
}

double Brush::aligning_moment(double slip) const {
    const double limit = full_sliding_slip();
    if (std::abs(slip) >= limit) {
        return 0.0;
    }
    const double left = 1.0 - std::abs(slip) / limit;
    return -stiffness() * slip * half_length / 3.0 * left * left * left;
}

double Brush::pressure(double x) const {
    const double part = x / half_length;
    return 0.75 * load / half_length * (1.0 - part) * (1.0 + part);
}

double Brush::load_before(double x) const {
    const double part = x / half_length;
    return 0.25 * load * (1.0 + part) * (1.0 + part) * (2.0 - part);
}

double Brush::sliding_between(double low, double high, double slip) const {
    if (high <= low) {
        return 0.0;
    }
    // Friction mu q times what a bristle's tip slides per metre of rolling, sigma + dv/dx with v = mu q / c_p.
    const double slid = friction * std::abs(slip) * (load_before(high) - load_before(low));
    const double unbent = friction * friction * (pressure(high) - pressure(low)) * (pressure(high) + pressure(low));
    return slid + 0.5 * unbent / tread_stiffness;
}

double Brush::sliding_power(double slip, double rolling_speed) const {
    return std::abs(rolling_speed) * sliding_between(-half_length, adhesion_end(slip), slip);
}

double Brush::stored_power(double slip, double rolling_speed) const {
    const double deflection = std::abs(slip) * (half_length - adhesion_end(slip));
    return 0.5 * std::abs(rolling_speed) * tread_stiffness * deflection * deflection;
}

double Brush::released_power(double slip, double rolling_speed) const {
    return std::isinf(friction) ? stored_power(slip, rolling_speed) : 0.0;
}

std::vector<double> Brush::sliding_power_slices(double slip, double rolling_speed, std::size_t slices) const {
    std::vector<double> power(slices);
    const double end = adhesion_end(slip);
    const auto edge = [&](std::size_t i) {
        return half_length * (1.0 - 2.0 * static_cast<double>(i) / static_cast<double>(slices));
    };
    for (std::size_t i = 0; i < slices; ++i) {
        power[i] = std::abs(rolling_speed) * sliding_between(edge(i + 1), std::min(edge(i), end), slip);
    }
    return power;
}

}  // namespace tiretherm::physics
