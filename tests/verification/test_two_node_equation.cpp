// SPDX-License-Identifier: BSD-3-Clause
// Heat flows of the two-node model at a thousand random states against the thesis's equation (31), written out
// independently.

#include <algorithm>
#include <random>

#include "solver/system.hpp"
#include "tests/support/order.hpp"
#include "tests/support/two_node_case.hpp"

namespace tiretherm {
namespace {

/// Draws of the whole range in which the thesis's formulas hold, its corners "at rest" and "without load" included.
class Draws {
public:
    explicit Draws(std::uint64_t seed) : engine_(seed) {}

    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(engine_) == 1; }

    support::TwoNodeThesis thesis() {
        support::TwoNodeThesis t;
        // Between rest and walking pace, and between no load and 50 N, the program has thresholds of its own.
        t.V = one_in(10) ? 0.0 : between(0.5, 80.0);
        t.Fz = one_in(10) ? 0.0 : between(50.0, 9000.0);
        t.alpha = between(-0.2618, 0.2618);  // 15 degrees
        t.kappa = between(-0.3, 0.3);
        t.Fx = between(-6000.0, 6000.0);
        t.Fy = between(-6000.0, 6000.0);
        t.T_air = between(250.0, 320.0);
        t.T_track = between(250.0, 340.0);
        for (double* scale :
             {&t.lambda_x, &t.lambda_y, &t.lambda_h, &t.lambda_Hc, &t.lambda_SELsrf, &t.lambda_SELblk}) {
            *scale = between(0.2, 3.0);
        }
        t.hpc = between(0.0, 1.0);
        t.k_20 = between(0.2, 0.6);
        t.k_per_K = between(0.0, 0.01);
        t.k_per_K2 = between(0.0, 1e-4);
        return t;
    }

private:
    std::mt19937_64 engine_;
};

physics::Inputs inputs_of(const support::TwoNodeThesis& t) {
    physics::Inputs in;
    in.speed = t.V;
    in.vertical_load = t.Fz;
    in.slip_angle = t.alpha;
    in.slip_ratio = t.kappa;
    in.longitudinal_force = t.Fx;
    in.lateral_force = t.Fy;
    in.air_temperature = t.T_air;
    in.road_temperature = t.T_track;
    return in;
}

TEST(TwoNodes, FlowsAreThoseOfEquation31AtAThousandRandomStates) {
    // Thesis (31) with (32)-(49) and the errata, written out in two_node_thesis.hpp without any code of physics/.
    // Each side is a sum of at most six terms of some ten roundings each, so 1e-12 of the sum of their absolute values
    // is two thousand roundings; the Gaussian of (49) has the exponent -36 +- 10 and costs the most of them.
    Draws draw(20140131);
    double worst = 0.0;
    int at_rest = 0;
    int unloaded = 0;
    for (int i = 0; i < 1000; ++i) {
        const support::TwoNodeThesis thesis = draw.thesis();
        solver::Problem problem = support::two_node_problem(thesis);
        solver::System system(problem);
        std::vector<double> coefficients(system.n_coefficients());
        system.evaluate_coefficients(inputs_of(thesis), coefficients);
        const std::vector<double> T{draw.between(250.0, 420.0), draw.between(250.0, 420.0)};
        system.evaluate(T, coefficients);

        const support::TwoNodeThesis::Flow exact = thesis.flow(T[0], T[1]);
        const double on_surface = std::abs(system.heat_flow()[0] - exact.surface) / exact.surface_terms;
        const double on_bulk = std::abs(system.heat_flow()[1] - exact.bulk) / exact.bulk_terms;
        ASSERT_LE(on_surface, 1e-12) << "draw " << i << ", V " << thesis.V << ", Fz " << thesis.Fz;
        ASSERT_LE(on_bulk, 1e-12) << "draw " << i << ", V " << thesis.V << ", Fz " << thesis.Fz;
        worst = std::max({worst, on_surface, on_bulk});
        at_rest += thesis.V == 0.0 ? 1 : 0;
        unloaded += thesis.Fz == 0.0 ? 1 : 0;
    }
    support::expect_below("worst_relative_difference", worst, 1e-12);
    // A tenth of the draws each, give or take five standard deviations of a binomial count.
    EXPECT_NEAR(at_rest, 100, 50);
    EXPECT_NEAR(unloaded, 100, 50);
}

TEST(TwoNodes, CapacitiesAreTheThesisMassesTimesItsSpecificHeat) {
    // m = rho 2 pi R0 W h = 6.173 kg (68); 15 % and 85 % of it times 1800 J/kgK are 1666.8 and 9445.1 J/K. One kelvin
    // of enthalpy is a difference of two numbers of 5e5 and 3e6 J: 1e-9 relative is a hundred roundings.
    const solver::Problem problem = support::two_node_problem({});
    const solver::System system(problem);
    std::vector<double> cold(2);
    std::vector<double> warm(2);
    system.enthalpy(std::vector<double>{300.0, 300.0}, cold);
    system.enthalpy(std::vector<double>{301.0, 301.0}, warm);
    EXPECT_NEAR(warm[0] - cold[0], support::TwoNodeThesis{}.capacity_surface(), 1e-9 * 1666.8);
    EXPECT_NEAR(warm[1] - cold[1], support::TwoNodeThesis{}.capacity_bulk(), 1e-9 * 9445.1);
    EXPECT_NEAR(support::TwoNodeThesis{}.mass(), 6.173, 5e-4);  // rounded
}

TEST(TwoNodes, DissipateAsMuchAsTheNotesComputeAt50And80Celsius) {
    // Whole watts: half a watt of rounding.
    struct Quoted {
        double Fz;
        double kilometres_per_hour;
        double at_50;
        double at_80;
    };
    for (const Quoted& q : {Quoted{4000.0, 100.0, 1204.0, 798.0}, Quoted{7000.0, 100.0, 2664.0, 1766.0},
                            Quoted{7500.0, 150.0, 4605.0, 3052.0}}) {
        support::TwoNodeThesis thesis;
        thesis.V = q.kilometres_per_hour / 3.6;
        thesis.Fz = q.Fz;
        EXPECT_NEAR(thesis.SEL(323.15), q.at_50, 0.5);
        EXPECT_NEAR(thesis.SEL(353.15), q.at_80, 0.5);
    }
}

}  // namespace
}  // namespace tiretherm
