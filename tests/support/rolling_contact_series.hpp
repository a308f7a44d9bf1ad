// SPDX-License-Identifier: BSD-3-Clause
// Conductance of a tread that meets fresh road once a revolution, from the flux in each of 60 parts of the contact: a
// second way to what physics/contact computes by DLMF 25.11.
#pragma once

#include <Eigen/LU>
#include <cmath>

namespace tiretherm::support {

/// Two half-spaces, heated only where they touch: the tread for `contact` of each `revolution`, of which its surface's mean
/// is 1 K, the road once, from 0 K.
struct RollingContactSeries {
    double contact = 0.0;             ///< s
    double revolution = 0.0;          ///< s
    double road = 0.0;                ///< W s^0.5/(m2 K), effusivity
    double interface_film = 25000.0;  ///< W/(m2 K)

    /// Mean flux over the contact at a difference of 1 K. W/(m2 K)
    [[nodiscard]] double film(double tread) const {
        constexpr int parts = 60;
        const double dt = contact / parts;
        // q_i/h + sum_j (rise of the road + fall of the tread at i by q_j) = 1, in the middle of each part.
        Eigen::MatrixXd rows = Eigen::MatrixXd::Identity(parts, parts) / interface_film;
        for (int i = 0; i < parts; ++i) {
            for (int j = 0; j < parts; ++j) {
                const double late = (i - j) * dt;
                rows(i, j) += once(late, dt) / road + (once(late, dt) + before(late) * dt) / tread;
            }
        }
        return rows.partialPivLu().solve(Eigen::VectorXd::Ones(parts)).mean();
    }

private:
    static constexpr double pi = 3.14159265358979323846;

    /// Surface of a half-space of effusivity 1 after a flux of 1 during dt, of which the middle is `late` ago. K
    static double once(double late, double dt) {
        const auto root = [](double t) { return t > 0.0 ? std::sqrt(t) : 0.0; };
        return 2.0 / std::sqrt(pi) * (root(late + 0.5 * dt) - root(late - 0.5 * dt));
    }
    /// By one in each of all revolutions before, in 1/s: sum of 1/sqrt(pi (late + m P)) less what a steady mean has, which
    /// the surface's mean holds already; integrated over a revolution the whole is 0. The rest of the sum is an integral.
    [[nodiscard]] double before(double late) const {
        constexpr int revolutions = 2000;
        double sum = 0.0;
        for (int m = 1; m <= revolutions; ++m) {
            sum += 1.0 / std::sqrt(late / revolution + m);
        }
        sum -= 2.0 * std::sqrt(late / revolution + revolutions + 0.5);
        return sum / std::sqrt(pi * revolution);
    }
};

}  // namespace tiretherm::support
