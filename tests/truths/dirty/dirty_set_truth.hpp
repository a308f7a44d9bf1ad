// SPDX-License-Identifier: BSD-3-Clause
// One set of dirty data: a tire with causes that the base model lacks, wrong inputs, imperfect instruments, several runs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "dirty/dirty_drive_truth.hpp"
#include "dirty/dirty_sensors_truth.hpp"
#include "dirty/dirty_tire_truth.hpp"

namespace hidden_effects {

/// What is logged of the inputs, beside the truth. A gain is true over logged.
struct DirtyInputs {
    double load_gain = 1.0;
    double speed_gain = 1.0;
    double slip_gain = 1.0;
    double load_delay = 0.0;  ///< s, how late the column is
    double slip_delay = 0.0;  ///< s
    bool road_is_measured = true;
    double road_over_air = 0.0;  ///< K, what the case assumes where the road is not measured: over the first run's air
    double road_assumed = 0.0;   ///< K, that temperature
};

/// Everything that can be wrong, together.
struct DirtyWorld {
    DirtyTire tire;
    DirtyInputs inputs;
    std::vector<DirtySensor> sensors;
};

/// A hidden cause, and the world without it.
struct DirtyCause {
    std::string id;                                          ///< of the catalogue, or a plain word
    std::string channel;                                     ///< where one sensor has it; "infrared" for all of them
    std::vector<std::pair<std::string, double>> parameters;  ///< true, in the catalogue's units
    bool in_catalogue = true;
    bool is_timing = false;
    /// What else names it as well as can be asked.
    std::vector<std::string> accepted;
    std::function<void(DirtyWorld&)> remove;
    double rms = 0.0;       ///< K, in the readings of the runs, after the best constant of each run is removed
    double rms_left = 0.0;  ///< K, after the free numbers of the base model have taken what they can
};

struct DirtySet {
    std::uint64_t seed = 0;
    bool two_node = true;
    bool laps = true;
    std::string style;         ///< structure, dominant or many
    double interval = 0.5;     ///< s, of the log
    std::size_t n_runs = 2;    ///< without the one that is kept back
    bool loss_is_free = true;  ///< tan_delta_a beside lambda_h; otherwise lambda_y
    bool wide_list = false;    ///< the case lists candidates
    bool has_gas_sensor = false;
    std::vector<int> case_layers;  ///< cells of tread and carcass of the case
    DirtyColumn base_column;       ///< what the base model has
    DirtyWorld world;
    std::vector<std::pair<double, double>> shifts;  ///< K, start of each run: surface, bulk
    std::vector<DirtyDrive> drives;                 ///< the last is kept back
    std::vector<DirtyCause> causes;
};

/// What the log says was driven: gains and delays of the inputs, and the road as the case assumes it.
[[nodiscard]] DirtyDrive dirty_logged(const DirtyDrive& drive, const DirtyInputs& inputs);
/// A set, with the size of every cause.
[[nodiscard]] DirtySet draw_dirty_set(std::uint64_t seed);
/// Of each run and sensor, without noise: [n_runs][n_sensors][n_times of dirty_step], K
[[nodiscard]] std::vector<std::vector<std::vector<double>>> dirty_courses(const DirtySet& set, const DirtyWorld& world,
                                                                          std::size_t n_runs, bool as_logged = false);
/// Fills in rms and rms_left of every cause.
void measure_dirty_causes(DirtySet& set);

}  // namespace hidden_effects
