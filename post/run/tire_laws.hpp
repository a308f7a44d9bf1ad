// SPDX-License-Identifier: BSD-3-Clause
// The laws of a case's tire beside what was measured of it: footprint, radii, cornering stiffness, largest loss tangent.
#pragma once

#include <string>
#include <vector>

#include "physics/tire_laws/compound.hpp"
#include "post/report/report.hpp"
#include "solver/problem.hpp"

namespace tiretherm::post {

/// The largest loss tangent of a compound, and its layers.
struct CompoundPeak {
    physics::LossPeak peak;
    std::vector<std::string> layers;
};
/// In the order of the layers; none where the loss is off or measured as a whole.
[[nodiscard]] std::vector<CompoundPeak> compound_peaks(const solver::Problem& problem);

/// Whether the case says or asks something of the cornering stiffness, whose standard moduli are assumptions.
[[nodiscard]] bool shows_stiffness(const solver::Problem& problem);

/// Charts of the laws against the load with measured points; tables of measured and computed values, and of the cornering
/// stiffness where the case has one. Empty without a tire.
[[nodiscard]] ReportSection tire_laws_section(const solver::Problem& problem);
/// loss_tangent_peaks, laws, measured, cornering_stiffness and the units of their numbers; nothing without a tire.
[[nodiscard]] Value tire_laws_data(const solver::Problem& problem);

inline constexpr const char* stiffness_name = "cornering_stiffness.csv";
/// Load, temperature of the bulk and stiffness, a row each; empty where it is not shown.
[[nodiscard]] std::string cornering_stiffness_csv(const solver::Problem& problem);

}  // namespace tiretherm::post
