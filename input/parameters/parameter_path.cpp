// SPDX-License-Identifier: BSD-3-Clause
// Paths of keys through the document of a case, and the path of a number of a problem.
#include "input/parameters/parameter_path.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/effects/user_effects.hpp"
#include "input/text/characters.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/vehicle/vehicle_numbers.hpp"
#include "physics/signals.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

namespace {

using physics::Scope;

const std::string* name_of(const TomlValue& table) {
    const TomlValue* name = table.kind == TomlValue::Kind::table ? table.find("name") : nullptr;
    return name != nullptr && name->kind == TomlValue::Kind::text ? &name->text : nullptr;
}

/// The key with which a rest of a path begins: in a list the longest name of its tables, with or without dots in it,
/// otherwise what stands before the next dot.
std::string_view first_key(std::string_view rest, const TomlValue* list) {
    std::string_view found;
    for (std::size_t i = 0; list != nullptr && i < list->items.size(); ++i) {
        const std::string* name = name_of(list->items[i]);
        const bool here =
            name != nullptr && rest.starts_with(*name) && (rest.size() == name->size() || rest[name->size()] == '.');
        if (here && found.size() < name->size()) {
            found = rest.substr(0, name->size());
        }
    }
    return found.empty() ? rest.substr(0, rest.find('.')) : found;
}

std::vector<std::string> names_in(const TomlValue& list) {
    std::vector<std::string> names;
    for (const TomlValue& item : list.items) {
        if (const std::string* name = name_of(item)) {
            names.push_back(*name);
        }
    }
    return names;
}

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

Entry& entry_of(TomlValue& table, const LocatedString& key) {
    const auto known = std::ranges::find(table.entries, key.text, &Entry::key);
    if (known != table.entries.end()) {
        return *known;
    }
    TomlValue made;
    made.kind = TomlValue::Kind::table;
    made.place = key.place;
    table.entries.push_back({.key = key.text, .place = key.place, .value = std::move(made)});
    return table.entries.back();
}

/// The first `n` keys of a path with dots between them.
std::string joined(const std::vector<LocatedString>& keys, std::size_t n) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) {
        text += (i > 0 ? "." : "") + keys[i].text;
    }
    return text;
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
    ParameterPath path;
    const TomlValue* at = &document;
    for (std::size_t begin = 0; begin < text.text.size();) {
        const bool in_list = at != nullptr && at->kind == TomlValue::Kind::array;
        const std::string key(first_key(std::string_view(text.text).substr(begin), in_list ? at : nullptr));
        // The text begins behind its quotation mark.
        SourceLocation place = text.place;
        place.column += 1 + static_cast<int>(split_characters(text.text.substr(0, begin)).size());
        place.length = std::max<int>(1, static_cast<int>(split_characters(key).size()));
        path.keys.push_back({key, place});
        at = at == nullptr ? nullptr : in_list ? find_named(*at, key) : at->find(key);
        begin += key.size() + 1;
    }
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

const TomlValue* ParameterPath::find(const TomlValue& document) const {
    const TomlValue* at = &document;
    for (const LocatedString& key : keys) {
        at = at == nullptr                        ? nullptr
             : at->kind == TomlValue::Kind::array ? find_named(*at, key.text)
                                                  : at->find(key.text);
    }
    return at;
}

bool ParameterPath::set(TomlValue& document, const TomlValue& value, InputErrors& errors) const {
    TomlValue* at = &document;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const LocatedString& key = keys[i];
        const bool is_last = i + 1 == keys.size();
        if (at->kind == TomlValue::Kind::array) {
            const auto item = std::ranges::find_if(at->items, [&](const TomlValue& table) {
                const std::string* name = name_of(table);
                return name != nullptr && *name == key.text;
            });
            if (item == at->items.end()) {
                const std::vector<std::string> names = names_in(*at);
                errors.add(key.place, fmt::format("there is no \"{}\" in [[{}]]", key.text, joined(keys, i)),
                           names.empty() ? "its tables have no names, so none can be told from the others"
                                         : suggest(key.text, names, "names"));
                return false;
            }
            if (is_last) {
                SourceLocation whole = keys.front().place;
                whole.length = key.place.column + key.place.length - whole.column;
                errors.add(whole, fmt::format("\"{}\" is a table; one of its values is wanted", text()),
                           fmt::format("go on with a key of it: \"{}.key\"", text()));
                return false;
            }
            at = &*item;
            continue;
        }
        if (at->kind != TomlValue::Kind::table) {
            errors.add(key.place, fmt::format("{} is {}, which has no \"{}\"", joined(keys, i), shown(*at), key.text),
                       fmt::format("end the path there: \"{}\"", joined(keys, i)));
            return false;
        }
        Entry& entry = entry_of(*at, key);
        if (is_last) {
            entry.value = value;
            return true;
        }
        at = &entry.value;
    }
    return false;
}

const TomlValue* find_named(const TomlValue& list, std::string_view name) {
    const auto found = std::ranges::find_if(list.items, [&](const TomlValue& item) {
        const std::string* its = name_of(item);
        return its != nullptr && *its == name;
    });
    return found == list.items.end() ? nullptr : &*found;
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
