// SPDX-License-Identifier: BSD-3-Clause
// Unknown heat sources as candidates: heat at a place of the mesh that follows a signal or acts in a time window, and
// what the channels would read of each.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/observations/observations.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// Where heat may enter: nodes with their shares of a watt.
struct HeatPlace {
    std::string name;
    mesh::Functional nodes;  ///< weights sum to 1
};
/// Regions, layers, zones and patches, as a [[source]] names them, each set of nodes once.
/// @param all otherwise regions, patches and zones alone, or layers where there are no zones
[[nodiscard]] std::vector<HeatPlace> heat_places(const solver::Problem& problem, bool all);

/// A signal that a source may follow, in every run.
struct SourceSignal {
    std::string follows;  ///< a logged signal or a formula of signals, as a [[source]] has it
    std::string unit;
    std::vector<std::vector<double>> time;   ///< [n_runs][n] s
    std::vector<std::vector<double>> value;  ///< [n_runs][n], linear between
    double largest = 0.0;                    ///< absolute value over all runs
};
/// Inputs and products of them, and the columns that the model does not use and that may be causes
/// (UnusedSignal::may_be_cause). Those that never change are left out but for "1".
/// @param all otherwise a few that stand for the rest
[[nodiscard]] std::vector<SourceSignal> source_signals_of(const input::Experiment& experiment, bool all);

/// A source that no effect of the catalogue is: heat at a place that follows a signal, or a reading that does.
struct UnknownTerm {
    std::size_t place = 0;   ///< index into the places, or of Problem::channels for a sensor
    std::size_t signal = 0;  ///< index into the signals; of an event nothing
    bool sensor = false;     ///< the reading changes, not the heat
    bool event = false;      ///< constant heat over a window of one run
    std::size_t run = 0;     ///< of an event
    double from = 0.0;       ///< s, of an event
    double to = 0.0;
};

/// Unknown sources and what the channels would read of each.
struct CandidateSources {
    std::vector<HeatPlace> places;
    std::vector<SourceSignal> signals;
    std::vector<UnknownTerm> terms;  ///< events last
    Eigen::Index n_followers = 0;    ///< terms that follow a signal
    Eigen::MatrixXd columns;         ///< [n_rows][n_terms] SI per unit of the signal's largest value, per W of an event
};

/// @param problems [n_runs] at the fitted values  @param steps [n_runs] that they take
/// A source costs a run of the linear equations: on meshes of more than 50 nodes a few places and signals stand for all,
/// and there are no events.
/// @param windows that each run is divided into for events
[[nodiscard]] CandidateSources candidate_sources_of(const input::Experiment& experiment,
                                                    const Observations& observations,
                                                    const std::vector<solver::Problem>& problems,
                                                    const std::vector<std::vector<double>>& steps, int windows);

/// Constant heat at each place in each of some windows of one run, window by window. @returns columns of all rows, zero in those of
/// other runs
[[nodiscard]] CandidateSources events_of_run(std::size_t run, const Observations& observations,
                                             const solver::Problem& problem, const std::vector<double>& steps,
                                             std::vector<HeatPlace> places, int windows);

}  // namespace tiretherm::diagnosis
