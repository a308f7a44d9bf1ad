// SPDX-License-Identifier: BSD-3-Clause
// The chart of a camera's frames: values of measured and simulated, scales, the frame that is shown first, squares of pixels.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/comparison/camera_chart.hpp"
#include "post/report/base64.hpp"

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

/// Every pixel of an image but the first, measured 300 K and simulated 302 K, in the second frame 305 K.
diagnosis::ComparedImages frames(int rows, int columns) {
    diagnosis::ComparedImages images;
    images.camera = "camera";
    images.time = {0.0, 10.0};
    images.rows = rows;
    images.columns = columns;
    images.pitch_x = images.pitch_y = 0.5e-3;
    for (int pixel = 1; pixel < rows * columns; ++pixel) {
        images.place.push_back({pixel / columns, pixel % columns});
    }
    images.measured.assign(2 * images.pixels(), 300.0);
    images.simulated.assign(images.pixels(), 302.0);
    images.simulated.resize(2 * images.pixels(), 305.0);
    images.worst = 1;
    return images;
}

Json chart_of(const diagnosis::ComparedImages& images) { return Json::parse(json_text(camera_chart(images))); }

}  // namespace

// Two rows of three pixels of 0.5 mm, of which the first is left out: five values of each kind and frame. 300 K to 305 K is one
// scale of 26.85 to 31.85 degC, and the differences reach to 5 K, in the frame that is the worst.
TEST(CameraChart, MeasuredAndSimulatedShareAScaleAndTheWorstFrameIsShownFirst) {
    const Json chart = chart_of(frames(2, 3));
    EXPECT_EQ(chart["kind"], "images");
    EXPECT_EQ(chart["pixels"], Json::parse("[1,2,3,4,5]"));
    EXPECT_NEAR(chart["low"].get<double>(), 26.85, 1e-4);
    EXPECT_NEAR(chart["high"].get<double>(), 31.85, 1e-4);
    EXPECT_NEAR(chart["reach"].get<double>(), 5.0, 1e-4);
    EXPECT_EQ(chart["hottest"], 1);
    EXPECT_EQ(chart["first"], "worst frame");
    EXPECT_EQ(chart["half_width"], 0.75);
    EXPECT_EQ(chart["half_height"], 0.5);
    const std::string bytes = from_base64(chart["values"].get<std::string>()).value();
    ASSERT_EQ(bytes.size(), 2U * 2U * 10U);  // two bytes of two frames of ten values
    EXPECT_EQ(bytes.substr(0, 2), std::string("\0\0", 2));
    EXPECT_EQ(bytes.substr(38, 2), "\xff\xff");  // simulated, at the end
}

// 200 x 200 pixels are 5 times as many as a panel has squares: 3 by 3 are one, 67 to a side, and none is lost.
TEST(CameraChart, ManyPixelsAreDrawnAsSquaresOfSome) {
    const diagnosis::ComparedImages images = frames(200, 200);
    const Json chart = chart_of(images);
    EXPECT_EQ(chart["columns"], 67);
    EXPECT_EQ(chart["pixels"].size(), 67U * 67U);
    EXPECT_EQ(chart["square"], Json::parse("[1.5,1.5]"));
    EXPECT_NE(camera_caption(images).find("3 by 3 pixels"), std::string::npos);
    EXPECT_EQ(camera_caption(frames(2, 3)).find("by"), std::string::npos);
}

}  // namespace tiretherm::post
