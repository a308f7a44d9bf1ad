// SPDX-License-Identifier: BSD-3-Clause
// A case with its measured runs and fitted parameters: the data that compare, identify and diagnose work on.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/laps/laps.hpp"
#include "input/laps/repeated_lap.hpp"
#include "input/measurements/read_column.hpp"
#include "physics/camera.hpp"
#include "solver/sensitivity/free_parameter.hpp"

namespace tiretherm::input {

/// What one sensor gave.
struct MeasuredSeries {
    std::size_t channel = 0;    ///< index into Problem::channels
    std::vector<double> value;  ///< [n_times] SI; NaN where it is missing
    bool frozen = false;        ///< it never changes though it should: nothing can be learnt from it
};

/// One number of a source, with its standard uncertainty.
struct MeasuredNumber {
    std::size_t channel = 0;          ///< index into Problem::channels
    double time = 0.0;                ///< s; the run's end in a steady case
    double value = 0.0;               ///< SI
    double standard_deviation = 0.0;  ///< > 0
    std::string source;
};

/// What a column that the model does not use is, by its name, its unit and its course in all runs. A drive alone may be a
/// cause: unknown heat or the error of a sensor may follow it.
enum class ColumnKind : std::uint8_t {
    drive,                ///< what acts on the tire from outside: a throttle, a brake, the temperature of a brake disc
    temperature_of_tire,  ///< a temperature of the tire, or what moves like one: an effect of the heat
    copy,                 ///< of an input, a sensor or another column, perhaps scaled or shifted
    result,               ///< a computed channel: a simulation or a math channel
    clock,                ///< a time, a counter, a lap's number, a distance or a coordinate
    constant              ///< it never changes
};

/// A column of the file that the model does not use.
struct UnusedSignal {
    std::string name;
    std::string unit;             ///< as the file writes it
    solver::SharedSamples value;  ///< [n_times] in that unit; NaN where it is missing
    ColumnKind kind = ColumnKind::drive;
    std::string reason{};      ///< why it is of this kind or is left out, the rest of a sentence about it; may be empty
    bool may_be_cause = true;  ///< a diagnosis tries it: a drive, unless [diagnose] says otherwise
};

/// Sensors that are read by one camera, array, logger or amplifier: what is wrong with it is wrong with all of them.
struct Instrument {
    std::string name;
    std::vector<std::size_t> channels;  ///< indices into Problem::channels, two at least, each measured in some run
    bool assumed = false;               ///< by names and places of the sensors; the case does not say it
};

/// What a camera gave: images of a surface, whose pixels are means over nodes of it.
struct MeasuredFrames {
    std::string camera;
    std::string file;
    int patch = -1;        ///< that it looks at, index into the mesh's patches
    std::size_t pose = 0;  ///< index into Problem::effects: where the image lies (physics::camera_pose)
    solver::CameraChannels channels{};
    physics::Detectors detectors;
    int bin = 1;   ///< so many by so many of them make a pixel
    int rows = 0;  ///< of the binned image, all pixels
    int columns = 0;
    std::vector<physics::BinnedPixel> pixels{};  ///< [n_pixels] that are of use
    std::vector<double> time{};                  ///< [n_frames] s, ascending
    std::vector<double> value{};                 ///< [n_frames][n_pixels] K
    std::optional<double> standard_deviation{};  ///< K, of a binned pixel, as the data sheet says
    int dead = 0;                                ///< detectors without a value in some frame
    int beside = 0;                              ///< detectors that do not see the specimen alone
};

/// A run as it was measured: the case under this run's inputs, from its first time to its last, with its own initial
/// state, and what was read.
struct MeasuredRun {
    std::string name;
    std::string recording{};  ///< of a corner: the name of the run without it
    std::string corner{};     ///< FL, FR, RL or RR; empty: the case has no [[corner]]
    std::string file;
    solver::Problem problem;
    std::vector<double> time;  ///< [n_times] s, ascending
    std::vector<MeasuredSeries> series;
    std::vector<MeasuredNumber> numbers;
    std::vector<UnusedSignal> unused;
    std::vector<ReadColumn> columns{};  ///< of the file that the model uses, without those of its clock
    std::vector<MeasuredFrames> frames;
    std::vector<Lap> laps{};  ///< of the file, those that lie in the run
    RepeatedLap repeated{};   ///< that goes before it
    std::vector<std::string>
        not_driven{};  ///< what of the case's schedule or of the file is not simulated, a sentence each
};

/// A programme that the user can run.
struct Manoeuvre {
    std::string name;
    solver::InputSignals inputs;  ///< that it gives
    double start = 0.0;           ///< s
    double end = 0.0;
    std::vector<std::string> of_largest{};  ///< inputs that are shares of the largest that the runs have
};

/// A case with its measured runs and the numbers of it that may be fitted.
struct Experiment {
    std::vector<MeasuredRun> runs;
    std::vector<solver::FreeParameter>
        parameters;                    ///< those of one run say which; indices hold for every run's problem
    std::string noise = "correlated";  ///< model of the noise: "correlated" (AR(1) + white), "white" or "automatic"
    bool robust = false;               ///< outliers count less (Huber)
    std::vector<std::string> candidates{};  ///< effects (or "effect.key") that a diagnosis may name; empty: all
    std::vector<Instrument> instruments{};  ///< those of the case first, then those that are assumed
    std::vector<Manoeuvre> possible{};      ///< as the next experiment
};

/// What of schedules and files is not simulated, with the runs' names; a sentence of all corners of a car once.
[[nodiscard]] std::vector<std::string> not_driven(const Experiment& experiment);

}  // namespace tiretherm::input
