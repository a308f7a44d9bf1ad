// SPDX-License-Identifier: BSD-3-Clause
// Where, when and after which signal a model is wrong, in two or three sentences.
#pragma once

#include <string>

#include "post/diagnosis/diagnosis_report.hpp"

namespace tiretherm::post {

/// Of the sensor that is most of its standard deviations off: "surface_temperature is 2.2 K rms off beyond its noise: +2.0 K while
/// slipping, -2.0 K while free rolling; most in run3. ..."; empty where nothing is left.
[[nodiscard]] std::string where_it_shows(const DiagnosisRecord& record);

}  // namespace tiretherm::post
