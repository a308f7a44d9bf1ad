// SPDX-License-Identifier: BSD-3-Clause
// The ways in which the columns of a log may be labelled wrongly: a unit that is another one, two columns that were exchanged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/observations/observations.hpp"
#include "input/measurements/experiment.hpp"
#include "input/parameters/column_change.hpp"

namespace tiretherm::diagnosis {

/// Runs that share a fault: all, those of one recording, or all but those.
struct FaultScope {
    std::vector<std::size_t> runs;        ///< indices into Experiment::runs
    std::vector<std::string> recordings;  ///< by their names; empty: all there are
};
[[nodiscard]] std::vector<FaultScope> fault_scopes(const input::Experiment& experiment);

/// A column by what the model takes it for.
struct LabelledColumn {
    std::string name;  ///< of the input or the sensor
    bool is_input = false;

    friend bool operator==(const LabelledColumn& a, const LabelledColumn& b) = default;
};

/// Columns whose labels may be wrong, whatever the runs in which they are.
struct Relabelling {
    enum class Kind : std::uint8_t {
        unit,
        exchange,
        mirror  ///< the inputs are those of the wheel on the other side
    };
    Kind kind = Kind::unit;
    std::vector<LabelledColumn> columns;  ///< of an exchange two
    std::string unit{};                   ///< in which the numbers of all of them are then

    [[nodiscard]] bool touches_inputs() const;
};
/// All that the columns' sizes allow: each column and all temperatures together in another unit, each two sensors of one
/// quantity exchanged, each two inputs of one; and the inputs of the other wheel of an axle, where the case is of one tire.
[[nodiscard]] std::vector<Relabelling> relabellings(const input::Experiment& experiment);

/// Whether all runs of the scope have the columns, and their sizes allow it. Inputs that make heat are wrong in all runs or in none:
/// of some runs alone other causes look the same.
[[nodiscard]] bool is_possible(const Relabelling& what, const FaultScope& scope, const input::Experiment& experiment);

/// How a case says so. @returns none where it is not possible, or where no key of a case says it: of mirrored inputs
[[nodiscard]] std::vector<input::ColumnChange> changes_of(const Relabelling& what, const FaultScope& scope,
                                                          const input::Experiment& experiment);

/// The columns of a relabelling in a run, in its order. @returns none where the run lacks one
[[nodiscard]] std::vector<const input::ReadColumn*> columns_in(const Relabelling& what, const input::MeasuredRun& run);

/// Rows that sensors of logs have read: no images, and no single numbers.
[[nodiscard]] std::vector<Eigen::Index> sensor_rows(const Observations& observations);

/// What the sensors read if the relabelling is right in all runs. @returns [n_rows] SI, NaN where the other sensor has no sample
[[nodiscard]] Eigen::VectorXd relabelled(const Relabelling& what, const input::Experiment& experiment,
                                         const Observations& observations);

/// Gives runs the inputs of the other wheel: what the load of a run is less than its mean it is more there, the lateral force goes
/// with the load, and the signs of lateral force, slip angle and camber turn. @param runs indices into Experiment::runs
void mirror_inputs(input::Experiment& experiment, const std::vector<std::size_t>& runs);

}  // namespace tiretherm::diagnosis
