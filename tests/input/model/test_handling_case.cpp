// SPDX-License-Identifier: BSD-3-Clause
// Cornering stiffness, lateral force and friction as a user gives them in [tire].
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "physics/celsius.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

Reading read_cornering(const std::string& tables, const std::string& csv = "") {
    const Written written;
    written.add("stiffness.csv", csv);
    return read_case(written.add(
        "case.toml",
        "include = [\"" + (source_folder() / "tests/bad_cases/good/tire.toml").string() + "\"]\n" + tables));
}

double stiffness_of(const Reading& reading, double load, double celsius) {
    EXPECT_TRUE(reading.problem) << render(reading);
    return reading.problem ? reading.problem->handling.cornering_stiffness(
                                 reading.problem->tire, {.vertical_load = load}, zero_celsius + celsius)
                           : 0.0;
}

const std::string cords = R"(
[[material]]
name = "belt"
[material.cord_rubber]
rubber = "rubber"
cord_diameter = "0.8 mm"
ends = "1000 1/m"
thickness = "2 mm"
angle = "22 deg"
cord_conductivity = "50 W/mK"
cord_density = "7850 kg/m3"
cord_heat_capacity = "470 J/kgK"
cord_modulus = "200 GPa"
cord_poisson = 0.3
rubber_modulus = "10 MPa"
rubber_poisson = 0.5
)";

}  // namespace

// 2 and 4 kN, 40 and 80 degC; at 3 kN and 50 degC 57.5 and 105, half-way 81.25 kN/rad, however the rows are sorted.
TEST(HandlingCase, StiffnessIsATableOfTheCaseOrAFile) {
    const std::string heads = "vertical_load [kN],bulk_temperature [degC],cornering_stiffness [kN/rad]\n";
    const Reading file = read_cornering("[tire]\ncornering_stiffness = \"stiffness.csv\"\n",
                                        heads + "4,80,90\n2,40,60\n4,40,110\n2,80,50\n");
    EXPECT_NEAR(stiffness_of(file, 3000.0, 50.0), 81.25e3, 1e-6);
    const Reading inside = read_cornering(R"([tire]
cornering_stiffness = { columns = ["bulk_temperature [degC]", "cornering_stiffness [kN/deg]", "vertical_load [N]"], rows = [[40, 1, 2000], [80, 0.8, 2000]] }
)");
    // One load: it holds for all. 0.9 kN/deg = 900 180/pi N/rad
    EXPECT_NEAR(stiffness_of(inside, 7000.0, 60.0), 900.0 * 180.0 / std::acos(-1.0), 1e-6);
}

// V = 0.08 pi: E_x of the pair at +-22 degrees is the belt's largest modulus, and the fall the same 31/33 of it:
// at 4 kN E_l = E_x (2/33 + 31/33/13.4502) = 0.130449 E_x, in series with the tread's 65.552 MPa at 70 degC (by hand in
// CorneringStiffness.DefaultIs30TimesTheLoadAt70Degrees), times l^2/2 = 4.67533e-3 m2. One ply alone, free to shear, has
// 44.15 MPa (CordRubberCase.ReportsThePlysModuli), the pair 15 times as much.
TEST(HandlingCase, BeltIsThatOfItsCords) {
    const std::string of_belt = "[tire.modulus]\nbelt_material = \"belt\"\n";
    const Reading pair = read_cornering(of_belt + cords);
    ASSERT_TRUE(pair.problem) << render(pair);
    const double E_x = pair.problem->handling.modulus.E_max;
    EXPECT_NEAR(E_x, 655e6, 10e6);
    const double E_l = 0.130449 * E_x;
    EXPECT_NEAR(stiffness_of(pair, 4000.0, 70.0), 4.67533e-3 / (1.0 / E_l + 1.0 / 65.552e6), 10.0);
    std::string single = cords;
    single.replace(single.find("rubber_modulus"), 0, "plies = 1\n");
    const Reading one = read_cornering(of_belt + single);
    ASSERT_TRUE(one.problem) << render(one);
    EXPECT_NEAR(one.problem->handling.modulus.E_max, 44.15e6, 0.05e6);
    // The thesis's E_x (56) at angle 0 is E1 = 50.27 GPa.
    single.replace(single.find("22 deg"), 6, "0 deg");
    const Reading along = read_cornering(of_belt + single);
    ASSERT_TRUE(along.problem) << render(along);
    EXPECT_NEAR(along.problem->handling.modulus.E_max, 50.2729e9, 1e5);
}

// Friction at a surface of 80 degC against 40: 0.683900 (Grip.IsTheSumOfAdhesionHysteresisAndWear), so that of the peak of
// 4000 N 2735.60 N are left. Slope, peak and asymptote alone make a lateral force, whose curve shrinks by it: at 2 degrees it is
// 0.6839 times that at 2/0.6839 = 2.924404 degrees: B x = 19.423018 0.0510405 = 0.991360, its atan 0.781060, the argument 0.991360
// + 0.143749 0.210301 = 1.021591: 0.683900 4000 sin(1.287133 atan 1.021591) = 2337.67 N
TEST(HandlingCase, ForceAndPeakFollowBulkAndSurface) {
    const Reading reading = read_cornering(R"([tire]
cornering_stiffness = { columns = ["vertical_load [N]", "cornering_stiffness [N/rad]"], rows = [[4000, 1e5]] }
[tire.lateral_peak]
friction = 1
[tire.grip]
adhesion = { columns = ["surface [degC]", "friction [-]"], rows = [[40, 0.3], [80, 0.27]] }
hysteresis = 0.68
wear = 0.02
[drive]
slip_angle = "2 deg"
[initial]
temperature = "80 degC"
[[sensor]]
name = "force"
kind = "lateral_force"
[[sensor]]
name = "friction"
kind = "grip"
[[sensor]]
name = "peak"
kind = "peak_lateral_force"
)");
    ASSERT_TRUE(reading.problem) << render(reading);
    std::vector<double> first;
    const auto report = solver::run(*reading.problem, [&](const solver::Snapshot& moment) {
        first.assign(moment.channels.begin(), moment.channels.end());
        return false;
    });
    EXPECT_EQ(report.status.outcome, solver::Outcome::stopped);
    ASSERT_EQ(first.size(), 4U);
    EXPECT_NEAR(first[1], 2337.67, 0.01);
    EXPECT_NEAR(first[2], 0.683900, 1e-6);
    EXPECT_NEAR(first[3], 2735.60, 0.01);
}

// The two nodes do not change: what these tables say reaches channels alone.
TEST(HandlingCase, LeavesTheTemperaturesAlone) {
    const auto last = [](const Reading& reading) {
        EXPECT_TRUE(reading.problem) << render(reading);
        double T = 0.0;
        const auto report = solver::run(*reading.problem, [&](const solver::Snapshot& moment) {
            T = moment.channels.front();
            return true;
        });
        EXPECT_TRUE(report.status.ok());
        return T;
    };
    EXPECT_EQ(last(read_cornering("[tire.grip]\nhysteresis = 1\n[tire.lateral_peak]\nfriction = 1\n")),
              last(read_cornering("")));
}

TEST(HandlingCase, MeasuredValuesStandBesideTheLaws) {
    const Reading reading = read_cornering(R"([tire.measured]
contact_length = { columns = ["load [kN]", "length [mm]"], rows = [[2, 54], [4, 97]] }
cornering_stiffness = { columns = ["vertical_load [kN]", "bulk_temperature [degC]", "cornering_stiffness [kN/rad]"], rows = [[4, 70, 120]] }
)");
    ASSERT_TRUE(reading.problem) << render(reading);
    const physics::Handling& handling = reading.problem->handling;
    EXPECT_DOUBLE_EQ(handling.measured.contact_length->value(4000.0), 0.097);
    ASSERT_EQ(handling.measured.cornering_stiffness.size(), 1U);
    EXPECT_DOUBLE_EQ(handling.measured.cornering_stiffness[0].stiffness, 120e3);
    // The law stays: 96.70 mm.
    EXPECT_NEAR(reading.problem->tire.contact_length(4000.0), 0.096699, 1e-6);
    EXPECT_FALSE(reading.problem->tire.contact_length_table);
}

}  // namespace tiretherm::input
