// SPDX-License-Identifier: BSD-3-Clause
// Judges additions on experiments that took no part in fitting their numbers: each experiment is left out in turn.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "diagnosis/quoted/addition.hpp"
#include "diagnosis/quoted/interactions.hpp"
#include "diagnosis/quoted/quoted_numbers.hpp"

namespace tiretherm::diagnosis::quoted {

/// A share with its 95 % interval.
struct ShareInterval {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// The numbers of some additions as they fit some experiments.
struct AdditionFit {
    std::vector<double> values{};  ///< [additions]
    std::vector<double> low{};     ///< [additions] 95 %, the others fitted anew; widened where the rest does not fit
    std::vector<double> high{};
    std::vector<bool> is_bound{};   ///< [additions] the fit ended at an end of the plausible range
    std::vector<double> changes{};  ///< [rows] of the model's value, of all rows
    double chi_squared = 0.0;       ///< of the rows that were fitted
    double cost = 0.0;              ///< that, and what each number pays for its range
};

/// How well additions predict experiments that they were not fitted to. rms are over the rows that count.
struct HeldOut {
    std::vector<double> changes{};  ///< [rows] predicted with the row's experiment left out
    double rms_before = 0.0;        ///< in units of the total uncertainty
    double rms_after = 0.0;
    double kelvin_before = 0.0;  ///< of the temperatures and their differences
    double kelvin_after = 0.0;
    ShareInterval removed{};  ///< 1 - after/before of the rms; the interval by a bootstrap over experiments
    std::vector<std::size_t>
        better{};  ///< experiments whose own rms falls by more than a tenth of the total uncertainty
};

/// Indices of additions that are made together, none twice.
using AdditionSet = std::vector<std::size_t>;

/// Numbers, the rows of them that count, and the additions that are tried; holds what all fits share.
class Judge {
public:
    static constexpr auto none = static_cast<std::size_t>(-1);

    /// @param counts [rows] which rows are fitted and judged   @param additions that can be simulated
    /// @param interactions of these additions; null: they add up
    Judge(const Numbers& numbers, std::vector<bool> counts, const std::vector<Addition>& additions,
          const Interactions* interactions = nullptr);

    /// Fits the numbers of some additions to all experiments but those left out, each with its plausible range as two
    /// standard deviations: what the experiments do not ask for stays where it changes nothing.
    [[nodiscard]] AdditionFit fit(const AdditionSet& chosen, const std::vector<std::size_t>& left_out) const;
    /// To all experiments, without the intervals, which cost most of it.
    [[nodiscard]] AdditionFit fit_alone(const AdditionSet& chosen) const;
    /// Leaves out each experiment in turn.
    /// @param reference [rows] changes of the model that is improved upon, as predicted for each row; empty: none
    [[nodiscard]] HeldOut held_out(const AdditionSet& chosen, const std::vector<double>& reference = {}) const;
    /// The same, where the set itself is chosen anew without the experiment that is left out. It shows how far the choice can be
    /// trusted.
    /// @param choose a set by all experiments but one
    [[nodiscard]] HeldOut held_out_choice(const std::function<AdditionSet(std::size_t without)>& choose,
                                          const std::vector<double>& reference = {}) const;
    /// Root of the mean square of what is predicted of each experiment by the others, in total uncertainties.
    /// @param without an experiment that takes no part; none: all take part
    [[nodiscard]] double left_out_error(const AdditionSet& chosen, std::size_t without = none) const;
    /// Experiments with rows that count.
    [[nodiscard]] const std::vector<std::size_t>& experiments() const { return experiments_; }
    /// Which of them have a row further off than 2 of its total uncertainties.
    [[nodiscard]] std::vector<std::size_t> off(const std::vector<double>& changes) const;
    /// Residuals in units of the total uncertainty, of the rows that count; 0 of the others.
    /// @param changes [rows]   @returns [rows]
    [[nodiscard]] std::vector<double> scores(const std::vector<double>& changes) const;
    /// @param changes [rows]   @returns chi squared of the rows that count, with what they share
    [[nodiscard]] double chi_squared(const std::vector<double>& changes) const;
    /// Root of the mean square of these.
    [[nodiscard]] double rms(const std::vector<double>& changes) const;
    [[nodiscard]] std::size_t n_rows() const;
    /// Whether the addition changes any row that counts by more than a tenth of its total uncertainty.
    [[nodiscard]] bool matters(std::size_t addition) const;

private:
    struct Block {
        std::size_t experiment = 0;
        std::vector<std::size_t> rows;
        Eigen::MatrixXd whitening;  ///< inverse of the Cholesky factor
    };
    [[nodiscard]] std::vector<Block> blocks(const std::vector<std::size_t>& chosen) const;
    [[nodiscard]] double cost(const std::vector<Block>& blocks, const std::vector<std::size_t>& left_out,
                              const std::vector<double>& changes) const;
    [[nodiscard]] AdditionFit fit(const std::vector<Block>& blocks, const std::vector<std::size_t>& chosen,
                                  const std::vector<std::size_t>& left_out, bool with_interval) const;
    /// For the rows of each experiment what is predicted without it; 0 of one that stays out of all.
    [[nodiscard]] std::vector<double> leave_out_each(
        const std::function<std::vector<double>(std::size_t experiment)>& changes_without,
        std::size_t but = none) const;
    [[nodiscard]] HeldOut summary(std::vector<double> changes, const std::vector<double>& reference) const;
    [[nodiscard]] std::vector<double> or_nothing(const std::vector<double>& reference) const;
    /// Mean square score over the rows of all experiments but one.
    [[nodiscard]] double mean_square(const std::vector<double>& changes, std::size_t without) const;

    const Numbers& numbers_;
    std::vector<bool> counts_{};
    const std::vector<Addition>& additions_;
    std::vector<std::vector<std::vector<double>>> tables_{};  ///< [additions][values][rows]
    std::vector<std::size_t> experiments_;
    const Interactions* interactions_ = nullptr;
};

}  // namespace tiretherm::diagnosis::quoted
