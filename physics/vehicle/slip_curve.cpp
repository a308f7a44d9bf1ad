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

double slip_where(const std::function<double(double)>& force, double value, double low, double high, double tolerance) {
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

SlipCurve SlipCurve::lateral(const VehicleTire& tire, double load, double static_load, double camber) {
    SlipCurve curve;
    curve.tire_ = &tire;
    curve.load_ = load;
    curve.static_load_ = static_load;
    curve.camber_ = camber;
    if (load <= 0.0) {
        return curve;
    }
    if (tire.magic_formula && tire.magic_formula->cornering_stiffness(load, camber) < 0.0) {
        curve.sense_ = -1.0;
    }
    curve.first_ = curve.peak_slip(-1.0);
    curve.last_ = curve.peak_slip(1.0);
    curve.lowest_ = curve.of_law(curve.first_);
    curve.highest_ = curve.of_law(curve.last_);
    return curve;
}

SlipCurve SlipCurve::longitudinal(const VehicleTire& tire, double load, double static_load, double camber) {
    SlipCurve curve;
    curve.tire_ = &tire;
    curve.is_lateral_ = false;
    curve.load_ = load;
    curve.static_load_ = static_load;
    curve.camber_ = camber;
    if (load <= 0.0) {
        return curve;
    }
    curve.first_ = curve.peak_slip(-1.0);
    curve.last_ = curve.peak_slip(1.0);
    curve.lowest_ = curve.of_law(curve.first_);
    curve.highest_ = curve.of_law(curve.last_);
    return curve;
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
