// SPDX-License-Identifier: BSD-3-Clause
// A case from a size runs as it is, has the library's values, and says of every value what it is.
#include "input/new_case/made.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::input {
namespace {

/// Channels after ten minutes, K. Whoever shares all numbers shares every digit.
std::vector<double> after_ten_minutes(const std::filesystem::path& file) {
    Reading reading = read_case(file);
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    if (!reading.problem) {
        return {};
    }
    reading.problem->settings.end = 600.0;
    return solver::run(*reading.problem, [](const solver::Snapshot&) { return true; }).channel_final;
}

std::filesystem::path library(const std::string& name) { return source_folder() / "cases" / (name + ".toml"); }

// The library's cases are the source of the new case's values, so not a digit may differ.
TEST(NewCase, ThesisTireGivesTheLibrarysNumbersOnEveryMesh) {
    for (const auto& [mesh, name] :
         {std::pair("section", "section/4000N_100kmh_all_heat_paths"), std::pair("layers", "layers/two_conductivities"),
          std::pair("two_node", "two_node/4000N_100kmh")}) {
        const Written written;
        const NewCase made = make(written, "225/50 R17", mesh);
        ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
        const std::vector<double> found = after_ten_minutes(written.add("case.toml", made.text));
        EXPECT_EQ(found, after_ten_minutes(library(name))) << mesh;
        EXPECT_FALSE(found.empty());
    }
}

// The library's tires were scaled by hand, from the radius rounded to 0.1 mm: a unit of the last printed digit.
TEST(NewCase, OtherSizesAreScaledAsTheLibrarysDrumTires) {
    for (const auto& [size, name] :
         {std::pair("235/45 R17", "drum/235_45_R17_two_node"), std::pair("245/40 R18", "drum/245_40_R18_two_node"),
          std::pair("265/65 R16C", "drum/265_65_R16C_two_node"),
          std::pair("225/50 R17", "drum/225_50_R17_spec_1_two_node")}) {
        const Written written;
        const Reading made = read_case(written.add("case.toml", make(written, size, "two_node").text));
        const Reading shipped = read_case(library(name));
        ASSERT_TRUE(made.problem && shipped.problem) << render(made);
        const physics::Tire& a = made.problem->tire;
        const physics::Tire& b = shipped.problem->tire;
        EXPECT_EQ(a.width, b.width) << size;
        EXPECT_EQ(a.section_height, b.section_height) << size;
        EXPECT_EQ(a.tread_thickness, b.tread_thickness) << size;
        EXPECT_EQ(a.sidewall_thickness, b.sidewall_thickness) << size;
        EXPECT_NEAR(a.unloaded_radius, b.unloaded_radius, 1.01e-4) << size;
        EXPECT_NEAR(a.contact_length_limit, b.contact_length_limit, 1e-12) << size;
        EXPECT_NEAR(a.contact_length_slope, b.contact_length_slope, 1e-12) << size;
        EXPECT_NEAR(a.contact_area_slope, b.contact_area_slope, 1e-15) << size;
        EXPECT_NEAR(a.loaded_radius_at_zero, b.loaded_radius_at_zero, 1.01e-4) << size;
        EXPECT_NEAR(a.loaded_radius_slope, b.loaded_radius_slope, 1e-15) << size;
        EXPECT_NEAR(a.rolling_radius_factor, b.rolling_radius_factor, 1.01e-4) << size;
        EXPECT_EQ(a.rolling_radius_exponent, b.rolling_radius_exponent) << size;
    }
}

TEST(NewCase, SizesFromKartToTruckAreSoundOnEveryMesh) {
    for (const std::string_view size : {"115/70 R15", "155/80 R13", "175/65 R14", "205/55 R16 91V", "275/35 ZR20",
                                        "325/30 R21", "LT285/75 R16", "215/75 R16C", "180/55 R17", "315/80 R22.5"}) {
        for (const std::string_view mesh : mesh_template_names()) {
            const Written written;
            const NewCase made = make(written, size, std::string(mesh));
            EXPECT_TRUE(made.errors.empty()) << size << " " << mesh << "\n" << errors_of(made, written);
            EXPECT_TRUE(made.warnings.empty()) << size << " " << mesh << "\n" << made.warnings.front();
            EXPECT_FALSE(made.assumed.empty());
            EXPECT_TRUE(made.missing.empty());
        }
    }
}

// 8 + 2 + 1.2 + 0.8 mm and 3 mm more of tread; the sidewall's rubber 7 mm and 2 mm more. Cells as large as before.
TEST(NewCase, LightTruckTireHasAThickerTreadAndSidewall) {
    const Written written;
    const Reading reading = read_case(written.add("case.toml", make(written, "265/65 R16C").text));
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_NEAR(reading.problem->tire.tread_thickness, 0.015, 1e-12);
    EXPECT_NEAR(reading.problem->tire.sidewall_thickness, 0.011, 1e-12);
    const std::string text = make(written, "265/65 R16C").text;
    EXPECT_NE(text.find("thickness = \"11 mm\" "), std::string::npos);
    EXPECT_NE(text.find("thickness = \"9 mm\" "), std::string::npos);
    EXPECT_NE(text.find("cells = 17 "), std::string::npos);
    EXPECT_NE(text.find("cells = 22 "), std::string::npos);
    EXPECT_NE(text.find("scaled at 450 kPa"), std::string::npos);
}

// Contact pressure in proportion to the inflation: half the area at 440 kPa.
TEST(NewCase, InflationScalesContactAndStiffness) {
    const Written written;
    NewCaseRequest request{.size = std::get<TireSize>(read_tire_size("225/50 R17")),
                           .inflation_pressure = 440e3,
                           .target = written.folder() / "case.toml"};
    const Reading reading = read_case(written.add("case.toml", make_new_case(request).text));
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_NEAR(reading.problem->tire.contact_area_slope, 1.1665e-6, 1e-9);
    EXPECT_GT(reading.problem->tire.loaded_radius_slope, -2.6e-6);
    EXPECT_NEAR(reading.problem->tire.unloaded_radius, 0.3308, 1e-12);
}

// A table's entries that a user may change carry a comment; of sensors, layers and materials the first of a kind does.
TEST(NewCase, EveryValueOfDriveTireAndEffectsIsExplained) {
    for (const std::string_view mesh : mesh_template_names()) {
        const Written written;
        std::string table;
        int explained = 0;
        for (const std::string& line : lines_of(make(written, "205/60 R15", std::string(mesh)).text)) {
            table = line.starts_with('[') ? line : table;
            const bool must = table.starts_with("[tire]") || table.starts_with("[drive]") ||
                              table.starts_with("[mesh]") || table.starts_with("[initial]") ||
                              table.starts_with("[time]") || table.starts_with("[effects.");
            const bool entry = !line.empty() && line.front() >= 'A' && line.find(" = ") != std::string::npos;
            if (must && entry && line.front() != '[') {
                // A mesh of two nodes has the name of its material, which stands below it.
                EXPECT_TRUE(line.find(" # ") != std::string::npos || line.starts_with("material =")) << line;
                ++explained;
            }
        }
        EXPECT_GT(explained, mesh == "specimen" ? 10 : 25) << mesh;
    }
}

// Whatever folder it is moved to: nothing is included and no path is named.
TEST(NewCase, CaseOfASizeNeedsNoOtherFile) {
    const Written written;
    const std::string text = make(written, "225/50 R17").text;
    EXPECT_EQ(text.find("\ninclude"), std::string::npos);
    EXPECT_EQ(text.find(".toml\""), std::string::npos);
    EXPECT_EQ(text.find(TIRETHERM_SOURCE_DIR), std::string::npos);
    EXPECT_EQ(text.find(written.folder().generic_string()), std::string::npos);
    for (const std::string& line : lines_of(text)) {
        EXPECT_LE(line.size(), 220U) << line.substr(0, 60);
    }
}

}  // namespace
}  // namespace tiretherm::input
