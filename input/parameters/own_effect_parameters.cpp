// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the user's own effects and of cameras, and the kind of all parameters of effects.
#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "input/effects/user_effects.hpp"
#include "input/parameters/effect_names.hpp"
#include "input/parameters/effect_parameters.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;

std::optional<FreeParameters> find_user_effect_parameter(const ParameterPath& path, const CaseAsRead& in) {
    const UserEffectKind& kind = path.keys[0].text == user_heat_source.list ? user_heat_source : user_heat_transfer;
    const LocatedString& name = path.keys[1];
    const std::vector<std::string> known = user_effect_names(in.document, kind.list);
    const std::string_view plural = kind.list == user_heat_source.list ? "sources" : "exchanges";
    if (!find_name(name, known, fmt::format("there is no [[{}]]", kind.list), plural, in.errors) ||
        !has_shape(path, in)) {
        return std::nullopt;
    }
    const EffectKey key = effect_key(path);
    if (key.key != kind.number) {
        return in.errors.add(key.at,
                             fmt::format("[[{}]] {} has no number \"{}\" to fit", kind.list, name.text, key.key),
                             fmt::format("its number is {}", kind.number));
    }
    const std::size_t index = solver::find_user_effect(in.problem, name.text);
    if (index == in.problem.effects.size()) {
        return std::nullopt;  // it has been reported
    }
    return free_effect_parameter(in, index, 0, key);
}

std::optional<FreeParameters> find_camera_parameter(const ParameterPath& path, const CaseAsRead& in) {
    const LocatedString& name = path.keys[1];
    if (std::ranges::find(in.cameras, name.text, &Camera::name) == in.cameras.end()) {
        return in.errors.add(
            name.place, fmt::format("there is no camera \"{}\"", name.text),
            in.cameras.empty() ? "add [[camera]] with this name" : suggest(name.text, names_of(in.cameras), "cameras"));
    }
    if (!has_shape(path, in)) {
        return std::nullopt;
    }
    // A camera's numbers are those of the effects that carry its name.
    const EffectKey key = effect_key(path);
    std::vector<std::string> known;
    for (std::size_t e = 0; e < in.problem.effects.size(); ++e) {
        const ActiveEffect& active = in.problem.effects[e];
        if (active.name != name.text || active.effect->sensor_model() == nullptr) {
            continue;
        }
        for (std::size_t p = 0; p < active.effect->parameters.size(); ++p) {
            const std::string_view its = active.effect->parameters[p].key;
            if (its == "reflected_temperature" && active.choices.front() == 0) {
                continue;
            }
            if (its == key.key) {
                return free_effect_parameter(in, e, p, key);
            }
            known.emplace_back(its);
        }
    }
    const bool is_grey = key.key == "emissivity" || key.key == "reflected_temperature";
    if (in.problem.mesh.n_nodes == 0 || key.key.empty() || (is_grey && path.find(in.document) != nullptr)) {
        return std::nullopt;
    }
    if (is_grey) {
        in.errors.add(
            key.at, fmt::format("the [[camera]] {} does not state {}", name.text, key.key),
            fmt::format("add {} to it: there the search begins",
                        key.key == "emissivity" ? "emissivity = 0.95" : "reflected_temperature = \"23 degC\""));
    } else {
        in.errors.add(key.at, fmt::format("a camera has no number \"{}\"", key.key),
                      suggest(key.key, known, "numbers"));
    }
    return std::nullopt;
}

/// Adds to a path the keys of a number: "h", or "h_by_patch" and "top" where patch = "top" is given beside the key.
/// @returns false after an error
bool add_number(TomlTable& table, LocatedString key, ParameterPath& path) {
    constexpr std::array<std::string_view, 4> words{"patch", "layer", "zone", "channel"};
    std::optional<LocatedString> place;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!table.has(words[i])) {
            continue;
        }
        if (place) {
            table.add_error(words[i], "a number is free at one place, and here are two", "keep one of them");
            return false;
        }
        place = located(table, words[i]);
        key.text += key.text.empty() ? "" : key_ending(static_cast<physics::Scope>(i));
    }
    const bool is_at_place = place && !key.text.empty();
    path.keys.push_back(std::move(key));
    if (is_at_place) {
        path.keys.push_back(std::move(*place));
    }
    return !is_at_place || !path.keys.back().text.empty();
}

/// The list in which the document has a user effect of this name; empty where it has none.
std::string_view list_of(const TomlValue& document, const std::string& name) {
    for (const UserEffectKind& kind : {user_heat_source, user_heat_transfer}) {
        if (std::ranges::count(user_effect_names(document, kind.list), name) > 0) {
            return kind.list;
        }
    }
    return {};
}

/// The path of an effect's number: the catalogue's, which has to be named, or the one of a user effect.
std::optional<ParameterPath> effect_path(TomlTable& table, std::string_view subject, const TomlValue& document) {
    table.declare_keys({"key", "patch", "layer", "zone", "channel"});
    const LocatedString name = located(table, subject);
    const std::string_view list = subject == "effect" ? list_of(document, name.text) : subject;
    LocatedString key = located(table, "key", list.empty() ? Need::required : Need::optional);
    if (!list.empty() && !table.has("key")) {
        key.text = (list == user_heat_source.list ? user_heat_source : user_heat_transfer).number;
    }
    ParameterPath path{.keys = {{list.empty() ? "effects" : std::string(list), table.place(subject)}, name}};
    const bool is_sound = add_number(table, std::move(key), path) && !name.text.empty();
    return is_sound ? std::optional(std::move(path)) : std::nullopt;
}

std::vector<ParameterPath> paths_of_effect(TomlTable& table, std::string_view subject, const TomlValue& document) {
    if (subject == "camera") {
        const LocatedString name = located(table, "camera");
        const LocatedString key = located(table, "key", Need::required);
        return {ParameterPath{.keys = {{"camera", table.place(subject)}, name, key}}};
    }
    std::optional<ParameterPath> path = effect_path(table, subject, document);
    return path ? std::vector{std::move(*path)} : std::vector<ParameterPath>{};
}

std::optional<FreeParameters> find_parameter(const ParameterPath& path, const CaseAsRead& in, const Knots& /*knots*/) {
    const std::string& first = path.keys.front().text;
    return first == "effects"  ? find_effect_parameter(path, in)
           : first == "camera" ? find_camera_parameter(path, in)
                               : find_user_effect_parameter(path, in);
}

ParameterPath path_of_parameter(const solver::Problem& problem, const solver::FreeParameter& number) {
    ParameterPath path = path_of(problem.effects[number.effect], number.parameter);
    if (!number.everywhere) {
        path.keys.back().text += key_ending(number.scope);
        path.keys.push_back({place_names(problem, number.scope)[static_cast<std::size_t>(number.place)], {}});
    }
    return path;
}

bool takes(const ParameterPath& path) {
    const std::array<std::string_view, 4> tables{"effects", user_heat_source.list, user_heat_transfer.list, "camera"};
    return std::ranges::find(tables, path.keys.front().text) != tables.end();
}

}  // namespace

ParameterKind effect_kind() {
    return {.subjects = {"effect", "source", "exchange", "camera"},
            .takes = takes,
            .has =
                [](const solver::FreeParameter& parameter) {
                    return parameter.kind == solver::FreeParameter::Kind::effect;
                },
            .paths_of_table = paths_of_effect,
            .find = find_parameter,
            .path_of = path_of_parameter,
            .write = write_effects};
}

}  // namespace tiretherm::input
