#include <fmt/format.h>

#include "input/effects/active.hpp"
#include "input/model/draft.hpp"
#include "input/effects/needs.hpp"
#include "input/effects/own_effects.hpp"
#include "input/text/words.hpp"
#include "physics/own_place.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;

void report_unknown(Section& effects) {
    std::vector<std::string> known;
    for (const Effect* effect : physics::catalogue()) {
        if (!physics::is_own(*effect)) {
            known.emplace_back(effect->id);
        }
    }
    for (const Entry& entry : effects.table().entries) {
        if (physics::find_effect(entry.key) == nullptr) {
            effects.know({entry.key});
            // The catalogue is too long for a message.
            const std::string remedy = nearest(entry.key, known).empty()
                                           ? fmt::format("`tiretherm effects` lists all {} of them", known.size())
                                           : suggest(entry.key, known, "effects");
            effects.mistakes().add(entry.place, fmt::format("there is no effect \"{}\"", entry.key), remedy);
        }
    }
}

/// The user's own effects have names and lists of their own.
void refuse_own(Section& section, const Effect& effect) {
    if (section.exists()) {
        const bool exchange = effect.id == own_exchange.effect;
        section.mistakes().add(
            section.place(), fmt::format("{} has a name and a list of its own", effect.id),
            fmt::format("write [[{}]] with name, follows, at and {}", exchange ? own_exchange.list : own_source.list,
                        exchange ? own_exchange.number : own_source.number));
        section.forgive();
    }
}

}  // namespace

void read_effects(Section& root, Draft& draft) {
    Section effects = root.section("effects");
    const std::size_t before = root.mistakes().count();
    report_unknown(effects);
    for (const Effect* effect : physics::catalogue()) {
        const std::string id(effect->id);
        Section section = effects.section(id);
        if (physics::is_own(*effect)) {
            refuse_own(section, *effect);
            continue;
        }
        const bool named = section.exists();
        const bool on = section.flag("on").value_or(named || (effect->on && (draft.has_tire || !effect->needs_tire)));
        ActiveEffect active = read_active(section, *effect, draft);
        if (on) {
            // What is on by itself is asked for by the tire; otherwise by its table.
            const Place asked = named ? section.place() : root.place("tire");
            check_needs(root, active, asked, section.has("patches"), draft);
            if (effect->extend != nullptr && draft.has_mesh) {
                solver::switch_on(draft.problem, std::move(active), 0.0);
            } else {
                draft.problem.effects.push_back(std::move(active));
            }
        }
    }
    check_signals(root, draft);
    draft.has_sound_effects = draft.has_mesh && root.mistakes().count() == before;
}

void bind_readings(Section& root, Draft& draft) {
    const Node* effects = root.table().find("effects");
    for (ActiveEffect& active : draft.problem.effects) {
        const Node* table = effects != nullptr ? effects->find(active.effect->id) : nullptr;
        if (active.effect->on_channels && table != nullptr && active.name.empty()) {
            Section section(*table, fmt::format("[effects.{}]", active.effect->id), root.mistakes());
            section.forgive();  // its other keys have been read
            bind_channels(section, draft, active);
        }
    }
    if (draft.has_sound_effects && root.mistakes().count() == 0) {
        check_weights(root, draft);
    }
    if (draft.has_sound_effects) {
        warn_of_unread_signals(root, draft);
        warn_of_doubles(root, draft);
    }
}

}  // namespace tiretherm::input
