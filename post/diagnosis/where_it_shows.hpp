// SPDX-License-Identifier: BSD-3-Clause
// Where, when and after which signal a model is wrong, and what that leaves open for other runs, in two or three sentences.
#pragma once

#include <string>

#include "post/diagnosis/diagnosis_report.hpp"

namespace tiretherm::post {

/// Of the sensor that is most of its standard deviations off: "surface_temperature is 2.2 K rms off beyond its noise: +2.0 K while
/// slipping, -2.0 K while free rolling; most in run3. ..."; empty where nothing is left.
[[nodiscard]] std::string where_it_shows(const DiagnosisRecord& record);
/// "speeds up to 162 km/h and vertical loads up to 6.6 kN": how far the runs go; empty where they give neither.
[[nodiscard]] std::string driven_range(const DiagnosisRecord& record);
/// " The greater part of what is wrong with surface_temperature is left ..."; empty where each sensor has lost it.
[[nodiscard]] std::string hardly_explained(const DiagnosisRecord& record);
/// That of what drifts in the only run nobody knows the next; empty where nothing does.
[[nodiscard]] std::string drift_of_the_run(const DiagnosisRecord& record);

}  // namespace tiretherm::post
