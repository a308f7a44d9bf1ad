// SPDX-License-Identifier: BSD-3-Clause
// Lists the candidate causes of an experiment: which effects can act on its mesh and inputs, at which places, and at
// which trial values the signatures are taken.

#include "diagnosis/detect/candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "input/parameters/effect_names.hpp"
#include "input/parameters/parameter_path.hpp"
#include "physics/plausible_ranges.hpp"

namespace tiretherm::diagnosis {

namespace {

using physics::Effect;
using physics::ParameterSpec;

bool is_on(const solver::Problem& problem, const Effect& effect) {
    return std::ranges::any_of(problem.effects, [&](const physics::ActiveEffect& a) { return a.effect == &effect; });
}

/// Whether the effect's inputs are given in every run and its places are there.
bool can_act(const input::Experiment& experiment, const Effect& effect) {
    const solver::Problem& problem = experiment.runs.front().problem;
    if (const physics::HeatEffect* heat = effect.heat_effect();
        heat != nullptr && heat->travels) {  // the same cause, averaged over a revolution, is resolved_contact
        return false;
    }
    const bool has_tire = std::ranges::any_of(problem.effects, [](const auto& a) { return a.effect->needs_tire; });
    if ((effect.needs_tire && !has_tire) || (effect.needs_grid && problem.mesh.is_lumped())) {
        return false;
    }
    for (const std::string_view signal : effect.reads) {
        if (!std::ranges::all_of(experiment.runs, [&](const input::MeasuredRun& run) {
                return run.problem.input_signals.gives(*physics::find_signal(signal));
            })) {
            return false;
        }
    }
    const physics::ActiveEffect standard = physics::activate(effect, problem.mesh);
    const bool placed = effect.patches.empty() || !standard.patches.empty();
    return placed && (effect.invalid_on_mesh == nullptr || effect.invalid_on_mesh(standard, problem.mesh).empty());
}

/// Whether a camera can see what the channel reads: nodes of the boundary alone. A probe in the surface also has nodes
/// beneath it, without weight.
bool is_seen(const mesh::Mesh& mesh, const solver::Channel& channel) {
    for (std::size_t i = 0; i < channel.where.nodes.size(); ++i) {
        const bool on_surface = std::ranges::any_of(mesh.patches, [&](const mesh::Patch& patch) {
            return patch.name != "inside" && std::ranges::any_of(patch.faces, [&](const mesh::PatchFace& face) {
                       return face.node == channel.where.nodes[i];
                   });
        });
        if (!on_surface && std::abs(channel.where.weights[i]) > 1e-9) {
            return false;
        }
    }
    return true;
}

bool can_read(const Effect& effect, const solver::Problem& problem, const solver::Channel& channel) {
    const bool is_temperature = channel.quantity == solver::Quantity::temperature;
    switch (effect.sensor_model()->applies_to) {
        case physics::ChannelsOf::anything:
            break;
        case physics::ChannelsOf::temperature:
            if (!is_temperature) {
                return false;
            }
            break;
        case physics::ChannelsOf::temperature_at_point:
            if (!is_temperature || !channel.point) {
                return false;
            }
            break;
        case physics::ChannelsOf::pressure:
            if (channel.quantity != solver::Quantity::gas_pressure) {
                return false;
            }
            break;
    }
    return !effect.sensor_model()->sees_surfaces_only || is_seen(problem.mesh, channel);
}

/// Channels of which anything was measured.
std::vector<int> measured_channels(const input::Experiment& experiment) {
    std::vector<int> channels;
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const input::MeasuredSeries& series : run.series) {
            if (!series.frozen) {
                channels.push_back(static_cast<int>(series.channel));
            }
        }
        for (const input::MeasuredNumber& number : run.numbers) {
            channels.push_back(static_cast<int>(number.channel));
        }
    }
    std::ranges::sort(channels);
    channels.erase(std::unique(channels.begin(), channels.end()), channels.end());
    return channels;
}

/// @returns null where the slope is enough
const physics::TrialValues* trial_values_of(const Effect& effect, const ParameterSpec& parameter) {
    const auto found = std::ranges::find(effect.trials, parameter.key, &physics::TrialValues::parameter);
    return found == effect.trials.end() ? nullptr : &*found;
}

/// One number of an effect at one place, at all its trial values.
void add(std::vector<Candidate>& all, const Candidate& plain) {
    const physics::TrialValues* special = trial_values_of(*plain.effect, plain.number());
    Candidate one = plain;
    one.cause = all.empty() ? 0 : all.back().cause + 1;
    one.trial = one.absent;
    if (special == nullptr) {
        all.push_back(one);
        return;
    }
    if (special->left_out) {
        return;
    }
    const auto other = static_cast<std::size_t>(physics::find_parameter(*plain.effect, special->other));
    if (special->factor != 0.0) {
        one.companions = {{.parameter = other, .factor = special->factor}};
    }
    const auto n_held = static_cast<std::size_t>(std::ranges::find(special->held, 0.0) - special->held.begin());
    const physics::PlausibleRange* range =
        n_held > 0 ? physics::plausible_range(*plain.effect, other, physics::SensorKind::any) : nullptr;
    for (std::size_t i = 0; i < n_held; ++i) {
        const double value = special->held[i];
        const double below = i > 0 ? value - special->held[i - 1] : special->held[i + 1] - value;
        const double above = i + 1 < n_held ? special->held[i + 1] - value : below;
        one.held = {{.parameter = other,
                     .value = value,
                     .low = range != nullptr ? std::max(value - below, range->low) : value - below,
                     .high = range != nullptr ? std::min(value + above, range->high) : value + above}};
        all.push_back(one);
    }
    for (const double value : special->trials) {
        if (value != 0.0) {
            one.trial = value;
            all.push_back(one);
        }
    }
}

/// @param chosen effects, or one number of them: "layer_conductivity.scale"; empty: all
bool is_chosen(const std::vector<std::string>& chosen, const Effect& effect, std::size_t parameter) {
    return chosen.empty() || std::ranges::any_of(chosen, [&](const std::string& name) {
               const std::optional<input::CatalogueEntry> entry = input::find_in_catalogue(name);
               return entry && entry->includes(effect, parameter);
           });
}

/// The sensors that an effect may act on: those of one instrument together, which have a clock, a lens and an amplifier in
/// common, then one by one; a camera's rings are one sensor. What lies in the surface and not in the device, as its
/// emissivity does, is common to all that look at surfaces: they are the last, together.
std::vector<std::vector<int>> sensors_read(const Effect& effect, const input::Experiment& experiment,
                                           const std::vector<int>& measured) {
    const solver::Problem& problem = experiment.runs.front().problem;
    std::vector<std::vector<int>> sensors;
    for (const input::Instrument& instrument : experiment.instruments) {
        std::vector<int> common;
        for (const std::size_t channel : instrument.channels) {
            if (std::ranges::find(measured, static_cast<int>(channel)) != measured.end() &&
                can_read(effect, problem, problem.channels[channel])) {
                common.push_back(static_cast<int>(channel));
            }
        }
        if (common.size() > 1 && std::ranges::find(sensors, common) == sensors.end()) {
            sensors.push_back(std::move(common));
        }
    }
    std::vector<int> all;
    for (const int channel : measured) {
        if (!can_read(effect, problem, problem.channels[static_cast<std::size_t>(channel)])) {
            continue;
        }
        const solver::CameraChannels* camera = problem.camera_of(channel);
        if (camera != nullptr && static_cast<int>(camera->first) != channel) {
            continue;
        }
        const int end = camera != nullptr ? static_cast<int>(camera->end()) : channel + 1;
        std::vector<int>& one = sensors.emplace_back();
        for (int of = channel; of < end; ++of) {
            one.push_back(of);
            all.push_back(of);
        }
    }
    if (effect.sensor_model()->sees_surfaces_only && sensors.size() > 1 &&
        std::ranges::find(sensors, all) == sensors.end()) {
        sensors.push_back(all);
    }
    return sensors;
}

/// Whether a parameter's input is logged and changes: the delay of any other does nothing. True of any other effect.
bool is_delayed(const input::Experiment& experiment, const Effect& effect, std::size_t parameter) {
    if (effect.input_correction() == nullptr || effect.input_correction()->delay == nullptr) {
        return true;
    }
    const physics::Signal* signal = physics::find_signal(effect.parameters[parameter].key);
    return std::ranges::any_of(experiment.runs, [&](const input::MeasuredRun& run) {
        return std::ranges::any_of(run.problem.input_signals.series(), [&](const solver::Series& series) {
            return series.signal == signal && series.logged &&
                   std::ranges::adjacent_find(series.value, std::ranges::not_equal_to{}) != series.value.end();
        });
    });
}

/// Inputs that one logger writes are late together: those of handling, and all. @param plain of the effect that delays inputs
void add_common_delays(std::vector<Candidate>& all, const input::Experiment& experiment, Candidate plain,
                       const std::vector<std::string>& chosen) {
    const auto is_of_handling = [](std::string_view signal) {
        return signal != "speed" && signal != "vertical_load" && signal != "laser_power";
    };
    std::size_t before = 0;
    for (const bool handling : {true, false}) {
        std::vector<std::size_t> late;
        for (std::size_t p = 0; p < plain.effect->parameters.size(); ++p) {
            if (is_delayed(experiment, *plain.effect, p) && is_chosen(chosen, *plain.effect, p) &&
                (!handling || is_of_handling(plain.effect->parameters[p].key))) {
                late.push_back(p);
            }
        }
        if (late.size() > std::max<std::size_t>(1, before)) {
            plain.parameter = late.front();
            plain.companions.clear();
            for (std::size_t i = 1; i < late.size(); ++i) {
                plain.companions.push_back({.parameter = late[i], .factor = 1.0});
            }
            add(all, plain);
        }
        before = late.size();
    }
}

void add_all(std::vector<Candidate>& all, const input::Experiment& experiment, const Effect& effect,
             const std::vector<int>& channels, const std::vector<std::string>& chosen) {
    const solver::Problem& problem = experiment.runs.front().problem;
    // By itself an effect on layers leaves the outermost alone, whose numbers are known best; what is known may be wrong.
    std::vector<int> layers = physics::activate(effect, problem.mesh).layers;
    if (!problem.mesh.is_lumped() && !layers.empty() && layers.front() > 0) {
        layers.insert(layers.begin(), 0);
    }
    for (std::size_t p = 0; p < effect.parameters.size(); ++p) {
        const ParameterSpec& parameter = effect.parameters[p];
        if (std::isnan(parameter.absent) || !is_chosen(chosen, effect, p)) {
            continue;
        }
        if (!is_delayed(experiment, effect, p)) {
            continue;
        }
        const Candidate plain{.effect = &effect,
                              .parameter = p,
                              .absent = parameter.absent_of(problem.tire),
                              .low = parameter.low,
                              .high = parameter.high};
        if (effect.sensor_model() != nullptr) {
            for (const std::vector<int>& sensors : sensors_read(effect, experiment, channels)) {
                Candidate one = plain;
                one.channels = sensors;
                add(all, one);
            }
        } else if (effect.on_layers) {
            for (const int layer : layers) {
                Candidate one = plain;
                one.layer = layer;
                add(all, one);
            }
        } else {
            add(all, plain);
        }
    }
    if (effect.input_correction() != nullptr && effect.input_correction()->delay != nullptr) {
        add_common_delays(all, experiment,
                          {.effect = &effect,
                           .absent = 0.0,
                           .low = effect.parameters.front().low,
                           .high = effect.parameters.front().high},
                          chosen);
    }
}

/// Most cases have no place for an effect that is tried beside another only; the inputs of a car's log are those of a road.
bool is_worth_trying(const solver::Problem& problem, const Effect& effect, const std::vector<std::string>& chosen) {
    return effect.tried_beside.empty() || !chosen.empty() ||
           (problem.input_model == nullptr && is_on(problem, *physics::find_effect(effect.tried_beside)));
}

/// Numbers of an effect that is on, with one value everywhere that the fit does not free, where the case doubts them.
void add_numbers(std::vector<Candidate>& all, const input::Experiment& experiment, std::size_t on,
                 const std::vector<std::string>& chosen) {
    const physics::ActiveEffect& active = experiment.runs.front().problem.effects[on];
    for (std::size_t p = 0; p < active.parameters.size(); ++p) {
        const ParameterSpec& parameter = active.effect->parameters[p];
        const bool is_free = std::ranges::any_of(experiment.parameters, [&](const solver::FreeParameter& number) {
            return number.kind == solver::FreeParameter::Kind::effect && number.effect == on && number.parameter == p;
        });
        const bool is_split =
            std::ranges::any_of(active.overrides, [&](const auto& other) { return other.parameter == p; });
        if (!chosen.empty() && is_chosen(chosen, *active.effect, p) && !is_free && !is_split) {
            const double value = active.parameters[p];
            all.push_back({.effect = active.effect,
                           .parameter = p,
                           .on = static_cast<int>(on),
                           .absent = value,
                           .low = parameter.low,
                           .high = parameter.high,
                           .trial = value,
                           .cause = all.empty() ? 0 : all.back().cause + 1});
        }
    }
}

/// Why an effect that is listed gives no candidate.
Remark why_untried(const input::Experiment& experiment, const Effect& effect) {
    const solver::Problem& problem = experiment.runs.front().problem;
    if (effect.sensor_model() != nullptr) {
        return effect.sensor_model()->sees_surfaces_only ? remark::no_sensor_of_surfaces()
                                                         : remark::no_sensor_of_its_kind();
    }
    if (is_on(problem, effect)) {
        return remark::is_on_already();
    }
    if (effect.needs_grid && problem.mesh.is_lumped()) {
        return remark::needs_grid();
    }
    for (const std::string_view signal : effect.reads) {
        for (const input::MeasuredRun& run : experiment.runs) {
            if (!run.problem.input_signals.gives(*physics::find_signal(signal))) {
                return remark::needs_signal(std::string(signal), run.name);
            }
        }
    }
    return remark::nothing_to_act_on();
}

}  // namespace

Remarks untried(const input::Experiment& experiment) {
    Remarks all;
    const std::vector<Candidate> candidates = candidates_of(experiment, experiment.candidates);
    for (const std::string& name : experiment.candidates) {
        const std::optional<input::CatalogueEntry> entry = input::find_in_catalogue(name);
        const bool tried = std::ranges::any_of(candidates, [&](const Candidate& candidate) {
            return entry && entry->includes(*candidate.effect, candidate.parameter);
        });
        if (!tried) {
            all.push_back(
                remark::not_tried(name, {entry ? why_untried(experiment, *entry->effect) : remark::no_such_effect()}));
        }
    }
    return all;
}

std::vector<Candidate> candidates_of(const input::Experiment& experiment, const std::vector<std::string>& chosen) {
    const std::vector<int> channels = measured_channels(experiment);
    std::vector<Candidate> all;
    for (const Effect* effect : physics::catalogue()) {
        const solver::Problem& problem = experiment.runs.front().problem;
        if (!is_on(problem, *effect) && is_worth_trying(problem, *effect, chosen) && can_act(experiment, *effect)) {
            add_all(all, experiment, *effect, channels, chosen);
        }
    }
    const std::vector<physics::ActiveEffect>& active = experiment.runs.front().problem.effects;
    for (std::size_t on = 0; on < active.size(); ++on) {
        if (active[on].name.empty()) {  // the user's own may be anything
            add_numbers(all, experiment, on, chosen);
        }
    }
    return all;
}

}  // namespace tiretherm::diagnosis
