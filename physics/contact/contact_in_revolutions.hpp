// SPDX-License-Identifier: BSD-3-Clause
// Flux between a rolling tread and fresh road: two half-spaces in contact once a revolution, with memory of earlier
// contacts (Carslaw & Jaeger 1959, sec. 2.9; Hurwitz zeta function, DLMF 25.11).
#pragma once

#include <optional>

#include "physics/effect.hpp"
#include "physics/tire_laws/contact.hpp"

namespace tiretherm::physics {

/// Two half-spaces of which one comes back once a revolution, before its surface has forgotten the last contact, and the
/// other is fresh each time: a tread that rolls. All of it per kelvin by which the tread's surface, averaged over the
/// revolution, lies above the road: between contacts it recovers above that mean, at the exit it lies below.
///
/// With q the flux during the contact 0 <= t <= t_c, P the period of a revolution and D that difference,
///
///     q(t)/h + (1/e_a + 1/e_b) int_0^t q(s) / sqrt(pi (t-s)) ds
///            + 1/(e_a sqrt(pi P)) int_0^t_c q(s) zeta(1/2, 1 + (t-s)/P) ds = D
///
/// The last term is what earlier revolutions left: the sum of 1/sqrt(pi (t-s+kP)) over all of them, less its mean, which
/// is the flow through the tread that the slow field carries. Derived from Carslaw & Jaeger 1959, sec. 2.9 (flux into a
/// half-space) and Hurwitz's zeta function (DLMF 25.11).
class ContactInRevolutions {
public:
    /// @param duration of a contact, s, > 0  @param period of a revolution, s, > 3 duration. Allocates nothing.
    ContactInRevolutions(const ContactOfHalfSpaces& contact, double duration, double period);

    /// Mean flux over a contact. @returns W/(m2 K)
    [[nodiscard]] double mean_conductance() const { return mean_; }
    /// The tread's surface above its mean, over the difference D, when it meets the road; > 0
    [[nodiscard]] double at_entry() const { return entry_; }
    /// The same when it leaves the road; < 0
    [[nodiscard]] double at_exit() const { return exit_; }

    /// The same of heat that enters the tread's surface evenly during the contact, per W/m2 of it, above the mean over the
    /// revolution. @returns K m2/W
    [[nodiscard]] double heated_at_entry() const { return heated_entry_; }
    [[nodiscard]] double heated_at_exit() const { return heated_exit_; }

private:
    double mean_ = 0.0;
    double entry_ = 0.0;
    double exit_ = 0.0;
    double heated_entry_ = 0.0;
    double heated_exit_ = 0.0;
};

/// The contact that the effect `resolved_contact` makes at a moment, or nothing at rest and off the road.
[[nodiscard]] std::optional<ContactInRevolutions> contact_in_revolutions(const ActiveEffect& resolved_contact,
                                                                         const Tire& tire, const Inputs& inputs);

/// Hurwitz's zeta function, the sum of (a + k)^-s over k = 0, 1, ... and where that diverges its continuation.
/// DLMF 25.11.28 (Euler and Maclaurin), to 1e-14 of its largest term. @param s > 0, not 1  @param a > 0
[[nodiscard]] double hurwitz_zeta(double s, double a);

}  // namespace tiretherm::physics
