// SPDX-License-Identifier: BSD-3-Clause
// Exact cooling of a long round bar through its side, as a Bessel series: Carslaw and Jaeger (2nd ed. 1959), section
// 7.7.
#pragma once

#include <cmath>
#include <vector>

namespace tiretherm::support {

/// A long bar of radius a, at an excess of 1 over its surroundings, that exchanges heat through its side:
///
///     T(r, t) = sum_n 2 B J0(beta_n r/a) exp(-beta_n^2 alpha t/a^2) / ((beta_n^2 + B^2) J0(beta_n)),
///     beta_n J1(beta_n) = B J0(beta_n),   B = h a / k,
///
/// Carslaw and Jaeger, Conduction of Heat in Solids (2nd ed. 1959), section 7.7. Between two zeros of J1 the
/// left-hand side minus the right-hand side changes sign once; zero n of J1 lies between n pi and (n + 1/4) pi.
class RoundBar {
public:
    RoundBar(double radius, double conductivity, double capacity, double h, int terms)
        : radius_(radius), diffusivity_(conductivity / capacity), biot_(h * radius / conductivity) {
        const auto J1 = [](double x) { return std::cyl_bessel_j(1.0, x); };
        const auto balance = [&](double x) { return x * J1(x) - biot_ * std::cyl_bessel_j(0.0, x); };
        const double pi = std::acos(-1.0);
        double below = 0.0;
        for (int n = 1; n <= terms; ++n) {
            const double above = root(J1, n * pi, (n + 0.25) * pi);
            beta_.push_back(root(balance, below, above));
            below = above;
        }
    }

    [[nodiscard]] double excess(double r, double t) const {
        double sum = 0.0;
        for (const double b : beta_) {
            sum += 2.0 * biot_ * std::cyl_bessel_j(0.0, b * r / radius_) /
                   ((b * b + biot_ * biot_) * std::cyl_bessel_j(0.0, b)) *
                   std::exp(-b * b * diffusivity_ * t / (radius_ * radius_));
        }
        return sum;
    }

private:
    template <typename Function>
    static double root(const Function& f, double low, double high) {
        const bool rising = f(high) > f(low);
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (low + high);
            ((f(middle) < 0.0) == rising ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    double radius_;
    double diffusivity_;
    double biot_;
    std::vector<double> beta_;
};

}  // namespace tiretherm::support
