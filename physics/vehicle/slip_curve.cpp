// SPDX-License-Identifier: BSD-3-Clause
// Peaks of the Magic Formula from its macro-parameters, of the brush where all of the contact slides; inversion between
// them.

#include "physics/vehicle/slip_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/tire_laws/brush.hpp"

namespace tiretherm::physics {

namespace {

constexpr double largest_slip_angle = 0.7;  ///< rad, where a law has no peak before
constexpr double largest_slip_ratio = 0.9;
constexpr double far = 0.3;  ///< a slip that is surely on its side of the horizontal shift

Brush brush_of(const VehicleTire& tire, double stiffness, double load, double static_load) {
    // A contact of any length: force and slip do not depend on it.
    return {.half_length = 1.0,
            .tread_stiffness = 0.5 * stiffness * load / static_load,
            .friction = tire.friction,
            .load = load};
}

/// Where the Magic Formula has its peak: B x - E (B x - atan(B x)) = tan(pi / (2 C)).        Pacejka 2012, sec. 4.3.1
/// @returns |B x|; infinite where there is no peak
double peak_argument(double shape, double curvature) {
    if (shape <= 1.0) {
        return std::numeric_limits<double>::infinity();
    }
    const double wanted = std::tan(0.5 * std::numbers::pi / shape);
    const auto argument = [&](double u) { return u - curvature * (u - std::atan(u)); };
    double high = 1.0;
    while (argument(high) < wanted) {
        high *= 2.0;
        if (high > 1e4) {
            return std::numeric_limits<double>::infinity();
        }
    }
    return slip_where(argument, wanted, 0.0, high, 1e-12 * wanted);
}

}  // namespace

SlipCurve::SlipCurve(const VehicleTire& tire, bool is_lateral, double load, double static_load, double camber)
    : tire_(&tire), is_lateral_(is_lateral), load_(load), static_load_(static_load), camber_(camber) {
    if (load <= 0.0) {
        return;
    }
    if (is_lateral && tire.magic_formula && tire.magic_formula->cornering_stiffness(load, camber) < 0.0) {
        sense_ = -1.0;
    }
    first_ = peak_slip(-1.0);
    last_ = peak_slip(1.0);
    lowest_ = of_law(first_);
    highest_ = of_law(last_);
}

double SlipCurve::of_law(double slip) const {
    if (tire_->magic_formula) {
        const PureSlipState state{.load = load_, .slip = sense_ * slip, .camber = camber_};
        return is_lateral_ ? tire_->magic_formula->lateral(state).force
                           : tire_->magic_formula->longitudinal(state).force;
    }
    const double stiffness = is_lateral_ ? tire_->cornering_stiffness : tire_->slip_stiffness;
    const double sigma = is_lateral_ ? std::tan(slip) : Brush::of_slip_ratio(slip);
    const double all = stiffness * load_ / static_load_;
    return std::isinf(tire_->friction) ? all * sigma : brush_of(*tire_, stiffness, load_, static_load_).force(sigma);
}

double SlipCurve::peak_slip(double side) const {
    const double most = is_lateral_ ? largest_slip_angle : largest_slip_ratio;
    if (!tire_->magic_formula) {
        const double stiffness = is_lateral_ ? tire_->cornering_stiffness : tire_->slip_stiffness;
        const double sigma = std::isinf(tire_->friction)
                                 ? std::numeric_limits<double>::infinity()
                                 : side * brush_of(*tire_, stiffness, load_, static_load_).full_sliding_slip();
        // sigma = kappa/(1 + kappa) < 1 of a driven wheel, whatever its slip ratio.
        const double slip = is_lateral_ ? std::atan(sigma) : sigma < 1.0 ? sigma / (1.0 - sigma) : most;
        return std::isinf(sigma) ? side * most : std::clamp(slip, -most, most);
    }
    const MagicFormula& law = *tire_->magic_formula;
    const PureSlipState state{.load = load_, .slip = sense_ * side * far, .camber = camber_};
    const PureSlip curve = is_lateral_ ? law.lateral(state) : law.longitudinal(state);
    const double B = std::abs(curve.stiffness) / (curve.shape * curve.peak);
    if (!(curve.peak > 0.0) || !(B > 0.0)) {
        return 0.0;
    }
    const double x = sense_ * side * peak_argument(curve.shape, curve.curvature) / B - curve.horizontal_shift;
    const bool by_tangent = is_lateral_ && law.version != MagicFormulaVersion::mf52;
    return std::clamp(sense_ * (by_tangent ? std::atan(x) : x), -most, most);
}

double SlipCurve::force(double slip) const {
    return slip <= first_ ? lowest_ : slip >= last_ ? highest_ : of_law(slip);
}

double SlipCurve::most(double force) const {
    if (load_ > 0.0 && !tire_->magic_formula && std::isinf(tire_->friction)) {
        return tire_->friction;
    }
    return force < 0.0 ? -lowest_ : highest_;
}

double SlipCurve::slip(double force) const {
    return slip_where([this](double slip) { return this->force(slip); }, force, first_, last_, 1e-12 * load_);
}

}  // namespace tiretherm::physics
