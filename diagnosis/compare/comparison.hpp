// SPDX-License-Identifier: BSD-3-Clause
// Comparison of measured and simulated values as the case stands, without any fit: series by channel and run, single
// numbers, camera images and their figures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/compare/camera_comparison.hpp"
#include "diagnosis/compare/comparison_statistics.hpp"
#include "diagnosis/compare/corner_comparison.hpp"
#include "diagnosis/compare/phase.hpp"
#include "diagnosis/compare/stretch.hpp"
#include "input/measurements/experiment.hpp"
#include "solver/channel_unit.hpp"
#include "solver/compared_ranges.hpp"
#include "solver/status.hpp"

namespace tiretherm::diagnosis {

/// A channel of a run: samples that were measured, and what is simulated at their times. SI; a missing sample is not here.
struct ComparedSeries {
    std::size_t run = 0;
    std::string corner{};      ///< FL, FR, RL or RR; empty: the case has no [[corner]]
    std::vector<double> time;  ///< s
    std::vector<double> measured;
    std::vector<double> simulated;
    std::vector<double> surroundings;  ///< what a rise is counted from: air temperature, or 0
    std::vector<Phase> phase;
    std::vector<std::vector<double>> regressor;  ///< [n_regressors][n_samples], NaN where it is missing

    [[nodiscard]] std::vector<double> difference() const;  ///< simulated - measured
};

struct RunFigures {
    std::size_t run = 0;
    Figures figures;
    std::string corner{};
    StretchValues measured{};
    StretchValues simulated{};
};

/// A channel in one lap of a run.
struct LapFigures {
    std::size_t run = 0;
    input::Lap lap;
    Figures figures;
    StretchValues measured{};
    StretchValues simulated{};
};

/// What the differences do against one signal.
struct RegressorFigures {
    std::string name;
    std::string unit;
    Association association;
    std::vector<Bin> bins;
};

/// All of one channel.
struct ComparedChannel {
    std::string name;
    solver::ShownUnit unit;
    std::vector<ComparedSeries> series;
    Figures figures;                ///< over all runs
    double noise = 0.0;             ///< what changes from one sample to the next; NaN: too few samples to tell
    double sensor = 0.0;            ///< standard deviation taken for the sensor
    bool sensor_is_stated = false;  ///< by the case; otherwise it is `noise`
    double grid_error = 0.0;        ///< SI, the largest of grid and steps; 0 where nobody looked
    ModelUncertainty model;
    std::vector<RunFigures> runs;
    std::vector<PhaseFigures> phases;
    std::vector<LapFigures> laps;
    std::vector<CornerFigures> corners;        ///< empty: the case has no [[corner]]
    std::vector<CommonBias> common;            ///< of corners
    std::vector<RegressorFigures> regressors;  ///< the closest first
    /// Chance below which the closest regressor counts: 5 % over all that were tried.
    double significant = 0.05;
};

/// A single measured number beside the simulated one.
struct ComparedNumber {
    std::string channel;
    solver::ShownUnit unit;
    std::size_t run = 0;
    double time = 0.0;  ///< s
    bool at_end = false;
    double measured = 0.0;     ///< SI
    double uncertainty = 0.0;  ///< standard
    double simulated = 0.0;    ///< SI
    std::string source;

    [[nodiscard]] double in_uncertainties() const { return (simulated - measured) / uncertainty; }
};

/// A grid whose error was not looked at, because that would take too long.
struct GridLeftOut {
    int cells = 0;
    std::size_t samples = 0;  ///< of all runs, of sensors or of inputs
};

/// Measured compared with simulated. Every difference is simulated - measured.
struct Comparison {
    std::string name;
    std::vector<std::string> runs;
    std::vector<std::string> files;
    std::vector<solver::InputSignals> inputs;   ///< [runs] what was put in
    std::vector<std::vector<input::Lap>> laps;  ///< [runs] of a circuit; may be empty
    std::vector<RunHeat> heat;                  ///< [runs]
    std::vector<std::string> not_driven{};      ///< what of schedules and files is not simulated
    solver::Extrapolations extrapolations{};    ///< laws beyond their ranges
    std::vector<ComparedChannel> channels;      ///< of which anything was logged
    std::vector<ComparedNumber> numbers;
    std::vector<ComparedImages> images;  ///< of cameras, run by run
    std::optional<GridLeftOut> grid_left_out{};
    std::vector<std::string> warnings;
    std::vector<std::string> findings;
    solver::Status status;  ///< of the first run that failed; then there are no figures
    double seconds = 0.0;   ///< of all simulations
};

/// Simulates every run as the case stands and compares.
/// @param finer the experiment on a grid of half the spacing, for the error of the grid; null: it is not looked at
[[nodiscard]] Comparison compare(const input::Experiment& experiment, const std::string& name,
                                 const input::Experiment* finer = nullptr);
/// The figures of a channel, from its series; values of the regressors are used up.
/// @param regressors names and units, in the order of ComparedSeries::regressor
/// @param laps [runs]
void evaluate(ComparedChannel& channel, const std::vector<std::pair<std::string, std::string>>& regressors,
              const std::vector<std::vector<input::Lap>>& laps = {});

}  // namespace tiretherm::diagnosis
