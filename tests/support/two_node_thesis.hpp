// SPDX-License-Identifier: BSD-3-Clause
// The two-node model written a second time from the thesis (equations 31 to 49) and its errata, without code of
// physics/.
#pragma once

#include <algorithm>
#include <cmath>

namespace tiretherm::support {

/// The numbers of a tire that the thesis's formulas need, and of its 225/50 R17 where nothing is said: they stand here a
/// second time on purpose.
struct ThesisTire {
    double W = 0.225;                ///< m
    double H = 0.1125;               ///< m
    double R0 = 0.3308;              ///< m
    double h_tread = 0.012;          ///< m
    double h_sidewall = 0.009;       ///< m
    double length_limit = 0.160;     ///< m, (57)
    double length_slope = 0.35e-3;   ///< 1/N
    double area_slope = 2.333e-6;    ///< m2/N, (35)
    double radius_slope = 4.2e-6;    ///< m/N, (37)
    double rolling_factor = 0.3483;  ///< m at 1 N, (62)

    [[nodiscard]] double R_R(double Fz) const { return rolling_factor * std::pow(Fz, -0.009); }
    [[nodiscard]] double length(double Fz) const {
        return length_limit - 2.0 * length_limit / (1.0 + std::exp(length_slope * Fz));
    }
};

/// The two-node model of the thesis, written down from its text and its errata, sharing nothing
/// with physics/.
struct TwoNodeThesis {
    ThesisTire tire{};

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
    static constexpr double rho = 1100.0;
    static constexpr double c_v = 1800.0;
    static constexpr double dZ = 0.010;

    [[nodiscard]] double S_tot() const { return 2.0 * pi * tire.R0 * tire.W; }
    /// (68), erratum E16
    [[nodiscard]] double mass() const { return rho * S_tot() * tire.h_tread; }
    [[nodiscard]] double capacity_surface() const { return 0.15 * mass() * c_v; }
    [[nodiscard]] double capacity_bulk() const { return 0.85 * mass() * c_v; }

    [[nodiscard]] double k(double T_bulk) const {
        const double x = T_bulk - 293.15;
        return k_20 + k_per_K * x + k_per_K2 * x * x;
    }

    [[nodiscard]] double S_cont() const { return tire.area_slope * Fz; }  // (35)

    /// (32)
    [[nodiscard]] double forced() const {
        const double L = 1.0 / (1.0 / (2.0 * tire.R0) + 1.0 / tire.W);
        return 0.025 / L * (0.318 * std::pow(V * L / 1.5e-5, 0.571));
    }

    /// (33), erratum E4: T_surf in kelvin; never below the natural coefficient, erratum E9.
    [[nodiscard]] double h(double T_surf) const {
        return std::max(30.0, forced() + 8.59e-11 * std::exp(0.0879 * T_surf));
    }

    /// (37)-(49) with errata E1 (kelvin), E2 (contact length), E3 (area ratio), E5, E7 (sign), E8 (none at rest).
    [[nodiscard]] double SEL(double T_bulk) const {
        if (V == 0.0 || Fz == 0.0) {
            return 0.0;
        }
        const double R_L = tire.R0 - tire.radius_slope * Fz;
        const double strain = (tire.R0 - R_L) / tire.H;
        const double A_sdw = tire.h_sidewall * (tire.H - tire.h_tread);
        const double ratio = (tire.W * tire.h_tread + 2.0 * A_sdw) / (tire.W * tire.H);
        const double n = V / tire.R_R(Fz) / (2.0 * pi);
        const double decades = std::log10(n / 52.0);
        const double T_eq = T_bulk + 101.6 * decades / (-8.86 - decades);
        const double tan_delta = 2.14e15 * std::exp(-std::pow((T_eq + 4989.0) / 882.0, 2));
        const double per_passage = Fz * strain * ratio * tire.H * tan_delta;  // (43)
        return per_passage * (2.0 * pi * tire.R0 / tire.length(Fz)) * n;      // (44)-(46)
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
