// SPDX-License-Identifier: BSD-3-Clause
// Endings of keys by place, names of places and channels, and entries of the catalogue.
#include "input/parameters/effect_names.hpp"

#include <array>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"

namespace tiretherm::input {

using physics::Scope;

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
