// SPDX-License-Identifier: BSD-3-Clause
// Magic Formula in pure slip for MF-Tyre 5.2, MF-Tyre 6.1 and Pacejka's book of 2006 (thesis (4)-(11), (58)-(60),
// erratum E14); lambda_Tb scales K_y with the bulk temperature. A curve through a known peak where there is no file.
#pragma once

#include <cstdint>

namespace tiretherm::physics {

/// How camber acts, which differs between the Magic Formula's versions; g is the camber that the version uses.
enum class MagicFormulaVersion : std::uint8_t {
    mf52,       ///< MF-Tyre 5.2, property files FITTYP 5, 6 and 21: factor 1 - pKy3 |g|, g = lambda_gamma gamma, alpha
    book_2006,  ///< thesis (10), Pacejka's book of 2006: factor 1 - pKy3 g^2, g = sin gamma, alpha* = tan alpha
    mf61,  ///< MF-Tyre 6.1, FITTYP 61 and 62: factor 1 - pKy3 |g|, g = sin gamma, alpha* = tan alpha, pKy6 and pKy7
};

/// What a tire is put through. Angles as in the axis system of the coefficients.
struct PureSlipState {
    double load = 0.0;           ///< N, Fz
    double slip = 0.0;           ///< slip ratio kappa (1), or slip angle alpha (rad)
    double camber = 0.0;         ///< rad, gamma
    double speed = 16.7;         ///< m/s, V_cx of the contact centre; its sign turns alpha
    double sliding_speed = 0.0;  ///< m/s, V_s; counts only with lambda_muV
    double pressure = 0.0;       ///< Pa above the atmosphere; 0: that of the property file
};

/// A force and the macro-parameters of its curve D sin(C atan(B x - E (B x - atan B x))) + S_V, x = slip + S_H.
struct PureSlip {
    double force = 0.0;             ///< N
    double stiffness = 0.0;         ///< N or N/rad, K = B C D: the slope where x = 0
    double peak = 0.0;              ///< N, D
    double shape = 0.0;             ///< C
    double curvature = 0.0;         ///< E, <= 1
    double horizontal_shift = 0.0;  ///< S_H, in the slip
    double vertical_shift = 0.0;    ///< N, S_V
};

/// Forces of a tire in pure slip, from the coefficients of a property file, with no turn slip (every zeta is 1, so the
/// book's zeta_4 - 1 in S_Hy is 0).                                                                  thesis (8)-(11)
///     df_z = (Fz - Fz0')/Fz0',  Fz0' = lambda_Fz0 Fz0                                             thesis (9)
///     K_y = pKy1 Fz0' sin(pKy4 atan(Fz / ((pKy2 + pKy5 g^2) Fz0'))) (1 - pKy3 |g| or g^2) lambda_Ky      thesis (11)
/// The pressure acts in mf61 by dp_i = (p - p_i0)/p_i0 (Besselink, Schmeitz & Pacejka, Vehicle Syst. Dyn. 48, 2010):
///     K_x: 1 + pPx1 dp + pPx2 dp^2;  mu_x, mu_y: 1 + p3 dp + p4 dp^2;  K_ygamma: 1 + pPy5 dp
///     K_y: 1 + pPy1 dp, and the load of its peak, pKy2 + pKy5 g^2, times 1 + pPy2 dp
/// Erratum E14: (58) of the thesis lost the bars round gamma. The camber terms were compared with open implementations:
/// an MF 5.2 lateral force after B. Cobb and MFeval's branches for 5.2 and 6.1 all have |g|, none the square of (10).
/// In 5.2 they differ in S_Hy, here as in the former: pHy3 g; MFeval divides it by 1 - pKy3 |g|. A load below 0 counts
/// as 0.
struct MagicFormula {
    MagicFormulaVersion version = MagicFormulaVersion::mf52;
    double nominal_load = 4000.0;      ///< N, Fz0 > 0
    double reference_speed = 16.7;     ///< m/s, V_0 > 0
    double nominal_pressure = 0.0;     ///< Pa above the atmosphere, p_i0; 0: unknown, and dp is 0
    double own_pressure = 0.0;         ///< Pa, where a state gives none; 0: the nominal one
    double friction_degression = 1.0;  ///< A_mu in lambda'_mu = A lambda_mu/(1 + (A - 1) lambda_mu); the book offers 10

    double pCx1 = 0.0;
    double pDx1 = 0.0, pDx2 = 0.0, pDx3 = 0.0;  ///< pDx3: 1/rad2, 1 - pDx3 g^2 on the friction; not in (8)
    double pEx1 = 0.0, pEx2 = 0.0, pEx3 = 0.0, pEx4 = 0.0;
    double pKx1 = 0.0, pKx2 = 0.0, pKx3 = 0.0;
    double pHx1 = 0.0, pHx2 = 0.0;
    double pVx1 = 0.0, pVx2 = 0.0;
    double pPx1 = 0.0, pPx2 = 0.0, pPx3 = 0.0, pPx4 = 0.0;  ///< mf61

    double pCy1 = 0.0;
    double pDy1 = 0.0, pDy2 = 0.0, pDy3 = 0.0;
    double pEy1 = 0.0, pEy2 = 0.0, pEy3 = 0.0, pEy4 = 0.0, pEy5 = 0.0;  ///< pEy5: mf61
    double pKy1 = 0.0, pKy2 = 1.0, pKy3 = 0.0;
    double pKy4 = 2.0, pKy5 = 0.0, pKy6 = 0.0, pKy7 = 0.0;  ///< mf61
    double pHy1 = 0.0, pHy2 = 0.0, pHy3 = 0.0;              ///< pHy3: mf52, book_2006
    double pVy1 = 0.0, pVy2 = 0.0, pVy3 = 0.0, pVy4 = 0.0;
    double pPy1 = 0.0, pPy2 = 0.0, pPy3 = 0.0, pPy4 = 0.0, pPy5 = 0.0;  ///< mf61

    /// The user's lambdas, all 1 but muV.
    struct Scaling {
        double Fz0 = 1.0;
        double Cx = 1.0, mux = 1.0, Ex = 1.0, Kx = 1.0, Hx = 1.0, Vx = 1.0;
        double Cy = 1.0, muy = 1.0, Ey = 1.0, Ky = 1.0, Hy = 1.0, Vy = 1.0;
        double Kygamma = 1.0;               ///< book_2006, mf61
        double gammax = 1.0, gammay = 1.0;  ///< mf52
        double muV = 0.0;                   ///< decay of friction with V_s / V_0
    } lambda;

    /// F_x0 at a slip ratio.                                                                        thesis (8)
    [[nodiscard]] PureSlip longitudinal(const PureSlipState& state) const;
    /// F_y0 at a slip angle. @param lambda_Tb factor of the bulk temperature on K_y                 thesis (10)(59)
    /// @param grip of the surface's temperature on mu_y, beside lambda_muy
    [[nodiscard]] PureSlip lateral(const PureSlipState& state, double lambda_Tb = 1.0, double grip = 1.0) const;
    /// K_y(Fz, gamma), the reference of lambda_Tb. @param pressure as in PureSlipState
    /// @returns N/rad, with the sign of pKy1                                                        thesis (11)(60)
    [[nodiscard]] double cornering_stiffness(double load, double camber, double pressure = 0.0) const;
    /// K_ygamma0, about the force per camber at straight running. @returns N/rad                    thesis (10)
    [[nodiscard]] double camber_stiffness(double load, double pressure = 0.0) const;

private:
    [[nodiscard]] double load_change(double load) const;
    [[nodiscard]] double pressure_change(double pressure) const;
    [[nodiscard]] double camber_of(double camber, double scaling) const;
    [[nodiscard]] double camber_scaling() const;
    [[nodiscard]] double friction_scaling(double scaling, double sliding_speed) const;
};

/// A lateral force of which only the features are known: its slope, its peak and what is left far beyond the peak. They make the
/// Magic Formula's factors:                                                                             thesis (4)-(7)
///     D = mu Fz,  C = 1 + (1 - (2/pi) asin(y_a/D)),  B = CP/(C D),
///     E = (B x_m - tan(pi/(2 C))) / (B x_m - atan(B x_m)),  at most 1
struct PeakCurve {
    double friction = 1.0;                   ///< mu = D/Fz
    double asymptote = 0.9;                  ///< y_a/D, of the force far beyond its peak, >= 0 and < 1
    double peak_slip = 0.13089969389957470;  ///< rad, x_m > 0; 7.5 degrees: 7 to 8 of the thesis's tire (II.2)

    /// C of a curve that has a peak.                                                                    thesis (6)
    [[nodiscard]] double shape() const;
    /// E, so that a curve of this B has its peak at `peak_slip`.                                        thesis (7)
    /// @param B 1/rad, > 0  @returns at most 1
    [[nodiscard]] double curvature(double B) const;
    /// @param load N  @param CP N/rad, cornering stiffness  @param slip rad
    /// @param grip factor on the friction; the peak is at so much less or more slip
    [[nodiscard]] PureSlip force(double load, double CP, double slip, double grip = 1.0) const;
};

}  // namespace tiretherm::physics
