// SPDX-License-Identifier: BSD-3-Clause
// Materials of cords in rubber as cases give them: numbers in SI, the mesh that shows them, and the equal case in numbers.

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

// What [material.cord_rubber] becomes. Errors are in tests/bad_cases/cord_rubber*.toml.
namespace tiretherm::input {

namespace {

using std::numbers::pi;

std::string good(std::string_view name) {
    return "include = [\"" + (source_folder() / "tests/bad_cases/good" / name).string() + "\"]\n";
}

Reading read(std::string_view base, const std::string& more) {
    const Written written;
    return read_case(written.add("case.toml", good(base) + more));
}

/// A section whose carcass is of the material "plies".
std::string carcass(const std::string& plies) {
    return R"(
[[mesh.layer]]
name = "tread"
zones = ["crown", "shoulders"]
thickness = "8 mm"
cells = 2
material = "rubber"
[[mesh.layer]]
name = "carcass"
thickness = "4 mm"
cells = 2
material = "plies"
[[material]]
name = "plies"
)" + plies;
}

/// V = 1000 pi 0.8^2/4 mm2 over 1000 x 2 mm2 = 0.08 pi; the rubber is that of the section's tire.
const std::string belt = R"(
[material.cord_rubber]
rubber = "rubber"
cord_diameter = "0.8 mm"
ends = "1000 1/m"
thickness = "2 mm"
angle = "-22 deg"
cord_conductivity = "50 W/mK"
cord_density = "7850 kg/m3"
cord_heat_capacity = "470 J/kgK"
)";

const physics::Material& plies_of(const Reading& reading) { return reading.problem->materials.at(1); }

std::vector<double> final_of(const solver::Problem& problem) {
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return report.channel_final;
}

}  // namespace

TEST(CordRubberCase, HasTheConductivitiesDensityAndHeatCapacityOfItsPlies) {
    const Reading reading = read("section.toml", carcass(belt));
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_EQ(reading.warnings, std::vector<std::string>{});
    const physics::Material& rubber = reading.problem->materials.at(0);
    const physics::Material& plies = plies_of(reading);
    // The mixing rules written out again, with the rubber's own law at 320 K; its table is good to 1e-5.
    const double V = 0.08 * pi;
    const double k_r = rubber.along(mesh::Axis::through).value(320.0);
    const double k1 = V * 50.0 + (1.0 - V) * k_r;
    const double k2 = k_r * (50.0 + k_r + (50.0 - k_r) * V) / (50.0 + k_r - (50.0 - k_r) * V);
    const double c2 = std::pow(std::cos(22.0 * pi / 180.0), 2);
    EXPECT_NEAR(plies.along(mesh::Axis::through).value(320.0), k2, 1e-5);
    EXPECT_NEAR(plies.along(mesh::Axis::meridian).value(320.0), k1 * (1.0 - c2) + k2 * c2, 1e-5);
    EXPECT_NEAR(plies.along(mesh::Axis::circumference).value(320.0), k1 * c2 + k2 * (1.0 - c2), 1e-5);
    EXPECT_NEAR(plies.density, V * 7850.0 + (1.0 - V) * rubber.density, 1e-9);
    EXPECT_NEAR(plies.density * plies.heat_capacity.value(320.0),
                V * 7850.0 * 470.0 + (1.0 - V) * rubber.density * rubber.heat_capacity.value(320.0), 1e-6);
}

TEST(CordRubberCase, RunsAsTheCaseThatGivesTheSameNumbers) {
    // Rubber of 0.25 W/mK, 1100 kg/m3, 1800 J/kgK: V = 0.2513274, k1 = 12.5663706 + 0.1871681 = 12.753539,
    // k2 = 0.25 (50.25 + 12.5035386)/(50.25 - 12.5035386) = 0.415625, rho = 1972.920 + 823.540 = 2796.460. The other case
    // gives what follows from them with twelve digits: 1e-10 of some 40 K, and the steps' decisions may differ no more.
    const std::string rubber =
        "[[material]]\nname = \"filler\"\ndensity = \"1100 kg/m3\"\nheat_capacity = \"1800 J/kgK\"\n"
        "conductivity = \"0.25 W/mK\"\n";
    std::string of_cords = belt;
    of_cords.replace(of_cords.find("\"rubber\""), 8, "\"filler\"");
    const std::string sensor = "[[sensor]]\nname = \"inside\"\nkind = \"patch\"\npatch = \"inside\"\n";
    const Reading mixed = read("section.toml", carcass(of_cords) + rubber + sensor);
    const double V = 0.08 * pi;
    const double k1 = V * 50.0 + (1.0 - V) * 0.25;
    const double k2 = 0.25 * (50.25 + 49.75 * V) / (50.25 - 49.75 * V);
    const double c2 = std::pow(std::cos(22.0 * pi / 180.0), 2);
    const double rho = V * 7850.0 + (1.0 - V) * 1100.0;
    EXPECT_NEAR(k1, 12.753539, 1e-6);
    EXPECT_NEAR(k2, 0.415625, 1e-6);
    EXPECT_NEAR(rho, 2796.460, 1e-3);
    const Reading given =
        read("section.toml",
             carcass(fmt::format("density = \"{:.12g} kg/m3\"\nheat_capacity = \"{:.12g} J/kgK\"\n"
                                 "conductivity = \"{:.12g} W/mK\"\nconductivity_meridian = \"{:.12g} W/mK\"\n"
                                 "conductivity_circumference = \"{:.12g} W/mK\"\n",
                                 rho, (V * 7850.0 * 470.0 + (1.0 - V) * 1100.0 * 1800.0) / rho, k2,
                                 k1 * (1.0 - c2) + k2 * c2, k1 * c2 + k2 * (1.0 - c2))) +
                 sensor);
    ASSERT_TRUE(mixed.problem) << render(mixed);
    ASSERT_TRUE(given.problem) << render(given);
    const std::vector<double> a = final_of(*mixed.problem);
    const std::vector<double> b = final_of(*given.problem);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i], b[i], 1e-6) << i;
    }
}

TEST(CordRubberCase, ReportsThePlysModuli) {
    // V = 0.08 pi = 0.251327: E1 = V 200 GPa + (1 - V) 10 MPa = 50.2729 GPa; E2 = 10 MPa (1 + 2 V)/(1 - V) = 20.0709 MPa
    const Reading reading = read("section.toml", carcass(belt + R"(
cord_modulus = "200 GPa"
cord_poisson = 0.3
rubber_modulus = "10 MPa"
rubber_poisson = 0.5
)"));
    ASSERT_TRUE(reading.problem) << render(reading);
    ASSERT_EQ(reading.plies.size(), 1U);
    const PlySummary& ply = reading.plies[0];
    EXPECT_EQ(ply.material, "plies");
    EXPECT_NEAR(ply.cord_share, 0.08 * pi, 1e-15);
    ASSERT_TRUE(ply.elastic);
    EXPECT_NEAR(ply.elastic->lamina.E1, 50.2729e9, 1e5);
    EXPECT_NEAR(ply.elastic->lamina.E2, 20.0709e6, 1e2);
    // cos^4 = 0.739032, sin^4 = 0.019693, s^2 c^2 = 0.120638; G_c/G_r = 23076.9: G12 = G_r (1.251327 + 0.748673/23076.9)/
    // (0.748673 + 1.251327/23076.9) = 3.333333 MPa * 1.671316 = 5.571055 MPa; 1/E = 0.120638/5.571055 + 0.019693/20.0709
    // + 1e-5 = 0.021655 + 0.000981 + 0.000013 = 0.022649 1/MPa: 44.15 MPa
    EXPECT_NEAR(ply.elastic->lamina.G12, 5.571055e6, 10.0);
    EXPECT_NEAR(ply.elastic->ply.E_x, 44.15e6, 0.05e6);
    // Along the meridian sin and cos change places: 0.120638/5.571055 + 0.739032/20.0709 = 0.021655 + 0.036821 1/MPa
    EXPECT_NEAR(ply.elastic->ply.E_y, 17.101e6, 0.02e6);
    // 1/G_xy = cos^2(44)/G12 + sin^2(44)/E2, but for 1/E1 and nu21 = 0.517450/5.571055 + 0.482550/20.0709 1/MPa
    // = 0.092882 + 0.024042 = 0.116924: 8.553 MPa
    EXPECT_NEAR(ply.elastic->ply.G_xy, 8.552e6, 0.005e6);
    // nu_xy = -E_x (1/E2 - 1/G12) s^2 c^2, but for 1/E1: -44.15 (0.049823 - 0.179507) 0.120638 = 0.6907
    EXPECT_NEAR(ply.elastic->ply.nu_xy, 0.6907, 0.002);
    // The pair holds its plies: 4 G12 cot^2 + E2 (1 - cot^2)^2 for cords that do not stretch, cot^2(22) = 6.125998:
    // 136.51 + 527.38 = 663.9 MPa; those of steel stretch, which leaves 98 % of it.
    EXPECT_EQ(ply.elastic->plies, 2);
    EXPECT_NEAR(ply.elastic->layer.E_x / 663.9e6, 1.0, 0.03);
    // A case without them reports none.
    EXPECT_FALSE(read("section.toml", carcass(belt)).plies.at(0).elastic);
}

TEST(CordRubberCase, GivesItsOwnDensityAndHeatCapacity) {
    std::string own = belt;
    own.erase(own.find("cord_density"));
    const Reading reading =
        read("section.toml", carcass("density = \"2000 kg/m3\"\nheat_capacity = \"1000 J/kgK\"\n" + own));
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_DOUBLE_EQ(plies_of(reading).density, 2000.0);
    EXPECT_DOUBLE_EQ(plies_of(reading).heat_capacity.value(300.0), 1000.0);
}

// Around a section nothing changes, so that what a single ply conducts obliquely goes round and ends where it began. On a
// ring it does not; there a pair cancels it.
TEST(CordRubberCase, OfASinglePlyIsForMeshesThatAreEvenAroundTheCircumference) {
    const std::string ring = "[mesh]\nsectors = 8\n";
    std::string single = belt + "plies = 1\n";
    single.replace(single.find("\"2 mm\""), 6, "\"4 mm\"");
    EXPECT_TRUE(read("section.toml", carcass(single)).problem);
    EXPECT_FALSE(read("section.toml", ring + carcass(single)).problem);
    EXPECT_TRUE(read("section.toml", ring + carcass(belt)).problem);
    std::string radial = single;
    radial.replace(radial.find("-22 deg"), 7, "90 deg");
    EXPECT_TRUE(read("section.toml", ring + carcass(radial)).problem);
}

TEST(CordRubberCase, WarnsOfPliesThatDoNotFillTheLayerAndOfCordsCountedTwice) {
    const Reading thin = read("section.toml", carcass(belt + "plies = 1\n"));
    ASSERT_EQ(thin.warnings.size(), 1U) << render(thin);
    EXPECT_NE(thin.warnings[0].find("the layer is 4 mm thick, but its ply is one of 2 mm: 2 mm"), std::string::npos)
        << thin.warnings[0];
    const Reading twice = read("section.toml", carcass(belt) + "[effects.belt_anisotropy]\nlayers = [\"carcass\"]\n");
    ASSERT_EQ(twice.warnings.size(), 1U) << render(twice);
    EXPECT_NE(twice.warnings[0].find("belt_anisotropy multiplies the conductivities of plies along the belt"),
              std::string::npos)
        << twice.warnings[0];
}

TEST(CordRubberCase, IsNotFreeInAFitWhereItFollows) {
    const Written written;
    const std::string run =
        "[[run]]\nname = \"numbers\"\nmeasured = [{ channel = \"inside\", value = \"42 degC\", uncertainty = \"2 K\" "
        "}]\n"
        "[[sensor]]\nname = \"inside\"\nkind = \"patch\"\npatch = \"inside\"\n";
    const auto errors = [&](const std::string& material, const std::string& law) {
        const std::string free =
            fmt::format("[[parameter]]\nmaterial = \"{}\"\nlaw = \"{}\"\nat = \"60 degC\"\n", material, law);
        std::string text;
        const ExperimentReading reading =
            read_experiment(written.add("case.toml", good("section.toml") + carcass(belt) + run + free));
        for (const InputError& error : reading.errors) {
            text += error.what + "\n";
        }
        return text;
    };
    EXPECT_EQ(errors("plies", "conductivity"), "the conductivity of plies follows from its cords and rubber\n");
    EXPECT_EQ(errors("plies", "heat_capacity"), "the heat_capacity of plies follows from its cords and rubber\n");
    EXPECT_EQ(errors("rubber", "conductivity"),
              "the conductivity of rubber is also in the plies of plies, which would not follow it in a fit\n");
}

}  // namespace tiretherm::input
