// SPDX-License-Identifier: BSD-3-Clause
// Camera frames from HDF5: scaling, units, pixel size, and files that are refused.

#include <cmath>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>

#include "input/cameras/camera_bench.hpp"
#include "post/fields/hdf5_file.hpp"

namespace tiretherm::input {

namespace {

using Values = std::vector<double>;
using Write = std::function<void(post::Hdf5File&)>;

post::Label units(const std::string& unit) { return {.units = unit, .long_name = "", .source = "", .coordinates = ""}; }

/// Images of 3 x 4 pixels in one row each.
void add_frames(post::Hdf5File& file, const Values& values, const std::string& unit = "degC", std::size_t width = 12) {
    file.write("/frames", values, width, units(unit));
    file.add_attribute("/frames", "rows", 3.0);
    file.add_attribute("/frames", "columns", 4.0);
}

Values frames_of_two() {
    Values values(24);
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = 20.0 + static_cast<double>(i);
    }
    return values;
}

ExperimentReading read_hdf5(const Write& write, std::string_view camera = one_camera, std::uintmax_t keep = 0) {
    const Written written;
    const std::filesystem::path path = written.folder() / "frames.h5";
    {
        post::Hdf5File file(path);
        write(file);
    }
    if (keep > 0) {
        std::filesystem::resize_file(path, keep);
    }
    return read_experiment(written.add("case.toml", std::string(camera_bench) + std::string(camera) +
                                                        "[[run]]\nname = \"heating\"\nframes = \"frames.h5\"\n"));
}

std::string what_is_wrong_with(const ExperimentReading& reading) {
    std::string text;
    for (const InputError& error : reading.errors) {
        text += error.what + " | " + error.remedy + "\n";
    }
    return text;
}

}  // namespace

// Written in hundredths of a degree above 20 degC: 20 + 0.01 * 150 = 21.5 degC. The pixel's size comes with the file.
TEST(Hdf5Frames, AreUnpackedAndBringTheirPixelSize) {
    const ExperimentReading reading = read_hdf5(
        [](post::Hdf5File& file) {
            Values packed(24, 150.0);
            packed[5] = -1.0;
            add_frames(file, packed);
            file.add_attribute("/frames", "scale_factor", 0.01);
            file.add_attribute("/frames", "add_offset", 20.0);
            file.add_attribute("/frames", "_FillValue", -1.0);
            file.add_attribute("/frames", "pixel_size", 1.5);
            file.add_attribute("/frames", "pixel_size_units", "mm");
            file.write("/time", Values{0.0, 10.0}, 0, units("s"));
        },
        "[[camera]]\nname = \"camera\"\n");
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const MeasuredFrames& frames = reading.experiment->runs.front().frames.front();
    EXPECT_NEAR(frames.detectors.pitch_x, 1.5e-3, 1e-15);
    EXPECT_NEAR(frames.value.front(), 21.5 + 273.15, 1e-9);
    EXPECT_EQ(frames.dead, 1);
    EXPECT_EQ(frames.pixels.size(), 11U);
}

TEST(Hdf5Frames, InMinutesAndFahrenheitAreConverted) {
    const ExperimentReading reading = read_hdf5([](post::Hdf5File& file) {
        add_frames(file, Values(24, 77.0), "degF");
        file.write("/time", Values{0.0, 0.2}, 0, units("min"));
    });
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const MeasuredFrames& frames = reading.experiment->runs.front().frames.front();
    EXPECT_NEAR(frames.value.front(), 25.0 + 273.15, 1e-9);
    EXPECT_NEAR(frames.time.back(), 12.0, 1e-12);
}

// Wrong unit, wrong number of moments and a size without unit are reported together.
TEST(Hdf5Frames, ThatAreWrongInSeveralWaysAreToldOfAll) {
    const ExperimentReading reading = read_hdf5([](post::Hdf5File& file) {
        add_frames(file, frames_of_two(), "W");
        file.add_attribute("/frames", "pixel_size", 1.5);
        file.write("/time", Values{0.0, 10.0, 20.0}, 0, units("s"));
    });
    EXPECT_FALSE(reading.experiment);
    const std::string found = what_is_wrong_with(reading);
    for (const char* what : {"the dataset frames is in \"W\"", "the dataset frames has no attribute pixel_size_units",
                             "time has 3 values for 2 frames | give each frame one moment"}) {
        EXPECT_NE(found.find(what), std::string::npos) << what << "\nin\n" << found;
    }
}

TEST(Hdf5Frames, WhoseTimeGoesBackAreRefused) {
    EXPECT_EQ(what_is_wrong_with(read_hdf5([](post::Hdf5File& file) {
                  add_frames(file, frames_of_two());
                  file.write("/time", Values{10.0, 5.0}, 0, units("s"));
              })),
              "time goes back from frame 0 (10 s) to frame 1 (5 s) | sort the frames by time, each moment once\n");
}

TEST(Hdf5Frames, WhoseShapeDoesNotFitAreRefused) {
    EXPECT_EQ(what_is_wrong_with(read_hdf5([](post::Hdf5File& file) {
                  add_frames(file, frames_of_two(), "degC", 8);
                  file.write("/time", Values{0.0, 5.0, 10.0}, 0, units("s"));
              })),
              "an image of 3 x 4 pixels has 12 values, and frames has 8 in a row | correct the attributes rows and "
              "columns, or write three dimensions\n");
    EXPECT_EQ(what_is_wrong_with(read_hdf5([](post::Hdf5File& file) { file.write("/T", Values{1.0}, 0, units("K")); })),
              "the file has no dataset frames of numbers | write the images as frames [n, rows, columns], with the "
              "attribute units = \"degC\"\n");
}

// 2 x 7.5 is the 15 of a row, and no image.
TEST(Hdf5Frames, WithHalfAColumnAreRefused) {
    EXPECT_EQ(what_is_wrong_with(read_hdf5([](post::Hdf5File& file) {
                  file.write("/frames", Values(30, 25.0), 15, units("degC"));
                  file.add_attribute("/frames", "rows", 2.0);
                  file.add_attribute("/frames", "columns", 7.5);
                  file.write("/time", Values{0.0, 5.0}, 0, units("s"));
              })),
              "an image of 2 x 7.5 pixels has 15 values, and frames has 15 in a row | correct the attributes rows and "
              "columns, or write three dimensions\n");
}

TEST(Hdf5Frames, WithoutALivingPixelAreRefused) {
    EXPECT_EQ(what_is_wrong_with(read_hdf5([](post::Hdf5File& file) {
                  add_frames(file, Values(24, std::nan("")));
                  file.write("/time", Values{0.0, 5.0}, 0, units("s"));
              })),
              "no pixel of camera is of use: of 12 detectors 12 are dead and 0 look beside the specimen | export the "
              "frames again, as temperatures\n");
}

TEST(Hdf5Frames, ThatAreCutOffAreRefused) {
    const std::string found = what_is_wrong_with(read_hdf5(
        [](post::Hdf5File& file) {
            add_frames(file, frames_of_two());
            file.write("/time", Values{0.0, 5.0}, 0, units("s"));
        },
        one_camera, 900));
    EXPECT_NE(found.find("cut off, damaged or still being written | copy or export it again"), std::string::npos)
        << found;
}

}  // namespace tiretherm::input
