// SPDX-License-Identifier: BSD-3-Clause
// The film of a rotating disk: both regimes by hand, the mean of the whole disk as the source states it, the transition.
// Air of 300 K: k = 0.0263 W/(m K), nu = 1.589e-5 m2/s. The ring is that of the sidewalls of a 225/50 R17, 0.2183 m
// to 0.3308 m.
#include "physics/tire_laws/rotating_disk.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace tiretherm::physics {

namespace {

constexpr double inner = 0.2183;
constexpr double outer = 0.3308;

double sum(const RotatingDisk::Film& film) { return film.laminar + film.turbulent; }

}  // namespace

TEST(AirProperties, FollowTheTables) {
    // Incropera & DeWitt, table A.4: T in K, k in W/(m K), nu in m2/s. The power laws stay within 1.1 %.
    struct Row {
        double T, k, nu;
    };
    for (const Row& row : std::array{Row{250.0, 22.3e-3, 11.44e-6}, Row{300.0, 26.3e-3, 15.89e-6},
                                     Row{350.0, 30.0e-3, 20.92e-6}, Row{400.0, 33.8e-3, 26.41e-6}}) {
        EXPECT_NEAR(Air::conductivity(row.T) / row.k, 1.0, 0.011) << row.T;
        EXPECT_NEAR(Air::viscosity(row.T) / row.nu, 1.0, 0.011) << row.T;
    }
}

TEST(RotatingDisk, IsLaminarWhenItTurnsSlowly) {
    // 10 rad/s: Re at 0.3308 m 10 * 0.10943/1.589e-5 = 68 867. h = 0.36 * 0.0263 * sqrt(10/1.589e-5) = 0.009468 *
    // 793.30 = 7.5110 W/m2K at every radius, so of any ring.
    const RotatingDisk disk;
    EXPECT_NEAR(disk.mean(10.0, inner, outer, 300.0).laminar, 7.5110, 1e-4);
    EXPECT_EQ(disk.mean(10.0, inner, outer, 300.0).turbulent, 0.0);
    EXPECT_NEAR(disk.mean(10.0, 0.0, inner, 300.0).laminar, 7.5110, 1e-4);
}

TEST(RotatingDisk, IsTurbulentOverTheWholeRingWhenItTurnsFast) {
    // 100 rad/s: Re at 0.2183 m 299 905, beyond the transition. 0.0195 * 0.0263 * (6.29327e6)^0.8 = 5.1285e-4 * 274 853
    // = 140.958; 2/2.6 (0.056347 - 0.019122)/(0.109429 - 0.047655) = 0.463536; the product 65.339 W/m2K.
    const RotatingDisk disk;
    EXPECT_EQ(disk.mean(100.0, inner, outer, 300.0).laminar, 0.0);
    EXPECT_NEAR(disk.mean(100.0, inner, outer, 300.0).turbulent, 65.339, 1e-2);
}

TEST(RotatingDisk, HasTheMeanOfItsSourceOnAWholeDisk) {
    // Cobb and Saunders state the mean of a turbulent disk, Nu = 0.015 Re^0.8 with Nu = h R/k and Re = w R^2/nu. A
    // transition at 0 leaves no laminar core.
    const RotatingDisk disk{.transition = 0.0};
    for (const double turning : {20.0, 90.0, 300.0}) {
        const double reynolds = turning * outer * outer / 1.589e-5;
        const double nusselt = sum(disk.mean(turning, 0.0, outer, 300.0)) * outer / 0.0263;
        EXPECT_NEAR(nusselt / (0.015 * std::pow(reynolds, 0.8)), 1.0, 1e-12) << turning;
    }
}

TEST(RotatingDisk, IsTheMeanOfItsLocalFilms) {
    // 55 rad/s: the transition is at sqrt(2.4e5 * 1.589e-5/55) = 0.26333 m, inside the ring. The midpoint rule on 20 000
    // rings misses it by half a ring, 3e-6 m of 0.11 m with a jump of the film by 1.2 of its mean: 3e-5.
    constexpr double turning = 55.0;
    constexpr int n = 20000;
    double heat = 0.0;
    double area = 0.0;
    for (int i = 0; i < n; ++i) {
        const double r = inner + (outer - inner) * (i + 0.5) / n;
        const double reynolds = turning * r * r / 1.589e-5;
        const double nusselt = reynolds < 2.4e5 ? 0.36 * std::sqrt(reynolds) : 0.0195 * std::pow(reynolds, 0.8);
        heat += nusselt * 0.0263 / r * r;
        area += r;
    }
    const RotatingDisk::Film film = RotatingDisk{}.mean(turning, inner, outer, 300.0);
    EXPECT_GT(film.laminar, 0.0);
    EXPECT_GT(film.turbulent, 0.0);
    EXPECT_NEAR(sum(film) / (heat / area), 1.0, 5e-5);
}

TEST(RotatingDisk, HasNoJumpAtTheTransition) {
    // The transition enters the ring at its outer edge at w = 2.4e5 nu/0.3308^2 = 34.850 rad/s and leaves it at the inner
    // edge at 2.4e5 nu/0.2183^2 = 80.026 rad/s. The steepest rise is where it enters: the film grows as w^0.5, and the
    // share 0.10943/0.06177 of the ring's area per ln w changes from Nu_r = 0.36 * 489.9 = 176.4 to 0.0195 * 20 145 = 392.8:
    // w dh/dw = (0.5 + 1.2274 * 1.7715) h = 2.674 h. 2e-6 of the speed makes 5.35e-6; a jump would make 1.2.
    const RotatingDisk disk;
    for (const double edge : {inner, outer}) {
        const double turning = 2.4e5 * 1.589e-5 / (edge * edge);
        const double below = sum(disk.mean(turning * (1.0 - 1e-6), inner, outer, 300.0));
        const double above = sum(disk.mean(turning * (1.0 + 1e-6), inner, outer, 300.0));
        EXPECT_GT(above, below);
        EXPECT_NEAR(above / below, 1.0, 5.4e-6) << edge;
    }
}

TEST(RotatingDisk, FollowsTheTemperatureOfTheFilmByItsExponents) {
    // h ~ k nu^-0.5 ~ T^(0.85 - 0.89) in laminar flow and k nu^-0.8 ~ T^(0.85 - 1.424) in turbulent flow.
    const RotatingDisk disk;
    const double laminar = disk.mean(10.0, inner, outer, 340.0).laminar / disk.mean(10.0, inner, outer, 300.0).laminar;
    const double turbulent =
        disk.mean(200.0, inner, outer, 340.0).turbulent / disk.mean(200.0, inner, outer, 300.0).turbulent;
    EXPECT_NEAR(laminar, std::pow(340.0 / 300.0, -0.04), 1e-12);
    EXPECT_NEAR(turbulent, std::pow(340.0 / 300.0, -0.574), 1e-12);
    EXPECT_NEAR(RotatingDisk::laminar_exponent, -0.04, 1e-12);
    EXPECT_NEAR(RotatingDisk::turbulent_exponent, -0.574, 1e-12);
}

TEST(RotatingDisk, GivesNothingWithoutTurning) { EXPECT_EQ(sum(RotatingDisk{}.mean(0.0, inner, outer, 300.0)), 0.0); }

}  // namespace tiretherm::physics
