// SPDX-License-Identifier: BSD-3-Clause
// Fluxes of a contact that has no memory of earlier ones, by what drives them: a Volterra equation of the second kind with
// Abel's kernel, of which few moments are wanted.
#pragma once

#include <Eigen/Core>

namespace tiretherm::physics {

/// Powers of u = t/t_c - 1/2 that stand for what earlier revolutions left. The error of the conductance is 1e-11 where the
/// contact takes 0.06 of a revolution and 2e-6 where it takes 0.3.
inline constexpr int n_moments = 7;
/// What drives a flux: the powers of u, and the Abel integral of an even flux.
inline constexpr int n_drives = n_moments + 1;
using Moments = Eigen::Matrix<double, n_moments, 1>;
using Drives = Eigen::Matrix<double, n_drives, 1>;

/// Fluxes f that obey f + H A f = drive during the contact 0 <= t <= t_c, each with its drive, where A is Abel's integral,
/// A f = int_0^t f(s) / sqrt(t_c (t-s)) ds. Carslaw & Jaeger 1959, sec. 2.9.
struct FreshFluxes {
    /// Column d, row k: int f_d u^k dt / t_c
    Eigen::Matrix<double, n_moments, n_drives> moments = Eigen::Matrix<double, n_moments, n_drives>::Zero();
    /// A f_d at t = t_c
    Drives abel_at_exit = Drives::Zero();

    /// From a table with continuous slopes, to 1e-8 of the equation; beyond the table from the equation. Allocates nothing.
    /// The first call makes the table, 80 kB in a millisecond; it may come from several threads at once.
    /// @param H 1, >= 0: interface_h (1/e_a + 1/e_b) sqrt(t_c/pi) of two half-spaces
    [[nodiscard]] static FreshFluxes at(double H);
    /// From the equation, by collocation: the flux is linear in each of 24 pieces of sqrt(t/t_c).
    [[nodiscard]] static FreshFluxes by_collocation(double H);
    /// Derivative of all of it with ln H, by collocation.
    [[nodiscard]] static FreshFluxes slope_by_collocation(double H);
};

/// What drives a flux at the entry and at the exit of the contact, and the moments of an even flux.
[[nodiscard]] const Drives& drives_at_entry();
[[nodiscard]] const Drives& drives_at_exit();
[[nodiscard]] const Moments& moments_of_even_flux();

}  // namespace tiretherm::physics
