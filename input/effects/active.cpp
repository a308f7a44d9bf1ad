// SPDX-License-Identifier: BSD-3-Clause
// Reads parameters, choices, patches and overrides (_by_patch, _by_layer, _by_zone, _by_channel), and binds sensor
// models to channels and cameras.

#include "input/effects/active.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/model/law.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;
using physics::ParameterSpec;

/// An option by its word; true and false stand for "on" and "off" where an effect has these.
void read_choice(TomlTable& table, const physics::Choice& choice, int& chosen) {
    const TomlValue* value = table.value(choice.key);
    if (value != nullptr && value->kind == TomlValue::Kind::boolean) {
        const std::string_view word = value->truth ? "on" : "off";
        const auto found = std::find(choice.options.begin(), choice.options.end(), word);
        if (found != choice.options.end()) {
            chosen = static_cast<int>(found - choice.options.begin());
            return;
        }
    }
    if (const auto index = table.choice(choice.key, choice.options)) {
        chosen = static_cast<int>(*index);
    }
}

/// Whether a parameter's key holds a word of the choice that goes by the same key.
bool is_choice(TomlTable& table, const Effect& effect, std::string_view key) {
    const int choice = physics::find_choice(effect, key);
    const TomlValue* value = choice >= 0 && table.has(key) ? table.value(key) : nullptr;
    return value != nullptr && value->kind == TomlValue::Kind::text &&
           // The first option is the number itself, which no word says.
           std::ranges::count(effect.choices[static_cast<std::size_t>(choice)].options.subspan(1), value->text) > 0;
}

/// A word where a number or a word of the choice that goes by the same key is wanted. @returns whether it was refused
bool refuse_word(TomlTable& table, const Effect& effect, std::string_view key) {
    const int choice = physics::find_choice(effect, key);
    const TomlValue* value = choice >= 0 && table.has(key) ? table.value(key) : nullptr;
    if (value == nullptr || value->kind != TomlValue::Kind::text || value->text.empty() ||
        std::isalpha(static_cast<unsigned char>(value->text.front())) == 0) {
        return false;
    }
    std::vector<std::string> words;
    for (const std::string_view word : effect.choices[static_cast<std::size_t>(choice)].options.subspan(1)) {
        words.push_back(fmt::format("\"{}\"", word));
    }
    table.add_error(key, fmt::format("{} is \"{}\"", key, value->text),
                    fmt::format("write a number, or {}", fmt::join(words, ", ")));
    return true;
}

/// A list of parts of the mesh: `patches` or `layers`. Without a mesh nothing is known of them.
/// @param plural what messages call them; the key itself
void read_parts(TomlTable& table, std::string_view plural, const std::vector<std::string>& known, bool has_mesh,
                std::vector<int>& parts) {
    const std::vector<LocatedString> words = table.texts(plural);
    if (!has_mesh || !table.has(plural)) {
        return;
    }
    const std::string one(plural.substr(0, plural == "patches" ? 5 : plural.size() - 1));
    if (words.empty()) {
        table.add_error(plural, fmt::format("{} is an empty list", plural),
                        fmt::format("name one, or switch the effect off: on = false"));
    }
    parts.clear();
    for (const LocatedString& word : words) {
        const auto part = find_name(word, known, fmt::format("the mesh has no {}", one), plural, table.errors());
        if (part && std::ranges::count(parts, static_cast<int>(*part)) > 0) {
            table.errors().add(word.place, fmt::format("the {} \"{}\" is named twice", one, word.text), "remove one");
        } else if (part) {
            parts.push_back(static_cast<int>(*part));
        }
    }
}

/// Names that a table of overrides may use, and the key's ending.
struct Overridable {
    physics::Scope scope;
    std::string_view ending;
    std::vector<std::string> names;
};

std::vector<Overridable> overridable(const Effect& effect, const mesh::Mesh& mesh, const ActiveEffect& active) {
    std::vector<Overridable> found;
    if (!effect.patches.empty()) {
        std::vector<std::string> names;
        for (const int patch : active.patches) {
            names.push_back(mesh.patches[static_cast<std::size_t>(patch)].name);
        }
        found.push_back({physics::Scope::patch, "_by_patch", std::move(names)});
    }
    for (const physics::Scope scope : effect.scopes) {
        if (scope == physics::Scope::layer) {
            found.push_back({scope, "_by_layer", mesh.layers});
        } else if (scope == physics::Scope::zone && !mesh.zones.empty()) {
            found.push_back({scope, "_by_zone", mesh.zones});
        }
    }
    return found;
}

int find_part(const mesh::Mesh& mesh, physics::Scope scope, std::string_view name) {
    switch (scope) {
        case physics::Scope::patch:
            return mesh.find_patch(name);
        case physics::Scope::layer:
            return mesh.find_layer(name);
        case physics::Scope::zone:
            return mesh.find_zone(name);
        case physics::Scope::channel:
            break;
    }
    return -1;
}

/// The table `<parameter>_by_patch`, `_by_layer` or `_by_zone`: other values at some places.
void read_overrides(TomlTable& table, const ParameterSpec& parameter, std::size_t index, const Overridable& where,
                    const mesh::Mesh& mesh, ActiveEffect& active) {
    TomlTable values = table.subtable(std::string(parameter.key) + std::string(where.ending));
    if (!values.exists()) {
        return;
    }
    if (mesh.n_nodes == 0) {
        values.allow_unknown_keys();
        return;
    }
    for (const std::string& name : where.names) {
        if (const auto value = values.quantity(name, quantity_specs::of(parameter))) {
            active.overrides.push_back({.scope = where.scope,
                                        .index = find_part(mesh, where.scope, name),
                                        .parameter = index,
                                        .value = *value});
        }
    }
}

}  // namespace

ActiveEffect read_active(TomlTable& table, const Effect& effect, const mesh::Mesh& mesh) {
    const bool has_mesh = mesh.n_nodes > 0;
    ActiveEffect active = physics::activate(effect, mesh);
    for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
        const ParameterSpec& parameter = effect.parameters[i];
        active.parameters[i] =
            is_choice(table, effect, parameter.key) || refuse_word(table, effect, parameter.key)
                ? parameter.standard
                : table.quantity(parameter.key, quantity_specs::of(parameter)).value_or(parameter.standard);
    }
    for (std::size_t i = 0; i < effect.choices.size(); ++i) {
        const std::string_view key = effect.choices[i].key;
        if (physics::find_parameter(effect, key) < 0 || is_choice(table, effect, key)) {
            read_choice(table, effect.choices[i], active.choices[i]);
        }
    }
    for (std::size_t i = 0; i < effect.tables.size(); ++i) {
        const physics::Table& curve = effect.tables[i];
        active.tables[i] = read_curve(table, curve.key, {.unit = curve.variable_unit, .low = -1e6, .high = 1e6},
                                      {.unit = curve.value_unit, .low = 0.0, .high = 1e9});
    }
    if (!effect.patches.empty()) {
        read_parts(table, "patches", names_of(mesh.patches), has_mesh, active.patches);
    }
    if (effect.on_layers) {
        read_parts(table, "layers", mesh.layers, has_mesh, active.layers);
    }
    for (const Overridable& where : overridable(effect, mesh, active)) {
        for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
            read_overrides(table, effect.parameters[i], i, where, mesh, active);
        }
    }
    if (effect.field() != physics::FieldOf::nothing) {  // read when the run's times are known
        static_cast<void>(table.text("field"));         // here also of an effect that is off
        if (effect.field() != physics::FieldOf::pressure) {
            table.declare_keys({"use"});
        }
        if (effect.field() == physics::FieldOf::loss) {
            table.declare_keys({"total", "coastdown"});
        }
    }
    if (effect.sensor_model() != nullptr) {  // read when the sensors are known
        static_cast<void>(table.texts("channels"));
        for (const ParameterSpec& parameter : effect.parameters) {
            table.declare_keys({std::string(parameter.key) + "_by_channel"});
        }
    }
    return active;
}

namespace {

/// Whether a sensor model can stand behind a channel.
void check_channel(TomlTable& table, const LocatedString& word, const Effect& effect, const solver::Channel& channel) {
    const bool is_temperature = channel.quantity == solver::Quantity::temperature;
    const auto refuse = [&](std::string_view wanted) {
        table.errors().add(word.place, fmt::format("{} is not {}, which {} reads", channel.name, wanted, effect.id),
                           "name other sensors");
    };
    switch (effect.sensor_model()->applies_to) {
        case physics::ChannelsOf::anything:
            return;
        case physics::ChannelsOf::temperature:
            return is_temperature ? void() : refuse("a temperature");
        case physics::ChannelsOf::temperature_at_point:
            return is_temperature && channel.point ? void() : refuse("a temperature at one point");
        case physics::ChannelsOf::pressure:
            return channel.quantity == solver::Quantity::gas_pressure ? void() : refuse("a pressure");
    }
}

/// Puts a sensor model behind all that a camera sees.
void bind_camera(TomlTable& table, const LocatedString& word, const Camera& camera, const solver::Problem& problem,
                 ActiveEffect& active) {
    const bool has_own = std::ranges::any_of(problem.effects, [&](const ActiveEffect& other) {
        return other.name == camera.name && other.effect == active.effect;
    });
    if (has_own) {
        table.errors().add(word.place, fmt::format("the [[camera]] {} has an emissivity of its own", camera.name),
                           "state it once");
        return;
    }
    if (camera.channels.count > 0) {
        check_channel(table, word, *active.effect, problem.channels[camera.channels.first]);
    }
    for (std::size_t channel = camera.channels.first; channel < camera.channels.end(); ++channel) {
        active.channels.push_back(static_cast<int>(channel));
    }
}

}  // namespace

void bind_channels(TomlTable& table, const std::vector<Camera>& cameras, const solver::Problem& problem,
                   ActiveEffect& active) {
    // A camera's channels go by the camera's name.
    std::vector<std::string> known = names_of(problem.channels);
    known.resize(problem.n_sensors());
    const std::string example = fmt::format("write channels = [\"{}\"]", known.empty() ? "..." : known.front());
    if (!table.has("channels")) {
        table.add_error("channels", fmt::format("{} lacks channels: which sensors read so", table.title()), example);
    }
    for (const LocatedString& word : table.texts("channels")) {
        if (const auto camera = std::ranges::find(cameras, word.text, &Camera::name); camera != cameras.end()) {
            bind_camera(table, word, *camera, problem, active);
        } else if (const auto channel = find_name(word, known, "there is no sensor", "sensors", table.errors())) {
            active.channels.push_back(static_cast<int>(*channel));
            check_channel(table, word, *active.effect, problem.channels[*channel]);
        }
    }
    for (std::size_t i = 0; i < active.effect->parameters.size(); ++i) {
        const ParameterSpec& parameter = active.effect->parameters[i];
        TomlTable values = table.subtable(std::string(parameter.key) + "_by_channel");
        if (!values.exists()) {
            continue;
        }
        if (problem.mesh.n_nodes == 0) {
            values.allow_unknown_keys();  // a camera has no channels then
        }
        std::map<std::string, std::optional<double>> read;  // a camera's once for all its channels
        for (const int channel : active.channels) {
            const solver::CameraChannels* camera = problem.camera_of(channel);
            const std::string& name =
                camera != nullptr ? camera->camera : problem.channels[static_cast<std::size_t>(channel)].name;
            const auto [value, is_new] = read.try_emplace(name);
            if (is_new) {
                value->second = values.quantity(name, quantity_specs::of(parameter));
            }
            if (value->second) {
                active.overrides.push_back(
                    {.scope = physics::Scope::channel, .index = channel, .parameter = i, .value = *value->second});
            }
        }
    }
}

}  // namespace tiretherm::input
