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

/// A tire of a new case after an hour with its own load. @returns degC, of the bulk
double warm_bulk(std::string_view size) {
    const Written written;
    const Reading reading = read_case(written.add("case.toml", make(written, size).text));
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    const auto& channels = reading.problem->channels;
    const auto bulk = std::ranges::find(channels, "bulk_temperature", &solver::Channel::name) - channels.begin();
    return solver::run(*reading.problem, [](const solver::Snapshot&) { return true; })
               .channel_final[static_cast<std::size_t>(bulk)] -
           273.15;
}

// 4 mm and a pattern of 5 mm in front; 12 mm behind, as a passenger tire. Sidewalls of 9 - 3 mm. Without a load index the load is
// the thesis's 4 kN in proportion to W sqrt(R H), whatever the pressure: 4000 N (120/225) sqrt(299.9 84/(328.4 112.5)) = 1762 N and 4000 N
// (180/225) sqrt(314.9 99/(328.4 112.5)) = 2939 N; 80 % of the load indices 58 and 73 are 1852 and 2864 N.
TEST(NewCase, MotorcycleTiresHaveTheirOwnRubberPressureAndLoad) {
    const Written written;
    for (const auto& [size, crown, load, pressure] :
         {std::tuple{"120/70 ZR17", 0.009, 1760.0, 250e3}, std::tuple{"180/55 ZR17", 0.012, 2940.0, 290e3},
          std::tuple{"120/70 ZR17 M/C (58W)", 0.009, 1850.0, 250e3},
          std::tuple{"180/55 ZR17 M/C (73W)", 0.012, 2860.0, 290e3}}) {
        const Reading reading = read_case(written.add("case.toml", make(written, size).text));
        ASSERT_TRUE(reading.problem) << render(reading);
        EXPECT_NEAR(reading.problem->tire.tread_thickness, crown, 1e-12) << size;
        EXPECT_NEAR(reading.problem->tire.sidewall_thickness, 0.006, 1e-12) << size;
        EXPECT_NE(make(written, size).text.find(fmt::format("scaled at {:g} kPa", pressure * 1e-3)), std::string::npos);
        EXPECT_NEAR(reading.problem->input_signals.at(1.0, solver::JumpSide::after).vertical_load, load, 0.6) << size;
    }
    const std::string front = make(written, "120/70 ZR17").text;
    EXPECT_NE(front.find("3 mm less than a passenger tire's"), std::string::npos);
    EXPECT_NE(front.find("a motorcycle's front wheel stands in the travel wind"), std::string::npos);
    EXPECT_NE(make(written, "180/55 ZR17").text.find("# slip_ratio = "), std::string::npos);
}

// Both carry 15 to 16 kN a meter of width and are deflected alike, so that as much heat passes each square meter of tread; it is hotter
// below 3 mm more rubber of 0.5 W/mK, by half of the 7 K that 1.2 kW/m2 make across them. The rear's higher sidewalls take some of it
// away, and the front stands in the wind, half a kelvin. The drive, which the case only suggests, adds to it.
TEST(NewCase, TheRearOfAMotorcycleIsHotterThanTheFront) {
    for (const auto& [front, rear] :
         {std::pair{"120/70 ZR17", "180/55 ZR17"}, std::pair{"120/70 ZR17", "190/55 ZR17"},
          std::pair{"120/70 ZR17 (58W)", "180/55 ZR17 (73W)"}, std::pair{"120/70 ZR17 (58W)", "190/55 ZR17 M/C (75W)"},
          std::pair{"110/70 R17 54H", "150/60 R17 66H"}}) {
        const double hotter = warm_bulk(rear) - warm_bulk(front);
        EXPECT_GT(hotter, 0.5) << front;
        EXPECT_LT(hotter, 5.0) << front;
    }
}

// 52 to 57 degC are read in trucks at 80 to 85 km/h; at 100 km/h, which they do not drive, it would be four kelvin more.
TEST(NewCase, ATruckDrivesAtItsOwnSpeed) {
    const Written written;
    EXPECT_NE(make(written, "315/80 R22.5").text.find("speed = \"80 km/h\""), std::string::npos);
    EXPECT_NEAR(warm_bulk("315/80 R22.5"), 54.5, 2.5);
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
