// SPDX-License-Identifier: BSD-3-Clause
// How the loss of filled rubber follows its strain: the filler's network breaks down with growing amplitude.
#pragma once

namespace tiretherm::physics {

/// Loss modulus over that of small strains, G'' = G''_inf (1 + A 2 x / (1 + x^2)) with x = (e/e_c)^m. Kraus, J. Appl. Polym. Sci.:
/// Appl. Polym. Symp. 39, 1984; Ulmer, Rubber Chem. Technol. 69, 1996.
struct KrausLaw {
    double amplitude = 0.0;  ///< A, 1; 0: the strain has no say
    double strain = 0.02;    ///< e_c, 1, of the largest loss modulus
    double exponent = 0.6;   ///< m, 1

    /// @param e strain, 1, >= 0  @returns 1, >= 1 for A >= 0
    [[nodiscard]] double loss(double e) const;
};

}  // namespace tiretherm::physics
