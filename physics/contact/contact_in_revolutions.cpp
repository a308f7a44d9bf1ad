// SPDX-License-Identifier: BSD-3-Clause
// Collocation in y = sqrt(t/t_c) with a flux that is linear in each of 24 pieces, Abel integrals in closed form, and
// earlier revolutions by the Taylor series of zeta(1/2, 1 + x).

#include "physics/contact/contact_in_revolutions.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <Eigen/LU>

namespace tiretherm::physics {

namespace {

/// Of the contact, evenly spaced in the square root of time, in which the flux is smooth.
constexpr int n_pieces = 24;
using Vector = Eigen::Matrix<double, n_pieces + 1, 1>;
using Square = Eigen::Matrix<double, n_pieces + 1, n_pieces + 1>;

double node(int j) { return static_cast<double>(j) / n_pieces; }

/// int of 2 y / sqrt(x^2 - y^2) and of 2 y^2 / sqrt(x^2 - y^2) up to y.
struct Abel {
    double zeroth = 0.0;
    double first = 0.0;
};
Abel abel_up_to(double y, double x) {
    const double root = std::sqrt(std::max(0.0, x * x - y * y));
    return {.zeroth = -2.0 * root, .first = x * x * std::asin(std::min(1.0, y / x)) - y * root};
}

/// What a flux that is straight in y = sqrt(t/t_c) between its nodes amounts to, whatever the contact.
struct Weights {
    /// Row i: int_0^t q(s) / sqrt(pi (t-s)) ds at t = t_c node(i)^2, over sqrt(t_c / pi).
    Square abel = Square::Zero();
    /// int_0^t_c q ds, over t_c: of hat functions in 2 y dy.
    Vector mean = Vector::Zero();

    Weights() {
        constexpr double width = 1.0 / n_pieces;
        for (int j = 0; j < n_pieces; ++j) {
            mean[j] += width * (node(j) + width / 3.0);
            mean[j + 1] += width * (node(j) + 2.0 * width / 3.0);
            for (int i = j + 1; i <= n_pieces; ++i) {
                const Abel from = abel_up_to(node(j), node(i));
                const Abel to = abel_up_to(node(j + 1), node(i));
                const double zeroth = to.zeroth - from.zeroth;
                const double first = to.first - from.first;
                abel(i, j) += (node(j + 1) * zeroth - first) * n_pieces;
                abel(i, j + 1) += (first - node(j) * zeroth) * n_pieces;
            }
        }
    }
};

/// Taylor's series of zeta(1/2, 1 + x) about x = 0, whose terms fall by x: d/da zeta(s, a) = -s zeta(s+1, a).
class PastContacts {
public:
    PastContacts() {
        double factor = 1.0;
        for (std::size_t n = 0; n < terms_.size(); ++n) {
            const double s = 0.5 + static_cast<double>(n);
            terms_[n] = factor * hurwitz_zeta(s, 1.0);
            factor *= -s / static_cast<double>(n + 1);
        }
    }
    [[nodiscard]] double operator()(double x) const {
        double sum = 0.0;
        for (std::size_t n = terms_.size(); n-- > 0;) {
            sum = sum * x + terms_[n];
        }
        return sum;
    }

private:
    std::array<double, 14> terms_{};  // 1e-8 of it are left at x = 0.3, the largest share of a revolution
};

}  // namespace

double hurwitz_zeta(double s, double a) {
    constexpr int n_terms = 14;
    double sum = 0.0;
    for (int k = 0; k < n_terms; ++k) {
        sum += std::pow(a + k, -s);
    }
    const double x = a + n_terms;
    sum += std::pow(x, -s) * (x / (s - 1.0) + 0.5);
    // B_2j / (2j)! s (s+1) ... (s+2j-2) x^(-s-2j+1)
    double factor = s * std::pow(x, -s - 1.0);
    int j = 0;
    for (const double bernoulli : {1.0 / 12.0, -1.0 / 720.0, 1.0 / 30240.0, -1.0 / 1209600.0, 1.0 / 47900160.0}) {
        sum += bernoulli * factor;
        factor *= (s + 2 * j + 1) * (s + 2 * j + 2) / (x * x);
        ++j;
    }
    return sum;
}

ContactInRevolutions::ContactInRevolutions(const ContactOfHalfSpaces& contact, double duration, double period) {
    static const Weights weights;
    static const PastContacts past_contacts;
    const double share = duration / period;
    Square past;
    for (int i = 0; i <= n_pieces; ++i) {
        for (int j = 0; j <= n_pieces; ++j) {
            past(i, j) = weights.mean[j] * past_contacts((node(i) * node(i) - node(j) * node(j)) * share);
        }
    }
    const Square abel = std::sqrt(duration * std::numbers::inv_pi) * weights.abel;
    past *= duration / std::sqrt(std::numbers::pi * period);
    const double a = 1.0 / contact.effusivity_a;
    const Square system =
        Square(Square::Identity()) / contact.interface_h + (a + 1.0 / contact.effusivity_b) * abel + a * past;
    const Square tread = a * (abel + past);  // the tread's surface above its mean, by the flux into it
    Eigen::Matrix<double, n_pieces + 1, 3> right;
    right.col(0) = Vector::Ones();
    right.col(1) = tread.rowwise().sum();
    right.col(2) = a * past.rowwise().sum();
    const Eigen::Matrix<double, n_pieces + 1, 3> flux = system.partialPivLu().solve(right);
    mean_ = weights.mean.dot(flux.col(0));
    entry_ = -tread.row(0).dot(flux.col(0));
    exit_ = -tread.row(n_pieces).dot(flux.col(0));
    entry_alone_ = tread.row(0).sum();
    exit_alone_ = tread.row(n_pieces).sum();
    const auto taken = [&](int column) {
        return Taken{.road_share = weights.mean.dot(flux.col(column)),
                     .entry_cooled = tread.row(0).dot(flux.col(column)),
                     .exit_cooled = tread.row(n_pieces).dot(flux.col(column))};
    };
    in_tread_ = taken(1);
    between_ = taken(2);
}

}  // namespace tiretherm::physics
