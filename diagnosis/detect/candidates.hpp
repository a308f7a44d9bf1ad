// SPDX-License-Identifier: BSD-3-Clause
// Candidate causes of a diagnosis: effects of the catalogue that are off, and chosen parameters of effects that are on,
// each with the value at which it changes nothing.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "input/measurements/experiment.hpp"
#include "physics/effect.hpp"

namespace tiretherm::diagnosis {

/// What may be wrong with a model: one number of an effect of the catalogue, at one place, and the value at which it
/// changes nothing: where the effect is absent, or, of an effect that is on, what the case says.
struct Candidate {
    const physics::Effect* effect = nullptr;
    std::size_t parameter = 0;
    std::vector<solver::FreeParameter::Companion> companions{};  ///< numbers that move along
    /// Numbers that mean nothing while the effect is absent, such as a critical speed, and their values on trial.
    struct Held {
        std::size_t parameter = 0;
        double value = 0.0;  ///< on trial
        double low = 0.0;    ///< where the neighbouring trials are: as far as it goes in a fit
        double high = 0.0;
    };
    std::vector<Held> held{};
    /// Indices into Problem::channels, of a sensor's effect: one sensor, the rings of a camera, or all infrared sensors.
    std::vector<int> channels{};
    int layer = -1;  ///< index into Mesh::layers, of an effect on layers
    int on = -1;     ///< index into Problem::effects, where the effect is on and its number may be wrong
    double absent = 0.0;
    double low = 0.0;
    double high = 0.0;
    /// Where the signature is taken, by difference to the absent effect; `absent`: by its slope there.
    double trial = 0.0;
    /// The same for all that differ only in what is held or where the signature is taken: one cause.
    std::size_t cause = 0;

    [[nodiscard]] const physics::ParameterSpec& number() const { return effect->parameters[parameter]; }
    [[nodiscard]] bool by_slope() const { return trial == absent; }
};

/// Every cause that can act on an experiment's model and is not in it: effects of the catalogue that are off, whose inputs
/// are given and whose places the mesh has. Of an effect that is on, its numbers that are chosen and not free anyway.
/// @param chosen effects by id, or one number of an effect ("layer_conductivity.scale"); empty: all that are off
[[nodiscard]] std::vector<Candidate> candidates_of(const input::Experiment& experiment,
                                                   const std::vector<std::string>& chosen);

/// Whether one case can have both: two effects, two numbers of one that is on, or one effect at two places or on two inputs.
[[nodiscard]] bool can_stand_beside(const Candidate& one, const Candidate& other);

/// Whether it delays several inputs together.
[[nodiscard]] bool is_common_delay(const Candidate& candidate);

/// What is said of effects that the case lists and that cannot act on it, or that no sensor sees: a sentence each.
[[nodiscard]] Remarks untried(const input::Experiment& experiment);

/// Where a candidate's number is expected to lie, within what the effect allows (physics::plausible_range). @returns low, high
[[nodiscard]] std::pair<double, double> plausible_bounds(const Candidate& candidate);

/// The effect as it is switched on at a value of the candidate's number.
[[nodiscard]] physics::ActiveEffect active_at(const Candidate& candidate, const mesh::Mesh& mesh, double value);
/// What a sensor's effect acts on: "bulk_temperature", "all 8 sensors of surfaces"; empty for any other effect.
[[nodiscard]] std::string sensors_of(const Candidate& candidate, const solver::Problem& problem);

/// "sensor_lag of bulk_temperature", "layer_conductivity.slope of tread"
[[nodiscard]] std::string name_of(const Candidate& candidate, const input::Experiment& experiment);

/// The experiment with candidates switched on in every run, their numbers free after its own.
/// @param values [n_candidates] of their numbers
[[nodiscard]] input::Experiment with(input::Experiment experiment, const std::vector<Candidate>& candidates,
                                     const std::vector<double>& values);

}  // namespace tiretherm::diagnosis
