// SPDX-License-Identifier: BSD-3-Clause
// Force of a tire in pure slip at one load, from its lowest to its highest, and the slip that makes a force.
#pragma once

#include <cmath>

#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::physics {

/// Slip where `force` takes a value, of a function of the slip that never falls (regula falsi, Illinois).
/// @param tolerance of the force  @returns `low` or `high` where the value lies beyond what is taken there
template <typename Force>
[[nodiscard]] double slip_where(const Force& force, double value, double low, double high, double tolerance) {
    double below = force(low) - value;
    double above = force(high) - value;
    if (below >= 0.0) {
        return low;
    }
    if (above <= 0.0) {
        return high;
    }
    int side = 0;  // the end that stayed last
    for (int i = 0; i < 200 && high - low > 1e-15 * (std::abs(low) + std::abs(high)); ++i) {
        // Every fourth time the middle: a flat side would keep regula falsi waiting.
        const double at = i % 4 == 3 ? 0.5 * (low + high) : (low * above - high * below) / (above - below);
        const double now = force(at) - value;
        if (std::abs(now) <= tolerance) {
            return at;
        }
        if (now < 0.0) {
            low = at;
            below = now;
            above *= side == 1 ? 0.5 : 1.0;
            side = 1;
        } else {
            high = at;
            above = now;
            below *= side == -1 ? 0.5 : 1.0;
            side = -1;
        }
    }
    return 0.5 * (low + high);
}

/// A tire's force in one direction against the slip in that direction alone. The slip counts in the sense in which the
/// force rises with it, whatever the sign of pKy1. Beyond its peaks the force stays at them.
class SlipCurve {
public:
    /// @param load N  @param static_load N, where the stiffness of a brush holds  @param camber rad, of the vehicle
    [[nodiscard]] static SlipCurve lateral(const VehicleTire& tire, double load, double static_load, double camber) {
        return {tire, true, load, static_load, camber};
    }
    [[nodiscard]] static SlipCurve longitudinal(const VehicleTire& tire, double load, double static_load,
                                                double camber) {
        return {tire, false, load, static_load, camber};
    }

    /// N, never falling. @param slip rad, or 1
    [[nodiscard]] double force(double slip) const;
    [[nodiscard]] double lowest() const { return lowest_; }    ///< N, at `first`
    [[nodiscard]] double highest() const { return highest_; }  ///< N, at `last`
    [[nodiscard]] double first() const { return first_; }      ///< slip of the lowest force
    [[nodiscard]] double last() const { return last_; }        ///< slip of the highest force
    /// How much there is at most in the direction of a force. @returns N, >= 0; infinite of a linear tire
    [[nodiscard]] double most(double force) const;
    /// The slip that makes the force; that of the peak where no slip does.
    [[nodiscard]] double slip(double force) const;
    /// A slip as the Magic Formula counts it: with pKy1 < 0 the other way.
    [[nodiscard]] double as_written(double slip) const { return sense_ * slip; }

private:
    SlipCurve(const VehicleTire& tire, bool is_lateral, double load, double static_load, double camber);
    [[nodiscard]] double of_law(double slip) const;
    /// @param side 1 of the highest force, -1 of the lowest
    [[nodiscard]] double peak_slip(double side) const;

    const VehicleTire* tire_ = nullptr;
    bool is_lateral_ = true;
    double load_ = 0.0;
    double static_load_ = 1.0;
    double camber_ = 0.0;
    double sense_ = 1.0;
    double first_ = 0.0;
    double last_ = 0.0;
    double lowest_ = 0.0;
    double highest_ = 0.0;
};

}  // namespace tiretherm::physics
