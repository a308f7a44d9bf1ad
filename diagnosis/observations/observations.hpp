// SPDX-License-Identifier: BSD-3-Clause
// All measured values of an experiment as one vector, and a simulator that predicts it with its slopes over fixed time
// steps.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/noise/noise.hpp"
#include "diagnosis/observations/images.hpp"
#include "input/measurements/experiment.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::diagnosis {

/// All measured values of an experiment in one stack: channel by channel of each run, then its cameras' frames, each
/// taken apart by size (ImageBands), of which every band has its noise; then the single numbers.
struct Observations {
    /// What a row is.
    struct Row {
        std::size_t run = 0;
        std::size_t channel = 0;  ///< index into Problem::channels
        std::size_t time = 0;     ///< index into `times` of the run
        int image = -1;           ///< index into `images`; -1: a channel as it is
    };
    std::vector<NoiseBlock> blocks;
    std::vector<Row> rows;
    Eigen::VectorXd measured;                ///< [n_rows] SI
    std::vector<std::vector<double>> times;  ///< [n_runs] s, ascending: when the run is asked
    std::vector<std::size_t> recordings;  ///< [n_runs] which each belongs to, from 0 on: the corners of a car share one
    std::vector<double> lap_ends{};       ///< s, ascending, of a single recording whose laps are known
    std::vector<std::size_t> channels;    ///< [n_noises] indices into Problem::channels: Block::channel counts these
    std::vector<std::string> names;       ///< [n_noises] the sensor's, or of a camera with its band
    std::vector<double> stated;           ///< [n_noises] standard deviation as the data sheet says, or 0
    std::vector<ImageRows> images;

    [[nodiscard]] std::size_t n_recordings() const {
        return recordings.empty() ? 0 : *std::ranges::max_element(recordings) + 1;
    }
    /// First and last time of a recording. @returns s
    [[nodiscard]] std::pair<double, double> span_of(std::size_t recording) const;
};
/// What was measured, row by row. Sensors that never change though they should are left out.
[[nodiscard]] Observations observe(const input::Experiment& experiment);

/// What the model says of the observations at some values of its numbers.
struct ModelPrediction {
    solver::Status status;
    Eigen::VectorXd simulated;                       ///< [n_rows] SI
    Eigen::MatrixXd slope;                           ///< [n_rows][n_parameters] SI per unit of the parameter
    std::vector<std::string> non_smooth_parameters;  ///< names of numbers at a switch or a clamp
};

/// Simulates the runs of an experiment, several at a time, over steps that stay the same from one call to the next, so
/// that what it gives follows the parameters smoothly.
class Simulator {
public:
    /// @param experiment, observations live longer
    Simulator(const input::Experiment& experiment, const Observations& observations);

    /// Asked again at the same values it remembers. @errors solver::Interrupted when the user has asked for an end
    /// @param values [n_parameters] in the units of the experiment's parameters
    [[nodiscard]] const ModelPrediction& at(const Eigen::VectorXd& values);
    /// The next prediction chooses its steps anew, by the error control of each run.
    void clear_steps() {
        step_ends_.assign(step_ends_.size(), {});
        last_values_.resize(0);
    }
    /// The steps that each run takes, by their ends; a run without any chooses them at the next one. @returns s
    [[nodiscard]] const std::vector<std::vector<double>>& steps() const { return step_ends_; }
    void take_steps(std::vector<std::vector<double>> ends) {
        step_ends_ = std::move(ends);
        last_values_.resize(0);
    }
    /// A run's problem at these values.
    [[nodiscard]] solver::Problem problem(std::size_t run, const Eigen::VectorXd& values) const;
    /// The values that the experiment's case has.
    [[nodiscard]] const Eigen::VectorXd& start() const { return start_; }
    /// @param progress called after each prediction with the number of runs simulated so far
    void on_progress(std::function<void(long)> progress) { progress_ = std::move(progress); }
    [[nodiscard]] long simulations() const { return simulations_; }  ///< runs so far

private:
    [[nodiscard]] ModelPrediction predict(const Eigen::VectorXd& values);
    /// Whether a run has a row: of some rows alone it may have none.
    [[nodiscard]] bool is_asked(std::size_t run) const;
    [[nodiscard]] solver::Prediction simulate(std::size_t run, const Eigen::VectorXd& values) const;
    /// The rows of a run's sensors and numbers, and their slopes.
    void read_run(std::size_t run, const solver::Prediction& prediction, ModelPrediction& into) const;
    /// A camera's frames as the run gives them, and their slopes. @param now the run's problem
    void read_images(const ImageRows& image, const solver::Prediction& prediction, const solver::Problem& now,
                     ModelPrediction& into) const;

    const input::Experiment* experiment_;
    const Observations* observations_;
    Eigen::VectorXd start_;
    std::vector<std::vector<double>> step_ends_;        ///< [n_runs]
    std::vector<std::vector<std::size_t>> parameters_;  ///< [n_runs] those that a run follows
    std::vector<std::vector<Eigen::Index>> rows_;       ///< [n_runs]
    Eigen::VectorXd last_values_;
    ModelPrediction last_;
    long simulations_ = 0;
    std::function<void(long)> progress_;
};

/// The same experiment with the inputs that its fitted numbers make; all else is as it was. For pages, which show what was put in.
/// @param values [n_parameters]
[[nodiscard]] input::Experiment with_fitted_inputs(input::Experiment experiment, const Eigen::VectorXd& values);

}  // namespace tiretherm::diagnosis
