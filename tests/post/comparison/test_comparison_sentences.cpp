// SPDX-License-Identifier: BSD-3-Clause
// What is said of a channel's bias: significant, within chance, and beyond chance only by what the sensor cannot have done.

#include <gtest/gtest.h>

#include "post/comparison/comparison_report.hpp"
#include "post/comparison/comparison_sentences.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {
namespace {

/// @param bias, deviation, rmse K  @param sensor K, stated
diagnosis::ComparedChannel compared(double bias, double deviation, double rmse, double sensor) {
    diagnosis::ComparedChannel channel;
    channel.name = "belt";
    channel.unit = solver::shown_unit(solver::Quantity::temperature);
    channel.figures = {
        .samples = 4, .bias = bias, .rmse = rmse, .scatter = rmse, .independent = 4.0, .bias_deviation = deviation};
    channel.noise = channel.sensor = sensor;
    channel.sensor_is_stated = true;
    return channel;
}

}  // namespace

// 23.1 / 21.2 = 1.1 standard deviations: four samples cannot tell it from zero. The rms of 43 K is 29 times what the sensor
// may do, which is an error of the model whatever the bias is.
TEST(ComparisonSentences, AnErrorFarBeyondTheSensorIsNotCalledInsignificant) {
    const diagnosis::ComparedChannel channel = compared(-23.1, 21.2, 43.0, 1.5);
    EXPECT_EQ(sentences(channel).front(),
              "bias -23.10 +- 21.20 K: an effective sample size of 4 is too small to tell it from zero, but the rms of "
              "43.00 K is 29 times the sensor's noise");
    EXPECT_EQ(headline(channel, {"a"}),
              "belt: mean difference -23.10 +- 21.20 K, not significant; rms 43.00 K, 29 times the sensor's standard "
              "deviation of 1.50 K.");
}

// 0.3 / 0.2 = 1.5 standard deviations, and 1.2 / 1.5 = 0.8 of the sensor's noise: nothing is found.
TEST(ComparisonSentences, ABiasWithinChanceAndNoiseIsNotSignificant) {
    EXPECT_EQ(sentences(compared(0.3, 0.2, 1.2, 1.5)).front(),
              "no significant bias: +0.30 +- 0.20 K (effective sample size 4)");
}

// The largest difference is 300 - 302.5 = -2.5 K, the second sample of the second run.
TEST(ComparisonSentences, TheHeadlineHasTheBiasWithItsDoubtTheErrorAndTheLargestDifference) {
    diagnosis::ComparedChannel channel = compared(-1.0, 0.2, 1.2, 0.8);
    EXPECT_EQ(
        headline(channel, {"dry", "wet"}),
        "belt: simulated 1.00 +- 0.20 K too cold in the mean of 2 runs; rms 1.20 K, 1.5 times the sensor's standard "
        "deviation of 0.80 K.");
    channel.series.resize(2);
    for (std::size_t run = 0; run < 2; ++run) {
        channel.series[run].run = run;
        channel.series[run].time = {0.0, 31.0};
        channel.series[run].measured = {300.0, run == 1 ? 302.5 : 300.0};
        channel.series[run].simulated = {301.0, 300.0};
    }
    const std::string said = headline(channel, {"dry", "wet"});
    EXPECT_TRUE(said.ends_with("of 0.80 K; at most -2.50 K, at 31 s of wet.")) << said;
}

}  // namespace tiretherm::post
