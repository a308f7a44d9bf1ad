#include <fmt/format.h>

#include "cases/active.hpp"
#include "cases/draft.hpp"
#include "cases/needs.hpp"
#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

using physics::ActiveEffect;
using physics::Effect;

void report_unknown(Section& effects) {
    std::vector<std::string> known;
    for (const Effect* effect : physics::catalogue()) {
        known.emplace_back(effect->id);
    }
    for (const Entry& entry : effects.table().entries) {
        if (physics::find_effect(entry.key) == nullptr) {
            effects.know({entry.key});
            effects.mistakes().add(entry.place, fmt::format("there is no effect \"{}\"", entry.key),
                                   suggest(entry.key, known, "effects"));
        }
    }
}

}  // namespace

void read_effects(Section& root, Draft& draft) {
    Section effects = root.section("effects");
    Mistakes& mistakes = root.mistakes();
    const std::size_t before = mistakes.count();
    report_unknown(effects);
    for (const Effect* effect : physics::catalogue()) {
        const std::string id(effect->id);
        Section section = effects.section(id);
        const bool named = section.exists();
        const bool on = section.flag("on").value_or(named || (effect->on && (draft.has_tire || !effect->needs_tire)));
        ActiveEffect active = read_active(section, *effect, draft);
        if (on) {
            // What is on by itself is asked for by the tire; otherwise by its table.
            const Place asked = named ? section.place() : root.place("tire");
            check_needs(root, active, asked, section.has("patches"), draft);
            draft.problem.effects.push_back(std::move(active));
        }
    }
    check_signals(root, draft);
    if (mistakes.count() > before || !draft.has_mesh) {  // what cannot be placed has been complained about
        return;
    }
    const physics::Setting setting{
        .mesh = draft.problem.mesh, .materials = draft.problem.materials, .tire = draft.problem.tire};
    for (ActiveEffect& active : draft.problem.effects) {
        if (active.effect->place != nullptr) {
            active.effect->place(setting, active);
        }
    }
    warn_of_unread_signals(root, draft);
}

}  // namespace tiretherm::cases
