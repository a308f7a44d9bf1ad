// SPDX-License-Identifier: BSD-3-Clause
// The catalogue of effects and the look-ups in it.
#include "physics/effect.hpp"

#include <algorithm>
#include <array>

namespace tiretherm::physics {

namespace effects {
#define EFFECT(id) extern const Effect id;
#include "physics/effects.list"
#undef EFFECT
}  // namespace effects

namespace {

#define EFFECT(id) &effects::id,
constexpr std::array list{
#include "physics/effects.list"
};
#undef EFFECT

template <typename Entries>
int find_key(const Entries& entries, std::string_view key) {
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.key == key; });
    return found == entries.end() ? -1 : static_cast<int>(found - entries.begin());
}

}  // namespace

ActiveEffect activate(const Effect& effect, const mesh::Mesh& mesh) {
    ActiveEffect active;
    active.effect = &effect;
    for (const ParameterSpec& parameter : effect.parameters) {
        active.parameters.push_back(parameter.standard);
    }
    active.choices.assign(effect.choices.size(), 0);
    for (const std::string_view name : effect.patches) {
        if (const int patch = mesh.find_patch(name); patch >= 0 && !(effect.one_patch && !active.patches.empty())) {
            active.patches.push_back(patch);
        }
    }
    active.tables.resize(effect.tables.size());
    const int n_layers = static_cast<int>(mesh.layers.size());
    for (int layer = n_layers > 1 ? 1 : 0; effect.on_layers && layer < n_layers; ++layer) {
        active.layers.push_back(layer);
    }
    return active;
}

void Effect::place(const PlacementContext& context, ActiveEffect& active) const {
    const auto placed_by = property_modifier() != nullptr ? property_modifier()->place
                           : heat_effect() != nullptr     ? heat_effect()->place
                                                          : nullptr;
    if (placed_by != nullptr) {
        placed_by(context, active);
    }
}

LossLaw Effect::loss_law() const {
    return property_modifier() != nullptr ? property_modifier()->scale_loss
           : heat_effect() != nullptr     ? heat_effect()->scale_loss
                                          : nullptr;
}

double ActiveEffect::at(std::size_t parameter, Scope scope, int index) const {
    const auto found = std::find_if(overrides.begin(), overrides.end(), [&](const Override& o) {
        return o.scope == scope && o.index == index && o.parameter == parameter;
    });
    return found == overrides.end() ? parameters[parameter] : found->value;
}

const ActiveEffect* PlacementContext::find(std::string_view id) const {
    const auto found =
        std::find_if(effects.begin(), effects.end(), [&](const ActiveEffect& e) { return e.effect->id == id; });
    return found == effects.end() ? nullptr : &*found;
}

int PlacementContext::index_of(std::string_view id) const {
    const ActiveEffect* found = find(id);
    return found == nullptr ? -1 : static_cast<int>(found - effects.data());
}

const Effect& in_frames(const Effect& effect) {
    static const std::vector<Effect> copies = [] {
        std::vector<Effect> made;
        for (const Effect* original : list) {
            if (const HeatEffect* heat = original->heat_effect(); heat != nullptr && heat->frame_coefficients > 0) {
                made.push_back(*original);
                std::get<HeatEffect>(made.back().model).n_coefficients += heat->frame_coefficients;
            }
        }
        return made;
    }();
    return *std::ranges::find(copies, effect.id, &Effect::id);
}

int find_parameter(const Effect& effect, std::string_view key) { return find_key(effect.parameters, key); }

int find_choice(const Effect& effect, std::string_view key) { return find_key(effect.choices, key); }

int find_table(const Effect& effect, std::string_view key) { return find_key(effect.tables, key); }

std::span<const Effect* const> catalogue() { return list; }

const Effect* find_effect(std::string_view id) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Effect* e) { return e->id == id; });
    return found == list.end() ? nullptr : *found;
}

}  // namespace tiretherm::physics
