// SPDX-License-Identifier: BSD-3-Clause
// The two-node model written a second time from the thesis (equations 31 to 49) and its errata, without code of
// physics/.
#pragma once

#include <algorithm>
#include <cmath>

namespace tiretherm::support {

/// The two-node model of the thesis, written down from its text and from the errata of thesis-notes.md, sharing nothing
/// with physics/: the numbers of the 225/50 R17 stand here a second time on purpose.
struct TwoNodeThesis {
    // Inputs of a moment.
    double V = 0.0;        ///< m/s
    double Fz = 0.0;       ///< N
    double alpha = 0.0;    ///< rad
    double kappa = 0.0;    ///< slip ratio
    double Fx = 0.0;       ///< N
    double Fy = 0.0;       ///< N
    double T_air = 0.0;    ///< K
    double T_track = 0.0;  ///< K

    // Scaling factors (V.1.2) and heat partition.
    double lambda_x = 1.0;
    double lambda_y = 1.0;
    double lambda_h = 1.0;
    double lambda_Hc = 1.0;
    double lambda_SELsrf = 1.0;
    double lambda_SELblk = 1.0;
    double hpc = 0.6;

    // k = a T^2 + b T + c of the link (34), about 20 C; c_v is constant.
    double k_20 = 0.29;
    double k_per_K = 0.00943;
    double k_per_K2 = 0.0;

    static constexpr double pi = 3.14159265358979323846;
    static constexpr double W = 0.225;
    static constexpr double H = 0.1125;
    static constexpr double R0 = 0.3308;
    static constexpr double h_tread = 0.012;
    static constexpr double h_sidewall = 0.009;
    static constexpr double rho = 1100.0;
    static constexpr double c_v = 1800.0;
    static constexpr double dZ = 0.010;

    [[nodiscard]] static double S_tot() { return 2.0 * pi * R0 * W; }
    [[nodiscard]] static double mass() { return rho * 2.0 * pi * R0 * W * h_tread; }  // (68), erratum E16
    [[nodiscard]] static double capacity_surface() { return 0.15 * mass() * c_v; }
    [[nodiscard]] static double capacity_bulk() { return 0.85 * mass() * c_v; }

    [[nodiscard]] double k(double T_bulk) const {
        const double x = T_bulk - 293.15;
        return k_20 + k_per_K * x + k_per_K2 * x * x;
    }

    [[nodiscard]] double S_cont() const { return 2.333e-6 * Fz; }  // (35)

    /// (33), erratum E4: T_surf in kelvin; never below the natural coefficient, erratum E9.
    [[nodiscard]] double h(double T_surf) const {
        const double L = 1.0 / (1.0 / (2.0 * R0) + 1.0 / W);
        const double forced = 0.025 / L * (0.318 * std::pow(V * L / 1.5e-5, 0.571));
        return std::max(30.0, forced + 8.59e-11 * std::exp(0.0879 * T_surf));
    }

    /// (37)-(49) with errata E1 (kelvin), E2 (contact length), E3 (area ratio), E5, E7 (sign), E8 (none at rest).
    [[nodiscard]] double SEL(double T_bulk) const {
        if (V == 0.0 || Fz == 0.0) {
            return 0.0;
        }
        const double R_L = 0.3308 - 4.2e-6 * Fz;
        const double R_R = 0.3483 * std::pow(Fz, -0.009);
        const double strain = (R0 - R_L) / H;
        const double A_sdw = h_sidewall * (H - h_tread);
        const double ratio = (W * h_tread + 2.0 * A_sdw) / (W * H);
        const double l = 0.160 - 2.0 * 0.160 / (1.0 + std::exp(0.35 * Fz / 1000.0));
        const double n = V / R_R / (2.0 * pi);
        const double decades = std::log10(n / 52.0);
        const double T_eq = T_bulk + 101.6 * decades / (-8.86 - decades);
        const double tan_delta = 2.14e15 * std::exp(-std::pow((T_eq + 4989.0) / 882.0, 2));
        const double per_passage = Fz * strain * ratio * H * tan_delta;  // (43)
        return per_passage * (2.0 * pi * R0 / l) * n;                    // (44)-(46)
    }

    /// Right-hand sides of (31) in W, and the sums of the absolute values of their terms.
    struct Flow {
        double surface;
        double bulk;
        double surface_terms;
        double bulk_terms;
    };

    [[nodiscard]] Flow flow(double T_surf, double T_bulk) const {
        const bool contact = Fz > 0.0;
        const double friction_x = contact ? hpc * lambda_x * std::abs(Fx * V * kappa) : 0.0;
        const double friction_y = contact ? hpc * lambda_y * std::abs(Fy * V * std::tan(alpha)) : 0.0;
        const double loss = SEL(T_bulk);
        const double SEL_srf = 0.15 * lambda_SELsrf * loss;
        const double SEL_blk = 0.85 * lambda_SELblk * loss;
        const double air = lambda_h * h(T_surf) * (T_air - T_surf) * (S_tot() - S_cont());
        const double track = lambda_Hc * 500.0 * (T_track - T_surf) * S_cont();
        const double link = k(T_bulk) / dZ * (T_bulk - T_surf) * S_tot();
        return {.surface = friction_x + friction_y + SEL_srf + air + track + link,
                .bulk = SEL_blk - link,
                .surface_terms = friction_x + friction_y + SEL_srf + std::abs(air) + std::abs(track) + std::abs(link),
                .bulk_terms = SEL_blk + std::abs(link)};
    }
};

}  // namespace tiretherm::support
