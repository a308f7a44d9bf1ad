// SPDX-License-Identifier: BSD-3-Clause
// The shipped camera example: the comparison reports the noise and the rms that its page states.

#include <filesystem>

#include <gtest/gtest.h>

#include "diagnosis/compare/comparison.hpp"
#include "input/runs/read_experiment.hpp"
#include "post/comparison/comparison_report.hpp"
#include "tests/support/report_cells.hpp"

namespace tiretherm::diagnosis {

// The shipped frames, 2 runs of 40 frames of 64 x 64 pixels with three dead ones. As the case stands the image is assumed
// 0.7 mm off where it lies: the rms is that of the crescents beside the spot (3 to 8 mm from its centre), and the sensor's
// 0.08 K is what changes from frame to frame. The page of the example states these figures.
TEST(CameraExample, IsOneChannelWhosePixelsAreOffWhereTheImageLiesElsewhere) {
    const input::ExperimentReading reading = input::read_experiment(std::filesystem::path(TIRETHERM_SOURCE_DIR) /
                                                                    "cases" / "laser" / "imaging" / "imaging.toml");
    ASSERT_TRUE(reading.experiment);
    const Comparison comparison = compare(*reading.experiment, "imaging");
    ASSERT_TRUE(comparison.status.ok()) << comparison.status.message;
    EXPECT_EQ(comparison.channels.size(), 1U);  // the probe; a camera's nodes are no channels to a reader
    ASSERT_EQ(comparison.images.size(), 2U);
    const ComparedImages& one = comparison.images[0];
    const ComparedImages& three = comparison.images[1];
    EXPECT_EQ(one.pixels(), 4093U);
    EXPECT_EQ(one.dead, 3);
    EXPECT_EQ(one.time.size(), 40U);
    EXPECT_NEAR(one.figures.bias, 0.139, 0.01);
    EXPECT_NEAR(one.figures.rmse, 1.85, 0.02);
    EXPECT_NEAR(three.figures.bias, 0.567, 0.02);
    EXPECT_NEAR(three.figures.rmse, 3.81, 0.03);
    EXPECT_NEAR(one.noise, 0.086, 0.004);
    EXPECT_GT(three.rings[2].rmse, 5.0 * three.rings[6].rmse);
    const post::Report report = post::comparison_report(comparison, {});
    const post::ReportSection& cameras = post::section(report, "Cameras");
    EXPECT_EQ(post::cell_text(cameras, 1, "run"), "three_watts");
    EXPECT_EQ(post::cell_text(cameras, 1, "frames"), "40");
    EXPECT_EQ(post::cell_text(cameras, 1, "pixels"), "4 093");
    EXPECT_EQ(post::page_text(report, false).find("camera 12"), std::string::npos);
}

}  // namespace tiretherm::diagnosis
