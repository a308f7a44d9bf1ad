// SPDX-License-Identifier: BSD-3-Clause
// Image bands are orthogonal, pixels add up radiation, slopes equal differences of runs, and camera fits contain the
// true values.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "diagnosis/compare/camera_comparison.hpp"
#include "diagnosis/compare/camera_rings.hpp"
#include "diagnosis/compare/observed_comparison.hpp"
#include "diagnosis/fit/camera_bench.hpp"
#include "diagnosis/fit/identification.hpp"
#include "diagnosis/fit/refinement.hpp"

namespace tiretherm::diagnosis {

namespace {

using Place = std::vector<std::pair<int, int>>;

/// 5 x 3 pixels without the one in the middle and a corner.
Place with_holes() {
    Place place;
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 3; ++column) {
            if ((row != 2 || column != 1) && (row != 4 || column != 2)) {
                place.emplace_back(row, column);
            }
        }
    }
    return place;
}

}  // namespace

// White noise stays white of the same size exactly when the transformation keeps lengths and right angles: Q' Q = 1, also
// where pixels are missing.
TEST(ImageBands, AreAnOrthogonalTransformationWhateverPixelsThereAre) {
    const ImageBands bands(with_holes());
    const auto n = static_cast<Eigen::Index>(bands.entries());
    ASSERT_EQ(n, 13);
    Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        bands.apply({Q.col(j).data(), static_cast<std::size_t>(n)});
    }
    EXPECT_LT((Q.transpose() * Q - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-14);
}

// A constant image of 13 pixels has nothing but a mean, sqrt(13) times its value; 5 rows and 3 columns are joined in
// three levels, the last of which is the whole.
TEST(ImageBands, OfAConstantImageHaveNothingButTheMean) {
    const ImageBands bands(with_holes());
    std::vector<double> image(13, 7.0);
    bands.apply(image);
    EXPECT_EQ(bands.bands(), 4);
    for (std::size_t i = 0; i < image.size(); ++i) {
        EXPECT_NEAR(image[i], bands.band(i) == 3 ? 7.0 * std::sqrt(13.0) : 0.0, 1e-13) << i;
    }
    EXPECT_EQ(bands.name(3), "mean of the frame");
    EXPECT_EQ(bands.name(1), "differences over 2 px");
}

// What differs from pixel to pixel stands in the finest band, what differs between the halves of the image in the coarsest.
TEST(ImageBands, TellFineFromCoarse) {
    Place place;
    std::vector<double> fine;
    std::vector<double> coarse;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            place.emplace_back(row, column);
            fine.push_back(column % 2 == 0 ? 1.0 : -1.0);
            coarse.push_back(column < 2 ? 1.0 : -1.0);
        }
    }
    const ImageBands bands(place);
    bands.apply(fine);
    bands.apply(coarse);
    for (std::size_t i = 0; i < place.size(); ++i) {
        EXPECT_TRUE(std::abs(fine[i]) < 1e-14 || bands.band(i) == 0) << i;
        EXPECT_TRUE(std::abs(coarse[i]) < 1e-14 || bands.band(i) == 1) << i;
    }
}

// A sharp, black camera over a specimen of one temperature shows it; over two, the fourth root of the mean of T^4.
TEST(ImageView, AddsUpRadiation) {
    const input::Experiment experiment = camera_experiment();
    const input::MeasuredFrames& frames = experiment.runs.front().frames.front();
    const solver::Problem& problem = experiment.runs.front().problem;
    const ImageView view(frames, problem);
    std::vector<double> channels(problem.channels.size(), 350.0);
    std::vector<double> pixels(frames.pixels.size());
    view.read(channels, pixels);
    for (const double pixel : pixels) {
        EXPECT_NEAR(pixel, 350.0, 1e-9);
    }
    const physics::SeenSurface surface(problem.mesh, frames.patch);
    const mesh::Functional weights =
        physics::over_pixel(surface, frames.detectors, physics::pose_of(problem.effects[frames.pose]), 7, 11);
    double sum = 0.0;
    for (std::size_t node = 0; node < channels.size(); ++node) {
        channels[node] = node % 2 == 0 ? 300.0 : 400.0;
    }
    for (std::size_t k = 0; k < weights.nodes.size(); ++k) {
        sum += weights.weights[k] * std::pow(channels[static_cast<std::size_t>(weights.nodes[k])], 4);
    }
    view.read(channels, pixels);
    EXPECT_NEAR(pixels[7 * 16 + 11], std::pow(sum, 0.25), 1e-9);
}

// Slopes of every free number, a conductivity, the absorbed share, the emissivity, the image's place and blur, against
// differences of whole simulations over the same steps.
TEST(CameraSlopes, EqualDifferencesOfWholeRuns) {
    input::Experiment experiment = camera_experiment();
    const Observations observations = observe(experiment);
    Simulator simulator(experiment, observations);
    const Eigen::VectorXd here = camera_truth;
    const ModelPrediction base = simulator.at(here);
    ASSERT_TRUE(base.status.ok()) << base.status.message;
    const std::vector<double> step{1e-3, 1e-3, 1e-3, 0.125e-3, 0.125e-3, 0.125e-3};
    for (Eigen::Index j = 0; j < here.size(); ++j) {
        Eigen::VectorXd up = here;
        Eigen::VectorXd down = here;
        up[j] += step[static_cast<std::size_t>(j)];
        down[j] -= step[static_cast<std::size_t>(j)];
        const Eigen::VectorXd above = simulator.at(up).simulated;
        const Eigen::VectorXd below = simulator.at(down).simulated;
        const Eigen::VectorXd difference = (above - below) / (up[j] - down[j]);
        const double largest = difference.cwiseAbs().maxCoeff();
        EXPECT_GT(largest, 0.0);
        EXPECT_LT((base.slope.col(j) - difference).cwiseAbs().maxCoeff(), 5e-3 * largest)
            << experiment.parameters[static_cast<std::size_t>(j)].name;
    }
}

// Frames of the model itself with 0.05 K of noise in each pixel and 0.05 K common to a frame. The finest band's noise is that
// of a pixel; the mean's entry is 16 times the mean of 256 pixels: sqrt(256 * 0.05^2 + 0.05^2) = 0.80 K. Every number
// within three of its standard deviations, and none wider than its prior.
TEST(CameraFit, FindsWhatIsTrueWithinItsIntervals) {
    input::Experiment experiment = camera_experiment();
    make_frames(experiment, camera_truth, 0.05, 0.05, 7);
    const Observations observations = observe(experiment);
    const Identification result = identify(experiment, observations);
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    EXPECT_TRUE(result.converged);
    for (std::size_t j = 0; j < result.fitted.size(); ++j) {
        const Fitted& one = result.fitted[j];
        EXPECT_LT(std::abs(one.value - camera_truth[static_cast<Eigen::Index>(j)]), 3.0 * one.standard_deviation)
            << experiment.parameters[j].name << " " << one.value << " +- " << one.standard_deviation;
    }
    EXPECT_LT(result.fitted[3].standard_deviation, 0.01e-3);
    EXPECT_LT(result.fitted[0].standard_deviation, 0.01);
    ASSERT_EQ(result.channels.size(), 5U);
    EXPECT_NEAR(result.channels.front().noise.sigma, 0.05, 0.002);
    EXPECT_EQ(result.channels.front().name, "camera, differences over 1 px");
    EXPECT_NEAR(result.channels.back().noise.sigma, 0.80, 0.35);
}

// The drift is distinguished from the pixels' noise: with 0.5 K of it in place of none, the absorbed share, which the
// level of the frames tells, is known less well; where the image lies, which differences tell, stays known as it was.
TEST(CameraFit, TakesADriftOfTheFramesForWhatItIs) {
    const auto deviations = [](double drift) {
        input::Experiment experiment = camera_experiment();
        make_frames(experiment, camera_truth, 0.05, drift, 11);
        const Observations observations = observe(experiment);
        const Identification result = identify(experiment, observations);
        EXPECT_TRUE(result.status.ok()) << result.status.message;
        return std::pair{result.fitted[1].standard_deviation, result.fitted[3].standard_deviation};
    };
    const auto [share, place] = deviations(0.0);
    const auto [share_in_drift, place_in_drift] = deviations(0.5);
    EXPECT_GT(share_in_drift, 1.2 * share);
    EXPECT_NEAR(place_in_drift / place, 1.0, 0.15);
}

// Frames without noise from a grid of half the spacing and steps held to 0.1 mK: what they lie off the coarse grid is, at
// second order, three quarters of the coarse grid's error, which the refinement therefore tells as four thirds of it.
TEST(CameraRefinement, TellsFourThirdsOfWhatTheFinerGridShows) {
    input::Experiment finer = camera_experiment(twice_as_fine());
    input::Experiment experiment = camera_experiment();
    make_frames(finer, camera_truth, 0.0, 0.0, 3, 1e-4);
    experiment.runs.front().frames.front().value = finer.runs.front().frames.front().value;
    const Observations observations = observe(experiment);
    Simulator simulator(experiment, observations);
    const Eigen::VectorXd base = simulator.at(camera_truth).simulated;
    const Eigen::VectorXd change = change_by_refinement({.experiment = experiment,
                                                         .observations = observations,
                                                         .values = camera_truth,
                                                         .simulated = base,
                                                         .steps = simulator.steps()},
                                                        &finer);
    const Eigen::VectorXd off = observations.measured - base;
    EXPECT_GT(off.norm(), 1.0);
    EXPECT_LT((change - 4.0 / 3.0 * off).norm(), 0.1 * off.norm());
}

// A quarter of what the correction moved belongs to the interval: the standard deviation is at least that.
TEST(CameraFit, WidensItsIntervalsByWhatTheGridMayHaveLeft) {
    const input::Experiment finer = camera_experiment(twice_as_fine());
    input::Experiment experiment = camera_experiment();
    make_frames(experiment, camera_truth, 0.05, 0.05, 3);
    const Observations observations = observe(experiment);
    const Identification result = identify(experiment, observations, {.finer = &finer});
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    double moved = 0.0;
    for (const Fitted& one : result.fitted) {
        moved = std::max(moved, std::abs(one.by_grid) / one.standard_deviation);
        EXPECT_GE(one.standard_deviation, 0.2499 * std::abs(one.by_grid));
        EXPECT_LE(one.low, one.value);
        EXPECT_GE(one.high, one.value);
    }
    EXPECT_GT(moved, 1.0);
}

// Held against the model that made them, frames leave white noise: no bias, its rms in every ring, every stage and every
// size. A specimen that is 1 K warmer everywhere is 1 K off in all of them.
TEST(CameraComparison, TellsNoiseFromWhatIsCommonToThePixels) {
    input::Experiment experiment = camera_experiment();
    const Observations observations = observe(experiment);
    const Simulator simulator(experiment, observations);
    make_frames(experiment, simulator.start(), 0.05, 0.0, 5);
    input::MeasuredRun& run = experiment.runs.front();
    input::MeasuredFrames& frames = run.frames.front();
    const solver::Prediction prediction = solver::predict(run.problem, {.times = frames.time});
    const ComparedImages noise = compare_images(run, 0, frames, frames.time, prediction);
    EXPECT_NEAR(noise.figures.rmse, 0.05, 0.002);
    EXPECT_NEAR(noise.figures.bias, 0.0, 0.004);
    EXPECT_NEAR(noise.noise, 0.05, 0.003);
    EXPECT_LT(noise.removable, 0.02);
    EXPECT_EQ(noise.pixels(), 256U);
    EXPECT_LT(noise.scales.back().second, 0.05 * 2.0);
    for (double& value : frames.value) {
        value -= 1.0;
    }
    const ComparedImages warm = compare_images(run, 0, frames, frames.time, prediction);
    EXPECT_NEAR(warm.figures.bias, 1.0, 0.004);
    for (const PartFigures& ring : warm.rings) {
        EXPECT_NEAR(ring.bias, 1.0, 0.03) << ring.from;
    }
    EXPECT_NEAR(warm.scales.back().second, 16.0, 0.1);
    EXPECT_NEAR(warm.scales.front().second, 0.05, 0.003);
}

// As rings a camera is three ordinary channels; those of a round field hold what its pixels hold.
TEST(CameraRings, HoldTheMeanOfTheirPixels) {
    input::Experiment experiment = camera_experiment();
    const Observations observations = observe(experiment);
    const Simulator simulator(experiment, observations);
    make_frames(experiment, simulator.start(), 0.0, 0.0, 5);
    Remarks remarks;
    const input::Experiment rings = in_rings(experiment, remarks);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_EQ(remarks.front().code, RemarkCode::images_as_rings);
    EXPECT_EQ(std::get<long>(remarks.front().about[1]), 3);
    EXPECT_EQ(rings.parameters.size(), 3U);  // where the image lies is no question any more
    const input::MeasuredRun& run = rings.runs.front();
    EXPECT_TRUE(run.frames.empty());
    ASSERT_EQ(run.series.size(), 3U);
    ASSERT_EQ(run.problem.channels.size(), 3U);
    EXPECT_EQ(run.problem.channels.front().name, "camera 1");
    const solver::Prediction prediction = solver::predict(run.problem, {.times = run.time});
    for (const input::MeasuredSeries& series : run.series) {
        for (std::size_t i = 0; i < run.time.size(); ++i) {
            EXPECT_NEAR(prediction.at(i, series.channel), series.value[i], 0.01) << series.channel << " " << i;
        }
    }
}

// The coefficients of frames are no samples of a channel: where a camera is all that measures, there is nothing to compare.
TEST(Images, AreNoChannelsOfAComparison) {
    const input::Experiment experiment = camera_experiment();
    const Observations observations = observe(experiment);
    ASSERT_FALSE(observations.blocks.empty());
    EXPECT_TRUE(compare_observed(experiment, observations, observations.measured).empty());
}

}  // namespace tiretherm::diagnosis
