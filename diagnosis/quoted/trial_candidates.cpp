// SPDX-License-Identifier: BSD-3-Clause
// Candidates of single runs, made into additions with ranges from the table of plausible ranges.

#include "diagnosis/quoted/trial_candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "physics/plausible_ranges.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

/// "critical_speed = 125 km/h" of a number that is held, or empty.
std::string held_text(const Candidate& candidate) {
    std::string text;
    for (const Candidate::Held& held : candidate.held) {
        const physics::ParameterSpec& spec = candidate.effect->parameters[held.parameter];
        text += fmt::format("{}{} = {:.4g} {}", text.empty() ? "" : ", ", spec.key, held.value, spec.unit);
    }
    return text;
}

std::string layer_text(const Candidate& candidate, const solver::Problem& problem) {
    return candidate.layer >= 0 && problem.mesh.layers.size() > 1
               ? problem.mesh.layers[static_cast<std::size_t>(candidate.layer)]
               : std::string();
}

/// Numbers of effects that are on, of which another one in the catalogue says the same with less else moved.
constexpr std::array<std::string_view, 3> said_otherwise{
    "air_convection.exponent",     // convection_exponent, equal at its pivot: without one the film grows tenfold
    "air_convection.coefficient",  // lambda_h
    "road_contact.Hc",             // lambda_Hc
};

physics::SensorKind kind_of(const std::string& name) {
    const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
    return has("surface") || has("spot") ? physics::SensorKind::infrared
           : has("gas")                  ? physics::SensorKind::gas
                                         : physics::SensorKind::probe;
}

}  // namespace

std::vector<Candidate> candidates_in(const solver::Problem& problem) {
    input::Experiment alone;
    alone.runs.emplace_back();
    alone.runs.front().problem = problem;
    std::vector<std::string> numbers;
    for (const physics::ActiveEffect& active : problem.effects) {
        for (std::size_t p = 0; active.name.empty() && p < active.parameters.size(); ++p) {
            std::string name = fmt::format("{}.{}", active.effect->id, active.effect->parameters[p].key);
            if (std::ranges::find(said_otherwise, name) == said_otherwise.end()) {
                numbers.push_back(std::move(name));
            }
        }
    }
    std::vector<Candidate> all = candidates_of(alone, {});
    if (!numbers.empty()) {
        const std::vector<Candidate> on = candidates_of(alone, numbers);
        all.insert(all.end(), on.begin(), on.end());
    }
    std::vector<Candidate> found;
    for (const Candidate& one : all) {
        const bool is_users = one.effect->id.starts_with("user_");
        const bool is_known = std::ranges::any_of(found, [&](const Candidate& other) {
            return other.effect == one.effect && other.parameter == one.parameter && other.layer == one.layer &&
                   held_text(other) == held_text(one);
        });
        if (!is_users && !is_known && one.effect->sensor_model() == nullptr &&
            physics::plausible_range(*one.effect, one.parameter) != nullptr) {
            found.push_back(one);
        }
    }
    return found;
}

bool is_of(const Candidate& candidate, const Addition& addition, const solver::Problem& problem) {
    if (candidate.effect->id != addition.id || candidate.number().key != addition.key ||
        (candidate.on >= 0) != (addition.kind == AdditionKind::number)) {
        return false;
    }
    const std::string held = held_text(candidate);
    // A layer is a name of one mesh: on another one the first that can be meant.
    const bool has_layer = std::ranges::find(problem.mesh.layers, addition.what) != problem.mesh.layers.end();
    return !held.empty() ? held == addition.what : !has_layer || layer_text(candidate, problem) == addition.what;
}

void add_effects(std::vector<Addition>& all, const std::vector<Candidate>& candidates, const solver::Problem& problem) {
    for (const Candidate& candidate : candidates) {
        const auto [low, high] = plausible_bounds(candidate);
        const std::string held = held_text(candidate);
        Addition addition{
            .kind = candidate.on >= 0 ? AdditionKind::number : AdditionKind::effect,
            .id = std::string(candidate.effect->id),
            .key = std::string(candidate.number().key),
            .unit = std::string(candidate.number().unit),
            .what = held.empty() ? layer_text(candidate, problem) : held,
            .absent = candidate.absent,
            .low = low,
            .high = high,
            .source = std::string(physics::plausible_range(*candidate.effect, candidate.parameter)->source)};
        const bool is_known = std::ranges::any_of(all, [&](const Addition& other) {
            return other.kind == addition.kind && other.id == addition.id && other.key == addition.key &&
                   other.what == addition.what;
        });
        if (!is_known && addition.low < addition.high) {
            addition.nodes = trial_nodes(addition.absent, addition.low, addition.high);
            all.push_back(std::move(addition));
        }
    }
}

std::string instrument_of(const std::string& channel) {
    constexpr std::array<std::string_view, 3> sides{"inside_shoulder_", "outside_shoulder_", "crown_"};
    for (const std::string_view side : sides) {
        if (channel.starts_with(side)) {
            return channel.substr(side.size());
        }
    }
    return channel;
}

void add_instrument(std::vector<Addition>& all, const std::string& name, const std::string& source) {
    struct Error {
        const char* effect;
        const char* parameter;
        const char* key;
    };
    constexpr std::array errors{Error{"sensor_offset", "kelvin", offset_key}, Error{"sensor_gain", "excess", gain_key}};
    for (const Error& error : errors) {
        const physics::Effect* effect = physics::find_effect(error.effect);
        const auto parameter = static_cast<std::size_t>(physics::find_parameter(*effect, error.parameter));
        const physics::PlausibleRange* range = physics::plausible_range(*effect, parameter, kind_of(name));
        if (range != nullptr) {
            all.push_back({.kind = AdditionKind::instrument,
                           .id = name,
                           .key = error.key,
                           .unit = std::string(effect->parameters[parameter].unit),
                           .what = source,
                           .low = range->low,
                           .high = range->high,
                           .source = std::string(range->source),
                           .nodes = {range->low, 0.0, range->high}});
        }
    }
}

}  // namespace tiretherm::diagnosis::quoted
