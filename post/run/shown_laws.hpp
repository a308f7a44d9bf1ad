// SPDX-License-Identifier: BSD-3-Clause
// How the laws of a tire are shown: names, units, and the loads and temperatures at which they are taken.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "post/report/report.hpp"
#include "solver/problem.hpp"

namespace tiretherm::post {

/// A law of the load as it is shown.
struct ShownLaw {
    const char* name;
    const char* key;
    const char* unit;
    double factor;  ///< to it from SI
    int decimals;
    double (physics::Tire::*law)(double load) const;
    std::optional<physics::Curve> physics::MeasuredLaws::*measured;
    const char* chart;  ///< laws of one chart stand below one another
};
inline constexpr std::array shown_laws{
    ShownLaw{"contact length", "contact_length", "mm", 1e3, 1, &physics::Tire::contact_length,
             &physics::MeasuredLaws::contact_length, "Footprint"},
    ShownLaw{"contact area", "contact_area", "cm2", 1e4, 1, &physics::Tire::contact_area,
             &physics::MeasuredLaws::contact_area, "Footprint"},
    ShownLaw{"loaded radius", "loaded_radius", "mm", 1e3, 2, &physics::Tire::loaded_radius,
             &physics::MeasuredLaws::loaded_radius, "Radii"},
    ShownLaw{"rolling radius", "rolling_radius", "mm", 1e3, 2, &physics::Tire::rolling_radius,
             &physics::MeasuredLaws::rolling_radius, "Radii"},
};

/// Round loads, six of them, up to half more than the highest of the drive and what was measured. N
[[nodiscard]] std::vector<double> shown_loads(const solver::Problem& problem);

/// Where the cornering stiffness is shown: a measured table's own points, or round ones.
struct StiffnessMap {
    std::vector<double> loads;         ///< N
    std::vector<double> temperatures;  ///< K
};
[[nodiscard]] StiffnessMap stiffness_map(const solver::Problem& problem);
/// Without camber, at the pressure where the laws hold. @param load N  @param T K, of the bulk  @returns N/rad
[[nodiscard]] double shown_stiffness(const solver::Problem& problem, double load, double T);

/// Footprint and radii against the load, with measured points.
void add_law_charts(ReportSection& section, const solver::Problem& problem);
/// The stiffness against the load, a curve for each temperature, with measured points.
void add_stiffness_chart(ReportSection& section, const solver::Problem& problem);

}  // namespace tiretherm::post
