// SPDX-License-Identifier: BSD-3-Clause
// Imperfect instruments of the exam of dirty data: slow, late, coarse, resampled, clipped, stuck.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dirty/dirty_tire_truth.hpp"

namespace hidden_effects {

/// A sensor and what is wrong with it.
struct DirtySensor {
    enum class Place { inside_shoulder, crown, outside_shoulder, bulk, probe, liner, gas };
    std::string name;
    Place place = Place::crown;
    double sigma = 0.3;             ///< K
    double correlated_share = 0.5;  ///< of the noise's variance
    double tau = 0.0;               ///< s
    double delay = 0.0;             ///< s
    double emissivity = 1.0;
    double offset = 0.0;      ///< K
    double resolution = 0.0;  ///< K
    double interval = 0.0;    ///< s, of its own samples; straight lines up to the log's rate. 0: that of the log
    double clip = 1e9;        ///< K, highest reading
    double stuck_from = 1e9;  ///< s

    [[nodiscard]] bool is_infrared() const {
        return place == Place::inside_shoulder || place == Place::crown || place == Place::outside_shoulder;
    }
};

/// What a sensor shows without noise, resolution, clipping and without sticking, at times of dirty_step, K.
[[nodiscard]] std::vector<double> dirty_course(const DirtySensor& sensor, const DirtyTrace& trace,
                                               const DirtyDrive& drive);
/// What is logged at 0, interval, 2 interval ... K. @param seed of the noise; 0: none
[[nodiscard]] std::vector<double> dirty_log(const DirtySensor& sensor, const std::vector<double>& course,
                                            double interval, std::uint64_t seed);

}  // namespace hidden_effects
