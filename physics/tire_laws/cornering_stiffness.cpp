// SPDX-License-Identifier: BSD-3-Clause
// Moduli of belt and tread in series, with the derivative with respect to the bulk temperature; CP is 0 without
// contact.

#include "physics/tire_laws/cornering_stiffness.hpp"

#include <cmath>

namespace tiretherm::physics {

double EquivalentModulus::belt(double contact_length) const {
    return E_max - dE + dE / (1.0 + std::exp(slope * (l_t - contact_length)));
}

WithSlope EquivalentModulus::tread(double T_bulk) const {
    const double a = -2.0 * std::log(0.003) / dT;
    const double x = T_bulk - T_g;
    const double left = std::exp(-a * std::abs(x));  // what is left of the way to the plateau
    return {E_mid - 0.5 * dE_T * std::copysign(1.0 - left, x), -0.5 * dE_T * a * left};
}

WithSlope EquivalentModulus::value(double contact_length, double T_bulk) const {
    const WithSlope E_T = tread(T_bulk);
    const double E_eq = 1.0 / (1.0 / belt(contact_length) + 1.0 / E_T.value);
    const double share = E_eq / E_T.value;  // of the compliance that is the tread's
    return {E_eq, share * share * E_T.by_temperature};
}

WithSlope cornering_stiffness(const EquivalentModulus& modulus, const Tire& tire, double vertical_load, double T_bulk) {
    if (!tire.touches(vertical_load)) {
        return {};
    }
    const double l = tire.contact_length(vertical_load);
    const WithSlope E_eq = modulus.value(l, T_bulk);
    return {0.5 * E_eq.value * l * l, 0.5 * E_eq.by_temperature * l * l};
}

double bulk_temperature_factor(double CP, double K_ref) { return K_ref == 0.0 ? 1.0 : CP / std::abs(K_ref); }

}  // namespace tiretherm::physics
