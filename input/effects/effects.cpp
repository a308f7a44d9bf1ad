// SPDX-License-Identifier: BSD-3-Clause
// Reads [effects]: switches the effects of the catalogue on or off, reports unknown names and binds sensor models to
// their channels.

#include <fmt/format.h>

#include "input/effects/active.hpp"
#include "input/effects/effect_requirements.hpp"
#include "input/effects/effects.hpp"
#include "input/effects/user_effects.hpp"
#include "input/text/suggestions.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;

void report_unknown(TomlTable& effects) {
    for (const Entry& entry : effects.content().entries) {
        if (physics::find_effect(entry.key) == nullptr) {
            effects.declare_keys({entry.key});
            effects.errors().add(entry.place, fmt::format("there is no effect \"{}\"", entry.key),
                                 unknown_effect_remedy(entry.key));
        }
    }
}

/// The user's own effects have names and lists of their own.
void refuse_user_effect(TomlTable& table, const Effect& effect) {
    if (table.exists()) {
        const bool exchange = effect.id == user_heat_transfer.effect;
        table.errors().add(table.place(), fmt::format("{} has a name and a list of its own", effect.id),
                           fmt::format("write [[{}]] with name, follows, at and {}",
                                       exchange ? user_heat_transfer.list : user_heat_source.list,
                                       exchange ? user_heat_transfer.number : user_heat_source.number));
        table.allow_unknown_keys();
    }
}

}  // namespace

std::string unknown_effect_remedy(std::string_view id, std::vector<std::string> known) {
    for (const Effect* effect : physics::catalogue()) {
        if (!physics::is_user_effect(*effect)) {
            known.emplace_back(effect->id);
        }
    }
    // The catalogue is too long for a message.
    return nearest(id, known).empty() ? "`tiretherm effects` lists all of them" : suggest(id, known, "effects");
}

bool read_effects(TomlTable& root, const EffectSurroundings& in, solver::Problem& problem) {
    const bool has_mesh = problem.mesh.n_nodes > 0;
    TomlTable effects = root.subtable("effects");
    const std::size_t before = root.errors().count();
    report_unknown(effects);
    for (const Effect* effect : physics::catalogue()) {
        const std::string id(effect->id);
        TomlTable table = effects.subtable(id);
        if (physics::is_user_effect(*effect)) {
            refuse_user_effect(table, *effect);
            continue;
        }
        const bool named = table.exists();
        const bool on = table.flag("on").value_or(named || (effect->on && (in.has_tire || !effect->needs_tire)));
        ActiveEffect active = read_active(table, *effect, problem.mesh);
        if (on) {
            // What is on by itself is asked for by the tire; otherwise by its table.
            const SourceLocation asked = named ? table.place() : root.place("tire");
            check_requirements(root, active, asked, table.has("patches"), in.has_tire, problem.mesh);
            if (has_mesh) {
                solver::switch_on(problem, std::move(active), 0.0);
            } else {
                problem.effects.push_back(std::move(active));
            }
        }
    }
    // Once for all effects, so that a signal that several of them lack is one error.
    check_signals(root, in, problem);
    return has_mesh && root.errors().count() == before;
}

void bind_readings(TomlTable& root, const std::vector<Camera>& cameras, solver::Problem& problem) {
    for (ActiveEffect& active : problem.effects) {
        const TomlValue* node = root.content().find({"effects", active.effect->id});
        if (active.effect->sensor_model() != nullptr && node != nullptr && active.name.empty()) {
            TomlTable table(*node, fmt::format("[effects.{}]", active.effect->id), root.errors());
            table.allow_unknown_keys();  // its other keys have been read
            bind_channels(table, cameras, problem, active);
        }
    }
}

void check_effects(TomlTable& root, const GivenSignals& given, const std::vector<std::string>& followed,
                   const solver::Problem& problem) {
    if (root.errors().count() == 0) {
        check_weights(root, problem);
    }
    warn_of_unread_signals(root, given, followed, problem);
    warn_of_doubles(root, problem);
    check_road(root, problem);
    warn_of_two_shares(root, given, problem);
}

}  // namespace tiretherm::input
