// SPDX-License-Identifier: BSD-3-Clause
// Where and when a model and its measured runs differ.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/compare/comparison.hpp"
#include "post/diagnosis/diagnosis_report.hpp"

namespace tiretherm::post {

/// Measured beside simulated, channel by channel with the figures of compare: by run, phase and signal.
/// @param simulated [n_rows] SI
[[nodiscard]] std::vector<diagnosis::ComparedChannel> compare_with_measured(const DiagnosisRecord& record,
                                                                            const Eigen::VectorXd& simulated);

/// Where and when measured and simulated differ, with the base model and, where there is one, with the extended one.
/// Single numbers stand for themselves.
[[nodiscard]] Section residual_breakdown(const DiagnosisRecord& record);

}  // namespace tiretherm::post
