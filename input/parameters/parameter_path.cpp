// SPDX-License-Identifier: BSD-3-Clause
// Paths of keys through the document of a case, and the path of a number of a problem.
#include "input/parameters/parameter_path.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/effects/user_effects.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/vehicle/vehicle_numbers.hpp"
#include "physics/signals.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

namespace {

using physics::Scope;

/// A path of one key: users write "speed" for "drive.speed".
void refuse_short(const LocatedString& path, const TomlValue& document, InputErrors& errors) {
    std::vector<std::string> signals;
    for (const physics::Signal& signal : physics::signals()) {
        signals.emplace_back(signal.name);
    }
    const TomlValue* table = document.find(path.text);
    const std::string near = table == nullptr ? nearest(path.text, signals) : std::string();
    errors.add(path.place, fmt::format("\"{}\" is not the path of a value: table and key are wanted", path.text),
               near.empty() ? "write such as \"drive.speed\" or \"material.rubber.density\""
                            : fmt::format("did you mean \"drive.{}\"?", near));
}

ParameterPath path_of(std::initializer_list<std::string> keys) {
    ParameterPath path;
    for (const std::string& key : keys) {
        path.keys.push_back({key, {}});
    }
    return path;
}

/// The word of [initial] that means these nodes.
std::string initial_word(const mesh::Mesh& mesh, const std::vector<int>& nodes) {
    if (static_cast<int>(nodes.size()) == mesh.n_nodes) {
        return "temperature";
    }
    const int layer = mesh.layer[static_cast<std::size_t>(nodes.front())];
    if (layer >= 0) {
        return mesh.layers[static_cast<std::size_t>(layer)];
    }
    return std::ranges::find(mesh.lumped_nodes, nodes.front(), &mesh::LumpedNode::node)->name;
}

}  // namespace

std::optional<ParameterPath> ParameterPath::parse(const LocatedString& text, const TomlValue& document,
                                                  InputErrors& errors) {
    if (text.text.empty() || text.text.starts_with('.') || text.text.ends_with('.') ||
        text.text.find("..") != std::string::npos) {
        errors.add(text.place, fmt::format("\"{}\" is not a path: a key is missing at a dot", text.text),
                   "write such as \"drive.speed\"");
        return std::nullopt;
    }
    ParameterPath path{.keys = split_path(text, document)};
    if (path.keys.size() == 1) {
        refuse_short(text, document, errors);
        return std::nullopt;
    }
    return path;
}

ParameterPath ParameterPath::of(const physics::ActiveEffect& active, std::size_t parameter) {
    const physics::Effect& effect = *active.effect;
    const std::string key(effect.parameters[parameter].key);
    if (physics::is_user_effect(effect)) {
        const UserEffectKind& kind = effect.id == user_heat_transfer.effect ? user_heat_transfer : user_heat_source;
        return path_of({std::string(kind.list), active.name, key});
    }
    return active.name.empty() ? path_of({"effects", std::string(effect.id), key})
                               : path_of({"camera", active.name, key});
}

ParameterPath ParameterPath::of(const solver::Problem& problem, const solver::FreeParameter& number) {
    using Kind = solver::FreeParameter::Kind;
    switch (number.kind) {
        case Kind::effect: {
            ParameterPath path = of(problem.effects[number.effect], number.parameter);
            if (!number.everywhere) {
                path.keys.back().text += key_ending(number.scope);
                path.keys.push_back({place_names(problem, number.scope)[static_cast<std::size_t>(number.place)], {}});
            }
            return path;
        }
        case Kind::conductivity:
        case Kind::heat_capacity:
            return path_of({"material", problem.materials[static_cast<std::size_t>(number.layers.front())].name,
                            number.kind == Kind::conductivity ? "conductivity" : "heat_capacity"});
        case Kind::link_conductivity:
            return path_of({"mesh", "link_conductivity"});
        case Kind::initial:
            return path_of({"initial", initial_word(problem.mesh, number.nodes)});
        case Kind::input:
            return path_of({"vehicle", std::string(vehicle_numbers()[number.parameter].key)});
    }
    return {};
}

std::string ParameterPath::text() const { return joined(keys, keys.size()); }

bool ParameterPath::is_law() const {
    const std::string& last = keys.back().text;
    return (keys.size() == 3 && keys.front().text == "material" &&
            (last == "conductivity" || last == "heat_capacity")) ||
           (keys.size() == 2 && keys.front().text == "mesh" && last == "link_conductivity");
}

std::string key_ending(Scope scope) {
    constexpr std::array<std::string_view, 4> endings{"_by_patch", "_by_layer", "_by_zone", "_by_channel"};
    return std::string(endings[static_cast<std::size_t>(scope)]);
}

std::vector<std::string> place_names(const solver::Problem& problem, Scope scope) {
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

std::string sensor_of(const solver::Problem& problem, int channel) {
    const solver::CameraChannels* camera = problem.camera_of(channel);
    return camera != nullptr ? camera->camera : problem.channels[static_cast<std::size_t>(channel)].name;
}

std::string CatalogueEntry::text() const {
    return parameter ? fmt::format("{}.{}", effect->id, effect->parameters[*parameter].key) : std::string(effect->id);
}

std::optional<CatalogueEntry> find_in_catalogue(std::string_view text) {
    constexpr std::string_view table = "effects.";
    text.remove_prefix(text.starts_with(table) ? table.size() : 0);
    const std::string_view id = text.substr(0, text.find('.'));
    const physics::Effect* effect = physics::find_effect(id);
    if (effect == nullptr || id == text) {
        return effect == nullptr ? std::nullopt : std::optional(CatalogueEntry{.effect = effect});
    }
    const int parameter = physics::find_parameter(*effect, text.substr(id.size() + 1));
    return parameter < 0
               ? std::nullopt
               : std::optional(CatalogueEntry{.effect = effect, .parameter = static_cast<std::size_t>(parameter)});
}

}  // namespace tiretherm::input
