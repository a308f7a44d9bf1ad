// SPDX-License-Identifier: BSD-3-Clause
// Earlier revolutions see only a few moments of the flux of a contact: their term is a polynomial in both times. What is
// left to solve is a small system in these moments, between fluxes of contacts without memory.

#include "physics/contact/contact_in_revolutions.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "physics/contact/fresh_fluxes.hpp"

namespace tiretherm::physics {

namespace {

using Memory = Eigen::Matrix<double, n_moments, n_moments>;

/// zeta(1/2, 1 + (u - v) x) = sum_jk u^j M_jk v^k for |u|, |v| <= 1/2, by Taylor's series about u = v, of which
/// d/da zeta(s, a) = -s zeta(s+1, a) gives the terms, and the binomial of each (u - v)^n.
class PastContacts {
public:
    PastContacts() {
        double term = 1.0;  // (-1)^n s (s+1) ... (s+n-1) / n! at s = 1/2
        for (int n = 0; n <= 2 * (n_moments - 1); ++n) {
            const double s = 0.5 + n;
            double binomial = 1.0;  // n over j, with the sign of v^(n-j)
            for (int j = n; j >= 0; --j) {
                if (j < n_moments && n - j < n_moments) {
                    terms_(j, n - j) = term * hurwitz_zeta(s, 1.0) * binomial;
                }
                binomial *= -static_cast<double>(j) / (n - j + 1);
            }
            term *= -s / (n + 1);
        }
    }
    /// @param x share of a contact in a revolution
    [[nodiscard]] Memory operator()(double x) const {
        Moments powers;
        powers[0] = 1.0;
        for (int k = 1; k < n_moments; ++k) {
            powers[k] = powers[k - 1] * x;
        }
        return terms_.cwiseProduct(powers * powers.transpose());
    }

private:
    Memory terms_ = Memory::Zero();
};

}  // namespace

double hurwitz_zeta(double s, double a) {
    constexpr int n_terms = 14;
    double sum = 0.0;
    for (int k = 0; k < n_terms; ++k) {
        sum += std::pow(a + k, -s);
    }
    const double x = a + n_terms;
    sum += std::pow(x, -s) * (x / (s - 1.0) + 0.5);
    // B_2j / (2j)! s (s+1) ... (s+2j-2) x^(-s-2j+1)
    double factor = s * std::pow(x, -s - 1.0);
    int j = 0;
    for (const double bernoulli : {1.0 / 12.0, -1.0 / 720.0, 1.0 / 30240.0, -1.0 / 1209600.0, 1.0 / 47900160.0}) {
        sum += bernoulli * factor;
        factor *= (s + 2 * j + 1) * (s + 2 * j + 2) / (x * x);
        ++j;
    }
    return sum;
}

// With w the moments of the flux and M the matrix of earlier revolutions, these warm the tread's surface by
// past P M w, P the powers of u. A flux that is driven by D = F - past M w, with F the drives of the right-hand side, is
// h (fresh fluxes) D, and its moments close the system (1 + h past m M) w = h m F, m the moments of the fresh fluxes.
ContactInRevolutions::ContactInRevolutions(const ContactOfHalfSpaces& contact, double duration, double period) {
    static const PastContacts past_contacts;
    constexpr int n_sides = 3;  // the difference D; heat into the tread; heat between the surfaces
    const double h = contact.interface_h;
    const double a = 1.0 / contact.effusivity_a;
    const double root = std::sqrt(duration * std::numbers::inv_pi);
    const FreshFluxes fresh = FreshFluxes::at(h * (a + 1.0 / contact.effusivity_b) * root);
    const Memory past = a * duration / std::sqrt(std::numbers::pi * period) * past_contacts(duration / period);
    const Moments past_of_even = past * moments_of_even_flux();

    Eigen::Matrix<double, n_drives, n_sides> driven = Eigen::Matrix<double, n_drives, n_sides>::Zero();
    driven(0, 0) = 1.0;
    driven.col(1).head<n_moments>() = past_of_even;
    driven(n_moments, 1) = a * root;
    driven.col(2).head<n_moments>() = past_of_even;
    Memory system = Memory::Identity();
    system.noalias() += h * fresh.moments.leftCols<n_moments>().lazyProduct(past);
    const Eigen::PartialPivLU<Memory> factor(system);
    Eigen::Matrix<double, n_moments, n_sides> moments;
    Eigen::Matrix<double, n_moments, n_sides> warmed;
    for (int side = 0; side < n_sides; ++side) {  // one by one, which Eigen unrolls
        moments.col(side) = factor.solve(h * (fresh.moments * driven.col(side)));
        warmed.col(side) = past * moments.col(side);
    }
    driven.topRows<n_moments>() -= warmed;

    // The tread's surface above its mean: by earlier revolutions alone at the entry, and by this contact at the exit.
    const Drives& first = drives_at_entry();
    const Drives& last = drives_at_exit();
    const Eigen::Matrix<double, n_sides, 1> at_entry = warmed.transpose() * first.head<n_moments>();
    const Eigen::Matrix<double, n_sides, 1> at_exit =
        warmed.transpose() * last.head<n_moments>() + a * root * h * driven.transpose() * fresh.abel_at_exit;
    mean_ = moments(0, 0);
    entry_ = -at_entry[0];
    exit_ = -at_exit[0];
    entry_alone_ = first.head<n_moments>().dot(past_of_even);
    exit_alone_ = last.head<n_moments>().dot(past_of_even) + a * root * last[n_moments];
    in_tread_ = {.road_share = moments(0, 1), .entry_cooled = at_entry[1], .exit_cooled = at_exit[1]};
    between_ = {.road_share = moments(0, 2), .entry_cooled = at_entry[2], .exit_cooled = at_exit[2]};
}

}  // namespace tiretherm::physics
