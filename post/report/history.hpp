// SPDX-License-Identifier: BSD-3-Clause
// The channels and the heat budget of a run kept in memory, for comparison with measured values and for charts.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "solver/time_integration/march.hpp"

namespace tiretherm::post {

/// The channels and the heat of each effect, row by row, kept for the comparison with measured values and for the charts at
/// the end.
class History {
public:
    void take(const solver::Snapshot& snapshot);

    [[nodiscard]] std::size_t rows() const { return time_.size(); }
    [[nodiscard]] const std::vector<double>& time() const { return time_; }  ///< [rows] s
    /// A channel's values. @returns [rows] K
    [[nodiscard]] std::vector<double> channel(std::size_t index) const;
    /// Heat of an effect into the mesh, not scaled by symmetry. @returns [rows] W; empty where rows came without
    [[nodiscard]] std::vector<double> watts(std::size_t effect) const;
    /// Heat of all effects since the start, not scaled by symmetry. @returns [rows * effects] J
    [[nodiscard]] const std::vector<double>& joules() const { return joules_; }
    /// Linear between rows, constant beyond them. @param t s  @pre rows() > 0  @returns K
    [[nodiscard]] double at(std::size_t channel, double t) const;

private:
    [[nodiscard]] double value(std::size_t row, std::size_t channel) const { return value_[row * width_ + channel]; }

    std::size_t width_ = 0;
    std::vector<double> time_;
    std::vector<double> value_;  ///< [rows * channels] K
    std::size_t effects_ = 0;
    std::vector<double> watts_;   ///< [rows * effects] W
    std::vector<double> joules_;  ///< [rows * effects] J
};

}  // namespace tiretherm::post
