// SPDX-License-Identifier: BSD-3-Clause
// Fields of a structural code as a user gives them to an effect, and what arrives.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "input/effects/field_bench.hpp"
#include "input/runs/read_experiment.hpp"
#include "solver/system.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::input {

namespace {

using namespace field_bench;

physics::ActiveEffect placed(const solver::Problem& problem, std::string_view id) {
    const solver::System system(problem);
    return *std::ranges::find_if(system.effects(), [&](const auto& active) { return active.effect->id == id; });
}

double sum(const Values& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

// A uniform field along the tread is what the effect does without one.
TEST(FieldFile, UniformFrictionIsTheBuiltInSpread) {
    const Reading with = read(friction, "y [mm],friction_power [W/m2]\n-100,5\n-50,5\n0,5\n50,5\n100,5\n");
    const Reading without = read("", "");
    ASSERT_TRUE(with.problem.has_value()) << render(with);
    const physics::ActiveEffect shaped = placed(*with.problem, "sliding_friction");
    const physics::ActiveEffect plain = placed(*without.problem, "sliding_friction");
    ASSERT_TRUE(shaped.field != nullptr);
    ASSERT_EQ(shaped.nodes, plain.nodes);
    for (std::size_t i = 0; i < plain.weights.size(); ++i) {
        EXPECT_NEAR(shaped.weights[i], plain.weights[i], 1e-15);
    }
}

// Five points 20 mm apart stand for -100 to 0 mm: the other half of the tread does not touch the road. Where pressure times
// speed is three times as large there is three times the friction, on faces as wide and as far from the axle.
TEST(FieldFile, PlacesTheRoadByPressureAndFrictionByPressureTimesSpeed) {
    const std::string text =
        "y [mm],pressure [kPa],sliding_velocity [m/s]\n-90,200,1\n-70,200,1\n-50,200,1\n-30,200,3\n-10,200,-3\n";
    const Reading reading = read(friction + "[effects.road_contact]\nfield = \"field.csv\"\n", text);
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    const mesh::Mesh& mesh = reading.problem->mesh;
    const std::vector<mesh::PatchFace>& faces =
        mesh.patches[static_cast<std::size_t>(mesh.find_patch("outside"))].faces;
    const Values road = placed(*reading.problem, "road_contact").weights;
    const Values sliding = placed(*reading.problem, "sliding_friction").weights;
    ASSERT_EQ(road.size(), faces.size());
    EXPECT_NEAR(sum(road), 1.0, 1e-14);
    EXPECT_NEAR(sum(sliding), 1.0, 1e-14);
    double touching = 0.0;
    for (const mesh::PatchFace& face : faces) {
        const double width = std::min(face.extent[1], 0.0) - std::max(face.extent[0], -0.1);
        touching += std::max(0.0, width) / (face.extent[1] - face.extent[0]) * face.area;
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const double width = std::min(faces[i].extent[1], 0.0) - std::max(faces[i].extent[0], -0.1);
        const double part = std::max(0.0, width) / (faces[i].extent[1] - faces[i].extent[0]);
        EXPECT_NEAR(road[i], part * faces[i].area / touching, 1e-14) << i;
        if (faces[i].extent[0] >= 0.0) {
            EXPECT_EQ(sliding[i], 0.0);
        }
    }
    // Faces of the shoulder from -90 to -67.5 mm, all at 1 m/s; of the crown from -33.75 to 0 mm, all but its first 3.75 mm
    // at 3 m/s: those lose 2 (0.00375)^2/2/0.020 of 3 times 0.03375.
    const auto face_at = [&](double y) {
        return static_cast<std::size_t>(
            std::ranges::find_if(
                faces, [&](const mesh::PatchFace& face) { return face.extent[0] < y && y < face.extent[1]; }) -
            faces.begin());
    };
    const double slow = sliding[face_at(-0.08)] / faces[face_at(-0.08)].area;
    const double fast = sliding[face_at(-0.01)] / faces[face_at(-0.01)].area;
    EXPECT_NEAR(fast / slow, 3.0 - 2.0 * 0.00375 * 0.00375 / 2.0 / 0.020 / 0.03375, 1e-9);
}

// The mean over a revolution by hand: 10 W/m2 at 0 and 180 deg, 50 at 90 and 10 at 270 deg: 20 W/m2. The same with a
// last frame at 360 deg. On a ring, so that watts are 20 W/m2 times the tread's area.
TEST(FieldFile, AgainstTheWheelAngleIsAveragedOverARevolution) {
    const std::string open = "wheel_angle [deg],y [mm],friction_power [W/m2]\n0,0,10\n90,0,50\n180,0,10\n270,0,10\n";
    for (const std::string& text : {open, open + "360,0,10\n"}) {
        const Reading reading = read(friction_watts, text);
        ASSERT_TRUE(reading.problem.has_value()) << render(reading);
        const mesh::Mesh& mesh = reading.problem->mesh;
        const double area = mesh.patches[static_cast<std::size_t>(mesh.find_patch("outside"))].area();
        const physics::ActiveEffect active = placed(*reading.problem, "sliding_friction");
        ASSERT_EQ(active.field->watts.size(), 1U);
        EXPECT_NEAR(active.field->watts[0], 20.0 * area, 1e-12 * area);
        EXPECT_NEAR(sum(active.weights), 1.0, 1e-14);
    }
    // In steps of 90, 90, 120 and 60 deg the frames count 75, 90, 105 and 90 of 360: 10 + 40 90/360 = 20 again, which
    // equal shares give as well; with 50 at 180 deg it is 10 + 40 105/360 = 21.667.
    const Reading uneven =
        read(friction_watts, "wheel_angle [deg],y [mm],friction_power [W/m2]\n0,0,10\n90,0,10\n180,0,50\n300,0,10\n");
    ASSERT_TRUE(uneven.problem.has_value()) << render(uneven);
    const mesh::Mesh& mesh = uneven.problem->mesh;
    const double area = mesh.patches[static_cast<std::size_t>(mesh.find_patch("outside"))].area();
    EXPECT_NEAR(placed(*uneven.problem, "sliding_friction").field->watts[0], (10.0 + 40.0 * 105.0 / 360.0) * area,
                1e-12 * area);
}

// Watts against time in a run of 60 s: none up to 10 s, a ramp of 20 s to P, and P for the last 30 s: 40 s P, whatever
// steps are taken. P = 0.6 1.2e6 W/m2 1e-3 m2 = 720 W: 28 800 J.
TEST(FieldFile, AgainstTimeIsIntegratedExactly) {
    for (const std::string step : {"", "step = \"17 s\"\n"}) {
        Reading reading =
            read(friction_watts + "[effects.strain_energy_loss]\non = false\n[effects.air_convection]\non = false\n" +
                     "[effects.road_contact]\non = false\n[time]\nend = \"60 s\"\n" + step,
                 "time [s],y [mm],area [mm2],friction_power [W/m2]\n10,0,1000,0\n30,0,1000,1.2e6\n50,0,1000,1.2e6\n");
        ASSERT_TRUE(reading.problem.has_value()) << render(reading);
        const solver::MarchReport report = solver::run(*reading.problem, [](const solver::Snapshot&) { return true; });
        ASSERT_TRUE(report.status.ok());
        EXPECT_LE(report.energy_closure, 1e-10);
        double joules = 0.0;
        for (std::size_t e = 0; e < reading.problem->effects.size(); ++e) {
            if (reading.problem->effects[e].effect->id == "sliding_friction") {
                joules = report.joules[e];
            }
        }
        EXPECT_NEAR(joules, 28800.0, 28800.0 * 1e-10) << step;
    }
}

// A run of laws beside fields closes its energy, and a shape leaves the total of the law as it was.
TEST(FieldFile, ShapesOfARunKeepTheTotalAndCloseTheEnergy) {
    const Written written;
    written.add("field.csv", "time [s],y [mm],friction_power [W/m2]\n0,-90,1\n0,90,3\n600,-90,3\n600,90,1\n");
    written.add("loss.csv", "y [mm],depth [mm],loss_density [W/m3]\n-80,2,1e4\n-80,8,2e4\n80,2,3e4\n80,8,1e4\n");
    const Reading sound = read_case(
        written.add("case.toml", cornering(friction + "[effects.strain_energy_loss]\nfield = \"loss.csv\"\n")));
    ASSERT_TRUE(sound.problem.has_value()) << render(sound);
    const solver::MarchReport report = solver::run(*sound.problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok());
    EXPECT_LE(report.energy_closure, 1e-10);
    const Reading plain = read("", "");
    const solver::MarchReport without = solver::run(*plain.problem, [](const solver::Snapshot&) { return true; });
    const auto friction_of = [](const solver::Problem& problem, const solver::MarchReport& of) {
        const auto found = std::ranges::find_if(
            problem.effects, [](const auto& active) { return active.effect->id == "sliding_friction"; });
        return of.joules[static_cast<std::size_t>(found - problem.effects.begin())];
    };
    const double joules = friction_of(*plain.problem, without);
    EXPECT_GT(joules, 0.0);
    EXPECT_NEAR(friction_of(*sound.problem, report), joules, 1e-11 * joules);
}

// Through the 12 mm of a mesh of layers: a loss that is alike everywhere is spread by mass, as without a file; one that
// grows with the depth follows it.
TEST(FieldFile, OfTheLossFollowsTheDepthOfLayers) {
    const auto weights = [](const std::string& field) {
        const Written written;
        written.add("field.csv", field);
        const std::string text =
            "include = [\"" + (source_folder() / "cases/layers/one_rubber.toml").string() + "\"]\n";
        const Reading reading = read_case(written.add("case.toml", text + (field.empty() ? "" : loss)));
        EXPECT_TRUE(reading.problem.has_value()) << render(reading);
        return reading.problem ? placed(*reading.problem, "strain_energy_loss").weights : Values{};
    };
    const Values plain = weights("");
    const Values uniform = weights("depth [mm],loss_density [W/m3]\n1,5\n4,5\n11,5\n");
    ASSERT_EQ(uniform.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_NEAR(uniform[i], plain[i], 1e-14);
    }
    const Values deep = weights("depth [mm],loss_density [W/m3]\n3,1\n9,2\n");
    EXPECT_NEAR(sum(deep), 1.0, 1e-14);
    // 1 up to 3 mm, 2 from 9 mm on, straight between: 18 mm in all, where a uniform 1 has 12.
    EXPECT_NEAR(deep.front() / plain.front(), 12.0 / 18.0, 1e-12);
    EXPECT_NEAR(deep.back() / plain.back(), 24.0 / 18.0, 1e-12);
}

// A number of an effect stays free where the effect follows a field in time.
TEST(FieldFile, LeavesTheNumbersOfTheEffectFree) {
    const Written written;
    written.add("field.csv", "time [s],y [mm],friction_power [W/m2]\n0,0,1\n600,0,3\n");
    const ExperimentReading reading = read_experiment(written.add(
        "case.toml",
        cornering(friction_watts + "[[parameter]]\neffect = \"sliding_friction\"\nkey = \"partition\"\n" +
                  "[[measured]]\nchannel = \"bulk_temperature\"\nvalue = \"40 degC\"\n" + "uncertainty = \"1 K\"\n")));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    ASSERT_EQ(reading.experiment->parameters.size(), 1U);
    EXPECT_EQ(reading.experiment->parameters[0].name, "sliding_friction.partition");
    EXPECT_EQ(reading.experiment->parameters[0].prior, 0.6);
}

}  // namespace tiretherm::input
