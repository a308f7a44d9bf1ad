// SPDX-License-Identifier: BSD-3-Clause
// Effects on properties and laws: one number each, by hand, on the bench of two nodes where the law acts there.
#include <cmath>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"

namespace tiretherm::physics {

namespace {

/// The strain-energy loss with another effect on, over that without.
double loss_ratio(const Part& part, const Inputs& in) {
    Whole plain(two_nodes(), {{"strain_energy_loss"}});
    Whole changed(two_nodes(), {{"strain_energy_loss"}, part});
    return changed.ask(in).watts("strain_energy_loss") / plain.ask(in).watts("strain_energy_loss");
}

Inputs at_speed(double kmh) {
    Inputs in = rolling();
    in.speed = kmh / 3.6;
    return in;
}

}  // namespace

TEST(LayerConductivity, ScalesAndTiltsTheLinkOfTwoNodes) {
    // k(55 C) = 0.29 + 0.00943 * 35 = 0.62005 W/mK over 10 mm; 1.5 times that, or plus
    // 0.005/K * 0.29 W/mK * 35 K = 0.05075 W/mK.
    const Bench bench = two_nodes();
    Whole scaled(bench, {{"conduction"}, {"layer_conductivity", {{"scale", 1.5}}}});
    scaled.ask(rolling());
    EXPECT_NEAR(scaled.system().terms().face_G[0], 1.5 * 62.005 * bench.tire.outer_area(), 1e-9);
    Whole tilted(bench, {{"conduction"}, {"layer_conductivity", {{"slope", 0.005}}}});
    tilted.ask(rolling());
    EXPECT_NEAR(tilted.system().terms().face_G[0], (62.005 + 5.075) * bench.tire.outer_area(), 1e-9);
}

TEST(LayerConductivity, KeepsToTheLayersNamed) {
    // On a section the standard layers are those below the tread.
    const Whole whole(section(), {{"layer_conductivity", {{"scale", 2.0}}}});
    EXPECT_EQ(whole.system().material_model().materials[0].along(mesh::Axis::through).value(300.0), 0.29);
    EXPECT_EQ(whole.system().material_model().materials[3].along(mesh::Axis::meridian).value(300.0), 0.58);
}

TEST(LayerHeatCapacity, ScalesThatOfTheBulk) {
    // 85 % of 6.173 kg at 1800 J/kgK, times 1.2; the surface as it was.
    const Bench bench = two_nodes();
    const Whole whole(bench, {{"layer_heat_capacity", {{"scale", 1.2}}}});
    EXPECT_NEAR(whole.system().capacity(1, 300.0), 1.2 * 0.85 * bench.tire.band_mass() * 1800.0, 1e-9);
    EXPECT_NEAR(whole.system().capacity(0, 300.0), 0.15 * bench.tire.band_mass() * 1800.0, 1e-9);
}

TEST(BeltAnisotropy, ConductsAlongTheBeltOnly) {
    // 4 times along the meridian: faces between belt cells of two columns; those through it as they were.
    const Bench bench = section();
    solver::Problem problem = Whole::problem_of(bench, {{"conduction"}, {"belt_anisotropy", {{"meridian", 4.0}}}});
    const int belt = bench.mesh.find_layer("belt");
    problem.effects[1].layers = {belt};
    solver::System system(problem);
    system.evaluate(problem.initial, {});
    int along = 0;
    for (std::size_t f = 0; f < bench.mesh.faces.size(); ++f) {
        const mesh::Face& face = bench.mesh.faces[f];
        const auto is_belt = [&](int node) { return bench.mesh.layer[static_cast<std::size_t>(node)] == belt; };
        const bool in_belt = is_belt(face.a) && is_belt(face.b) && face.axis == mesh::Axis::meridian;
        along += in_belt ? 1 : 0;
        if (in_belt || face.axis == mesh::Axis::through) {
            EXPECT_NEAR(system.terms().face_G[f],
                        (in_belt ? 4.0 : 1.0) * 0.29 * face.area / (face.half_a + face.half_b), 1e-12);
        }
    }
    EXPECT_EQ(along, 6);  // seven columns carry a belt
}

TEST(TreadWear, IsAThinnerTreadOnTheSameMesh) {
    // 2 of 8 mm worn: w = 0.75 of the mass and of the section across, 4/3 of the conductance through.
    const Whole whole(section(), {{"tread_wear", {{"depth", 0.002}}}});
    const Material& tread = whole.system().material_model().materials[0];
    EXPECT_NEAR(tread.density, 0.75 * 1100.0, 1e-9);
    EXPECT_NEAR(tread.along(mesh::Axis::through).value(300.0), 0.29 / 0.75, 1e-12);
    EXPECT_NEAR(tread.along(mesh::Axis::meridian).value(300.0), 0.29 * 0.75, 1e-12);
    EXPECT_EQ(whole.system().material_model().materials[1].density, 1100.0);
    EXPECT_NEAR(whole.system().capacity(2 * 2, 300.0), 0.75 * section().mesh.volume[4] * 1100.0 * 1800.0, 1e-9)
        << "the first cell after two columns of two sidewall cells is tread";
}

TEST(TreadWear, SeesTheThicknessOfAGrid) {
    // The specimen's tread is 3 mm: 1.5 mm worn is half.
    const Whole whole(specimen(), {{"tread_wear", {{"depth", 0.0015}}}});
    EXPECT_NEAR(whole.system().material_model().materials[0].density, 550.0, 1e-9);
}

TEST(ConvectionExponent, TurnsTheForcedPartAboutItsPivot) {
    // (32) at 25 m/s: L = 1/(1/0.6616 + 1/0.225) = 0.16790 m, Re = 25 L/1.5e-5 = 279 830,
    // h = 0.025/L * 0.318 Re^0.571 = 61.02 W/m2K; at 50 m/s with 0.805: 2^0.805 = 1.747145 times that. The exponential of
    // (33) at 35 C, 8.59e-11 exp(0.0879 * 308.15) = 49.86 W/m2K, stays.
    const Bench bench = two_nodes();
    Whole whole(bench, {{"air_convection", {}, {{"exponential", 1}}}, {"convection_exponent", {{"exponent", 0.805}}}});
    const double area = bench.tire.outer_area() - 2.333e-6 * 4000.0;
    const double L = 1.0 / (1.0 / 0.6616 + 1.0 / 0.225);
    const double at_pivot = 0.025 / L * 0.318 * std::pow(25.0 * L / 1.5e-5, 0.571);
    EXPECT_NEAR(at_pivot, 61.02, 0.01);
    const double term = 8.59e-11 * std::exp(0.0879 * 308.15);
    EXPECT_NEAR(term, 49.86, 0.05);
    whole.ask(at_speed(180.0));
    EXPECT_NEAR(whole.system().terms().node_G[0], area * (1.747145 * at_pivot + term), 1e-3);
    whole.ask(at_speed(90.0));
    EXPECT_NEAR(whole.system().terms().node_G[0], area * (at_pivot + term), 1e-9);
    Inputs rest = at_speed(0.0);
    whole.ask(rest);
    EXPECT_NEAR(whole.system().terms().node_G[0], area * term, 1e-9);
}

TEST(ConvectionExponent, StartsFromTheExponentInUse) {
    // With 0.7 in air_convection the law at the pivot is the one with 0.7: nothing changes there.
    const Bench bench = two_nodes();
    Whole plain(bench, {{"air_convection", {{"exponent", 0.7}}}});
    Whole bent(bench, {{"air_convection", {{"exponent", 0.7}}}, {"convection_exponent", {{"exponent", 0.5}}}});
    EXPECT_NEAR(bent.ask(at_speed(90.0)).watts("air_convection"), plain.ask(at_speed(90.0)).watts("air_convection"),
                1e-9);
    // Below it the smaller exponent cools more.
    EXPECT_LT(bent.ask(at_speed(50.0)).watts("air_convection"), plain.ask(at_speed(50.0)).watts("air_convection"));
}

TEST(Wind, AddsToTheSpeedOfTheAir) {
    // 10 m/s across 25 m/s: (1 + 0.16)^(0.571/2) = exp(0.2855 * 0.148420) = 1.043283 times the forced part of (32), which is
    // 61.02 W/m2K there (ConvectionExponent, TurnsTheForcedPartAboutItsPivot). A tire that stands has none.
    const Bench bench = two_nodes();
    Whole plain(bench, {{"air_convection"}});
    Whole windy(bench, {{"air_convection"}, {"wind", {{"speed", 10.0}}}});
    const double area = bench.tire.outer_area() - 2.333e-6 * 4000.0;
    const auto film = [&](Whole& whole, double speed) {
        whole.ask(at_speed(speed));
        return whole.system().terms().node_G[0] / area;
    };
    EXPECT_NEAR(film(windy, 90.0) - film(plain, 90.0), 0.043283 * 61.02, 0.001);
    EXPECT_NEAR(film(windy, 0.0), film(plain, 0.0), 1e-12);
}

TEST(PartitionSpeed, IsALineInTheSlidingSpeed) {
    // v_s = 27.778 sqrt(0.01^2 + tan(2 deg)^2) = 27.778 * 0.036324 = 1.00900 m/s; 0.05 s/m: 1.050450 times 1247.36 W.
    Whole whole(two_nodes(), {{"sliding_friction"}, {"partition_speed", {{"slope", 0.05}}}});
    EXPECT_NEAR(whole.ask(driven()).watts("sliding_friction"), 1.050450 * 1247.36, 0.02);
    // Not clamped: 0.6 (1 + 2 * 1.009) = 1.81 of the friction power.
    Whole beyond(two_nodes(), {{"sliding_friction"}, {"partition_speed", {{"slope", 2.0}}}});
    EXPECT_NEAR(beyond.ask(driven()).watts("sliding_friction"), 3.01800 * 1247.36, 0.05);
}

TEST(LossTangentSlope, TurnsTheLossTangentAbout60C) {
    // Bulk at 55 C: exp(0.005 * (55 - 60)) = 0.975310
    EXPECT_NEAR(loss_ratio({"loss_tangent_slope", {{"slope", 0.005}}}, rolling()), 0.975310, 1e-6);
}

TEST(LossFrequencyShift, AddsKelvinPerDecade) {
    // R_R = 0.3483 * 4000^-0.009 = 0.32325 m, f = 27.778/(2 pi R_R) = 13.677 Hz, log10(13.677/52) = -0.58004:
    // 10 K a decade cool the loss tangent by 5.800 K.
    const LossTangent law;
    const double T_eq = 328.15 + law.shift(13.677);
    EXPECT_NEAR(loss_ratio({"loss_frequency_shift", {{"per_decade", 10.0}}}, rolling()),
                law.value(T_eq - 5.8004) / law.value(T_eq), 1e-5);
}

TEST(LoadExponentOfLoss, IsAPowerOfTheLoadOver4500N) {
    // (4000/4500)^0.5 = 0.942809
    EXPECT_NEAR(loss_ratio({"load_exponent_of_loss", {{"exponent", 0.5}}}, rolling()), 0.942809, 1e-6);
}

TEST(DrumCurvature, IsTheRootOfOnePlusTheRatioOfRadii) {
    // Drum of 1.707 m: 1/R = 1.1716 1/m, sqrt(1 + 0.3308 * 1.1716) = 1.17795
    EXPECT_NEAR(loss_ratio({"drum_curvature"}, rolling()), 1.17795, 1e-5);
}

TEST(DrumCurvature, CountsFromTheDrumOfTheLaw) {
    // A law of the drum of 1.707 m: 1 on that drum, 1/sqrt(1 + 0.3308 * 2/1.707) = 1/sqrt(1.387581) = 0.848928 on a flat
    // road, sqrt(1.3308/1.387581) = 0.979326 on a drum of 2 m.
    Bench bench = two_nodes();
    bench.tire.loss_drum_diameter = 1.707;
    const auto ratio = [&](double curvature) {
        Whole plain(bench, {{"strain_energy_loss"}});
        Whole changed(bench, {{"strain_energy_loss"}, {"drum_curvature", {{"curvature", curvature}}}});
        return changed.ask(rolling()).watts("strain_energy_loss") / plain.ask(rolling()).watts("strain_energy_loss");
    };
    EXPECT_NEAR(ratio(2.0 / 1.707), 1.0, 1e-15);
    EXPECT_NEAR(ratio(0.0), 0.848928, 1e-6);
    EXPECT_NEAR(ratio(1.0), 0.979326, 1e-6);
}

TEST(StandingWave, GrowsWithTheSquareBeyondTheCriticalSpeed) {
    // 160 km/h, 20 above 140: 1 + 1e-4 * 400 = 1.04; nothing at 140 and below.
    const Part wave{"standing_wave", {{"gain", 1e-4}, {"critical_speed", 140.0}}};
    EXPECT_NEAR(loss_ratio(wave, at_speed(160.0)), 1.04, 1e-12);
    EXPECT_EQ(loss_ratio(wave, at_speed(139.0)), 1.0);
}

TEST(InflationPressureRise, FollowsAGasThatCostsTheBulkNothing) {
    // Gas at 310 K, filled to 230 kPa above the atmosphere at 294.15 K: 331.325 310/294.15 - 101.325 = 247.853 kPa, and
    // (247.853/230)^-0.45 = 0.966919. It takes 9 (328.15 - 310) - 4 (310 - 296.15) = 107.95 W, the bulk
    // gives none of it.
    Whole plain(two_nodes(), {{"strain_energy_loss"}});
    Whole whole(two_nodes(), {{"strain_energy_loss"}, {"inflation_pressure_rise"}});
    plain.ask(rolling());
    whole.ask(rolling(), {308.15, 328.15, 310.0});
    EXPECT_NEAR(whole.watts("strain_energy_loss") / plain.watts("strain_energy_loss"), 0.966919, 1e-6);
    EXPECT_NEAR(whole.flow(whole.node("pressure_gas")), 107.95, 1e-9);
    EXPECT_NEAR(whole.flow(1), 0.85 * whole.watts("strain_energy_loss"), 1e-9);
    EXPECT_EQ(whole.watts("inflation_pressure_rise"), 0.0) << "a state of the law, no heat of the tire";
    EXPECT_NEAR(whole.system().of_budget(whole.system().heat_flow()), whole.watts("strain_energy_loss"), 1e-9);
    EXPECT_EQ(whole.system().capacity(2, 300.0), 70.0);
}

TEST(InflationPressureRise, FollowsTheGasOfTheCavityWhereThereIsOne) {
    // Gas of inner_gas at 320 K, its own at 310 K: 259.117 kPa, (259.117/230)^-0.45 = 0.947773. Either order of switching on.
    Whole plain(two_nodes(), {{"strain_energy_loss"}});
    plain.ask(rolling());
    const Part sel{"strain_energy_loss"};
    const Part gas{"inner_gas"};
    const Part rise{"inflation_pressure_rise"};
    for (const std::vector<Part>& parts : {std::vector{sel, gas, rise}, std::vector{rise, gas, sel}}) {
        Whole whole(two_nodes(), parts);
        std::vector<double> T{308.15, 328.15, 310.0, 310.0};
        T[static_cast<std::size_t>(whole.node("gas"))] = 320.0;
        whole.ask(rolling(), T);
        EXPECT_NEAR(whole.watts("strain_energy_loss") / plain.watts("strain_energy_loss"), 0.947773, 1e-6);
    }
}

TEST(CamberAsymmetry, HeatsTheInsideShoulderUnderNegativeCamber) {
    // -0.05 rad, c = 10: the inside shoulder takes 1.5 of its share, the outside one 0.5, the crown's centre all of its;
    // the total stays.
    const Bench bench = section();
    Whole plain(bench, {{"strain_energy_loss"}});
    Whole leaning(bench, {{"strain_energy_loss"}, {"camber_asymmetry"}});
    plain.ask(rolling());
    leaning.ask(rolling());
    const auto ratio = [&](std::size_t column) {
        const int cell = bench.mesh.columns[column].first_cell;
        return leaning.flow(cell) / plain.flow(cell);
    };
    EXPECT_NEAR(ratio(2), 0.5, 1e-9);  // outside shoulder: beyond its middle
    EXPECT_NEAR(ratio(5), 1.0, 1e-9);
    EXPECT_NEAR(ratio(8), 1.5, 1e-9);
    EXPECT_NEAR(leaning.watts("strain_energy_loss"), plain.watts("strain_energy_loss"), 1e-9);
}

}  // namespace tiretherm::physics
