// SPDX-License-Identifier: BSD-3-Clause
// Compares a diagnosis with what is hidden in its data set and marks it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "exam/exam_data_set_truth.hpp"

namespace hidden_effects {

/// What a diagnosis of a data set is worth, by the exam's rules. What does not apply to a data set's kind stays as it
/// is here.
struct Mark {
    std::string bench = "two_node";
    Kind kind = Kind::nothing;
    std::uint64_t seed = 0;
    double sigma = 0.0;
    std::string answer;        ///< what is true
    std::string verdict;       ///< the word, or why there is none
    std::string first;         ///< the first hypothesis, "a + b" for a pair; the verdict where there is none
    std::string set;           ///< every hypothesis
    bool detected = false;     ///< something was hidden and something was found; "cannot tell" finds nothing
    bool false_alarm = false;  ///< nothing was hidden, and any verdict but "consistent" came
    bool first_right = false;  ///< the first hypothesis is the truth, no more and no less
    /// That, or the first name correlates with the truth beyond 0.95 and the truth is in the set.
    bool first_right_or_alike = false;
    bool in_set = false;            ///< the truth is one of the hypotheses
    bool only_right = false;        ///< named, and it is the truth and nothing else
    std::optional<double> apart{};  ///< standard deviations that the nearest other hypothesis of a pair misses
    /// One hypothesis with confidence, and a name in it is not true.
    bool wrong_with_confidence = false;
    bool named_though_unknown = false;  ///< an unknown that got names of the catalogue
    bool unknown = false;               ///< an unknown that was called one
    bool place_right = false;
    bool signal_right = false;
    std::optional<bool> size_held{};  ///< whether the interval of the true cause's number holds the truth
    std::optional<double> removed{};  ///< share of the removable error that is gone from held-out runs
    bool confirmed = false;
    double numerical_error_sigma = 0.0;
    long simulations = 0;
    double seconds = 0.0;           ///< of the diagnosis, by the clock
    double draw_seconds = 0.0;      ///< of the processor: to draw the data set and to mark it,
    double diagnose_seconds = 0.0;  ///< and to diagnose it; both only where one data set is evaluated at a time

    /// What is wrong with the diagnosis, "missed", "the truth is not in the set"; empty where nothing is.
    [[nodiscard]] std::string faults() const;
};

[[nodiscard]] Mark mark_of(const ExamDataSet& data_set, const tiretherm::diagnosis::Diagnosis& diagnosis);

/// "sidewall_convection", "sensor_lag of bulk_temperature", "layer_heat_capacity in surface"
[[nodiscard]] std::string name_of(const tiretherm::diagnosis::Cause& cause);

}  // namespace hidden_effects
