#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "cases/parameter_kinds.hpp"
#include "cases/wanted.hpp"
#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

using physics::ActiveEffect;
using physics::Effect;
using physics::Scope;

struct PlaceKey {
    std::string_view key;
    std::string_view plural;
    Scope scope;
};
constexpr std::array places{PlaceKey{"patch", "patches", Scope::patch}, PlaceKey{"layer", "layers", Scope::layer},
                            PlaceKey{"zone", "zones", Scope::zone}, PlaceKey{"channel", "sensors", Scope::channel}};

/// Index of the parameter that a key names, or a mistake.
std::optional<std::size_t> read_key(const Section& section, const Effect& effect,
                                    const std::optional<std::string>& given) {
    if (!given) {
        return std::nullopt;
    }
    const std::string& key = *given;
    if (const int found = physics::find_parameter(effect, key); found >= 0) {
        return static_cast<std::size_t>(found);
    }
    if (physics::find_choice(effect, key) >= 0 || physics::find_table(effect, key) >= 0) {
        section.mistake("key",
                        fmt::format("{}.{} is {}, not a number", effect.id, key,
                                    physics::find_choice(effect, key) >= 0 ? "a word" : "a table"),
                        fmt::format("`tiretherm effects {}` lists its numbers", effect.id));
        return std::nullopt;
    }
    std::vector<std::string> known;
    for (const physics::Parameter& parameter : effect.parameters) {
        known.emplace_back(parameter.key);
    }
    section.mistake("key", fmt::format("{} has no parameter \"{}\"", effect.id, key),
                    suggest(key, known, "parameters"));
    return std::nullopt;
}

bool may_differ(const Effect& effect, Scope scope) {
    return scope == Scope::patch ? !effect.patches.empty()
                                 : std::find(effect.scopes.begin(), effect.scopes.end(), scope) != effect.scopes.end();
}

/// All places of a kind, and those of them where an effect acts.
struct Known {
    std::vector<std::string> names;
    std::vector<int> acting;
};

Known known_places(const Draft& draft, const ActiveEffect& active, Scope scope) {
    const mesh::Mesh& mesh = draft.problem.mesh;
    Known known;
    const auto all = [&] {
        for (std::size_t i = 0; i < known.names.size(); ++i) {
            known.acting.push_back(static_cast<int>(i));
        }
    };
    switch (scope) {
        case Scope::patch:
            known = {names_of(mesh.patches), active.patches};
            return known;
        case Scope::channel:
            known = {names_of(draft.problem.channels), active.channels};
            return known;
        case Scope::zone:
            known.names = mesh.zones;
            all();
            return known;
        case Scope::layer:
            known.names = mesh.layers;
            if (active.effect->on_layers) {
                known.acting = active.layers;
            } else {
                all();
            }
            return known;
    }
    return known;
}

/// The place where alone the number is free, if the table names one. @returns false after a mistake
bool read_place(Section& section, const Draft& draft, const ActiveEffect& active, solver::Adjustable& number) {
    const Effect& effect = *active.effect;
    bool sound = true;
    for (const PlaceKey& place : places) {
        const std::optional<std::string> name = section.text(place.key);
        if (!name) {
            continue;
        }
        if (!number.everywhere) {
            section.mistake(place.key, "a number is free at one place, and here are two", "keep one of them");
            return false;
        }
        number.everywhere = false;
        number.scope = place.scope;
        if (!may_differ(effect, place.scope)) {
            section.mistake(place.key, fmt::format("{} has the same values in all {}", effect.id, place.plural),
                            fmt::format("leave {} out: the value is free everywhere", place.key));
            sound = false;
            continue;
        }
        if (!draft.has_mesh) {
            return false;
        }
        const Known known = known_places(draft, active, place.scope);
        const auto found = std::find(known.names.begin(), known.names.end(), *name);
        number.place = static_cast<int>(found - known.names.begin());
        if (found == known.names.end()) {
            const std::string what = place.scope == Scope::channel
                                         ? fmt::format("there is no sensor \"{}\"", *name)
                                         : fmt::format("the mesh has no {} \"{}\"", place.key, *name);
            section.mistake(place.key, what, suggest(*name, known.names, place.plural));
            sound = false;
        } else if (std::find(known.acting.begin(), known.acting.end(), number.place) == known.acting.end()) {
            const bool is_channel = place.scope == Scope::channel;
            section.mistake(
                place.key,
                fmt::format("{} does not act on the {} \"{}\"", effect.id, is_channel ? "sensor" : place.key, *name),
                fmt::format("name it in {} of [effects.{}]", is_channel ? "channels" : place.plural, effect.id));
            sound = false;
        } else {
            number.name += " at " + *name;
        }
    }
    return sound;
}

void report_unknown(const Section& section, const std::string& id) {
    std::vector<std::string> known;
    for (const Effect* effect : physics::catalogue()) {
        known.emplace_back(effect->id);
    }
    section.mistake("effect", fmt::format("there is no effect \"{}\"", id),
                    nearest(id, known).empty() ? fmt::format("`tiretherm effects` lists all {} of them", known.size())
                                               : suggest(id, known, "effects"));
}

}  // namespace

std::optional<Freed> free_effect(Section& parameter, const Draft& draft, const Node* effects) {
    parameter.know({"patch", "layer", "zone", "channel"});
    const std::string id = parameter.text("effect").value_or("");
    const std::optional<std::string> key = parameter.text("key", Need::required);
    const Effect* effect = physics::find_effect(id);
    if (effect == nullptr) {
        report_unknown(parameter, id);
        return std::nullopt;
    }
    const std::optional<std::size_t> index = read_key(parameter, *effect, key);
    const std::vector<ActiveEffect>& on = draft.problem.effects;
    const auto active = std::find_if(on.begin(), on.end(), [&](const auto& other) { return other.effect == effect; });
    if (active == on.end()) {
        const bool named = effects != nullptr && effects->find(id) != nullptr;
        parameter.mistake("effect", fmt::format("{} is off: its numbers change nothing", id),
                          named ? fmt::format("switch it on: remove on = false from [effects.{}]", id)
                                : fmt::format("switch it on: add [effects.{}]", id));
        return std::nullopt;
    }
    if (!index) {
        return std::nullopt;
    }
    const physics::Parameter& found = effect->parameters[*index];
    solver::Adjustable number;
    number.name = fmt::format("{}.{}", id, found.key);
    number.unit = found.unit;
    number.kind = solver::Adjustable::Kind::effect;
    number.effect = static_cast<std::size_t>(active - on.begin());
    number.parameter = *index;
    number.low = found.low;
    number.high = found.high;
    if (!read_place(parameter, draft, *active, number)) {
        return std::nullopt;
    }
    return Freed{.numbers = {std::move(number)}, .wanted = wanted::of(found)};
}

}  // namespace tiretherm::cases
