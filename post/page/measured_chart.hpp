// SPDX-License-Identifier: BSD-3-Clause
// Measured and simulated in one chart for each run, the differences below.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "input/measurements/experiment.hpp"
#include "post/report/report.hpp"
#include "solver/channel_unit.hpp"
#include "solver/input_signals.hpp"

namespace tiretherm::post {

/// A channel of a run with what one or several models say of it.
struct MeasuredSeries {
    struct Model {
        std::string name;               ///< "case", "fitted"
        std::vector<double> simulated;  ///< [samples] SI
    };
    std::string channel;
    solver::ShownUnit unit;
    std::string run;
    std::vector<double> time;      ///< [samples] s
    std::vector<double> measured;  ///< [samples] SI
    std::vector<Model> models;     ///< from the first to the best
    double noise = 0.0;            ///< standard deviation of the sensor's noise, SI; 0: not known
};

/// What was put in during a run, for the panels below its channels.
struct RunInputs {
    std::string run;
    const solver::InputSignals* inputs = nullptr;
    std::span<const input::Lap> laps{};  ///< of a circuit; bands in the place of steps
};
[[nodiscard]] std::vector<RunInputs> inputs_of_runs(const input::Experiment& experiment);

/// A section with a chart for each run: channels of one unit in one panel, simulated less measured below, the inputs that change
/// at the bottom, and laps or steps as bands. The first model is dashed where there is another. Where the noise is known the
/// differences have its 95 % band, and of many samples their means over a fortieth of the run. All charts zoom together.
/// Nothing where there is no series of two samples or more.
[[nodiscard]] ReportSection measured_section(const std::vector<MeasuredSeries>& series,
                                             const std::vector<RunInputs>& inputs = {});

}  // namespace tiretherm::post
