// SPDX-License-Identifier: BSD-3-Clause
// The measured numbers of a validation table as data of a diagnosis: what one model says of each, how uncertain both are,
// and which of them belong to one experiment.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/validation/validation_table.hpp"
#include "input/validation/validation.hpp"

/// Numbers that a source quotes, over many experiments: what explains them.
namespace tiretherm::diagnosis::quoted {

/// A quoted number and what the model says of it, in the unit in which it is shown.
struct QuotedResult {
    std::size_t number = 0;  ///< index into Validation::numbers and into the rows of the table
    std::string id;
    std::string what;
    std::string unit;
    double low = 0.0;  ///< measured; an open end is infinite
    double high = 0.0;
    double uncertainty = 0.0;  ///< standard: as stated; of an order the median of those stated in its unit
    double spread = 0.0;       ///< standard uncertainty that inputs leave which the source does not print
    double value = 0.0;        ///< simulated
    bool is_open = false;      ///< an order or a sign
    bool decidable = false;    ///< as `validate` says
    std::size_t experiment = 0;

    /// Standard uncertainty of simulated less measured.
    [[nodiscard]] double total() const;
    /// Simulated less measured, to the nearest end of a range; 0 inside it. @param simulated in the row's unit
    [[nodiscard]] double residual(double simulated) const;
    /// A temperature or a difference of two.
    [[nodiscard]] bool is_temperature() const { return unit == "degC" || unit == "K"; }
};

/// An input that the source does not print, with what it changes.
struct UnknownInput {
    std::string name;
    std::string unit;                          ///< empty where its range is words
    double value = 0.0;                        ///< as the cases have it; the middle of its range where it was inferred
    std::vector<double> at;                    ///< [points] in its unit, ascending; where it is words 0, 1, 2 ...
    std::vector<std::vector<double>> changes;  ///< [points][rows], of the row's value; 0 where it does not act
    bool is_number = false;

    /// Mean product of its changes of two rows when the input is anywhere in its range, all values alike: their
    /// covariance about the values that the cases have.
    [[nodiscard]] double covariance(std::size_t row, std::size_t other) const;
};

/// All numbers of a table that one model gives and that were measured.
struct Numbers {
    std::vector<QuotedResult> rows;
    std::vector<std::string> experiments;  ///< "M4, M5, M14": ids whose numbers are read from the same tests
    std::vector<UnknownInput> inputs;
    std::size_t without_scale = 0;    ///< numbers left out: an order in a unit in which no uncertainty is stated
    std::size_t about_the_model = 0;  ///< numbers left out: the source says them of its own model

    /// Covariance of the residuals of some rows: their own uncertainties, and that of the inputs that they share.
    /// @param free index of an input that is fitted and adds nothing; -1: none   @returns [of.size()][of.size()]
    [[nodiscard]] Eigen::MatrixXd covariance(const std::vector<std::size_t>& of, const std::vector<int>& free) const;
};

/// @param model index into Validation::models   @param table rows as `validation_rows` makes them, of all its numbers
[[nodiscard]] Numbers quoted_numbers(const input::Validation& validation, const std::vector<ValidationRow>& table,
                                     std::size_t model);

}  // namespace tiretherm::diagnosis::quoted
