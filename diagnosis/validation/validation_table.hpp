// SPDX-License-Identifier: BSD-3-Clause
// A validation table as data: measured numbers with uncertainty beside those of each model, what the inputs that the
// source does not print make of them, verdicts, and the figures of each model.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/validation/validation.hpp"

/// Measured numbers beside those of the models.
namespace tiretherm::diagnosis {

/// A number as one model gives it.
struct ModelValue {
    bool applicable = false;      ///< false: the model has no such number
    std::optional<double> value;  ///< in the row's unit; empty when its run failed
    std::string failure;          ///< why, otherwise empty
};

/// An input of the experiment, and what the models give where it is at an end of its range.
struct InputEffect {
    std::string name;
    std::string meaning;
    std::string_view standing;      ///< "printed", "inferred" or "assumed"
    bool inferred_from_it = false;  ///< from this very number
    std::string value;
    std::vector<std::string> ends;                            ///< of its range; empty of a printed one
    std::string unit;                                         ///< of `numbers`
    std::vector<double> numbers;                              ///< the ends; empty where they are words
    std::vector<std::vector<std::optional<double>>> at_ends;  ///< [models][ends] row's unit; empty: it does not act
};

/// One number, in the unit in which it is shown.
struct ValidationRow {
    std::string id;    ///< of the experiment
    std::string what;  ///< which number
    std::string unit;  ///< degC of a temperature, K of a difference of two, 1 of a ratio
    std::string source;
    bool is_measured = false;
    double low = -std::numeric_limits<double>::infinity();  ///< measured; an open end is infinite
    double high = std::numeric_limits<double>::infinity();
    double uncertainty = 0.0;  ///< standard; 0 where there is none
    std::vector<std::pair<std::string, double>> parts;
    std::vector<ModelValue> models;   ///< [models of the record]
    std::vector<InputEffect> inputs;  ///< all that are named

    /// "falls", "hotter than": only one end was measured.
    [[nodiscard]] bool is_open() const;
};

/// Model less measured, to the nearest end of a range; 0 inside it. Empty where one of the two is missing.
[[nodiscard]] std::optional<double> difference(const ValidationRow& row, std::size_t model);

/// How far the inputs that the source does not print can move a simulated number, each to both ends of its range by
/// itself: root of the sum of squares of their changes upwards and downwards.
struct Reach {
    double down = 0.0;  ///< >= 0, row's unit
    double up = 0.0;    ///< >= 0
    double spread =
        0.0;             ///< standard uncertainty: each input even over its larger change d, d/sqrt(3); root-sum-square
    std::string widest;  ///< the input with the largest change; empty where there is none
};
/// @pre the model has a value
[[nodiscard]] Reach reach(const ValidationRow& row, std::size_t model);

/// Standard uncertainty of a difference: of the measured number and of the inputs that the source does not print.
[[nodiscard]] double total_uncertainty(const ValidationRow& row, std::size_t model);

/// d(simulated number)/d(input) between the two ends of its range, row's unit over the input's.
/// @returns nothing where the ends are words, or the input does not act on the model
[[nodiscard]] std::optional<double> sensitivity(const InputEffect& input, std::size_t model);

/// What a number says of a model.
enum class Judgement : std::uint8_t {
    none,       ///< nothing was measured, or the model has no such number
    no_result,  ///< a run failed
    passes,  ///< within twice the measured uncertainty, wherever the inputs are in their ranges; an order holds there
    fails,   ///< outside it, on the same side wherever the inputs are, and by more than twice the total one
    not_decidable  ///< otherwise: the inputs decide; or an input was inferred from this very number
};
[[nodiscard]] Judgement judge(const ValidationRow& row, std::size_t model);

/// A table with what it took to make it.
struct ValidationRecord {
    std::string title;
    std::vector<input::ValidationModel> models;
    std::vector<ValidationRow> rows;
    std::size_t runs = 0;
    double seconds = 0.0;         ///< wall time
    double energy_closure = 0.0;  ///< largest of all runs
    std::vector<std::string> warnings;
};

/// A model against the experiments: its temperatures that have a measured value and an uncertainty, and its orders. Only
/// numbers that can be decided count.
struct ModelFigures {
    std::size_t temperatures = 0;  ///< how many
    double bias = 0.0;             ///< K, mean difference
    double rms = 0.0;              ///< K, root of the mean square difference
    double scatter = 0.0;          ///< K, standard deviation about the bias less what the total uncertainty explains
    std::size_t within = 0;        ///< temperatures that pass
    std::size_t orders = 0;        ///< statements of order or sign
    std::size_t holding = 0;
    std::size_t not_decidable = 0;  ///< measured numbers of any kind that count nowhere above
};
/// @param common only numbers that every model gives and that can be decided for each
[[nodiscard]] ModelFigures figures(const ValidationRecord& record, std::size_t model, bool common);

}  // namespace tiretherm::diagnosis
