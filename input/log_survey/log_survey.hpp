// SPDX-License-Identifier: BSD-3-Clause
// What is in a data logger's file: format, channels with rate and range and what they would be used as, laps, doubts.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/laps/laps.hpp"
#include "input/new_case/log_columns.hpp"
#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// A column of a logger's file.
struct ColumnSurvey {
    std::string name;
    std::string unit{};           ///< as written; empty: none
    double rate = 0.0;            ///< Hz, of the samples that have a value; 0: fewer than two
    std::size_t samples = 0;      ///< with a value
    double missing = 0.0;         ///< share of the samples that its rate announces
    std::optional<double> low{};  ///< in `unit`, of a clock s; nothing without a value
    std::optional<double> high{};
    std::string use{};         ///< "time", "input", "sensor", "laps", "course", or empty
    std::string used_as{};     ///< the name that the model has for it, "surface_temperature of FL"; empty: none
    std::string suggestion{};  ///< a name that it may have
    std::string reason{};      ///< why it is not used
    bool is_dropped = false;   ///< it is the suggestion, and has too little in it
};

/// A file as a whole.
struct LogSurvey {
    std::string path;
    LogDescription description{};
    double from = 0.0;  ///< s
    double to = 0.0;
    std::size_t rows = 0;
    std::vector<ColumnSurvey> columns{};
    Laps laps{};
    std::vector<std::string> doubts{};  ///< sentences
};

/// Looks at a file as `tiretherm new` would use it, on a cross-section of a tire.
/// @param units as read_log takes them
/// @returns nothing after an error
[[nodiscard]] std::optional<LogSurvey> survey_log(const std::filesystem::path& path,
                                                  const std::vector<GivenUnit>& units, InputErrors& errors);

/// Whether a file is a log by the ending of its name: .csv, .ld, .ibt ..., and those that only their makers' programs read.
[[nodiscard]] bool is_log_file(const std::filesystem::path& path);

}  // namespace tiretherm::input
