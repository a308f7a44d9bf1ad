// SPDX-License-Identifier: BSD-3-Clause
// A completed study as data: varied quantities, the shape of its grid, samples, and the outcome of each run.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "solver/problem.hpp"
#include "solver/time_integration/law_ranges.hpp"

namespace tiretherm::diagnosis {

/// What one run of a study came to. The numbers have no meaning where it failed.
struct StudyOutcome {
    std::string failure;        ///< the solver's sentence; empty when it came to its end
    double hottest = 0.0;       ///< K, highest temperature of the whole field over the whole run
    double hottest_time = 0.0;  ///< s
    std::string hottest_layer{};
    std::string hottest_zone{};           ///< of a section; empty elsewhere
    std::vector<double> channel_final{};  ///< [channels] SI
    std::vector<double> channel_min{};
    std::vector<double> channel_max{};
    double energy_closure = 0.0;
    long steps = 0;
    /// The hottest place of a part with a critical temperature, over the rows of the run.
    struct Part {
        double hottest = 0.0;   ///< K
        double critical = 0.0;  ///< K
        friend bool operator==(const Part&, const Part&) = default;
    };
    std::vector<Part> parts{};                     ///< [[[critical]] of the case]
    std::vector<solver::RangeWarning> warnings{};  ///< where it left the range of a law

    [[nodiscard]] bool ok() const { return failure.empty(); }
    friend bool operator==(const StudyOutcome&, const StudyOutcome&) = default;
};

/// A quantity that a study varies, with its value in each run.
struct StudyColumn {
    std::string key;      ///< path in the case
    std::string unit;     ///< as the user wrote it; empty for a pure number and for words
    std::string udunits;  ///< the same as UDUNITS reads it
    bool is_number = true;
    bool is_drawn = false;
    std::vector<std::string> texts;  ///< [runs] as the case has it
    std::vector<double> numbers;     ///< [runs] in `unit`; NaN for a word

    /// "drive.speed [km/h]", as a column or an axis is headed.
    [[nodiscard]] std::string heading() const;
};

/// Where runs left the ranges of laws, a sentence for each law: in how many runs, and how far. @param of_runs [runs]
[[nodiscard]] Remarks left_ranges(const std::vector<std::vector<solver::RangeWarning>>& of_runs);

/// A study that has been run.
struct StudyRecord {
    std::string title;
    std::string study_file;
    std::string study_text;
    std::string case_file;
    std::string case_name;
    std::string version;
    std::optional<double> critical;    ///< K
    std::vector<StudyColumn> columns;  ///< first those of the grid, the slowest first; then those that are drawn
    std::vector<std::size_t> sides;    ///< [grid] number of values of each side
    std::size_t samples = 1;           ///< runs at each point of the grid, side by side; 1 where nothing is drawn
    bool is_sampled = false;
    std::vector<solver::Channel> channels;
    std::vector<std::string> parts{};    ///< names of the case's critical temperatures
    std::vector<StudyOutcome> outcomes;  ///< [runs]
    std::vector<std::string> warnings;

    [[nodiscard]] std::size_t points() const { return outcomes.size() / samples; }
    [[nodiscard]] std::vector<std::size_t> failed() const;  ///< indices of the runs that failed
    [[nodiscard]] Remarks left_ranges() const;
    /// Keys that changed nothing: the numbers of every run are those of its neighbour with another value of the key.
    [[nodiscard]] std::vector<std::string> without_effect() const;
};

}  // namespace tiretherm::diagnosis
