// SPDX-License-Identifier: BSD-3-Clause
// Effects laid over a case: parameters that were fitted, and effects that were switched on.
#include "input/parameters/effect_parameters.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "input/parameters/effect_names.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;
using physics::Scope;
using toml_text::quantity_value;
using toml_text::text_value;
using toml_text::texts_value;

void lay_number(TomlValue& over, const ActiveEffect& active, std::size_t parameter) {
    path_of(active, parameter).put(over, quantity_value(active[parameter], active.effect->parameters[parameter].unit));
}

/// All places that have a value of their own: a table in braces replaces the original's.
void lay_places(TomlValue& over, const solver::Problem& problem, const ActiveEffect& active, std::size_t parameter,
                Scope scope) {
    const std::vector<std::string> names = place_names(problem, scope);
    TomlValue values = toml_text::table_value();
    for (const ActiveEffect::Override& other : active.overrides) {
        if (other.parameter == parameter && other.scope == scope) {
            values.set(names[static_cast<std::size_t>(other.index)],
                       quantity_value(other.value, active.effect->parameters[parameter].unit));
        }
    }
    if (!values.entries.empty()) {
        ParameterPath path = path_of(active, parameter);
        path.keys.back().text += key_ending(scope);
        path.put(over, std::move(values));
    }
}

/// The value of a fitted parameter of an effect.
void lay_fitted(TomlValue& over, const solver::Problem& fitted, const solver::FreeParameter& number) {
    const ActiveEffect& active = fitted.effects[number.effect];
    if (number.everywhere) {
        lay_number(over, active, number.parameter);
    } else {
        lay_places(over, fitted, active, number.parameter, number.scope);
    }
}

TomlValue names_at(const std::vector<int>& places, const std::vector<std::string>& names) {
    std::vector<std::string> words;
    for (const int place : places) {
        words.push_back(names[static_cast<std::size_t>(place)]);
    }
    return texts_value(words);
}

/// Channels by their names; a camera's by the camera's name, once.
TomlValue channel_names(const solver::Problem& problem, const std::vector<int>& channels) {
    std::vector<std::string> words;
    for (const int channel : channels) {
        std::string name = sensor_of(problem, channel);
        if (std::ranges::find(words, name) == words.end()) {
            words.push_back(std::move(name));
        }
    }
    return texts_value(words);
}

/// All that an effect was switched on with, where it is not the standard.
void lay_effect(TomlValue& over, const solver::Problem& problem, const ActiveEffect& active) {
    const Effect& effect = *active.effect;
    const ActiveEffect standard = physics::activate(effect, problem.mesh);
    const auto lay = [&](std::string_view key, TomlValue value) {
        ParameterPath::of({"effects", effect.id, key}).put(over, std::move(value));
    };
    lay("on", toml_text::boolean_value(true));
    if (!effect.patches.empty() && active.patches != standard.patches) {
        lay("patches", names_at(active.patches, names_of(problem.mesh.patches)));
    }
    if (effect.on_layers && active.layers != standard.layers) {
        lay("layers", names_at(active.layers, problem.mesh.layers));
    }
    if (effect.sensor_model() != nullptr) {
        lay("channels", channel_names(problem, active.channels));
    }
    for (std::size_t i = 0; i < effect.choices.size(); ++i) {
        if (active.choices[i] != standard.choices[i]) {
            const auto word = static_cast<std::size_t>(active.choices[i]);
            lay(effect.choices[i].key, text_value(std::string(effect.choices[i].options[word])));
        }
    }
    for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
        if (active[i] != standard[i]) {
            lay_number(over, active, i);
        }
        for (const Scope scope : {Scope::patch, Scope::layer, Scope::zone, Scope::channel}) {
            lay_places(over, problem, active, i, scope);
        }
    }
}

/// An effect that is on several times, each time at places or for inputs of its own: one table, with the values by place.
void lay_together(TomlValue& over, const solver::Problem& problem, const std::vector<const ActiveEffect*>& parts) {
    const Effect& effect = *parts.front()->effect;
    const Scope scope = effect.sensor_model() != nullptr ? Scope::channel : Scope::layer;
    const bool by_place = effect.sensor_model() != nullptr || effect.on_layers;
    ActiveEffect all = *parts.front();
    all.overrides.clear();
    for (const ActiveEffect* part : parts) {
        std::ranges::copy(part->channels, std::back_inserter(all.channels));
        std::ranges::copy(part->layers, std::back_inserter(all.layers));
    }
    for (std::vector<int>* places : {&all.channels, &all.layers}) {
        std::ranges::sort(*places);
        places->erase(std::unique(places->begin(), places->end()), places->end());
    }
    const ActiveEffect standard = physics::activate(effect, problem.mesh);
    for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
        for (const ActiveEffect* part : parts) {
            if (!by_place && (*part)[i] != standard[i]) {
                all.parameters[i] = (*part)[i];
            }
            for (const int place :
                 by_place ? (scope == Scope::channel ? part->channels : part->layers) : std::vector<int>{}) {
                all.overrides.push_back(
                    {.scope = scope, .index = place, .parameter = i, .value = part->at(i, scope, place)});
            }
        }
        if (by_place) {
            all.parameters[i] = standard[i];
        }
    }
    lay_effect(over, problem, all);
}

/// All that a user effect was switched on with. Its size is the problem's, which a fit has moved.
void lay_user_effect(TomlValue& over, const ActiveEffect& active, std::span<const solver::UserEffect> user_effects) {
    const auto found = std::ranges::find(user_effects, active.name, &solver::UserEffect::name);
    if (found == user_effects.end()) {
        throw std::invalid_argument(fmt::format("no signal is named that {} follows", active.name));
    }
    ParameterPath path = path_of(active, 0);
    const auto lay = [&](const char* key, TomlValue value) {
        path.keys.back().text = key;
        path.put(over, std::move(value));
    };
    lay("follows", text_value(found->follows));
    lay("at", found->places.size() == 1 ? text_value(found->places.front()) : texts_value(found->places));
    if (!found->temperature.empty()) {
        lay("temperature", text_value(found->temperature));
    }
    lay_number(over, active, 0);
}

}  // namespace

void write_effects(TomlValue& over, const Overlay& overlay, const TomlValue& /*original*/) {
    const solver::Problem& fitted = *overlay.fitted;
    for (std::size_t e = 0; e < fitted.effects.size(); ++e) {
        const ActiveEffect& active = fitted.effects[e];
        const bool was_on = std::ranges::any_of(overlay.before->effects, [&](const ActiveEffect& other) {
            return other.effect == active.effect && other.name == active.name;
        });
        std::vector<const ActiveEffect*> parts;
        for (const ActiveEffect& other : fitted.effects) {
            if (other.effect == active.effect && !physics::is_user_effect(*active.effect)) {
                parts.push_back(&other);
            }
        }
        if (parts.size() > 1) {
            if (parts.front() == &active) {
                lay_together(over, fitted, parts);
            }
            continue;
        }
        if (!was_on && physics::is_user_effect(*active.effect)) {
            lay_user_effect(over, active, overlay.user_effects);
        } else if (!was_on) {
            lay_effect(over, fitted, active);
        }
        for (const solver::FreeParameter& number : overlay.parameters) {
            if (was_on && number.kind == solver::FreeParameter::Kind::effect && number.effect == e &&
                number.runs.empty()) {
                lay_fitted(over, fitted, number);
            }
        }
    }
}

void write_effects_of_run(TomlValue& into, const solver::Problem& fitted,
                          std::span<const solver::FreeParameter> parameters, std::size_t run) {
    for (const solver::FreeParameter& number : parameters) {
        if (number.kind == solver::FreeParameter::Kind::effect && !number.runs.empty() && number.belongs_to(run)) {
            lay_fitted(into, fitted, number);
        }
    }
}

}  // namespace tiretherm::input
