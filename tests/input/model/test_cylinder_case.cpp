// SPDX-License-Identifier: BSD-3-Clause
// What a case with a cylinder becomes: true radii, and those of the tire where it states none.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/mesh.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

using std::numbers::pi;

const std::string rubber =
    "[[mesh.layer]]\nname = \"tread\"\nthickness = \"12 mm\"\ncells = 4\nmaterial = \"rubber\"\n"
    "[[mesh.layer]]\nname = \"carcass\"\nthickness = \"8 mm\"\ncells = 2\nmaterial = \"rubber\"\n"
    "[[material]]\nname = \"rubber\"\ndensity = \"1100 kg/m3\"\nheat_capacity = \"1800 J/kgK\"\n"
    "conductivity = \"0.29 W/mK\"\n[initial]\ntemperature = \"20 degC\"\n[time]\nend = \"60 s\"\n";

Reading read(const std::string& text) {
    const Written written;
    return read_case(written.add("case.toml", text));
}

}  // namespace

// 30 to 50 mm over 0.1 m: pi (50^2 - 30^2) 0.1 m3 of rubber, 2 pi 50 mm outside, 2 pi 30 mm inside. A flux sensor and a
// point 1 mm below the outer surface show that places are depths.
TEST(CylinderCase, HasTheRadiiThatItStates) {
    const Reading reading =
        read("[mesh]\nkind = \"cylinder\"\ninner_radius = \"30 mm\"\nlength = \"10 cm\"\n" + rubber +
             "[[sensor]]\nname = \"skin\"\nkind = \"point\"\ndepth = \"1 mm\"\n"
             "[[sensor]]\nname = \"flux\"\nkind = \"heat_flux\"\npatch = \"inside\"\n");
    ASSERT_TRUE(reading.problem) << render(reading);
    const mesh::Mesh& mesh = reading.problem->mesh;
    EXPECT_EQ(mesh.kind, "cylinder");
    EXPECT_EQ(mesh.n_cells, 6);
    EXPECT_NEAR(mesh.total_volume(), pi * (0.05 * 0.05 - 0.03 * 0.03) * 0.1, 1e-15);
    EXPECT_NEAR(mesh.patches[0].area(), 2.0 * pi * 0.05 * 0.1, 1e-15);
    EXPECT_NEAR(mesh.patches[1].area(), 2.0 * pi * 0.03 * 0.1, 1e-15);
    const solver::Channel& flux = reading.problem->channels.at(1);
    EXPECT_EQ(flux.quantity, solver::Quantity::heat_flux);
    EXPECT_EQ(flux.meaning, "heat flux out of the rubber, mean over the patch inside");
    ASSERT_EQ(flux.where.nodes.size(), 1U);
    EXPECT_NEAR(flux.where.weights[0] * mesh.patches[1].area(), 1.0, 1e-14);
}

// With a tire: its unloaded radius outside, and the area that `layers` would have.
TEST(CylinderCase, TakesTheTiresRadiusAndArea) {
    const std::string tire =
        "[tire]\nsize = \"225/50 R17\"\nunloaded_radius = \"330.8 mm\"\n"
        "[drive]\nspeed = \"100 km/h\"\nvertical_load = \"4000 N\"\nair_temperature = \"23 degC\"\n"
        "road_temperature = \"23 degC\"\n";
    const Reading round = read(tire + "[mesh]\nkind = \"cylinder\"\n" + rubber);
    const Reading flat = read(tire + "[mesh]\nkind = \"layers\"\n" + rubber);
    ASSERT_TRUE(round.problem) << render(round);
    ASSERT_TRUE(flat.problem) << render(flat);
    const mesh::Mesh& mesh = round.problem->mesh;
    EXPECT_NEAR(mesh.grid->outer_radius, 0.3308, 1e-12);
    EXPECT_NEAR(mesh.patches[0].area(), flat.problem->mesh.patches[0].area(), 1e-12);
    EXPECT_NEAR(mesh.patches[1].area(), mesh.patches[0].area() * (0.3308 - 0.020) / 0.3308, 1e-12);
}

TEST(CylinderCase, RefusesLayersThickerThanTheTiresRadius) {
    std::string thick = rubber;
    thick.replace(thick.find("12 mm"), 5, "40 cm");
    const Reading reading = read(
        "[tire]\nsize = \"225/50 R17\"\nunloaded_radius = \"330.8 mm\"\n"
        "[mesh]\nkind = \"cylinder\"\n" +
        thick);
    EXPECT_FALSE(reading.problem);
    EXPECT_NE(render(reading).find("the layers are 408 mm thick, and the tire's radius is 330.8 mm"), std::string::npos)
        << render(reading);
}

// The library's case against its closed form, T(r) = -q r^2 / (4 k) + A ln r + B: A and B follow from both films,
//   k (A/r1 - q r1/(2 k)) = h1 (T(r1) - T_air),   -k (A/r2 - q r2/(2 k)) = h2 (T(r2) - T_air).
// 200 cells of second order are good to 1e-4 K.
TEST(CylinderCase, ReferenceIsItsClosedForm) {
    constexpr double r1 = 0.03;
    constexpr double r2 = 0.05;
    constexpr double k = 0.25;
    constexpr double q = 1e5;
    constexpr double h1 = 10.0;
    constexpr double h2 = 60.0;
    const auto particular = [&](double r) { return -q * r * r / (4.0 * k); };
    // Rows: (k/r1 - h1 ln r1) A - h1 B = q r1/2 + h1 (particular(r1) - T_air), and likewise outside.
    const double a11 = k / r1 - h1 * std::log(r1);
    const double a12 = -h1;
    const double b1 = 0.5 * q * r1 + h1 * (particular(r1) - 23.0);
    const double a21 = -k / r2 - h2 * std::log(r2);
    const double a22 = -h2;
    const double b2 = -0.5 * q * r2 + h2 * (particular(r2) - 23.0);
    const double det = a11 * a22 - a12 * a21;
    const double A = (b1 * a22 - b2 * a12) / det;
    const double B = (a11 * b2 - a21 * b1) / det;
    const auto T = [&](double r) { return particular(r) + A * std::log(r) + B; };

    const Reading reading = read_case(source_folder() / "cases/reference/cylinder.toml");
    ASSERT_TRUE(reading.problem) << render(reading);
    const solver::MarchReport report = solver::run(*reading.problem, [](const solver::Snapshot&) { return true; });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    const std::vector<double>& found = report.channel_final;
    ASSERT_EQ(found.size(), 5U);
    EXPECT_NEAR(found[0] - 273.15, T(r2), 1e-3);
    EXPECT_NEAR(found[1] - 273.15, T(0.04), 1e-3);
    EXPECT_NEAR(found[2] - 273.15, T(r1), 1e-3);
    EXPECT_NEAR(found[3], h2 * (T(r2) - 23.0), 0.05);
    EXPECT_NEAR(found[4], h1 * (T(r1) - 23.0), 0.05);
}

}  // namespace tiretherm::input
