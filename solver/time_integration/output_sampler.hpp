// SPDX-License-Identifier: BSD-3-Clause
// What a run reports while it goes: rows at the output times, stored fields, extremes and range warnings.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/hot_spot_finder.hpp"
#include "solver/time_integration/law_ranges.hpp"
#include "solver/time_integration/march.hpp"
#include "solver/time_integration/sensor_outputs.hpp"
#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

/// What a run reports while it goes: rows at the output times, interpolated inside a step, and the extremes seen.
class OutputSampler {
public:
    OutputSampler(const Problem& problem, const Observer& observer, const Stepper& stepper);

    /// The present state as a row with its field: at the start, before the inputs act, or of a steady state.
    /// @returns false when the observer wants to stop
    [[nodiscard]] bool show();
    /// Takes an accepted step into the sensors' outputs.
    void take_step();
    /// Every row up to the present time of the stepper, and the end of the run itself. @returns as `show`
    [[nodiscard]] bool advance();
    /// Looks at the state for the extremes; writes them into the report.
    void watch(MarchReport& report);

    /// Range warnings: of the effects about the temperatures that their patches saw, of the materials about their layers'.
    [[nodiscard]] std::vector<RangeWarning> range_warnings() const;

    void visit(Archive& archive);
    [[nodiscard]] double seconds() const { return seconds_; }  ///< spent in the observer

private:
    bool emit(double t, std::span<const double> T, std::span<const double> watts, std::span<const double> joules,
              double stored, bool field);
    bool emit_state(bool field);
    bool emit_inside_step(double t);
    bool field_due(double t);
    void begin_sensor_outputs();
    void read(double t);
    [[nodiscard]] double output_time(long index) const;

    const Problem* problem_;
    const Observer* observer_;
    const Stepper* stepper_;
    HotSpotFinder hot_spot_finder_;
    SensorOutputs sensor_outputs_;
    std::vector<physics::Inputs> inputs_;  ///< logged ones at the stages of a step
    std::vector<double> channels_;
    std::vector<double> field_;
    std::vector<double> watts_;
    std::vector<double> joules_;
    /// What later rows and warnings depend on, beside the sensors' own state.
    struct State {
        double next_output = 0.0;     ///< s
        double next_field = 0.0;      ///< s
        long outputs = 1;             ///< rows at output times so far, the start included
        std::vector<double> coldest;  ///< [n_effects] K, on the patches of an effect with a range warning
        std::vector<double> hottest;
        std::vector<LayerExtremes> layer_extremes;  ///< [n_layers]
    };
    State now_;
    double seconds_ = 0.0;
};

}  // namespace tiretherm::solver
