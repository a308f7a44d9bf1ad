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
/// is the flow through the tread that the slow field carries. Heat g of sliding that enters the tread's surface in the
/// contact warms it there, by the same two integrals of g over e_a, which stand on the right-hand side beside D: the road
/// takes a part of g back before the contact ends. Heat between the surfaces warms both
/// alike in the contact, so that the two integrals over it cancel and the term of earlier revolutions alone stays. Derived from Carslaw & Jaeger 1959, sec. 2.9 (flux into a half-space)
/// and Hurwitz's zeta function (DLMF 25.11).
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

    /// Of heat that enters the tread's surface evenly during the contact, what the road takes back before the contact ends;
    /// 0 to 1
    [[nodiscard]] double road_share(SlidingHeat enters = SlidingHeat::in_tread) const { return of(enters).road_share; }
    /// The tread's surface above its mean, by that heat alone, when it meets the road and when it leaves it, per W/m2 into
    /// the tread.
    /// @param scale on what the road takes  @returns K m2/W
    [[nodiscard]] double heated_at_entry(double scale = 1.0, SlidingHeat enters = SlidingHeat::in_tread) const {
        return entry_alone_ - scale * of(enters).entry_cooled;
    }
    [[nodiscard]] double heated_at_exit(double scale = 1.0, SlidingHeat enters = SlidingHeat::in_tread) const {
        return exit_alone_ - scale * of(enters).exit_cooled;
    }

private:
    double mean_ = 0.0;
    double entry_ = 0.0;
    double exit_ = 0.0;
    /// What the road takes of heat of sliding, and by how much that cools the tread's surface.
    struct Taken {
        double road_share = 0.0;
        double entry_cooled = 0.0;
        double exit_cooled = 0.0;
    };
    [[nodiscard]] const Taken& of(SlidingHeat enters) const {
        return enters == SlidingHeat::between ? between_ : in_tread_;
    }

    double entry_alone_ = 0.0;  ///< by the heat without a road
    double exit_alone_ = 0.0;
    Taken in_tread_;
    Taken between_;
};

/// The contact that the effect `resolved_contact` makes at a moment with a tread of this effusivity, or nothing at rest and
/// off the road.
[[nodiscard]] std::optional<ContactInRevolutions> contact_in_revolutions(const ActiveEffect& resolved_contact,
                                                                         double effusivity, const Tire& tire,
                                                                         const Inputs& inputs);

/// What of heat of sliding, which enters the tread evenly in the contact, stays there when the road has taken its share
/// back by an effect `resolved_contact`; 1 at rest and off the road.
[[nodiscard]] double kept_heat(const ActiveEffect& resolved_contact, double effusivity, SlidingHeat enters,
                               const OperatingPoint& point);

/// Hurwitz's zeta function, the sum of (a + k)^-s over k = 0, 1, ... and where that diverges its continuation.
/// DLMF 25.11.28 (Euler and Maclaurin), to 1e-14 of its largest term. @param s > 0, not 1  @param a > 0
[[nodiscard]] double hurwitz_zeta(double s, double a);

}  // namespace tiretherm::physics
