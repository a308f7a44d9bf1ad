#include "input/parameters/fitted_effects.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "input/effects/user_effects.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/toml_text.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;
using physics::Scope;

/// Names of the places of a kind, in the order of their indices.
std::vector<std::string> names_of_places(const solver::Problem& problem, Scope scope) {
    switch (scope) {
        case Scope::patch:
            return names_of(problem.mesh.patches);
        case Scope::layer:
            return problem.mesh.layers;
        case Scope::zone:
            return problem.mesh.zones;
        case Scope::channel:
            return names_of(problem.channels);
    }
    return {};
}

std::string_view ending(Scope scope) {
    switch (scope) {
        case Scope::patch:
            return "_by_patch";
        case Scope::layer:
            return "_by_layer";
        case Scope::zone:
            return "_by_zone";
        case Scope::channel:
            return "_by_channel";
    }
    return {};
}

/// `h = "10 W m-2 K-1"`.
std::string value_line(const ActiveEffect& active, std::size_t parameter) {
    const physics::ParameterSpec& which = active.effect->parameters[parameter];
    return fmt::format("{} = {}\n", which.key, toml_text::quantity(active[parameter], which.unit));
}

/// `h_by_patch = { top = "60 W m-2 K-1" }` with all places that have a value of their own: it replaces the original's.
std::string places_line(const solver::Problem& problem, const ActiveEffect& active, std::size_t parameter,
                        Scope scope) {
    const physics::ParameterSpec& which = active.effect->parameters[parameter];
    const std::vector<std::string> names = names_of_places(problem, scope);
    std::string values;
    for (const ActiveEffect::Override& other : active.overrides) {
        if (other.parameter == parameter && other.scope == scope) {
            values += fmt::format("{}{} = {}", values.empty() ? "" : ", ",
                                  toml_text::key(names[static_cast<std::size_t>(other.index)]),
                                  toml_text::quantity(other.value, which.unit));
        }
    }
    return values.empty() ? std::string() : fmt::format("{}{} = {{ {} }}\n", which.key, ending(scope), values);
}

std::string parts_line(std::string_view key, const std::vector<int>& parts, const std::vector<std::string>& names) {
    std::vector<std::string> words;
    for (const int part : parts) {
        words.push_back(toml_text::in_quotes(names[static_cast<std::size_t>(part)]));
    }
    return fmt::format("{} = [{}]\n", key, fmt::join(words, ", "));
}

/// A camera's channels by the camera's name, once.
std::string channels_line(const solver::Problem& problem, const std::vector<int>& channels) {
    std::vector<std::string> words;
    for (const int channel : channels) {
        const solver::CameraChannels* camera = problem.camera_of(channel);
        const std::string& name =
            camera != nullptr ? camera->camera : problem.channels[static_cast<std::size_t>(channel)].name;
        if (std::string word = toml_text::in_quotes(name); std::ranges::find(words, word) == words.end()) {
            words.push_back(std::move(word));
        }
    }
    return fmt::format("channels = [{}]\n", fmt::join(words, ", "));
}

/// All that an effect was switched on with, where it is not the standard.
std::string switched_on_text(const solver::Problem& problem, const ActiveEffect& active) {
    const Effect& effect = *active.effect;
    const ActiveEffect standard = physics::activate(effect, problem.mesh);
    std::string text = "on = true\n";
    if (!effect.patches.empty() && active.patches != standard.patches) {
        text += parts_line("patches", active.patches, names_of(problem.mesh.patches));
    }
    if (effect.on_layers && active.layers != standard.layers) {
        text += parts_line("layers", active.layers, problem.mesh.layers);
    }
    if (effect.sensor_model() != nullptr) {
        text += channels_line(problem, active.channels);
    }
    for (std::size_t i = 0; i < effect.choices.size(); ++i) {
        if (active.choices[i] != standard.choices[i]) {
            const auto word = static_cast<std::size_t>(active.choices[i]);
            text +=
                fmt::format("{} = {}\n", effect.choices[i].key, toml_text::in_quotes(effect.choices[i].options[word]));
        }
    }
    for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
        text += active[i] != standard[i] ? value_line(active, i) : "";
        for (const Scope scope : {Scope::patch, Scope::layer, Scope::zone, Scope::channel}) {
            text += places_line(problem, active, i, scope);
        }
    }
    return text;
}

/// All that a user effect was switched on with. Its size is the problem's, which a fit has moved.
std::string user_effect_text(const ActiveEffect& active, std::span<const solver::UserEffect> user_effect) {
    const auto found = std::ranges::find(user_effect, active.name, &solver::UserEffect::name);
    if (found == user_effect.end()) {
        throw std::invalid_argument(fmt::format("nobody has said what {} follows", active.name));
    }
    std::vector<std::string> places;
    for (const std::string& place : found->places) {
        places.push_back(toml_text::in_quotes(place));
    }
    std::string text = fmt::format("follows = {}\nat = {}\n", toml_text::in_quotes(found->follows),
                                   places.size() == 1 ? places.front() : fmt::format("[{}]", fmt::join(places, ", ")));
    if (!found->temperature.empty()) {
        text += fmt::format("temperature = {}\n", toml_text::in_quotes(found->temperature));
    }
    return text + value_line(active, 0);
}

std::string heading(const ActiveEffect& active) {
    if (!active.name.empty() && !physics::is_user_effect(*active.effect)) {
        return fmt::format("\n[[camera]]\nname = {}\n", toml_text::in_quotes(active.name));
    }
    if (!physics::is_user_effect(*active.effect)) {
        return fmt::format("\n[effects.{}]\n", active.effect->id);
    }
    const UserEffectKind& kind = active.effect->id == user_heat_transfer.effect ? user_heat_transfer : user_heat_source;
    return fmt::format("\n[[{}]]\nname = {}\n", kind.list, toml_text::in_quotes(active.name));
}

}  // namespace

std::string effects_text(const solver::Problem& before, const solver::Problem& fitted,
                         std::span<const solver::FreeParameter> parameters,
                         std::span<const solver::UserEffect> user_effect) {
    std::string text;
    std::string last;
    for (std::size_t e = 0; e < fitted.effects.size(); ++e) {
        const ActiveEffect& active = fitted.effects[e];
        const bool was_on = std::ranges::any_of(before.effects, [&](const ActiveEffect& other) {
            return other.effect == active.effect && other.name == active.name;
        });
        const bool is_user_effect = physics::is_user_effect(*active.effect);
        std::string lines = was_on           ? ""
                            : is_user_effect ? user_effect_text(active, user_effect)
                                             : switched_on_text(fitted, active);
        std::set<std::tuple<std::size_t, bool, Scope>> written;
        for (const solver::FreeParameter& number : parameters) {
            const bool here = number.kind == solver::FreeParameter::Kind::effect && number.effect == e && was_on;
            if (here && written.emplace(number.parameter, number.everywhere, number.scope).second) {
                lines += number.everywhere ? value_line(active, number.parameter)
                                           : places_line(fitted, active, number.parameter, number.scope);
            }
        }
        if (!lines.empty()) {
            // The pose and the emissivity of a camera stand in one table.
            const std::string head = heading(active);
            text += (head == last ? "" : head) + lines;
            last = head;
        }
    }
    return text;
}

}  // namespace tiretherm::input
