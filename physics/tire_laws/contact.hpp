// SPDX-License-Identifier: BSD-3-Clause
// Two half-spaces in short contact through a conductance h: h_mean = h (e^tau erfc(sqrt tau) - 1 + 2 sqrt(tau/pi))/tau
// (Carslaw & Jaeger 1959, sec. 2.5 and 2.8).
#pragma once

#include <cstdint>

namespace tiretherm::physics {

/// Where heat of sliding enters: all that counts in the surface of a, the tread; or between the two surfaces, of which each
/// takes the share that warms both alike, e_a / (e_a + e_b) and e_b / (e_a + e_b) (Charron, Publ. Sci. Tech. Minist. Air
/// 182, 1943), so that the heat itself drives nothing through the interface.
enum class SlidingHeat : std::uint8_t { in_tread, between };

/// Two half-spaces that meet for a short time with a conductance between their surfaces: tread and road in a rolling
/// contact. Carslaw & Jaeger, Conduction of Heat in Solids, 2nd ed. 1959, sec. 2.5 and 2.8.
struct ContactOfHalfSpaces {
    double interface_h = 0.0;   ///< W/(m2 K) between the two surfaces, > 0
    double effusivity_a = 0.0;  ///< sqrt(k rho c), W s^0.5/(m2 K), > 0
    double effusivity_b = 0.0;

    /// Mean flux over a contact of this duration, per kelvin between the two before they met.
    ///     h_mean = h (e^tau erfc(sqrt tau) - 1 + 2 sqrt(tau/pi)) / tau,   tau = h^2 (1/e_a + 1/e_b)^2 t
    /// The interface alone for a very short contact, 2 / ((1/e_a + 1/e_b) sqrt(pi t)) for a long one.
    /// @param duration s, >= 0  @returns W/(m2 K)
    [[nodiscard]] double mean_conductance(double duration) const;

    /// Flux at a moment of the contact, per kelvin by which the surface of a lies above b as it was before they met: what
    /// a body needs whose own cells resolve a.
    ///     h g / (1 - e_b (1 - g) / (e_a + e_b)),   g = e^tau erfc(sqrt tau), tau as above
    /// @param since s since they met, >= 0  @returns W/(m2 K), descending from the interface's
    [[nodiscard]] double conductance_at(double since) const;

    /// Of heat that enters the surface of a evenly since they met, what stays in a: with `conductance_at` times the
    /// difference that the heat itself makes, which the cells of a show, the exchange is that of both half-spaces.
    ///     1 - s + conductance_at theta,   s = e_b / (e_a + e_b) (1 - g) what b takes of it at that moment,
    ///     theta = s / h + (2 sqrt(t/pi) - (1 - g) / beta) / (e_a + e_b) the warming of a by it,   beta = sqrt(tau / t)
    /// From the Laplace transform: flux to b h beta'/(s (sqrt s + beta)), beta' = h / e_a; C&J 1959, appendix V.
    /// Of heat between the two, per unit that enters a, the exchange is none: 1 + conductance_at 2 sqrt(t/pi) / e_a.
    /// @param since s since they met, >= 0
    [[nodiscard]] double kept_heat_at(double since, SlidingHeat enters = SlidingHeat::in_tread) const;
};

/// e^(x^2) erfc(x), which stays finite where the two factors do not. @param x >= 0
[[nodiscard]] double scaled_erfc(double x);

}  // namespace tiretherm::physics
