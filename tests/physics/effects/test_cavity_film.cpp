// SPDX-License-Identifier: BSD-3-Clause
// inner_gas with films of natural convection: watts by hand on the bench of two nodes, the derivatives, stable layers.
//
// 4000 N, 100 km/h, 220 kPa: w = 27.7778/(0.3483 * 4000^-0.009) = 85.9335 rad/s; w^2 r at the liner, 0.3188 m, 2354.2 m/s2, at
// the rim's edge, 0.2183 m, 1612.1. Gas: 321 325/(287.05 * 293.15) = 3.81854 kg/m3. At 320 K k = 0.0263 (320/300)^0.85 =
// 0.0277831 W/(m K), mu = 1.589e-5 (320/300)^1.78 * 101 325/(287.05 * 320) = 1.96618e-5 Pa s. h at 1 K = 0.15 k (w^2 r rho^2
// 1007/(320 mu k))^(1/3) = 24.2797 and 21.4005 W/(m2 K^(4/3)). Liner 2 pi 0.3308 * 0.225 = 0.467657 m2 of the bulk, rim 2 pi
// 0.2183 * 0.225 = 0.308614 m2.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/index.hpp"
#include "physics/effects/effect_contract.hpp"
#include "physics/tire_laws/cavity_film.hpp"

namespace tiretherm::physics {

namespace {

Part buoyant(std::vector<std::pair<std::string_view, double>> numbers = {}) {
    return {.id = "inner_gas", .numbers = std::move(numbers), .choices = {{"film", 1}}};
}

Inputs filled(double kmh) {
    Inputs in = rolling();
    in.speed = kmh / 3.6;
    in.slip_ratio = 0.0;
    in.inflation_pressure = 220e3;
    return in;
}

}  // namespace

TEST(CavityFilm, FollowsSpeedAndPressure) {
    const Tire tire;
    const CavityFilm film;
    const double at_100 = film.at_one_kelvin(tire, filled(100.0), 0.3188);
    EXPECT_NEAR(at_100, 24.2797, 1e-4);
    EXPECT_NEAR(film.at_one_kelvin(tire, filled(-100.0), 0.3188), at_100, 1e-12) << "either way round";
    // At rest gravity alone: 24.2797 (9.80665/2354.2)^(1/3) = 3.9066.
    EXPECT_NEAR(film.at_one_kelvin(tire, filled(0.0), 0.3188), 3.9066, 1e-4);
    // Twice the absolute pressure: rho^(2/3), 1.58740.
    Inputs hard = filled(100.0);
    hard.inflation_pressure = 2.0 * 220e3 + 101325.0;
    EXPECT_NEAR(film.at_one_kelvin(tire, hard, 0.3188) / at_100, std::cbrt(4.0), 1e-12);
    // Without a pressure that of the thesis tire, 220 kPa, or the tire's own.
    Inputs unknown = filled(100.0);
    unknown.inflation_pressure = 0.0;
    EXPECT_EQ(film.at_one_kelvin(tire, unknown, 0.3188), at_100);
    Tire truck;
    truck.reference_pressure = 700e3;
    EXPECT_NEAR(gas_density(truck, unknown), 801325.0 / (287.05 * 293.15), 1e-12);
}

TEST(InnerGasOfBuoyancy, HasItsWattsByHand) {
    // Bulk 55, gas 40, air 23 degC: liner 24.2797 * 0.467657 * 15^(4/3) = 420.042 W, rim 21.4005 * 0.308614 * 17^(4/3) =
    // 288.694 W. The conductances of the constant film do not count.
    Whole whole(two_nodes(), {buoyant({{"liner", 100.0}, {"rim", 100.0}})});
    whole.ask(filled(100.0), {308.15, 328.15, 313.15});
    EXPECT_NEAR(whole.flow(1), -420.042, 2e-3);
    EXPECT_NEAR(whole.flow(whole.node("gas")), 420.042 - 288.694, 3e-3);
    EXPECT_NEAR(whole.watts("inner_gas"), -288.694, 2e-3) << "what leaves to the rim at the air's temperature";
}

TEST(InnerGasOfBuoyancy, IsAQuarterWhereTheLayersAreStable) {
    // Gas 15 K warmer than the liner and 17 K cooler than the rim: a quarter of the film each.
    Whole whole(two_nodes(), {buoyant(), {"rim_conduction"}});
    std::vector<double> T{308.15, 298.15, 0.0, 0.0};
    T[at(whole.node("gas"))] = 313.15;
    T[at(whole.node("rim"))] = 330.15;
    whole.ask(filled(100.0), T);
    // The bead brings 1 W/K * 32 K to the bulk.
    EXPECT_NEAR(whole.flow(1), 0.25 * 420.042 + 32.0, 1e-3);
    EXPECT_NEAR(whole.flow(whole.node("gas")), 0.25 * (288.694 - 420.042), 1e-3);
}

TEST(InnerGasOfBuoyancy, GivesTheDerivativesOfItsHeat) {
    // d(flow)/dT_gas of the gas and of the nodes that it meets against a central difference over 2e-3 K; its error is a sixth
    // of the third derivative, (8/27) h/dT^2 1e-6 K2, 1e-9 of h at dT = 20 K.
    for (const Bench& bench : {two_nodes(), section()}) {
        for (const bool has_rim : {false, true}) {
            std::vector<Part> parts{buoyant()};
            if (has_rim) {
                parts.push_back({"rim_conduction"});
            }
            Whole whole(bench, parts);
            std::mt19937_64 random(23);
            std::vector<double> T = random_field(n_nodes(whole), random, 330.0, 370.0);
            const auto gas = at(whole.node("gas"));
            T[gas] = 300.0;
            const auto flow = [&](double shift) {
                std::vector<double> moved = T;
                moved[gas] += shift;
                const std::span<const double> q = whole.ask(filled(100.0), moved).system().heat_flow();
                return std::vector<double>(q.begin(), q.end());
            };
            const std::vector<double> up = flow(1e-3);
            const std::vector<double> down = flow(-1e-3);
            const Terms& terms = whole.ask(filled(100.0), T).system().terms();
            double slope = terms.node_slope[gas] - terms.node_G[gas];
            const mesh::Mesh& mesh = whole.problem().mesh;
            for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
                if (at(mesh.faces[f].a) == gas) {
                    slope += terms.face_dq_dTa[f] - terms.face_G[f];
                } else if (at(mesh.faces[f].b) == gas) {
                    slope -= terms.face_dq_dTb[f] + terms.face_G[f];
                }
            }
            EXPECT_NEAR((up[gas] - down[gas]) / 2e-3, slope, 1e-6 * std::abs(slope)) << bench.mesh.kind;
        }
    }
}

TEST(InnerGasOfBuoyancy, IsNothingWhereAllIsAtOneTemperature) {
    Whole whole(section(), {buoyant(), {"rim_conduction"}});
    whole.ask(filled(100.0), std::vector<double>(n_nodes(whole), 296.15));
    for (const double q : whole.system().heat_flow()) {
        EXPECT_EQ(q, 0.0);
    }
}

}  // namespace tiretherm::physics
