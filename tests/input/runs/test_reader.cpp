// SPDX-License-Identifier: BSD-3-Clause
// Reading of sound cases: keys, defaults, tire sizes, sensors and warnings; any truncated case is explained and never
// crashes.

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// A sound problem from the slab and more text, or a failure.
solver::Problem sound(const std::string& text) {
    const Written written;
    Reading reading = read_case(written.add("case.toml", text));
    EXPECT_TRUE(reading.problem.has_value()) << error_report(reading);
    return reading.problem ? std::move(*reading.problem) : solver::Problem{};
}

std::string with(std::string_view more) { return std::string(slab) + std::string(more); }

std::string slab_with(std::string_view what, std::string_view by) {
    std::string text(slab);
    return text.replace(text.find(what), what.size(), by);
}

std::vector<std::string> warnings(const std::string& text) {
    const Written written;
    return read_case(written.add("case.toml", text)).warnings;
}

}  // namespace

TEST(Reader, NamesACaseByItsPathBelowCases) {
    const Written written;
    const auto name = [&](const std::string& file) { return read_case(written.add(file, slab)).problem.value().name; };
    EXPECT_EQ(name("alone.toml"), "alone");
    EXPECT_EQ(name("cases/top.toml"), "top");
    EXPECT_EQ(name("cases/laser/spot.toml"), "laser/spot");
    EXPECT_EQ(name("cases/old/cases/laser/spot.toml"), "laser/spot");
}

TEST(Reader, TitleAndSourcesHaveDefaults) {
    EXPECT_EQ(sound(std::string(slab)).title, "case");
    EXPECT_TRUE(sound(std::string(slab)).sources.empty());
    EXPECT_EQ(sound("sources = \"one\"\n" + std::string(slab)).sources, std::vector<std::string>{"one"});
}

// The example of the page that users copy from.
TEST(Reader, TheExampleOfTheReadmeIsSound) {
    std::ostringstream page;
    page << std::ifstream(source_folder() / "cases" / "README.md").rdbuf();
    const std::string text = page.str();
    const std::size_t start = text.find("```toml\n", text.find("## A complete example")) + 8;
    const Written written;
    written.add("drum/load.csv", "time [s],Fz [N],speed [km/h]\n0,-4000,1\n1200,-4500,1\n");
    written.add("tires/thesis_225_50_R17.toml", "[tire]\nunloaded_radius = \"330.8 mm\"\n");
    const Reading reading =
        read_case(written.add("drum/case.toml", text.substr(start, text.find("```", start) - start)));
    ASSERT_TRUE(reading.problem.has_value()) << error_report(reading);
    EXPECT_TRUE(reading.warnings.empty()) << error_report(reading);
    EXPECT_EQ(reading.problem->mesh.n_cells, 24);
    EXPECT_DOUBLE_EQ(reading.problem->settings.end, 1200.0);
    EXPECT_DOUBLE_EQ(reading.problem->tire.contact_length(4000.0), 0.097);
}

TEST(Reader, EveryKeyOfTimeArrives) {
    const solver::Settings settings = sound(slab_with("end = \"60 s\"", R"(start = "1 min"
end = "1 h"
step = "2 s"
output = "10 s"
fields = "60 s"
method = "backward_euler"
linear_solver = "conjugate_gradient"
steady = false)"))
                                          .settings;
    EXPECT_DOUBLE_EQ(settings.start, 60.0);
    EXPECT_DOUBLE_EQ(settings.end, 3600.0);
    EXPECT_DOUBLE_EQ(settings.fixed_step.value(), 2.0);
    EXPECT_DOUBLE_EQ(settings.output_interval, 10.0);
    EXPECT_DOUBLE_EQ(settings.field_interval, 60.0);
    EXPECT_EQ(settings.method, solver::Method::backward_euler);
    EXPECT_EQ(settings.linear_solver, solver::LinearSolver::conjugate_gradient);
}

TEST(Reader, ASteadyCaseNeedsNoEnd) {
    EXPECT_TRUE(sound(slab_with("end = \"60 s\"", "steady = true")).settings.steady);
}

// Surface nodes start with their layer.
TEST(Reader, LayersMayStartApart) {
    const solver::Problem problem = sound(slab_with("temperature = \"23 degC\"", "rubber = \"40 degC\""));
    EXPECT_EQ(problem.initial, std::vector<double>(static_cast<std::size_t>(problem.mesh.n_nodes), 313.15));
}

TEST(Reader, EffectsOfATireAreOnAndMaySwitchedOff) {
    const std::string tire = R"(
[tire]
size = "225/50 R17"
[mesh]
kind = "two_node"
surface_mass_share = "15 %"
bulk_depth = "10 mm"
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.5 W/mK"
[drive]
speed = "100 km/h"
vertical_load = "4 kN"
air_temperature = "23 degC"
slip_angle = "2 deg"
lateral_force = "1500 N"
[effects.road_contact]
on = false
[effects.air_convection]
exponential = false
lambda_h = "110 %"
[effects.sliding_friction]
longitudinal = "off"
[initial]
temperature = "23 degC"
[time]
end = "60 s"
[[sensor]]
name = "bulk"
kind = "layer"
layer = "bulk"
)";
    const solver::Problem problem = sound(tire);
    ASSERT_EQ(problem.effects.size(), 4U);
    const physics::ActiveEffect& friction = problem.effects[2];
    const physics::ActiveEffect& air = problem.effects[3];
    EXPECT_EQ(friction.effect->id, "sliding_friction");
    EXPECT_EQ(friction.choices, (std::vector<int>{1, 0, 0, 0}));
    EXPECT_EQ(air.effect->id, "air_convection");
    EXPECT_EQ(air.choices, std::vector<int>{2});
    EXPECT_DOUBLE_EQ(air.parameters[0], 1.1);
    // R0 of the size alone: half of 17 in and the section's height, 215.9 + 112.5 mm.
    EXPECT_NEAR(problem.tire.unloaded_radius, 0.3284, 1e-12);
    EXPECT_NEAR(problem.tire.loaded_radius_at_zero, 0.3284, 1e-12);
    EXPECT_TRUE(warnings(tire).empty());  // sliding friction can do without the slip angle, but it reads it
    const auto unread =
        warnings(tire + "[[drive.schedule]]\ncolumns = [\"time [s]\", \"laser_power [W]\"]\nrows = [[0, 1]]\n");
    ASSERT_EQ(unread.size(), 1U);
    EXPECT_NE(unread[0].find("no active effect and no sensor uses laser_power"), std::string::npos);
}

TEST(Reader, SizesAsTheyStandOnSidewalls) {
    for (const std::string_view size :
         {"225/50 R17", "225/50R17", "225/50 R 17", "P225/50 R17 94V", "225/50 ZR17", "225/50-17", "225/50 R17C"}) {
        const Written written;
        const Reading reading =
            read_case(written.add("case.toml", with("[tire]\nsize = \"" + std::string(size) + "\"\n")));
        for (const InputError& error : reading.errors) {
            EXPECT_EQ(error.what.find("size"), std::string::npos) << size << ": " << error.what;
        }
    }
}

TEST(Reader, AnotherSizeWithTheThesissLawsIsWarnedAbout) {
    const auto found = warnings(
        with("[tire]\nsize = \"205/55 R16\"\nunloaded_radius = \"250 mm\"\ncontact_length_limit = \"150 mm\"\n"));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NE(found[0].find("unloaded_radius is 250.0 mm, but a 205/55 R16 has about 315.9 mm"), std::string::npos)
        << found[0];
    EXPECT_NE(found[1].find("contact_area, loaded_radius and rolling_radius of the 205/55 R16 are taken from"),
              std::string::npos)
        << found[1];
}

TEST(Reader, ALinkBelowALayer) {
    std::string text = with(R"([[mesh.layer]]
name = "inner"
thickness = "2 mm"
cells = 1
material = "rubber"
)");
    const std::string_view block =
        "kind = \"block\"\nx = [{ to = \"10 mm\", cells = 1 }]\ny = [{ to = \"10 mm\", cells = 1 }]";
    text.replace(text.find(block), block.size(),
                 "kind = \"layers\"\narea = \"0.4 m2\"\nlink_below = \"rubber\"\nlink_length = \"10 "
                 "mm\"\nlink_conductivity = \"0.3 W/mK\"");
    const solver::Problem problem = sound(text);
    ASSERT_EQ(problem.mesh.links.size(), 1U);
    EXPECT_DOUBLE_EQ(problem.mesh.links[0].length, 0.01);
    EXPECT_DOUBLE_EQ(problem.link_laws.at(0).value(300.0), 0.3);
    EXPECT_DOUBLE_EQ(problem.mesh.patches.at(0).area(), 0.4);
}

TEST(Reader, SensorsOfEveryKindSayWhatTheyRead) {
    const solver::Problem problem = sound(with(R"(
[[sensor]]
name = "deep"
kind = "point"
depth = "2.5 mm"
x = "3 mm"
[[sensor]]
name = "below"
kind = "point"
depth = "1 cm"
[[sensor]]
name = "spot"
kind = "spot"
patch = "bottom"
radius = "5 mm"
[[sensor]]
name = "face"
kind = "patch"
patch = "top"
[[sensor]]
name = "body"
kind = "layer"
layer = "rubber"
[[sensor]]
name = "region"
kind = "region"
region = "bulk"
meaning = "my own words"
)"));
    const std::vector<std::string> expected{"outer surface, x = 0 mm, y = 0 mm",
                                            "2.5 mm below the outer surface, x = 3 mm, y = 0 mm",
                                            "inner surface, x = 0 mm, y = 0 mm",
                                            "bottom, mean over a disc of 5 mm radius",
                                            "mean over the patch top",
                                            "mean over the layer rubber",
                                            "my own words"};
    ASSERT_EQ(problem.channels.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(problem.channels[i].meaning, expected[i]);
    }
}

// An effect's kelvin parameter is a number of kelvin; see the page.
TEST(Reader, UnusualValuesAreWarnedAboutAndUsed) {
    const std::string text = slab_with("density = \"1100 kg/m3\"", "density = \"50 kg/m3\"");
    EXPECT_DOUBLE_EQ(sound(text).materials.at(0).density, 50.0);
    EXPECT_EQ(warnings(text).size(), 1U);
}

// Still air takes heat to air whose temperature nobody gives. A wrong key is another error.
TEST(Reader, AnInputThatIsMissingIsToldByItsCode) {
    const Written written;
    const Reading reading = read_case(written.add("case.toml", with("[effects.still_air]\nhumidity = 1\n")));
    std::vector<std::string> missing;
    for (const InputError& error : reading.errors) {
        if (error.code == ErrorCode::missing_input) {
            missing.push_back(error.about);
        }
    }
    EXPECT_EQ(missing, std::vector<std::string>{"air_temperature"});
    EXPECT_EQ(reading.errors.size(), 2U);
}

// Any prefix of a sound case is either sound or explained, and never ends the program.
TEST(Reader, SurvivesEveryTruncation) {
    const Written written;
    const std::string text(slab);
    for (std::size_t length = 0; length < text.size(); ++length) {
        const Reading reading = read_case(written.add("case.toml", text.substr(0, length)));
        EXPECT_EQ(reading.problem.has_value(), reading.errors.empty());
        EXPECT_EQ(render(reading).empty(), reading.errors.empty() && reading.warnings.empty());
    }
}

}  // namespace tiretherm::input
