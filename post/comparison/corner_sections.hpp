// SPDX-License-Identifier: BSD-3-Clause
// The tires of a car beside each other, by corner and lap by lap.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/compare/observed_comparison.hpp"
#include "post/laps/lap_rows.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// Each channel run by run: its laps, then the whole run. @param run_names [n_runs]
[[nodiscard]] std::vector<LapRow> lap_rows(const std::vector<diagnosis::ComparedChannel>& channels,
                                           const std::vector<std::string>& run_names);
/// The same of what a fit leaves; empty where the case has no corners and no run several laps.
/// @param simulated [n_rows of the observations] SI
[[nodiscard]] std::vector<LapRow> observed_lap_rows(const input::Experiment& experiment,
                                                    const diagnosis::Observations& observations,
                                                    const Eigen::VectorXd& simulated);
/// Each channel by corner with what the corners have in common, then lap by lap. Neither where the case has no corners, or no run
/// several laps.
/// @param run_names [n_runs]  @param of_model behind the headings, such as " after the fit"; may be empty
void add_corners_and_laps(Report& report, const std::vector<diagnosis::ComparedChannel>& channels,
                          const std::vector<std::string>& run_names, const std::string& of_model = {});
/// The same of what a fit leaves. @param simulated [n_rows of the observations] SI
void add_observed_corners(Report& report, const input::Experiment& experiment,
                          const diagnosis::Observations& observations, const Eigen::VectorXd& simulated,
                          const std::string& of_model);

}  // namespace tiretherm::post
