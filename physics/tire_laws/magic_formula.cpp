// SPDX-License-Identifier: BSD-3-Clause
// Finds B, C, D, E and the shifts of each version, then F = D sin(C atan(Bx - E (Bx - atan Bx))) + S_V with x = slip +
// S_H.

#include "physics/tire_laws/magic_formula.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tiretherm::physics {

namespace {

constexpr double epsilon = 1e-6;             // N, keeps B finite without load
constexpr double epsilon_speed = 1e-3;       // m/s, eps_Vx of (8)
constexpr double smallest_stiffness = 1e-6;  // N/rad, keeps the camber shift of 6.1 finite

double sign(double x) { return x > 0.0 ? 1.0 : (x < 0.0 ? -1.0 : 0.0); }

/// Fills in the force from the macro-parameters. @param x slip with its horizontal shift
PureSlip on_curve(PureSlip curve, double x) {
    const double B = curve.stiffness / (curve.shape * curve.peak + epsilon);
    const double Bx = B * x;
    curve.curvature = std::min(curve.curvature, 1.0);
    curve.force = curve.peak * std::sin(curve.shape * std::atan(Bx - curve.curvature * (Bx - std::atan(Bx)))) +
                  curve.vertical_shift;
    return curve;
}

}  // namespace

double MagicFormula::load_change(double load) const {
    const double reference = lambda.Fz0 * nominal_load;
    return (load - reference) / reference;
}

double MagicFormula::pressure_change(double pressure) const {
    const double p = pressure > 0.0 ? pressure : own_pressure;
    return nominal_pressure > 0.0 && p > 0.0 ? (p - nominal_pressure) / nominal_pressure : 0.0;
}

double MagicFormula::camber_of(double camber, double scaling) const {
    return version == MagicFormulaVersion::mf52 ? camber * scaling : std::sin(camber);
}

double MagicFormula::camber_scaling() const { return version == MagicFormulaVersion::mf52 ? 1.0 : lambda.Kygamma; }

double MagicFormula::friction_scaling(double scaling, double sliding_speed) const {
    return scaling / (1.0 + lambda.muV * std::abs(sliding_speed) / reference_speed);
}

PureSlip MagicFormula::longitudinal(const PureSlipState& state) const {
    const double Fz = std::max(0.0, state.load);
    const double df = load_change(Fz);
    const double g = camber_of(state.camber, lambda.gammax);
    const double scaling = friction_scaling(lambda.mux, state.sliding_speed);
    const double degressive = friction_degression * scaling / (1.0 + (friction_degression - 1.0) * scaling);
    const double dp = pressure_change(state.pressure);
    const double mu = (pDx1 + pDx2 * df) * (1.0 + dp * (pPx3 + pPx4 * dp)) * (1.0 - pDx3 * g * g) * scaling;
    const double rolling = version == MagicFormulaVersion::book_2006
                               ? std::abs(state.speed) / (epsilon_speed + std::abs(state.speed))
                               : 1.0;
    PureSlip curve{
        .stiffness = Fz * (pKx1 + pKx2 * df) * std::exp(pKx3 * df) * (1.0 + dp * (pPx1 + pPx2 * dp)) * lambda.Kx,
        .peak = std::max(0.0, mu * Fz),
        .shape = pCx1 * lambda.Cx,
        .horizontal_shift = (pHx1 + pHx2 * df) * lambda.Hx,
        .vertical_shift = Fz * (pVx1 + pVx2 * df) * rolling * lambda.Vx * degressive};
    const double x = state.slip + curve.horizontal_shift;
    curve.curvature = (pEx1 + df * (pEx2 + df * pEx3)) * (1.0 - pEx4 * sign(x)) * lambda.Ex;
    return on_curve(curve, x);
}

double MagicFormula::cornering_stiffness(double load, double camber, double pressure) const {
    const double dp = pressure_change(pressure);
    const double reference = lambda.Fz0 * nominal_load;
    const double g = camber_of(camber, lambda.gammay);
    const double leaning = version == MagicFormulaVersion::book_2006 ? g * g : std::abs(g);  // erratum E14
    const double stiffest = (pKy2 + pKy5 * g * g) * (1.0 + pPy2 * dp) * reference;
    return pKy1 * reference * (1.0 + pPy1 * dp) * std::sin(pKy4 * std::atan(std::max(0.0, load) / stiffest)) *
           (1.0 - pKy3 * leaning) * lambda.Ky;
}

double MagicFormula::camber_stiffness(double load, double pressure) const {
    const double Fz = std::max(0.0, load);
    const double df = load_change(Fz);
    return version == MagicFormulaVersion::mf61
               ? Fz * (pKy6 + pKy7 * df) * (1.0 + pPy5 * pressure_change(pressure)) * camber_scaling()
               : (pHy3 * cornering_stiffness(Fz, 0.0) + Fz * (pVy3 + pVy4 * df)) * camber_scaling();
}

PureSlip MagicFormula::lateral(const PureSlipState& state, double lambda_Tb, double grip) const {
    const double Fz = std::max(0.0, state.load);
    const double df = load_change(Fz);
    const double g = camber_of(state.camber, lambda.gammay);
    const double scaling = friction_scaling(grip * lambda.muy, state.sliding_speed);
    const double degressive = friction_degression * scaling / (1.0 + (friction_degression - 1.0) * scaling);
    const double K = lambda_Tb * cornering_stiffness(Fz, state.camber, state.pressure);
    const double dp = pressure_change(state.pressure);
    const double mu = (pDy1 + pDy2 * df) * (1.0 + dp * (pPy3 + pPy4 * dp)) * (1.0 - pDy3 * g * g) * scaling;
    const double S_Vgamma = Fz * (pVy3 + pVy4 * df) * g * camber_scaling() * degressive;

    PureSlip curve{.stiffness = K,
                   .peak = std::max(0.0, mu * Fz),
                   .shape = pCy1 * lambda.Cy,
                   .horizontal_shift = (pHy1 + pHy2 * df) * lambda.Hy,
                   .vertical_shift = Fz * (pVy1 + pVy2 * df) * lambda.Vy * degressive + S_Vgamma};
    if (version == MagicFormulaVersion::mf61) {
        const double divisor = std::abs(K) < smallest_stiffness ? std::copysign(smallest_stiffness, K) : K;
        curve.horizontal_shift += (camber_stiffness(Fz, state.pressure) * g - S_Vgamma) / divisor;
    } else {
        curve.horizontal_shift += pHy3 * g * camber_scaling();
    }
    const double turned = state.speed < 0.0 ? -state.slip : state.slip;
    const double slip = version == MagicFormulaVersion::mf52 ? turned : std::tan(turned);
    const double x = slip + curve.horizontal_shift;
    curve.curvature = (pEy1 + pEy2 * df) * (1.0 + pEy5 * g * g - (pEy3 + pEy4 * g) * sign(x)) * lambda.Ey;
    return on_curve(curve, x);
}

double PeakCurve::shape() const { return 2.0 - 2.0 / std::numbers::pi * std::asin(asymptote); }

double PeakCurve::curvature(double B) const {
    const double Bx = B * peak_slip;
    return std::min(1.0, (Bx - std::tan(0.5 * std::numbers::pi / shape())) / (Bx - std::atan(Bx)));
}

PureSlip PeakCurve::force(double load, double CP, double slip, double grip) const {
    PureSlip curve{.stiffness = CP, .peak = friction * std::max(0.0, load), .shape = shape()};
    if (curve.peak > 0.0 && CP > 0.0) {
        curve.curvature = curvature(CP / (curve.shape * curve.peak));
        curve.peak *= grip;
        curve = on_curve(curve, slip);
    }
    return curve;
}

}  // namespace tiretherm::physics
