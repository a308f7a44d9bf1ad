// SPDX-License-Identifier: BSD-3-Clause
// A small disc under a laser with made-up camera frames of known parameters, pixel noise and drift.
#pragma once

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "diagnosis/observations/observations.hpp"
#include "input/runs/read_experiment.hpp"
#include "support/written.hpp"

namespace tiretherm::diagnosis {

/// A small disc under a laser, 16 x 16 pixels of 1.25 mm, twelve frames in two minutes; six numbers are free.
inline constexpr std::string_view camera_case = R"([mesh]
kind = "axisymmetric"
radius = [{ to = "5 mm", cells = 20 }, { to = "20 mm", cells = 20 }]
[[mesh.layer]]
name = "tread"
thickness = "5 mm"
cells = 10
ratio = 4
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.5 W/mK"
[effects.laser]
radius = "5 mm"
absorptivity = 0.95
[effects.still_air]
patches = ["top", "bottom"]
[drive]
laser_power = "2 W"
air_temperature = "23 degC"
[initial]
temperature = "23 degC"
[time]
end = "120 s"
[[camera]]
name = "camera"
pixel_size = "1.25 mm"
emissivity = 0.95
blur = "0.6 mm"
standard_deviation = "0.05 K"
[[parameter]]
material = "rubber"
law = "conductivity"
at = "60 degC"
[[parameter]]
effect = "laser"
key = "absorptivity"
standard_deviation = 0.02
[[parameter]]
camera = "camera"
key = "emissivity"
standard_deviation = 0.02
[[parameter]]
camera = "camera"
key = "x"
standard_deviation = "1 mm"
[[parameter]]
camera = "camera"
key = "y"
standard_deviation = "1 mm"
[[parameter]]
camera = "camera"
key = "blur"
standard_deviation = "0.5 mm"
[[run]]
name = "heating"
frames = "frames.csv"
)";

/// What is true of the made-up frames, in the order of the parameters.
inline const Eigen::VectorXd camera_truth =
    (Eigen::VectorXd(6) << 0.55, 0.97, 0.93, 0.4e-3, -0.3e-3, 0.9e-3).finished();

/// The experiment with frames of nothing but 20 degC. @param tables of the case
inline input::Experiment camera_experiment(std::string_view tables = camera_case) {
    constexpr int size = 16;
    constexpr int frames = 12;
    std::string text = "time [s]";
    for (int pixel = 0; pixel < size * size; ++pixel) {
        text += ",r" + std::to_string(pixel / size) + "c" + std::to_string(pixel % size) + " [degC]";
    }
    for (int frame = 0; frame < frames; ++frame) {
        text += "\n" + std::to_string(10 * (frame + 1));
        for (int pixel = 0; pixel < size * size; ++pixel) {
            text += ",20";
        }
    }
    const input::Written written;
    written.add("frames.csv", text + "\n");
    input::ExperimentReading reading = input::read_experiment(written.add("case.toml", tables));
    for (const input::InputError& error : reading.errors) {
        ADD_FAILURE() << render(error);
    }
    return reading.experiment.value_or(input::Experiment{});
}

/// The case with twice as many cells each way.
inline std::string twice_as_fine() {
    std::string text(camera_case);
    for (const auto& [coarse, fine] : {std::pair{"cells = 20", "cells = 40"}, {"cells = 10", "cells = 20"}}) {
        for (std::size_t at = 0; (at = text.find(coarse, at)) != std::string::npos; at += 10) {
            text.replace(at, 10, fine);
        }
    }
    return text;
}

/// Fills the frames with what the model itself gives at some values, with noise of the pixels and of whole frames.
/// @param pixel, drift standard deviations, K  @param tolerance of the steps, K
inline void make_frames(input::Experiment& experiment, const Eigen::VectorXd& truth, double pixel, double drift,
                        unsigned seed, double tolerance = 0.01) {
    const Observations observations = observe(experiment);
    const Simulator simulator(experiment, observations);
    solver::Problem problem = simulator.problem(0, truth);
    problem.settings.tolerance = tolerance;
    input::MeasuredFrames& frames = experiment.runs.front().frames.front();
    const solver::Prediction prediction = solver::predict(problem, {.times = frames.time});
    const ImageView view(frames, problem);
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> normal;
    for (std::size_t f = 0; f < frames.time.size(); ++f) {
        const auto image = std::span(frames.value).subspan(f * frames.pixels.size(), frames.pixels.size());
        view.read(std::span(prediction.value).subspan(f * prediction.n_channels, prediction.n_channels), image);
        const double common = drift * normal(engine);
        for (double& value : image) {
            value += common + pixel * normal(engine);
        }
    }
}

}  // namespace tiretherm::diagnosis
