#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/parameters/parameter_kinds.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "physics/user_effect_place.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::input {

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

/// Index of the parameter that a key names, or an error.
std::optional<std::size_t> read_key(const TomlTable& table, const Effect& effect,
                                    const std::optional<std::string>& given) {
    if (!given) {
        return std::nullopt;
    }
    const std::string& key = *given;
    if (const int found = physics::find_parameter(effect, key); found >= 0) {
        return static_cast<std::size_t>(found);
    }
    if (physics::find_choice(effect, key) >= 0 || physics::find_table(effect, key) >= 0) {
        table.add_error("key",
                        fmt::format("{}.{} is {}, not a number", effect.id, key,
                                    physics::find_choice(effect, key) >= 0 ? "a word" : "a table"),
                        fmt::format("`tiretherm effects {}` lists its numbers", effect.id));
        return std::nullopt;
    }
    std::vector<std::string> known;
    for (const physics::ParameterSpec& parameter : effect.parameters) {
        known.emplace_back(parameter.key);
    }
    table.add_error("key", fmt::format("{} has no parameter \"{}\"", effect.id, key),
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

Known known_places(const ProblemBuilder& builder, const ActiveEffect& active, Scope scope) {
    const mesh::Mesh& mesh = builder.problem.mesh;
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
            known = {names_of(builder.problem.channels), active.channels};
            known.names.resize(builder.problem.n_sensors());
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

/// A camera as that place: it is many channels, so that the effect must act on nothing else.
bool read_camera(TomlTable& table, const Camera& camera, const ActiveEffect& active, solver::FreeParameter& number) {
    const bool alone =
        std::ranges::all_of(active.channels, [&](int channel) { return camera.channels.contains(channel); });
    if (!alone || active.channels.empty() || !active.overrides.empty()) {
        table.add_error("channel",
                        alone
                            ? fmt::format("{} does not act on the camera {}", active.title(), camera.name)
                            : fmt::format("{} acts on other sensors beside the camera {}", active.title(), camera.name),
                        "let it act on the camera alone, everywhere with one value");
        return false;
    }
    number.everywhere = true;
    number.name += " at " + camera.name;
    return true;
}

/// The place where alone the number is free, if the table names one. @returns false after an error
bool read_place(TomlTable& table, const ProblemBuilder& builder, const ActiveEffect& active,
                solver::FreeParameter& number) {
    const Effect& effect = *active.effect;
    bool sound = true;
    for (const PlaceKey& place : places) {
        const std::optional<std::string> name = table.text(place.key);
        if (!name) {
            continue;
        }
        if (!number.everywhere) {
            table.add_error(place.key, "a number is free at one place, and here are two", "keep one of them");
            return false;
        }
        number.everywhere = false;
        number.scope = place.scope;
        if (!may_differ(effect, place.scope)) {
            table.add_error(place.key, fmt::format("{} has the same values in all {}", active.title(), place.plural),
                            fmt::format("leave {} out: the value is free everywhere", place.key));
            sound = false;
            continue;
        }
        if (!builder.has_mesh) {
            return false;
        }
        const auto camera = std::ranges::find(builder.cameras, *name, &Camera::name);
        if (place.scope == Scope::channel && camera != builder.cameras.end()) {
            sound = read_camera(table, *camera, active, number) && sound;
            continue;
        }
        const Known known = known_places(builder, active, place.scope);
        const auto found = std::find(known.names.begin(), known.names.end(), *name);
        number.place = static_cast<int>(found - known.names.begin());
        if (found == known.names.end()) {
            const std::string what = place.scope == Scope::channel
                                         ? fmt::format("there is no sensor \"{}\"", *name)
                                         : fmt::format("the mesh has no {} \"{}\"", place.key, *name);
            table.add_error(place.key, what, suggest(*name, known.names, place.plural));
            sound = false;
        } else if (std::find(known.acting.begin(), known.acting.end(), number.place) == known.acting.end()) {
            const bool is_channel = place.scope == Scope::channel;
            table.add_error(
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

void report_unknown(const TomlTable& table, const std::string& id, const TomlValue& document) {
    std::vector<std::string> known;
    for (const Effect* effect : physics::catalogue()) {
        if (!physics::is_user_effect(*effect)) {
            known.emplace_back(effect->id);
        }
    }
    const std::size_t of_the_catalogue = known.size();
    for (const UserEffectKind& kind : {user_heat_source, user_heat_transfer}) {
        std::ranges::copy(user_effect_names(document, kind.list), std::back_inserter(known));
    }
    table.add_error("effect", fmt::format("there is no effect \"{}\"", id),
                    nearest(id, known).empty()
                        ? fmt::format("`tiretherm effects` lists all {} of them", of_the_catalogue)
                        : suggest(id, known, "effects"));
}

/// The kind of a user effect, null where the document has none of this name.
const UserEffectKind* kind_of(const TomlValue& document, const std::string& name) {
    for (const UserEffectKind* kind : {&user_heat_source, &user_heat_transfer}) {
        if (std::ranges::count(user_effect_names(document, kind->list), name) > 0) {
            return kind;
        }
    }
    return nullptr;
}

/// A number of an effect as it may be moved.
solver::FreeParameter number_of(const ProblemBuilder& builder, std::size_t effect, std::size_t parameter) {
    const ActiveEffect& active = builder.problem.effects[effect];
    const physics::ParameterSpec& found = active.effect->parameters[parameter];
    solver::FreeParameter number;
    number.name = fmt::format("{}.{}", active.title(), found.key);
    number.unit = found.unit;
    number.kind = solver::FreeParameter::Kind::effect;
    number.effect = effect;
    number.parameter = parameter;
    number.low = found.low;
    number.high = found.high;
    return number;
}

/// The one number of a user effect that is called `name`.
std::optional<FreeParameters> free_number(TomlTable& parameter, const ProblemBuilder& builder, const std::string& name,
                                          const UserEffectKind& kind) {
    const Effect& effect = *physics::find_effect(kind.effect);
    const std::string key = parameter.text("key").value_or(std::string(kind.number));
    if (key != kind.number) {
        parameter.add_error("key", fmt::format("[[{}]] {} has no number \"{}\" to fit", kind.list, name, key),
                            fmt::format("its number is {}", kind.number));
        return std::nullopt;
    }
    const std::size_t index = solver::find_user_effect(builder.problem, name);
    if (index == builder.problem.effects.size()) {
        return std::nullopt;  // it has been reported
    }
    solver::FreeParameter number = number_of(builder, index, 0);
    if (!read_place(parameter, builder, builder.problem.effects[index], number)) {
        return std::nullopt;
    }
    return FreeParameters{.numbers = {std::move(number)}, .spec = quantity_specs::of(effect.parameters.front())};
}

}  // namespace

std::optional<FreeParameters> free_user_effect(TomlTable& parameter, const ProblemBuilder& builder,
                                               const TomlValue& document, const UserEffectKind& kind) {
    parameter.declare_keys({"key", "patch", "layer", "zone", "channel"});
    const std::optional<std::string> name = parameter.text(kind.list);
    if (!name) {
        return std::nullopt;
    }
    const std::vector<std::string> known = user_effect_names(document, kind.list);
    if (std::ranges::count(known, *name) == 0) {
        parameter.add_error(kind.list, fmt::format("there is no [[{}]] \"{}\"", kind.list, *name),
                            suggest(*name, known, kind.list == user_heat_source.list ? "sources" : "exchanges"));
        return std::nullopt;
    }
    return free_number(parameter, builder, *name, kind);
}

std::optional<FreeParameters> free_effect(TomlTable& parameter, const ProblemBuilder& builder,
                                          const TomlValue& document) {
    parameter.declare_keys({"patch", "layer", "zone", "channel"});
    const std::string id = parameter.text("effect").value_or("");
    if (const UserEffectKind* own = kind_of(document, id)) {
        return free_number(parameter, builder, id, *own);
    }
    const std::optional<std::string> key = parameter.text("key", Need::required);
    const Effect* effect = physics::find_effect(id);
    if (effect == nullptr || physics::is_user_effect(*effect)) {
        report_unknown(parameter, id, document);
        return std::nullopt;
    }
    const std::optional<std::size_t> index = read_key(parameter, *effect, key);
    const std::vector<ActiveEffect>& on = builder.problem.effects;
    const auto active = std::find_if(on.begin(), on.end(), [&](const auto& other) { return other.effect->id == id; });
    if (active == on.end()) {
        const TomlValue* effects = document.find("effects");
        const bool named = effects != nullptr && effects->find(id) != nullptr;
        parameter.add_error("effect", fmt::format("{} is off: its numbers change nothing", id),
                            named ? fmt::format("switch it on: remove on = false from [effects.{}]", id)
                                  : fmt::format("switch it on: add [effects.{}]", id));
        return std::nullopt;
    }
    if (!index) {
        return std::nullopt;
    }
    const physics::ParameterSpec& found = effect->parameters[*index];
    solver::FreeParameter number = number_of(builder, static_cast<std::size_t>(active - on.begin()), *index);
    if (!read_place(parameter, builder, *active, number)) {
        return std::nullopt;
    }
    return FreeParameters{.numbers = {std::move(number)}, .spec = quantity_specs::of(found)};
}

}  // namespace tiretherm::input
