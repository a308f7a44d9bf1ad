// SPDX-License-Identifier: BSD-3-Clause
// Parameters of effects that are on, everywhere or at one place.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/effects/effects.hpp"
#include "input/effects/user_effects.hpp"
#include "input/parameters/effect_names.hpp"
#include "input/parameters/effect_parameters.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;
using physics::Scope;

/// Index of the parameter that a key names, or an error.
std::optional<std::size_t> find_number(const CaseAsRead& in, const Effect& effect, const EffectKey& number) {
    const int found = physics::find_parameter(effect, number.key);
    if (found >= 0 || number.key.empty()) {
        return found >= 0 ? std::optional(static_cast<std::size_t>(found)) : std::nullopt;
    }
    const bool is_choice = physics::find_choice(effect, number.key) >= 0;
    if (is_choice || physics::find_table(effect, number.key) >= 0) {
        in.errors.add(number.at,
                      fmt::format("{}.{} is {}, not a number", effect.id, number.key, is_choice ? "a word" : "a table"),
                      fmt::format("`tiretherm effects {}` lists its numbers", effect.id));
    } else {
        in.errors.add(number.at, fmt::format("{} has no parameter \"{}\"", effect.id, number.key),
                      suggest(number.key, names_of(effect.parameters, &physics::ParameterSpec::key), "parameters"));
    }
    return std::nullopt;
}

bool may_differ(const Effect& effect, Scope scope) {
    return scope == Scope::patch ? !effect.patches.empty()
                                 : std::ranges::find(effect.scopes, scope) != effect.scopes.end();
}

/// Where an effect acts, as indices of the places of a kind.
std::vector<int> acting_places(const ActiveEffect& active, Scope scope, std::size_t n_places) {
    if (scope == Scope::patch) {
        return active.patches;
    }
    if (scope == Scope::channel) {
        return active.channels;
    }
    if (scope == Scope::layer && active.effect->on_layers) {
        return active.layers;
    }
    std::vector<int> all(n_places);
    for (std::size_t i = 0; i < n_places; ++i) {
        all[i] = static_cast<int>(i);
    }
    return all;
}

/// A camera as a place: it is many channels, so that the effect must act on nothing else.
bool resolve_camera_place(const CaseAsRead& in, const LocatedString& place, const Camera& camera,
                          const ActiveEffect& active, solver::FreeParameter& number) {
    const bool alone =
        std::ranges::all_of(active.channels, [&](int channel) { return camera.channels.contains(channel); });
    if (!alone || active.channels.empty() || !active.overrides.empty()) {
        in.errors.add(place.place,
                      alone ? fmt::format("{} does not act on the camera {}", active.title(), camera.name)
                            : fmt::format("{} acts on other sensors beside the camera {}", active.title(), camera.name),
                      "let it act on the camera alone, everywhere with one value");
        return false;
    }
    number.name += " at " + camera.name;
    return true;
}

struct ScopeWords {
    std::string_view key;
    std::string_view word;
    std::string_view plural;
};
constexpr std::array<ScopeWords, 4> scope_words{{{"patch", "patch", "patches"},
                                                 {"layer", "layer", "layers"},
                                                 {"zone", "zone", "zones"},
                                                 {"channel", "sensor", "sensors"}}};

/// The place where alone the number is free. @returns false after an error, or where the mesh is not known
bool resolve_place(const CaseAsRead& in, Scope scope, const LocatedString& place, const ActiveEffect& active,
                   solver::FreeParameter& number) {
    const ScopeWords& words = scope_words[static_cast<std::size_t>(scope)];
    const std::string& name = place.text;
    if (!may_differ(*active.effect, scope)) {
        in.errors.add(place.place, fmt::format("{} has the same values in all {}", active.title(), words.plural),
                      fmt::format("leave {} out: the value is free everywhere", words.key));
        return false;
    }
    if (in.problem.mesh.n_nodes == 0) {
        return false;
    }
    const std::vector<Camera>& cameras = in.cameras;
    const auto camera = std::ranges::find(cameras, name, &Camera::name);
    if (scope == Scope::channel && camera != cameras.end()) {
        return resolve_camera_place(in, place, *camera, active, number);
    }
    std::vector<std::string> known = place_names(in.problem, scope);
    if (scope == Scope::channel) {
        known.resize(in.problem.n_sensors());
    }
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
        in.errors.add(place.place,
                      scope == Scope::channel ? fmt::format("there is no sensor \"{}\"", name)
                                              : fmt::format("the mesh has no {} \"{}\"", words.word, name),
                      suggest(name, known, words.plural));
        return false;
    }
    number.everywhere = false;
    number.scope = scope;
    number.place = static_cast<int>(found - known.begin());
    number.name += " at " + name;
    const std::vector<int> acting = acting_places(active, scope, known.size());
    if (std::ranges::find(acting, number.place) == acting.end()) {
        in.errors.add(place.place, fmt::format("{} does not act on the {} \"{}\"", active.effect->id, words.word, name),
                      fmt::format("name it in {} of [effects.{}]", scope == Scope::channel ? "channels" : words.plural,
                                  active.effect->id));
        return false;
    }
    return true;
}

std::nullopt_t report_unknown_effect(const CaseAsRead& in, const LocatedString& id) {
    std::vector<std::string> own = user_effect_names(in.document, user_heat_source.list);
    std::ranges::copy(user_effect_names(in.document, user_heat_transfer.list), std::back_inserter(own));
    return in.errors.add(id.place, fmt::format("there is no effect \"{}\"", id.text),
                         unknown_effect_remedy(id.text, std::move(own)));
}

/// An effect on layers that is switched on without naming them leaves the outermost one out: a number that is to move all of them
/// would then move some.
std::string with_layers(const Effect& effect, const CaseAsRead& in) {
    const std::vector<std::string>& layers = in.problem.mesh.layers;
    if (!effect.on_layers || in.problem.mesh.n_nodes == 0 || layers.size() < 2) {
        return {};
    }
    return fmt::format(
        " with layers = [\"{}\"], or those of them that it is to act on; without layers it leaves {} out",
        fmt::join(layers, "\", \""), layers.front());
}

}  // namespace

EffectKey effect_key(const ParameterPath& path) {
    const LocatedString& last = path.keys[2];
    EffectKey found{.key = last.text, .at = last.place};
    for (const Scope scope : {Scope::patch, Scope::layer, Scope::zone, Scope::channel}) {
        if (path.keys.size() == 4 && last.text.ends_with(key_ending(scope))) {
            found.key.resize(last.text.size() - key_ending(scope).size());
            found.scope = scope;
            found.place = path.keys[3];
        }
    }
    return found;
}

bool has_shape(const ParameterPath& path, const CaseAsRead& in) {
    const std::size_t n = path.keys.size();
    const bool has_places = path.keys[0].text != "camera";
    const bool is_sound = n == 3 || (n == 4 && has_places && effect_key(path).scope);
    if (!is_sound) {
        const std::string whole = fmt::format("{}.{}", path.keys[0].text, path.keys[1].text);
        in.errors.add(path.keys[n == 2 ? 1 : 3].place, fmt::format("{} does not end at a number", path.text()),
                      has_places ? fmt::format("write \"{0}.KEY\", or at one place \"{0}.KEY_by_patch.PLACE\"", whole)
                                 : fmt::format("write \"{}.KEY\"", whole));
    }
    return is_sound;
}

std::optional<FreeParameters> free_effect_parameter(const CaseAsRead& in, std::size_t effect, std::size_t parameter,
                                                    const EffectKey& key) {
    const ActiveEffect& active = in.problem.effects[effect];
    const physics::ParameterSpec& found = active.effect->parameters[parameter];
    solver::FreeParameter number;
    number.name = fmt::format("{}.{}", active.title(), found.key);
    number.unit = found.unit;
    number.kind = solver::FreeParameter::Kind::effect;
    number.effect = effect;
    number.parameter = parameter;
    number.low = found.low;
    number.high = found.high;
    if (key.scope && !resolve_place(in, *key.scope, key.place, active, number)) {
        return std::nullopt;
    }
    return FreeParameters{.numbers = {std::move(number)}, .spec = quantity_specs::of(found)};
}

std::optional<FreeParameters> find_effect_parameter(const ParameterPath& path, const CaseAsRead& in) {
    const LocatedString& id = path.keys[1];
    const Effect* effect = physics::find_effect(id.text);
    if (effect == nullptr || physics::is_user_effect(*effect)) {
        return report_unknown_effect(in, id);
    }
    if (!has_shape(path, in)) {
        return std::nullopt;
    }
    const EffectKey key = effect_key(path);
    const std::optional<std::size_t> number = find_number(in, *effect, key);
    const std::vector<ActiveEffect>& on = in.problem.effects;
    // By its name: an effect that follows a field in frames has a description of its own.
    const auto active = std::ranges::find_if(on, [&](const ActiveEffect& one) { return one.effect->id == effect->id; });
    if (active == on.end()) {
        const TomlValue* effects = in.document.find("effects");
        const bool named = effects != nullptr && effects->find(id.text) != nullptr;
        return in.errors.add(id.place, fmt::format("{} is off: its numbers change nothing", id.text),
                             named
                                 ? fmt::format("switch it on: remove on = false from [effects.{}]", id.text)
                                 : fmt::format("switch it on: add [effects.{}]{}", id.text, with_layers(*effect, in)));
    }
    const int word = physics::find_choice(*effect, key.key);
    if (number && word >= 0 && active->choices[static_cast<std::size_t>(word)] != 0) {
        const std::string_view chosen =
            effect->choices[static_cast<std::size_t>(word)]
                .options[static_cast<std::size_t>(active->choices[static_cast<std::size_t>(word)])];
        return in.errors.add(key.at,
                             fmt::format("{}.{} is \"{}\" in this case, not a number", effect->id, key.key, chosen),
                             fmt::format("give [effects.{}] a number to begin with", effect->id));
    }
    return number ? free_effect_parameter(in, static_cast<std::size_t>(active - on.begin()), *number, key)
                  : std::nullopt;
}

ParameterPath path_of(const physics::ActiveEffect& active, std::size_t parameter) {
    const physics::Effect& effect = *active.effect;
    const std::string_view key = effect.parameters[parameter].key;
    if (physics::is_user_effect(effect)) {
        const UserEffectKind& kind = effect.id == user_heat_transfer.effect ? user_heat_transfer : user_heat_source;
        return ParameterPath::of({kind.list, active.name, key});
    }
    return active.name.empty() ? ParameterPath::of({"effects", effect.id, key})
                               : ParameterPath::of({"camera", active.name, key});
}

}  // namespace tiretherm::input
