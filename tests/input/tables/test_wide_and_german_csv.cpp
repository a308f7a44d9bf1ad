// SPDX-License-Identifier: BSD-3-Clause
// CSV files with very many columns, which must not take quadratic time, and with decimal commas.

#include <cmath>
#include <ctime>
#include <functional>

#include <gtest/gtest.h>

#include "input/cameras/camera_bench.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

double processor_seconds(const std::function<void()>& call) {
    const std::clock_t start = std::clock();
    call();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

std::string said_of(const ExperimentReading& reading, const Written& written) {
    return replaced(error_report(reading), written.folder().generic_string() + "/", "");
}

/// The bench under a log called log.csv.
ExperimentReading read_log(const Written& written, std::string_view log, std::string_view keys = "") {
    written.add("log.csv", log);
    return read_experiment(
        written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"log.csv\"\n" + std::string(keys)));
}

/// The bench's log with other separators and marks.
std::string german_log() {
    return "time [s];speed [km/h];vertical_load [N];air_temperature [degC];road_temperature [degC];"
           "surface_temperature [degC];bulk_temperature [degC]\n"
           "0,0;36,0;4000;25;30;25,25;25,5\n"
           "2,5;5,4e1;4100;25;30;-0,5;25,8\n"
           "5,0;72;4200;25;31;;26,1\n";
}

}  // namespace

// Every heading has its place in the line. Counted from the line's start each time, 76 800 headings are 3e10 characters
// and took a quarter of an hour; counted on from the one before, a second. The limit leaves room for a slow build.
TEST(WideCsv, FramesOf320By240PixelsAreReadInSeconds) {
    const Written written;
    std::string text = "time [s]";
    for (int pixel = 0; pixel < 320 * 240; ++pixel) {
        text += ",r" + std::to_string(pixel / 320) + "c" + std::to_string(pixel % 320) + " [degC]";
    }
    for (int frame = 0; frame < 5; ++frame) {
        text += "\n" + std::to_string(5 * frame);
        for (int pixel = 0; pixel < 320 * 240; ++pixel) {
            text += "," + std::to_string(20 + (pixel + frame) % 7);
        }
    }
    written.add("frames.csv", text + "\n");
    const std::filesystem::path file =
        written.add("case.toml", std::string(camera_bench) +
                                     "[[camera]]\nname = \"camera\"\npixel_size = \"0.1 mm\"\n" + std::string(one_run));
    EXPECT_LT(processor_seconds([&] {
                  const ExperimentReading reading = read_experiment(file);
                  ASSERT_TRUE(reading.experiment) << said_of(reading, written).substr(0, 1000);
                  EXPECT_EQ(reading.experiment->runs.front().frames.front().detectors.columns, 320);
              }),
              30.0);
}

// Likewise the columns of a run, of which the model uses five.
TEST(WideCsv, ARunMayHaveFiftyThousandColumns) {
    std::string head =
        "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],"
        "bulk_temperature [degC]";
    std::string row = ",36,4000,25,30,25";
    for (int i = 0; i < 50'000; ++i) {
        head += ",signal" + std::to_string(i) + " [V]";
        row += ",0.5";
    }
    const Written written;
    EXPECT_LT(processor_seconds([&] {
                  const ExperimentReading reading = read_log(written, head + "\n0" + row + "\n5" + row + "\n");
                  ASSERT_TRUE(reading.experiment) << said_of(reading, written).substr(0, 1000);
                  EXPECT_EQ(reading.experiment->runs.front().unused.size(), 50'000U);
              }),
              30.0);
}

// Where everything is wrong, some hundred errors are as good as all 384 000, each of which quotes its line.
TEST(WideCsv, ErrorsOfAllFieldsAreCutShort) {
    const Written written;
    std::string head = "time [s]";
    std::string row;
    for (int pixel = 0; pixel < 40'000; ++pixel) {
        head += ",r" + std::to_string(pixel / 200) + "c" + std::to_string(pixel % 200) + " [degC]";
        row += ",x";
    }
    written.add("frames.csv", head + "\n0" + row + "\n5" + row + "\n");
    const std::filesystem::path file =
        written.add("case.toml", std::string(camera_bench) + std::string(one_camera) + std::string(one_run));
    std::size_t size = 0;
    EXPECT_LT(processor_seconds([&] { size = read_experiment(file).errors.size(); }), 30.0);
    EXPECT_GT(size, 100U);
    EXPECT_LE(size, 1001U);
}

// A separator that is no comma leaves the comma to the numbers: 5,4e1 is 54 and -0,5 minus a half.
TEST(GermanCsv, SemicolonsWithDecimalCommasAreRead) {
    const Written written;
    const ExperimentReading reading = read_log(written, german_log());
    ASSERT_TRUE(reading.experiment) << said_of(reading, written);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_EQ(run.time, (std::vector<double>{0.0, 2.5, 5.0}));
    EXPECT_NEAR(run.problem.input_signals.at(2.5, solver::JumpSide::after).speed, 15.0, 1e-12);
    const MeasuredSeries* surface = find_series(run, "surface_temperature");
    ASSERT_NE(surface, nullptr);
    EXPECT_NEAR(surface->value[0], 298.40, 1e-9);
    EXPECT_NEAR(surface->value[1], 272.65, 1e-9);
    EXPECT_TRUE(std::isnan(surface->value[2]));
    // Tabs, as a spreadsheet saves its cells as text; unused columns follow the same rule.
    const ExperimentReading tabs =
        read_log(written, replaced(replaced(german_log(), ";", "\t"), "surface_temp", "IR_"));
    ASSERT_TRUE(tabs.experiment) << said_of(tabs, written);
    EXPECT_EQ(tabs.experiment->runs.front().time, run.time);
    ASSERT_EQ(tabs.experiment->runs.front().unused.size(), 1U);
    EXPECT_NEAR(tabs.experiment->runs.front().unused.front().value[0], 25.25, 1e-12);
}

// 4.000 beside 36,0 is four thousand in German and four elsewhere, and 1.234,5 is nothing that is read.
TEST(GermanCsv, PointsBesideCommasAreRefusedWithBothPlaces) {
    const Written written;
    const std::string mixed = said_of(read_log(written, replaced(german_log(), "36,0;4000", "36,0;4.000")), written);
    EXPECT_NE(mixed.find("log.csv:2:10: \"4.000\" has a decimal point, \"36,0\" in line 2 a decimal comma\n"),
              std::string::npos)
        << mixed;
    EXPECT_NE(mixed.find("remedy: export the file with one of them, and without marks between thousands\n"),
              std::string::npos);
    const std::string thousands = said_of(read_log(written, replaced(german_log(), ";4100;", ";4.100,5;")), written);
    EXPECT_NE(thousands.find("log.csv:3:11: vertical_load is 4.100,5, with a comma in the number"), std::string::npos)
        << thousands;
}

// Commas that separate leave nothing to the numbers; the remedy names both ways out.
TEST(GermanCsv, CommasThatAlsoSeparateAreRefused) {
    const Written written;
    const std::string found = said_of(read_log(written, "time [s],speed [km/h]\n0,0,36,5\n"), written);
    EXPECT_NE(found.find("remedy: if the numbers have decimal commas, export the file with semicolons or with decimal "
                         "points\n"),
              std::string::npos)
        << found;
}

// Quotes keep a decimal comma apart from those that separate. Three digits behind one may be thousands: nobody knows.
TEST(GermanCsv, DecimalCommasInQuotesAreRead) {
    const Written written;
    const std::string heads =
        "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],surface_temperature "
        "[degC]\n";
    const ExperimentReading reading =
        read_log(written, heads + "\"0,0\",\"36,0\",4000,25,30,\"25,25\"\n\"2,5\",\"54,0\",4100,25,30,\"-0,5\"\n");
    ASSERT_TRUE(reading.experiment) << said_of(reading, written);
    const MeasuredRun& run = reading.experiment->runs.front();
    EXPECT_EQ(run.time, (std::vector<double>{0.0, 2.5}));
    EXPECT_DOUBLE_EQ(run.series.front().value[1], 272.65);
    const std::string thousands =
        said_of(read_log(written, heads + "0,36,\"4,000\",25,30,25\n2,54,\"4,100\",25,30,26\n"), written);
    EXPECT_NE(thousands.find("vertical_load is 4,000, with a comma in the number"), std::string::npos) << thousands;
}

}  // namespace tiretherm::input
