// SPDX-License-Identifier: BSD-3-Clause
// Parameters and inputs at which every effect of the catalogue acts, for tests that run over all effects.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"

/// What tests of every effect share: numbers at which each acts, the thesis's effects beside it, inputs under which every
/// law has something to say.
namespace tiretherm::physics {

/// Numbers that make an effect act whose standard ones change nothing.
inline Part loud(std::string_view id) {
    static const std::vector<Part> parts{{"uniform_source", {{"power_density", 1e5}}},
                                         {"road_temperature_drift", {{"rate", 20.0}}},
                                         {"air_temperature_drift", {{"rate", 20.0}}},
                                         {"slip_input_gain", {{"gain", 1.2}}},
                                         {"slip_angle_offset", {{"offset", 0.01}}},
                                         {"load_input_gain", {{"gain", 1.2}}},
                                         {"speed_input_gain", {{"gain", 1.2}}},
                                         {"laser_absorptivity", {{"factor", 0.9}, {"fall", 0.1}}},
                                         {"laser_spot_size", {{"scale", 1.2}}},
                                         {"initial_temperature", {{"offset", 5.0}}},
                                         {"layer_conductivity", {{"scale", 1.2}, {"slope", 0.002}}},
                                         {"layer_heat_capacity", {{"scale", 1.2}}},
                                         {"partition_speed", {{"slope", 0.05}}},
                                         {"loss_tangent_slope", {{"slope", 0.005}}},
                                         {"loss_frequency_shift", {{"per_decade", 5.0}}},
                                         {"load_exponent_of_loss", {{"exponent", 0.3}}},
                                         {"sidewall_convection", {{"h", 40.0}}},
                                         {"sensor_depth", {{"offset", 0.001}}},
                                         {"clock_delay", {{"delay", 0.5}}},
                                         {"clock_rate", {{"rate", 0.01}}},
                                         {"sensor_offset", {{"kelvin", 1.0}}},
                                         {"sensor_gain", {{"excess", 0.05}}},
                                         {"sensor_drift", {{"rate", 5.0}}},
                                         {"wind", {{"speed", 8.0}}},
                                         {"own_source", {{"watts", -300.0}}},
                                         {"own_exchange", {{"conductance", 3.0}}}};
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.id == id; });
    return found == parts.end() ? Part{id} : *found;
}

/// The same with every candidate number where the effect is absent.
inline Part silent(const Effect& effect) {
    Part part = loud(effect.id);
    for (const ParameterSpec& parameter : effect.parameters) {
        if (!std::isnan(parameter.absent)) {
            part.numbers.emplace_back(parameter.key, parameter.absent);
        }
    }
    return part;
}

inline bool has_absent(const Effect& effect) {
    return std::ranges::any_of(effect.parameters, [](const ParameterSpec& p) { return !std::isnan(p.absent); });
}

inline bool can_act(const Effect& effect, const Bench& bench) {
    const bool has_place = effect.patches.empty() || !activate(effect, bench.mesh).patches.empty();
    const bool has_tire = !effect.needs_tire || bench.mesh.find_patch("top") < 0;
    const bool has_grid = !effect.needs_grid || !bench.mesh.is_lumped();
    return has_place && has_tire && has_grid;
}

/// The thesis's effects that can act on a bench, the laser and still air on a specimen among them.
inline std::vector<Part> thesis(const Bench& bench) {
    std::vector<Part> parts;
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact",
                           "laser", "still_air"}) {
        if (can_act(*find_effect(id), bench)) {
            parts.push_back({id});
        }
    }
    return parts;
}

inline std::vector<Part> with(std::vector<Part> parts, const Part& part) {
    if (std::ranges::none_of(parts, [&](const Part& other) { return other.id == part.id; })) {
        parts.push_back(part);
    }
    return parts;
}

/// Half an hour into a run, fast, loaded, leaning, on a wet road: every law has something to say.
inline Inputs lively() {
    Inputs in = rolling();
    in.time = 1800.0;
    in.speed = 45.0;
    in.vertical_load = 6000.0;
    in.wheel_angle = 3.0;  // of a column that meets the road at pi, +- 0.2 rad of contact
    return in;
}

/// Each effect on every bench where it can act.
class EveryEffect : public testing::TestWithParam<const Effect*> {
protected:
    [[nodiscard]] static std::vector<Bench> benches() {
        std::vector<Bench> result{two_nodes(), specimen(), section()};
        std::erase_if(result, [](const Bench& bench) { return !can_act(*GetParam(), bench); });
        return result;
    }
    [[nodiscard]] static Part part() { return loud(GetParam()->id); }
};

class EveryPassiveEffect : public EveryEffect {};
class EveryLoss : public EveryEffect {};
class EveryCandidate : public EveryEffect {};

template <typename Predicate>
std::vector<const Effect*> effects_that(Predicate predicate) {
    std::vector<const Effect*> chosen;
    std::copy_if(catalogue().begin(), catalogue().end(), std::back_inserter(chosen), predicate);
    return chosen;
}

inline std::string id_of(const testing::TestParamInfo<const Effect*>& test) { return std::string(test.param->id); }

inline std::vector<double> random_field(std::size_t n, std::mt19937_64& random, double low = 270.0,
                                        double high = 420.0) {
    std::uniform_real_distribution<double> temperature(low, high);
    std::vector<double> T(n);
    for (double& t : T) {
        t = temperature(random);
    }
    return T;
}

inline std::size_t n_nodes(const Whole& whole) { return static_cast<std::size_t>(whole.problem().mesh.n_nodes); }

}  // namespace tiretherm::physics
