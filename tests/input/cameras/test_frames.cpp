// SPDX-License-Identifier: BSD-3-Clause
// Camera frames from CSV: values, dead and outside pixels, binning, warnings, and the exact words of errors.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "input/cameras/camera_bench.hpp"

namespace tiretherm::input {

namespace {

/// The bench with a camera's and a run's tables and a file of frames.
ExperimentReading read_csv(const std::string& frames, std::string_view camera = one_camera,
                           std::string_view run = one_run) {
    const Written written;
    written.add("frames.csv", frames);
    return read_experiment(
        written.add("case.toml", std::string(camera_bench) + std::string(camera) + std::string(run)));
}

std::string what_is_wrong(const ExperimentReading& reading) {
    std::string text;
    for (const InputError& error : reading.errors) {
        text += error.what + " | " + error.remedy + "\n";
    }
    return text;
}

}  // namespace

TEST(Frames, OfACsvAreReadPixelByPixel) {
    const ExperimentReading reading = read_csv(frames_csv());
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const MeasuredRun& run = reading.experiment->runs.front();
    ASSERT_EQ(run.frames.size(), 1U);
    const MeasuredFrames& frames = run.frames.front();
    EXPECT_EQ(frames.camera, "camera");
    EXPECT_EQ(frames.rows, 3);
    EXPECT_EQ(frames.columns, 4);
    EXPECT_DOUBLE_EQ(frames.detectors.pitch_x, 2e-3);
    EXPECT_EQ(frames.time, (std::vector<double>{0.0, 20.0}));
    ASSERT_EQ(frames.pixels.size(), 12U);
    EXPECT_NEAR(frames.value[5], 25.0 + 273.15, 1e-9);
    EXPECT_NEAR(frames.value[12 + 6], 33.5 + 273.15, 1e-9);
    // The surface's ten nodes are the camera's channels; pixels cost none.
    EXPECT_EQ(frames.channels.count, 10U);
    EXPECT_EQ(run.problem.channels.size(), 10U);
}

// A run that nothing is compared with does not carry the camera along.
TEST(Frames, AreNoBusinessOfAPlainRun) {
    const Written written;
    written.add("frames.csv", frames_csv());
    const Reading reading = read_case(written.add("case.toml", std::string(camera_bench) + std::string(one_camera) +
                                                                   "emissivity = 0.9\n" + std::string(one_run)));
    ASSERT_TRUE(reading.problem);
    EXPECT_TRUE(reading.problem->channels.empty());
    for (const physics::ActiveEffect& active : reading.problem->effects) {
        EXPECT_TRUE(active.name.empty()) << active.name;
    }
}

// r1c2 is missing in one frame: it is left out of all, and reported.
TEST(Frames, LeaveADeadPixelOut) {
    const ExperimentReading reading = read_csv(frames_csv("nan"));
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const MeasuredFrames& frames = reading.experiment->runs.front().frames.front();
    EXPECT_EQ(frames.pixels.size(), 11U);
    EXPECT_EQ(frames.dead, 1);
    EXPECT_EQ(frames.value.size(), 22U);
    ASSERT_EQ(reading.data_warnings.size(), 1U);
    EXPECT_NE(reading.data_warnings.front().find("1 of 12 detectors have no value in some frame and count as dead"),
              std::string::npos)
        << reading.data_warnings.front();
}

// The image's four corners lie at (3, 2) mm from its centre. Moved by 16 mm, the columns at 13, 15, 17 and 19 mm: the last
// one's corners are at 20 mm and beyond, those of the third at 18 mm and up to 3 mm beside it, 18.2 mm.
TEST(Frames, LeaveOutWhatLooksBesideTheSpecimen) {
    const ExperimentReading reading = read_csv(frames_csv(), std::string(one_camera) + "x = \"16 mm\"\n");
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const MeasuredFrames& frames = reading.experiment->runs.front().frames.front();
    EXPECT_EQ(frames.beside, 3);
    EXPECT_EQ(frames.pixels.size(), 9U);
}

// 2 x 2 of 3 x 4: rows 0 and 1 make two whole pixels; of row 2 two half ones are left, with two of four detectors each.
TEST(Frames, AreBinnedAndWindowed) {
    const ExperimentReading binned =
        read_csv(frames_csv(), std::string(one_camera) + "bin = 2\nstandard_deviation = \"0.1 K\"\n");
    ASSERT_TRUE(binned.experiment) << error_report(binned);
    const MeasuredFrames& frames = binned.experiment->runs.front().frames.front();
    ASSERT_EQ(frames.pixels.size(), 4U);
    EXPECT_NEAR(frames.value[0], (20 + 21 + 24 + 25) / 4.0 + 273.15, 1e-9);
    EXPECT_NEAR(frames.value[3], (30 + 31) / 2.0 + 273.15, 1e-9);
    EXPECT_NEAR(*frames.standard_deviation, 0.05, 1e-12);
    const ExperimentReading window =
        read_csv(frames_csv(), std::string(one_camera) + "rows = [1, 2]\ncolumns = [0, 1]\n");
    ASSERT_TRUE(window.experiment) << error_report(window);
    const MeasuredFrames& part = window.experiment->runs.front().frames.front();
    ASSERT_EQ(part.pixels.size(), 4U);
    EXPECT_NEAR(part.value[0], 24.0 + 273.15, 1e-9);
}

TEST(Frames, OfACsvWithoutAPixelAreRefused) {
    const std::string text = replaced(replaced(frames_csv(), "r2c3 [degC]", "r3c3 [degC]"), "r0c1", "r0c0");
    EXPECT_EQ(what_is_wrong(read_csv(text)),
              "the pixel r0c0 has two columns | give every pixel of the image one column\n");
    EXPECT_EQ(what_is_wrong(read_csv(replaced(frames_csv(), "r2c3", "r3c3"))),
              "4 x 4 pixels need 16 columns, and there are 12: r2c3 is missing | give every pixel of the image one "
              "column\n");
    EXPECT_EQ(
        what_is_wrong(read_csv(replaced(frames_csv(), "r2c3 [degC]", "hottest [degC]"))),
        "the column hottest is neither time nor a pixel | call pixels by row and column, r0c0 [degC], r0c1 [degC] "
        "..., and the clock time [s]\n");
}

// Everything wrong with a camera and its frames at once, each with what to do.
TEST(Frames, AreReportedTogetherWithTheirCamera) {
    const ExperimentReading reading =
        read_csv(frames_csv(),
                 "[[camera]]\nname = \"camera\"\nsurface = \"rim\"\nblur = \"2 s\"\nbin = 0\nrows = [5, 1]\n"
                 "reflected_temperature = \"23 degC\"\nzoom = 2\n",
                 "[[run]]\nname = \"heating\"\nframes = { kamera = \"frames.csv\" }\n"
                 "[[parameter]]\ncamera = \"camera\"\nkey = \"emissivity\"\n");
    EXPECT_FALSE(reading.experiment);
    const std::string found = what_is_wrong(reading);
    for (const char* what :
         {"surface", "blur", "bin", "rows is no stretch of the image | write rows = [8, 55]",
          "a black surface, of emissivity 1, mirrors nothing | add emissivity = 0.95", "\"zoom\" is not a key",
          "there is no camera \"kamera\" | did you mean `camera`?",
          "the [[camera]] camera does not state emissivity | add emissivity = 0.95 to it: there the search begins"}) {
        EXPECT_NE(found.find(what), std::string::npos) << what << "\nin\n" << found;
    }
    for (const InputError& error : reading.errors) {
        EXPECT_GT(error.line, 0) << error.what;
    }
}

// With a name that cannot be one the camera of the frames is not known; there is nothing else to say about it.
TEST(Frames, OfACameraWithAWrongNameAreReportedOnce) {
    const std::string found =
        what_is_wrong(read_csv(frames_csv(), "[[camera]]\nname = \"a/b\"\npixel_size = \"2 mm\"\n",
                               "[[run]]\nname = \"heating\"\nframes = { camera = \"frames.csv\" }\n"));
    EXPECT_EQ(std::count(found.begin(), found.end(), '\n'), 1) << found;
    EXPECT_EQ(found.find("there is no camera"), std::string::npos) << found;
}

// A number that is wrongly written is not missed a second time where it is free.
TEST(Frames, OfACameraWithAWrongNumberAreReportedOnce) {
    const ExperimentReading reading =
        read_csv(frames_csv(), std::string(one_camera) + "emissivity = 1.2\n",
                 std::string(one_run) + "[[parameter]]\ncamera = \"camera\"\nkey = \"emissivity\"\n");
    EXPECT_EQ(what_is_wrong(reading), "emissivity is 1.2; it must be above 0 and at most 1 | \n");
}

TEST(Frames, WithoutAPixelSizeOrBeyondTheWindowAreRefused) {
    const std::string found = what_is_wrong(read_csv(frames_csv(), "[[camera]]\nname = \"camera\"\nrows = [0, 3]\n"));
    for (const char* what :
         {"rows of camera go to 3, and the frames of ", "frames.csv have 3, 0 to 2 | let rows end at 2 at most\n",
          "the size of a pixel of camera on the specimen is not given | add pixel_size = \"0.5 mm\" to "
          "the [[camera]], or the attribute pixel_size to the file's frames\n"}) {
        EXPECT_NE(found.find(what), std::string::npos) << what << "\nin\n" << found;
    }
}

// Ten pixels at exactly 31 degC in both frames: no specimen does that.
TEST(Frames, ThatLookSaturatedAreAFinding) {
    std::string text = frames_csv();
    text = text.substr(0, text.find("\n0,"));
    for (const char* row : {"\n0", "\n20"}) {
        text += row;
        for (int pixel = 0; pixel < 12; ++pixel) {
            text += pixel < 2 ? ",25" : ",31";
        }
    }
    const ExperimentReading reading = read_csv(text + "\n");
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    ASSERT_FALSE(reading.data_warnings.empty());
    EXPECT_NE(
        reading.data_warnings.front().find("its hottest value, 31.00 degC, stands 20 times, several times in each of 2 "
                                           "frames: the camera may be saturated there"),
        std::string::npos)
        << reading.data_warnings.front();
}

}  // namespace tiretherm::input
