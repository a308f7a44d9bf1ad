// SPDX-License-Identifier: BSD-3-Clause
// Laps of the made-up car as other loggers write them: MoTeC (CSV and .ld), RaceChrono, VBOX.
#pragma once

#include <string>
#include <vector>

#include "car/car_log_truth.hpp"

namespace hidden_effects {

/// A file of cases/car/loggers.
struct LoggerFile {
    std::string name;
    std::string content;
};

/// Three laps, five samples a second, of the car of cases/car/session.toml: the same values in each layout, under the names and in the
/// units that its logger has for them. The .ldx beside the .ld has its beacons.
[[nodiscard]] std::vector<LoggerFile> shipped_logger_files();
/// The laps in them, from which they are written.
[[nodiscard]] Session shipped_logger_session();

}  // namespace hidden_effects
