// SPDX-License-Identifier: BSD-3-Clause
// Periodic contact averaged over revolutions, against half-spaces and a fine grid integrated exactly in time.

#include "physics/contact/contact_in_revolutions.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace tiretherm::physics {

namespace {

constexpr double tread_k = 0.29;        // W/(m K)
constexpr double tread_rho_c = 1.98e6;  // J/(m3 K)
constexpr double road_k = 1.2;
constexpr double road_rho_c = 2.07e6;
const ContactOfHalfSpaces tread_on_road{.interface_h = 2.5e4,
                                        .effusivity_a = std::sqrt(tread_k * tread_rho_c),
                                        .effusivity_b = std::sqrt(road_k * road_rho_c)};

/// Cells of a slab and of a road on a square metre, stepped through contacts and pauses exactly in time (by the
/// eigenvectors of their matrix); the slab's far side is held at 1 K above the road, everything else insulated.
class SlabOnRoad {
public:
    /// @param growth of the cells from the surface in
    SlabOnRoad(double interface_h, double first_cell, double growth, double depth) : interface_h_(interface_h) {
        double width = first_cell;
        for (double d = 0.0; d < depth; d += width, width *= growth) {
            tread_.push_back(width);
        }
        width = first_cell;
        for (double d = 0.0; d < 1.5 * depth; d += width, width *= growth) {
            road_.push_back(width);
        }
    }

    struct Periodic {
        double mean = 0.0;   ///< of the slab's surface over the revolution
        double entry = 0.0;  ///< of the slab's surface
        double exit = 0.0;
        double exchanged = 0.0;  ///< J/m2 to the road, each contact
    };

    /// The state that comes back after a revolution, from the linear map of the slab's cells over one.
    /// @param heated W/m2 into the slab's surface during the contact  @param hot K, far side of the slab
    [[nodiscard]] Periodic revolution(double duration, double period, double hot, double heated) const {
        const auto n = static_cast<Eigen::Index>(tread_.size());
        const auto all = n + static_cast<Eigen::Index>(road_.size());
        const Mode touching(*this, true, hot, heated);
        const Mode apart(*this, false, hot, 0.0);
        const auto turn = [&](const Eigen::VectorXd& tread) {
            Eigen::VectorXd T = Eigen::VectorXd::Zero(all);
            T.head(n) = tread;
            return Eigen::VectorXd(apart.after(period - duration, touching.after(duration, T).head(n)));
        };
        const Eigen::VectorXd b = turn(Eigen::VectorXd::Zero(n));
        Eigen::MatrixXd M(n, n);
        for (Eigen::Index j = 0; j < n; ++j) {
            M.col(j) = turn(Eigen::VectorXd::Unit(n, j)) - b;
        }
        const Eigen::VectorXd start = (Eigen::MatrixXd::Identity(n, n) - M).partialPivLu().solve(b);
        Eigen::VectorXd T = Eigen::VectorXd::Zero(all);
        T.head(n) = start;
        const Eigen::VectorXd end = touching.after(duration, T);
        const double h = conductance();
        const double half = 0.5 * tread_.front() / tread_k;
        // Surface of the slab: below its first cell by the flux to the road, above it by the heat that enters.
        const auto surface = [&](const Eigen::VectorXd& now) {
            return now[0] + half * (heated - h * (now[0] - now[n] + heated * half));
        };
        const Eigen::VectorXd sum = touching.integral(duration, T);
        const double flux = h * (sum[0] - sum[n] + duration * heated * half);
        return {
            .mean = (sum[0] + half * (duration * heated - flux) + apart.integral(period - duration, end.head(n))[0]) /
                    period,
            .entry = start[0],
            .exit = surface(end),
            .exchanged = flux};
    }

private:
    /// Contact or pause: C dT/dt = b - K T.
    class Mode {
    public:
        Mode(const SlabOnRoad& of, bool touching, double hot, double heated) {
            const std::size_t n = of.tread_.size();
            const std::size_t all = n + (touching ? of.road_.size() : 0);
            Eigen::MatrixXd K = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(all), static_cast<Eigen::Index>(all));
            Eigen::VectorXd b = Eigen::VectorXd::Zero(K.rows());
            root_.resize(K.rows());
            const auto join = [&](Eigen::Index i, Eigen::Index j, double G) {
                K(i, i) += G;
                K(j, j) += G;
                K(i, j) -= G;
                K(j, i) -= G;
            };
            for (std::size_t i = 0; i < n; ++i) {
                const auto at = static_cast<Eigen::Index>(i);
                root_[at] = std::sqrt(tread_rho_c * of.tread_[i]);
                if (i + 1 < n) {
                    join(at, at + 1, 2.0 * tread_k / (of.tread_[i] + of.tread_[i + 1]));
                }
            }
            const auto last = static_cast<Eigen::Index>(n) - 1;
            K(last, last) += 2.0 * tread_k / of.tread_.back();
            b[last] += hot * 2.0 * tread_k / of.tread_.back();
            if (touching) {
                for (std::size_t i = 0; i < of.road_.size(); ++i) {
                    const auto at = static_cast<Eigen::Index>(n + i);
                    root_[at] = std::sqrt(road_rho_c * of.road_[i]);
                    if (i + 1 < of.road_.size()) {
                        join(at, at + 1, 2.0 * road_k / (of.road_[i] + of.road_[i + 1]));
                    }
                }
                const double h = of.conductance();
                join(0, last + 1, h);
                // Heat on the surface: a part goes to the road through the interface at once.
                const double to_road = h * 0.5 * of.tread_.front() / tread_k * heated;
                b[0] += heated - to_road;
                b[last + 1] += to_road;
            }
            const Eigen::VectorXd inverse = root_.cwiseInverse();
            eigen_.compute(inverse.asDiagonal() * K * inverse.asDiagonal());
            steady_ = K.ldlt().solve(b);
        }
        [[nodiscard]] Eigen::VectorXd after(double t, const Eigen::VectorXd& T) const {
            return through(T, [&](double rate) { return std::exp(-rate * t); }) + steady_;
        }
        [[nodiscard]] Eigen::VectorXd integral(double t, const Eigen::VectorXd& T) const {
            return through(T, [&](double rate) { return -std::expm1(-rate * t) / rate; }) + t * steady_;
        }

    private:
        template <class Function>
        [[nodiscard]] Eigen::VectorXd through(const Eigen::VectorXd& T, const Function& of) const {
            Eigen::VectorXd modes = eigen_.eigenvectors().transpose() * root_.cwiseProduct(T - steady_);
            for (Eigen::Index i = 0; i < modes.size(); ++i) {
                modes[i] *= of(eigen_.eigenvalues()[i]);
            }
            return root_.cwiseInverse().cwiseProduct(eigen_.eigenvectors() * modes);
        }
        Eigen::VectorXd root_;
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_;
        Eigen::VectorXd steady_;
    };

    /// Between the first cells of slab and road. W/(m2 K)
    [[nodiscard]] double conductance() const {
        return 1.0 / (0.5 * tread_.front() / tread_k + 1.0 / interface_h_ + 0.5 * road_.front() / road_k);
    }

    double interface_h_;
    std::vector<double> tread_;
    std::vector<double> road_;
};

}  // namespace

// zeta(1/2, 1) is Riemann's, -1.46035450880958681, zeta(2, 1) is pi^2/6, zeta(3, 1/2) seven times Apery's constant; a sum
// less its first term is that from the second on.
TEST(HurwitzZeta, HasItsKnownValues) {
    EXPECT_NEAR(hurwitz_zeta(0.5, 1.0), -1.46035450880958681, 1e-13);
    EXPECT_NEAR(hurwitz_zeta(2.0, 1.0), std::numbers::pi * std::numbers::pi / 6.0, 1e-13);
    EXPECT_NEAR(hurwitz_zeta(3.0, 0.5), 7.0 * 1.2020569031595943, 1e-13);
    for (double a = 0.05; a < 2.0; a += 0.05) {
        EXPECT_NEAR(hurwitz_zeta(0.5, a), 1.0 / std::sqrt(a) + hurwitz_zeta(0.5, a + 1.0), 1e-13) << a;
    }
}

// A tread that has forgotten the last contact: the closed form of two fresh half-spaces. What is left of the memory at a
// period of 1e9 contacts is 1.46 t_c h / (e sqrt(pi P)) < 3e-5 of it; the 24 pieces of the contact leave up to 2e-4, where
// the flux falls most (their error is of second order).
TEST(ContactInRevolutions, OfLongPeriodIsThatOfFreshHalfSpaces) {
    for (const double duration : {1e-4, 1e-3, 1e-2}) {
        const ContactInRevolutions rare(tread_on_road, duration, 1e9 * duration);
        EXPECT_NEAR(rare.mean_conductance() / tread_on_road.mean_conductance(duration), 1.0, 2.5e-4) << duration;
        EXPECT_NEAR(rare.at_entry(), 0.0, 1e-4);
        // The tread's surface at the end: e_b / (e_a + e_b) (1 - e^tau erfc(sqrt tau)) of the difference.
        const double a = tread_on_road.effusivity_a;
        const double b = tread_on_road.effusivity_b;
        const double root = tread_on_road.interface_h * (1.0 / a + 1.0 / b) * std::sqrt(duration);
        EXPECT_NEAR(rare.at_exit(), -b / (a + b) * (1.0 - scaled_erfc(root)), 1e-3) << duration;
        // Heat alone: 2 sqrt(t/pi) / e_a.
        const ContactOfHalfSpaces no_road{.interface_h = 1e-6, .effusivity_a = a, .effusivity_b = b};
        const ContactInRevolutions alone(no_road, duration, 1e9 * duration);
        EXPECT_NEAR(alone.heated_at_exit() / (2.0 * std::sqrt(duration / std::numbers::pi) / a), 1.0, 1e-4);
    }
}

// Contact by contact, 50 to 250 km/h with a contact of 0.1 m and a rolling circumference of 2.03 m: cells of half a
// micrometre at the surface, everything exact in time, the periodic state from the linear map of one revolution. With a
// tread 40 K above the road 0.0025 is 0.1 K; what is seen is 20 times less.
TEST(ContactInRevolutions, IsThePeriodicStateOfCells) {
    const SlabOnRoad cells(tread_on_road.interface_h, 0.4e-6, 1.09, 1.2e-3);
    for (const double kmh : {50.0, 100.0, 250.0}) {
        const double duration = 0.1 / (kmh / 3.6);
        const double period = 2.03 / (kmh / 3.6);
        const ContactInRevolutions contact(tread_on_road, duration, period);
        const SlabOnRoad::Periodic cold = cells.revolution(duration, period, 1.0, 0.0);
        EXPECT_NEAR(contact.mean_conductance() / (cold.exchanged / duration / cold.mean), 1.0, 1e-3) << kmh;
        EXPECT_NEAR(contact.at_entry(), (cold.entry - cold.mean) / cold.mean, 2e-4) << kmh;
        EXPECT_NEAR(contact.at_exit(), (cold.exit - cold.mean) / cold.mean, 2e-4) << kmh;
    }
}

// Heat of 1 kW/m2 during the contact, next to no road (an interface of 1e-6 W/m2K) and on the road, which takes half of the
// heat back. The flash at the exit is 0.05 K at 250 km/h to 0.12 K at 50 without the road; cells and pieces agree to 1e-4 K. On
// the road the tread's mean lies above the road's, and gives it what it gives without sliding.
TEST(ContactInRevolutions, FlashesAsHeatedCellsDoAndTheRoadTakesItsShare) {
    for (const double interface_h : {1e-6, tread_on_road.interface_h}) {
        const SlabOnRoad cells(interface_h, 0.4e-6, 1.09, 1.2e-3);
        ContactOfHalfSpaces surfaces = tread_on_road;
        surfaces.interface_h = interface_h;
        for (const double kmh : {50.0, 100.0, 250.0}) {
            const double duration = 0.1 / (kmh / 3.6);
            const double period = 2.03 / (kmh / 3.6);
            const ContactInRevolutions contact(surfaces, duration, period);
            const SlabOnRoad::Periodic hot = cells.revolution(duration, period, 0.0, 1000.0);
            const double entry = hot.mean * contact.at_entry() + 1000.0 * contact.heated_at_entry();
            const double exit = hot.mean * contact.at_exit() + 1000.0 * contact.heated_at_exit();
            EXPECT_NEAR(entry, hot.entry - hot.mean, 1e-4) << kmh;
            EXPECT_NEAR(exit, hot.exit - hot.mean, 1e-4) << kmh;
            const double share = hot.exchanged / duration - contact.mean_conductance() * hot.mean;
            EXPECT_NEAR(contact.road_share(), share / 1000.0, 1e-3) << kmh;
            EXPECT_GT(contact.heated_at_exit(), -3.0 * contact.heated_at_entry());
        }
    }
}

// Heat between the two surfaces warms both alike while they touch: of a tread that has forgotten the last turn nothing goes
// through the interface, and its exit is 2 sqrt(t/pi)/e_a above by 1 W/m2 in it. In turns what is left of earlier ones is
// what the road takes of a tread that is so much warmer when it comes: to first order its share of a warm start, conductance
// times the warmth 1.46 t_c/(e_a sqrt(pi P)) that is missing below the mean, with the other sign.
TEST(ContactInRevolutions, HeatBetweenTheSurfacesDrivesNothingThroughThem) {
    const double duration = 3.48e-3;
    const double a = tread_on_road.effusivity_a;
    const ContactInRevolutions rare(tread_on_road, duration, 1e9 * duration);
    EXPECT_NEAR(rare.road_share(SlidingHeat::between), 0.0, 1e-4);
    EXPECT_NEAR(rare.heated_at_exit(1.0, SlidingHeat::between) * a / (2.0 * std::sqrt(duration / std::numbers::pi)),
                1.0, 1e-3);
    const double period = 0.0731;
    const ContactInRevolutions rolling(tread_on_road, duration, period);
    const double below = -1.46035 * duration / (a * std::sqrt(std::numbers::pi * period));  // K m2/W
    const double first_order = rolling.mean_conductance() * below;
    EXPECT_NEAR(rolling.road_share(SlidingHeat::between) / first_order, 1.0, 0.1);
    EXPECT_LT(std::abs(rolling.road_share(SlidingHeat::between)), 0.3 * rolling.road_share());
}

}  // namespace tiretherm::physics
