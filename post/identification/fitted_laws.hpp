// SPDX-License-Identifier: BSD-3-Clause
// Material laws that a fit has changed, with their intervals, and the fitted parameters: as values and as tables.
#pragma once

#include <string>
#include <vector>

#include "post/identification/identification_report.hpp"

namespace tiretherm::post {

/// k(T) or c(T) of a material, before and after a fit.
struct FittedLaw {
    std::string material;
    const char* key;               ///< "conductivity", "conductivity_along", "heat_capacity"
    const char* name;              ///< "conductivity through the thickness"
    const char* unit;              ///< W/(m K) or J/(kg K)
    std::vector<double> before{};  ///< [temperatures] of the case
    std::vector<double> fitted{};  ///< [temperatures]
    /// [temperatures] standard deviation to first order, from the intervals of the parameters and their correlation; empty where
    /// a parameter that moves the law has no interval
    std::vector<double> deviation{};
};

/// The laws of a fit over one range of temperatures.
struct FittedLaws {
    std::vector<double>
        celsius;  ///< [temperatures] from the lowest to the highest that a sensor or a camera has measured
    std::vector<FittedLaw> laws;  ///< those that the fit has changed; isotropic materials have no law along the surface
};
[[nodiscard]] FittedLaws fitted_laws(const IdentificationRecord& record);

/// Half the width of a law's 95 % interval over its standard deviation.
inline constexpr double to_95 = 1.959964;

/// A row for each temperature: `TREAD conductivity [W/(m K)]`, `... case`, `... low` and `... high` (95 %) of each law.
[[nodiscard]] std::string laws_csv(const FittedLaws& laws);
/// A row for each parameter: fitted value, standard deviation, 95 % interval, what was known before, what the data say, and the
/// correlation with each parameter.
[[nodiscard]] std::string parameters_csv(const IdentificationRecord& record);

}  // namespace tiretherm::post
