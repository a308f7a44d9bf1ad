// SPDX-License-Identifier: BSD-3-Clause
// Names, sizes and the interpretation of a diagnosis in plain sentences.
#pragma once

#include <string>
#include <vector>

#include "post/diagnosis/diagnosis_report.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

/// "sidewall_convection", "sensor_lag of bulk_temperature"
[[nodiscard]] std::string name_of(const diagnosis::Cause& cause);
/// "conductance 8.1 W/K (7.2 to 9.0)", every number with its interval; one that was held has none.
[[nodiscard]] std::string size_of(const diagnosis::Cause& cause);
[[nodiscard]] std::string size_of(const diagnosis::CauseNumber& number);
/// The fitted numbers of a cause by their keys.
[[nodiscard]] Value parameters_data(const diagnosis::Cause& cause);
/// What an effect does to the readings, as the catalogue says it; empty for one that is not there.
[[nodiscard]] std::string meaning_of(const diagnosis::Cause& cause);
/// "heat at surface that follows throttle: 310 W where that is largest (250 to 370)"
[[nodiscard]] std::string text_of(const diagnosis::UnknownSource& unknown, const input::Experiment& experiment);
/// W of heat, or what differences of a channel's readings are shown in.
[[nodiscard]] solver::ShownUnit unit_of(const diagnosis::UnknownSource& unknown, const input::Experiment& experiment);
/// "coast-down from 150 km/h, 5 min: from 1.2 to 7 sigma"
[[nodiscard]] std::string text_of(const diagnosis::NextExperiment& next);
/// "stopped during the search of causes, at candidate 7 of 23 (inner_gas). This stage needs about 40 s more."
[[nodiscard]] std::string stop_text(const diagnosis::Diagnosis& diagnosis);
/// A time of work to two digits: "12 s".
[[nodiscard]] std::string seconds_text(double seconds);
/// How sure the verdict is and why, and what to do next: a sentence each.
[[nodiscard]] std::vector<std::string> certainty_of(const DiagnosisRecord& record);
/// The verdict as a thermal engineer would say it.
[[nodiscard]] std::string reason_of(const DiagnosisRecord& record);

/// What a fault of the data is called among causes: "unit", "channel_swap".
[[nodiscard]] std::string id_of(const diagnosis::DataFault& fault);

}  // namespace tiretherm::post
