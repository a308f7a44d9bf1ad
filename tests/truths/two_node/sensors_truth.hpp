// SPDX-License-Identifier: BSD-3-Clause
// Sensors of the truths: place, emissivity, lag, offset and gain.
#pragma once

#include <cstddef>
#include <vector>

#include "two_node/causes_truth.hpp"

namespace hidden_effects {

/// Sensors that read a field of nodes: each a weighted mean of temperatures, seen with its emissivity, with its lag, offset
/// and gain, in this order.
class Sensors {
public:
    /// A value and how fast it changes.
    struct Course {
        double value = 0.0;
        double rate = 0.0;
    };

    /// @param places [n_sensors][n_nodes] weights  @param readings [n_sensors]
    Sensors(std::vector<std::vector<double>> places, std::vector<Reading> readings);

    [[nodiscard]] bool lags() const { return lags_; }
    /// What the sensors' own elements are heading for. @param rate K/s, may be empty where nothing lags
    [[nodiscard]] std::vector<Course> now(const std::vector<double>& T, const std::vector<double>& rate,
                                          double T_air) const;
    void start(const std::vector<Course>& at);
    /// Over a step along which the courses are the cubics through their ends.
    void follow(double dt, const std::vector<Course>& from, const std::vector<Course>& to);
    /// What sensor c shows. K
    [[nodiscard]] double shown(std::size_t c) const;

private:
    std::vector<std::vector<double>> places_;
    std::vector<Reading> readings_;
    std::vector<double> state_;
    bool lags_ = false;
};

}  // namespace hidden_effects
