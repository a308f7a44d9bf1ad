// SPDX-License-Identifier: BSD-3-Clause
// Candidates in a model: what is switched on, or moved, when one of them is taken as true; and what they are called.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/detect/candidates.hpp"
#include "input/parameters/effect_names.hpp"
#include "input/text/word_lists.hpp"
#include "physics/plausible_ranges.hpp"

namespace tiretherm::diagnosis {

namespace {

/// As in a case that says nothing: at the effect's input, the air around gas and rim, or as the rest where it is not given. K
double start_of_own_nodes(const solver::Problem& problem, const physics::Effect& effect) {
    const physics::HeatEffect* heat = effect.heat_effect();
    const physics::Signal& around = *physics::find_signal(heat != nullptr ? heat->starts_at : "air_temperature");
    const physics::Inputs first = problem.input_signals.at(problem.settings.start, solver::JumpSide::after);
    return problem.input_signals.gives(around) ? first.*around.member : problem.initial.front();
}

}  // namespace

std::pair<double, double> plausible_bounds(const Candidate& candidate) {
    const physics::PlausibleRange* range = physics::plausible_range(*candidate.effect, candidate.parameter);
    if (range == nullptr) {
        return {candidate.low, candidate.high};
    }
    // Of an effect that is on the case's own number counts as plausible.
    return {std::clamp(std::min(range->low, candidate.absent), candidate.low, candidate.high),
            std::clamp(std::max(range->high, candidate.absent), candidate.low, candidate.high)};
}

bool is_common_delay(const Candidate& candidate) {
    const physics::InputCorrection* input = candidate.effect->input_correction();
    return input != nullptr && input->delay != nullptr && !candidate.companions.empty();
}

bool can_stand_beside(const Candidate& one, const Candidate& other) {
    if (one.effect != other.effect) {
        return true;
    }
    if (one.cause == other.cause || (one.on >= 0) != (other.on >= 0)) {
        return false;
    }
    if (one.effect->sensor_model() != nullptr && one.on < 0) {
        return std::ranges::none_of(one.channels, [&](int channel) {
            return std::ranges::find(other.channels, channel) != other.channels.end();
        });
    }
    if (one.layer >= 0 && other.layer >= 0) {
        return one.layer != other.layer;
    }
    const physics::InputCorrection* input = one.effect->input_correction();
    const bool own_inputs = input != nullptr && input->delay != nullptr;
    const auto moves = [](const Candidate& candidate, std::size_t parameter) {
        return candidate.parameter == parameter ||
               std::ranges::find(candidate.companions, parameter, &solver::FreeParameter::Companion::parameter) !=
                   candidate.companions.end();
    };
    const bool shares = moves(one, other.parameter) || std::ranges::any_of(one.companions, [&](const auto& companion) {
                            return moves(other, companion.parameter);
                        });
    return !shares && (one.on >= 0 || own_inputs);
}

physics::ActiveEffect active_at(const Candidate& candidate, const mesh::Mesh& mesh, double value) {
    physics::ActiveEffect active = physics::activate(*candidate.effect, mesh);
    for (std::size_t p = 0; p < active.parameters.size(); ++p) {
        if (const double absent = candidate.effect->parameters[p].absent; !std::isnan(absent)) {
            active.parameters[p] = absent;
        }
    }
    for (const Candidate::Held& held : candidate.held) {
        active.parameters[held.parameter] = held.value;
    }
    active.parameters[candidate.parameter] = value;
    for (const solver::FreeParameter::Companion& companion : candidate.companions) {
        active.parameters[companion.parameter] = companion.factor * value;
    }
    if (!candidate.channels.empty()) {
        active.channels = candidate.channels;
    }
    if (candidate.layer >= 0) {
        active.layers = {candidate.layer};
    }
    return active;
}

input::Experiment with(input::Experiment experiment, const std::vector<Candidate>& candidates,
                       const std::vector<double>& values) {
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        const Candidate& candidate = candidates[k];
        solver::FreeParameter number{.name = name_of(candidate, experiment),
                                     .unit = std::string(candidate.number().unit),
                                     .kind = solver::FreeParameter::Kind::effect,
                                     .parameter = candidate.parameter,
                                     .companions = candidate.companions,
                                     .layers = {},
                                     .knots = {},
                                     .nodes = {},
                                     .runs = {},
                                     .prior = candidate.absent,
                                     .low = candidate.low,
                                     .high = candidate.high};
        for (input::MeasuredRun& run : experiment.runs) {
            if (candidate.on >= 0) {
                number.effect = static_cast<std::size_t>(candidate.on);
                run.problem.effects[number.effect].parameters[candidate.parameter] = values[k];
                continue;
            }
            const physics::ActiveEffect active = active_at(candidate, run.problem.mesh, values[k]);
            number.effect = solver::switch_on(run.problem, active, start_of_own_nodes(run.problem, *active.effect));
        }
        experiment.parameters.push_back(std::move(number));
    }
    return experiment;
}

std::string sensors_of(const Candidate& candidate, const solver::Problem& problem) {
    std::vector<std::string> names;
    for (const int channel : candidate.channels) {
        std::string name = input::sensor_of(problem, channel);
        if (names.empty() || names.back() != name) {
            names.push_back(std::move(name));
        }
    }
    if (names.size() > 1 && candidate.effect->sensor_model()->sees_surfaces_only) {
        return fmt::format("all {} sensors of surfaces", names.size());
    }
    if (names.size() == 2) {
        return fmt::format("{} and {}", names.front(), names.back());
    }
    if (names.size() > 1) {
        return fmt::format("{} to {} ({} sensors)", names.front(), names.back(), names.size());
    }
    return names.empty() ? std::string() : names.front();
}

std::string name_of(const Candidate& candidate, const input::Experiment& experiment) {
    const solver::Problem& problem = experiment.runs.front().problem;
    std::string name(candidate.effect->id);
    const auto numbers =
        std::ranges::count_if(candidate.effect->parameters, [&](const physics::ParameterSpec& parameter) {
            return !std::isnan(parameter.absent) &&
                   std::ranges::none_of(candidate.effect->trials, [&](const physics::TrialValues& special) {
                       return special.parameter == parameter.key && special.left_out;
                   });
        });
    if (is_common_delay(candidate)) {
        std::vector<std::string> inputs{std::string(candidate.number().key)};
        for (const solver::FreeParameter::Companion& companion : candidate.companions) {
            inputs.emplace_back(candidate.effect->parameters[companion.parameter].key);
        }
        name += " of " + input::listed(inputs);
    } else if (numbers > 1 || candidate.on >= 0) {
        name += fmt::format(".{}", candidate.number().key);
    }
    if (!candidate.channels.empty()) {
        name += " of " + sensors_of(candidate, problem);
    }
    if (candidate.layer >= 0 && !problem.mesh.is_lumped() && problem.mesh.layers.size() > 1) {
        name += " of " + problem.mesh.layers[static_cast<std::size_t>(candidate.layer)];
    }
    return name;
}

}  // namespace tiretherm::diagnosis
