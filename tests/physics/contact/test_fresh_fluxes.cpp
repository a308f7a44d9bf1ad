// SPDX-License-Identifier: BSD-3-Clause
// Fluxes of a contact without memory, by collocation and by their table, and the small system of a contact in revolutions
// against the whole one.

#include "physics/contact/fresh_fluxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "physics/contact/contact_in_revolutions.hpp"

namespace tiretherm::physics {

namespace {

double largest(const FreshFluxes& fluxes) {
    return std::max(fluxes.moments.cwiseAbs().maxCoeff(), fluxes.abel_at_exit.cwiseAbs().maxCoeff());
}

FreshFluxes difference(const FreshFluxes& one, const FreshFluxes& other) {
    return {.moments = one.moments - other.moments, .abel_at_exit = one.abel_at_exit - other.abel_at_exit};
}

constexpr int n_pieces = 24;
using Fluxes = Eigen::Matrix<double, n_pieces + 1, 3>;

/// The contact in revolutions from all its nodes: fluxes by the difference, by heat into the tread and by heat between the
/// surfaces, in a dense system. Earlier contacts by Hurwitz's zeta function itself; Abel's integral of a hat function from
/// its second integral: int_0^y 2 z / sqrt(x^2 - z^2) dz and the like by the angle, z = x sin(angle).
class WholeContact {
public:
    WholeContact(const ContactOfHalfSpaces& of, double duration, double period) {
        constexpr double width = 1.0 / n_pieces;
        const auto node = [](int i) { return i * width; };
        Eigen::MatrixXd abel = Eigen::MatrixXd::Zero(n_pieces + 1, n_pieces + 1);
        Eigen::MatrixXd past(n_pieces + 1, n_pieces + 1);
        for (int j = 0; j <= n_pieces; ++j) {
            // int 2 z hat dz: of a whole hat 2 node width, of the half ones at the ends by their centre of area
            mean_[j] = 2.0 * node(j) * width;
            mean_[j] = j == 0 ? width * width / 3.0 : mean_[j];
            mean_[j] = j == n_pieces ? width * (1.0 - width / 3.0) : mean_[j];
        }
        for (int i = 0; i <= n_pieces; ++i) {
            const double x = node(i);
            for (int j = 0; j < i; ++j) {
                const double from = std::asin(std::min(1.0, node(j) / x));
                const double to = std::asin(std::min(1.0, node(j + 1) / x));
                const double even = 2.0 * x * (std::cos(from) - std::cos(to));
                const double rising = x * x * (to - from - 0.5 * (std::sin(2.0 * to) - std::sin(2.0 * from)));
                abel(i, j) += (node(j + 1) * even - rising) / width;
                abel(i, j + 1) += (rising - node(j) * even) / width;
            }
            for (int j = 0; j <= n_pieces; ++j) {
                past(i, j) = mean_[j] * hurwitz_zeta(0.5, 1.0 + (x * x - node(j) * node(j)) * duration / period);
            }
        }
        abel *= std::sqrt(duration / std::numbers::pi);
        past *= duration / std::sqrt(std::numbers::pi * period);
        const double a = 1.0 / of.effusivity_a;
        tread_ = a * (abel + past);
        Fluxes right;
        right.col(0).setOnes();
        right.col(1) = tread_.rowwise().sum();
        right.col(2) = a * past.rowwise().sum();
        const Eigen::MatrixXd system = Eigen::MatrixXd::Identity(n_pieces + 1, n_pieces + 1) / of.interface_h + tread_ +
                                       1.0 / of.effusivity_b * abel;
        flux_ = system.partialPivLu().solve(right);
    }

    [[nodiscard]] double mean(int drive) const { return mean_.dot(flux_.col(drive)); }
    [[nodiscard]] double at_entry(int drive) const { return tread_.row(0).dot(flux_.col(drive)); }
    [[nodiscard]] double at_exit(int drive) const { return tread_.row(n_pieces).dot(flux_.col(drive)); }
    /// The tread's surface by heat alone.
    [[nodiscard]] double heated_at_entry() const { return tread_.row(0).sum(); }
    [[nodiscard]] double heated_at_exit() const { return tread_.row(n_pieces).sum(); }

private:
    Eigen::Matrix<double, n_pieces + 1, 1> mean_;
    Eigen::MatrixXd tread_;
    Fluxes flux_;
};

}  // namespace

// With H = 0 the flux is its drive. Of an even one the moment k is int_-1/2^1/2 u^k du = 1, 0, 1/12. Pieces that are
// straight in y = sqrt(t/t_c) lie width^2/12 g'' above a convex g in the mean: 2/12 width^2 of u = y^2 - 1/2, whose g'' is 2,
// and 4/12 width^2 of u^2, where 12 y^2 - 2 is 4 in the mean of 2 y dy. int_0^1 ds / sqrt(1-s) = 2.
TEST(FreshFluxes, AreTheirDrivesWithoutAnInterface) {
    const FreshFluxes none = FreshFluxes::at(0.0);
    constexpr double width_squared = 1.0 / (24.0 * 24.0);
    EXPECT_NEAR(none.moments(0, 0), 1.0, 1e-14);
    EXPECT_NEAR(none.moments(1, 0), width_squared / 6.0, 1e-5);
    EXPECT_NEAR(none.moments(2, 0), 1.0 / 12.0 + width_squared / 3.0, 1e-5);
    EXPECT_NEAR(none.abel_at_exit[0], 2.0, 1e-13);
}

// f + H A f = 1 with A f(t) = int f(s)/sqrt(t_c (t-s)) ds is f = e^(x^2) erfc(x), x = H sqrt(pi t/t_c) (Carslaw & Jaeger
// 1959, sec. 2.8; Abel's equation of the second kind). At the exit A f = (1 - f)/H. The pieces leave 3e-4 of 1.
TEST(FreshFluxes, OfAnEvenDriveFallAsTheScaledErrorFunction) {
    for (const double H : {0.01, 0.3, 1.0, 3.0, 10.0}) {
        const double exact = (1.0 - scaled_erfc(H * std::sqrt(std::numbers::pi))) / H;
        EXPECT_NEAR(FreshFluxes::at(H).abel_at_exit[0] * H, exact * H, 3e-4) << H;
    }
}

// Polynomials of degree 7 in octaves of ln H, with singularities 9 half-octaves away in the complex plane, leave a few 1e-9;
// below and above the table there is the equation itself.
TEST(FreshFluxes, OfTheTableAreThoseOfTheEquation) {
    double worst = 0.0;
    for (double exponent = -12.0; exponent < 16.0; exponent += 0.0137) {
        const double H = std::exp2(exponent);
        const FreshFluxes exact = FreshFluxes::by_collocation(H);
        worst = std::max(worst, largest(difference(FreshFluxes::at(H), exact)) / largest(exact));
    }
    EXPECT_LT(worst, 1e-8);
}

// Where two octaves meet, and at both ends of the table, neither value nor slope jumps. One-sided differences of third order
// with steps of 1e-3 of ln H are off by 1e-9/4 times the fourth derivative, which is no more than a few of the fluxes.
TEST(FreshFluxes, HaveContinuousSlopesWhereOctavesMeet) {
    constexpr double step = 1e-3;
    for (int octave = -8; octave <= 12; ++octave) {
        const double H = std::exp2(octave);
        const FreshFluxes slope = FreshFluxes::slope_by_collocation(H);
        const double scale = largest(FreshFluxes::at(H));
        std::array<FreshFluxes, 2> ends;
        for (const int side : {0, 1}) {
            const double signed_step = side == 0 ? -step : step;
            FreshFluxes found;
            int n = 0;
            for (const double factor : {-11.0, 18.0, -9.0, 2.0}) {
                const FreshFluxes away = FreshFluxes::at(H * std::exp(signed_step * (n++ + 1e-8)));
                found.moments += factor / (6.0 * signed_step) * away.moments;
                found.abel_at_exit += factor / (6.0 * signed_step) * away.abel_at_exit;
            }
            EXPECT_LT(largest(difference(found, slope)), 5e-9 * scale) << octave;
            ends[static_cast<std::size_t>(side)] = FreshFluxes::at(H * std::exp(1e-12 * signed_step));
        }
        EXPECT_LT(largest(difference(ends[0], ends[1])), 1e-13 * scale) << octave;
    }
}

// The whole system of all nodes, with Hurwitz's zeta function at each pair, against the small one of the moments. A contact
// takes 0.03 to 0.08 of a revolution: 1e-8, the error of the table. At 0.3, the largest share, seven powers of time leave 2e-6.
TEST(ContactInRevolutions, IsTheWholeSystemOfItsNodes) {
    for (const double share : {1e-6, 0.05, 0.08, 0.3}) {
        const double error = share < 0.1 ? 2e-8 : 3e-6;
        for (const double interface_h : {1.0, 1e3, 2.5e4, 5.7e4, 1e6}) {
            for (const double of_tread : {400.0, 757.8, 1600.0}) {
                for (const double of_road : {100.0, 1576.0, 9000.0}) {
                    const double duration = 3.48e-3;
                    const ContactOfHalfSpaces surfaces{
                        .interface_h = interface_h, .effusivity_a = of_tread, .effusivity_b = of_road};
                    const ContactInRevolutions small(surfaces, duration, duration / share);
                    const WholeContact whole(surfaces, duration, duration / share);
                    EXPECT_NEAR(small.mean_conductance() / whole.mean(0), 1.0, error) << share << ' ' << interface_h;
                    EXPECT_NEAR(small.at_entry(), -whole.at_entry(0), error);
                    EXPECT_NEAR(small.at_exit(), -whole.at_exit(0), error);
                    const double flash = std::abs(whole.heated_at_exit());
                    EXPECT_NEAR(small.heated_at_entry(0.0), whole.heated_at_entry(), error * flash);
                    EXPECT_NEAR(small.heated_at_exit(0.0), whole.heated_at_exit(), error * flash);
                    for (const SlidingHeat enters : {SlidingHeat::in_tread, SlidingHeat::between}) {
                        const int drive = enters == SlidingHeat::in_tread ? 1 : 2;
                        EXPECT_NEAR(small.road_share(enters), whole.mean(drive), error);
                        EXPECT_NEAR(small.heated_at_entry(1.0, enters), whole.heated_at_entry() - whole.at_entry(drive),
                                    error * flash);
                        EXPECT_NEAR(small.heated_at_exit(1.0, enters), whole.heated_at_exit() - whole.at_exit(drive),
                                    error * flash);
                    }
                }
            }
        }
    }
}

}  // namespace tiretherm::physics
