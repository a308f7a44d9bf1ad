// SPDX-License-Identifier: BSD-3-Clause
// The loss tangent of the strain-energy loss: a table, compounds by layer, a peak in the cold, and Kraus's law of the strain.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/physics/effects/bench.hpp"

namespace tiretherm::physics {
namespace {

double loss_of(const ActiveEffect& loss, const Bench& bench, const Inputs& inputs) { return bench.watts(loss, inputs); }

void set(ActiveEffect& active, std::string_view key, double value) {
    active.parameters[static_cast<std::size_t>(find_parameter(*active.effect, key))] = value;
}

}  // namespace

// At the frequency of the characterisation nothing is shifted: bulk at 55 degC, tan delta 0.3 from 0.4 at 20 and 0.2 at 90 degC;
// the Gaussian has 2.14e15 exp(-((328.15 + 4989)/882)^2) = 0.35225 there.
TEST(StrainEnergyLoss, TakesATableInThePlaceOfTheGaussian) {
    const Bench bench = two_nodes();
    Inputs at_f0 = rolling();
    at_f0.speed = 52.0 * 2.0 * 3.14159265358979 * bench.tire.rolling_radius(4000.0);
    ActiveEffect loss = bench.active("strain_energy_loss");
    const double gaussian = loss_of(loss, bench, at_f0);
    loss.tables[static_cast<std::size_t>(find_table(*loss.effect, "tan_delta"))] =
        Curve::table({293.15, 363.15}, {0.4, 0.2});
    const double expected = 2.14e15 * std::exp(-std::pow((328.15 + 4989.0) / 882.0, 2.0));
    EXPECT_NEAR(loss_of(loss, bench, at_f0) / gaussian, 0.3 / expected, 1e-9);
}

// One layer of another compound, whose Gaussian is twice as high: it loses twice as much, the others as before; and the same
// where each cell's own temperature counts.
TEST(StrainEnergyLoss, CompoundsMayDifferByLayer) {
    for (const int local : {0, 1}) {
        const Bench bench = section();
        ActiveEffect loss = bench.active("strain_energy_loss");
        loss.choices.front() = local;
        const Terms one = bench.said(loss, rolling(), bench.T);
        const int belt = bench.mesh.find_layer("belt");
        loss.overrides.push_back({.scope = Scope::layer,
                                  .index = belt,
                                  .parameter = static_cast<std::size_t>(find_parameter(*loss.effect, "tan_delta_a")),
                                  .value = 2.0 * 2.14e15});
        bench.place(loss);
        const Terms two = bench.said(loss, rolling(), bench.T);
        for (int cell = 0; cell < bench.mesh.n_cells; ++cell) {
            const auto c = static_cast<std::size_t>(cell);
            EXPECT_NEAR(two.node_q[c] / one.node_q[c], bench.mesh.layer[c] == belt ? 2.0 : 1.0, 1e-12) << cell;
        }
    }
}

// In the cold the loss falls: with nodes at -43 degC and the frequency of the characterisation (no shift) it is that of +27 degC,
// 35 K on either side of the peak at -8 degC, and the derivative with the bulk's temperature is positive.
TEST(StrainEnergyLoss, FallsBelowItsPeak) {
    Bench bench = two_nodes();
    Inputs at_f0 = rolling();
    at_f0.speed = 52.0 * 2.0 * 3.14159265358979 * bench.tire.rolling_radius(4000.0);
    const ActiveEffect loss = bench.active("strain_energy_loss");
    bench.T = {230.15, 230.15};
    const double cold = loss_of(loss, bench, at_f0);
    bench.T = {231.15, 231.15};
    EXPECT_GT(loss_of(loss, bench, at_f0), cold);
    bench.T = {300.15, 300.15};
    EXPECT_NEAR(loss_of(loss, bench, at_f0) / cold, 1.0, 1e-9);
}

TEST(StrainEnergyLoss, SaysWhereTheColdBranchCounts) {
    const Bench bench = two_nodes();
    ActiveEffect loss = bench.active("strain_energy_loss");
    const auto warning = [&](double coldest) {
        return loss.effect->heat_effect()->range_warning(loss, coldest, 330.0);
    };
    EXPECT_EQ(warning(266.0), "");
    EXPECT_NE(warning(243.15).find("below -8 degC the loss tangent"), std::string::npos) << warning(243.15);
    set(loss, "tan_delta_peak", 0.0);
    EXPECT_EQ(warning(243.15), "") << "the Gaussian alone was asked for";
}

// 4 kN deflect the tire by 16.8 mm, 0.14933 of its section's height; 8 kN by twice that. With an amplitude of 2, e_c 0.02 and m
// 0.6: (0.14933/0.02)^0.6 = 3.3410, 1 + 4 3.3410/(1 + 11.1623) = 2.09881; at 0.29867 5.0642, 1 + 20.257/26.6457 = 1.76024; at the
// reference of 0.1 2.6265, 1 + 10.506/7.8986 = 2.33012.
TEST(StrainEnergyLoss, FollowsTheStrainByKrausWhereItIsAsked) {
    const Bench bench = two_nodes();
    ActiveEffect loss = bench.active("strain_energy_loss");
    Inputs inputs = rolling();
    const double plain = loss_of(loss, bench, inputs);
    set(loss, "kraus_amplitude", 2.0);
    EXPECT_NEAR(loss_of(loss, bench, inputs) / plain, 2.09881 / 2.33012, 1e-4);
    inputs.vertical_load = 8000.0;
    const double kraus = loss_of(loss, bench, inputs);
    set(loss, "kraus_amplitude", 0.0);
    EXPECT_NEAR(kraus / loss_of(loss, bench, inputs), 1.76024 / 2.33012, 1e-4);
}

}  // namespace tiretherm::physics
