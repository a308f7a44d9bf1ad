// SPDX-License-Identifier: BSD-3-Clause
// A validation table as data: measured numbers with uncertainty beside those of each model, verdicts, and the figures
// of each model.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Measured numbers beside those of the models.
namespace tiretherm::diagnosis {

/// A number as one model gives it.
struct ModelValue {
    bool applicable = false;      ///< false: the model has no such number
    std::optional<double> value;  ///< in the row's unit; empty when its run failed
    std::string failure;          ///< why, otherwise empty
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
    std::vector<ModelValue> models;  ///< [models of the record]

    /// "falls", "hotter than": only one end was measured.
    [[nodiscard]] bool is_open() const;
};

/// Model less measured, to the nearest end of a range; 0 inside it. Empty where one of the two is missing.
[[nodiscard]] std::optional<double> difference(const ValidationRow& row, std::size_t model);

/// "within (0.7 u)" up to 2 u, "3.1 u too hot" beyond; "holds" or "does not hold" of an open range; "failed"; empty
/// where nothing was measured.
[[nodiscard]] std::string verdict(const ValidationRow& row, std::size_t model);

/// A model as programs and as people call it.
struct ModelName {
    std::string key;   ///< "two_node"
    std::string name;  ///< "two nodes"
};

/// A table with what it took to make it.
struct ValidationRecord {
    std::string title;
    std::vector<ModelName> models;
    std::vector<ValidationRow> rows;
    std::size_t runs = 0;
    double seconds = 0.0;         ///< wall time
    double energy_closure = 0.0;  ///< largest of all runs
    std::vector<std::string> warnings;
};

/// A model against the experiments: its temperatures that have a measured value and an uncertainty, and its orders.
struct ModelFigures {
    std::size_t temperatures = 0;  ///< how many
    double bias = 0.0;             ///< K, mean difference
    double rms = 0.0;              ///< K, root of the mean square difference
    double scatter = 0.0;          ///< K, standard deviation about the bias less what the measurements' own explains
    std::size_t within = 0;        ///< temperatures within 2 u
    std::size_t orders = 0;        ///< statements of order or sign
    std::size_t holding = 0;
};
/// @param common only numbers that every model gives
[[nodiscard]] ModelFigures figures(const ValidationRecord& record, std::size_t model, bool common);

}  // namespace tiretherm::diagnosis
