// SPDX-License-Identifier: BSD-3-Clause
// Signals with which the differences between simulation and measurement may be associated.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "input/measurements/experiment.hpp"
#include "physics/signals.hpp"

namespace tiretherm::diagnosis {

/// A sample of a channel, as far as differences may follow it.
struct SampleContext {
    const input::MeasuredRun& run;  ///< of the experiment that the regressors are of
    std::size_t sample = 0;         ///< of the run's log
    const physics::Inputs& inputs;
    double simulated = 0.0;
    bool is_temperature = true;
};

/// A signal that differences are compared with: a function, or a column of the log.
struct Regressor {
    std::string name;
    std::string unit;
    std::function<double(const SampleContext&)> value{};  ///< in its unit, NaN where it is missing; empty: a column
    std::vector<solver::SharedSamples> column{};          ///< [runs] empty where a run has none
};

/// Time, the inputs that make or carry heat, the simulated rise over the air, and the columns that no model uses. The
/// rise is the simulated one: the measured one shares its noise with the differences and would follow them by itself.
/// @param experiment must outlive them
[[nodiscard]] std::vector<Regressor> regressors_of(const input::Experiment& experiment);

/// Adds a sample of those that are functions. @param into [n_regressors]
void add_values(const std::vector<Regressor>& regressors, const SampleContext& moment,
                std::vector<std::vector<double>>& into);
/// Adds those that are columns of the log. @param samples of a run  @param into [n_regressors]
void add_columns(const std::vector<Regressor>& regressors, std::size_t run, std::span<const std::size_t> samples,
                 std::vector<std::vector<double>>& into);

}  // namespace tiretherm::diagnosis
