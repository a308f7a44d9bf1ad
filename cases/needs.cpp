#include "cases/needs.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "cases/wanted.hpp"
#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

using physics::ActiveEffect;
using physics::Effect;

/// Whether an effect's intensities change with a signal: signals that an effect can do without are in no list of it.
bool responds(const ActiveEffect& active, const physics::Tire& tire, const physics::Signal& signal) {
    const Effect& effect = *active.effect;
    if (std::find(effect.reads.begin(), effect.reads.end(), signal.name) != effect.reads.end()) {
        return true;
    }
    if (effect.drive == nullptr) {
        return false;
    }
    // A tire that rolls, corners, brakes and stands under a laser: every product has factors that are not zero.
    physics::Inputs inputs{.speed = 20.0,
                           .vertical_load = 4000.0,
                           .slip_angle = 0.05,
                           .slip_ratio = 0.05,
                           .lateral_force = 1000.0,
                           .longitudinal_force = 1000.0,
                           .camber = 0.02,
                           .inflation_pressure = 2.2e5,
                           .air_temperature = 300.0,
                           .road_temperature = 310.0,
                           .wet = 1.0,
                           .laser_power = 1.0};
    std::vector<double> before(static_cast<std::size_t>(effect.n_intensities));
    effect.drive(active, tire, inputs, before);
    const double full = inputs.*signal.member;
    return std::ranges::any_of(std::array{0.5 * full, 0.0}, [&](double other) {
        inputs.*signal.member = other;
        std::vector<double> after(before.size());
        effect.drive(active, tire, inputs, after);
        return before != after;
    });
}

}  // namespace

void check_needs(Section& root, const ActiveEffect& active, const Place& place, bool chosen, const Draft& draft) {
    const Effect& effect = *active.effect;
    const std::string off = fmt::format("or switch it off: [effects.{}] on = false", effect.id);
    if (effect.needs_tire && !draft.has_tire) {
        root.mistakes().add(place, fmt::format("{} needs a tire", effect.id), fmt::format("add [tire], {}", off));
        return;
    }
    if (draft.has_mesh && !chosen && !effect.patches.empty() && active.patches.empty()) {
        const std::vector<std::string> patches = names_of(draft.problem.mesh.patches);
        const std::vector<std::string> standard(effect.patches.begin(), effect.patches.end());
        root.mistakes().add(
            place, fmt::format("{} acts on the patch {}, which this mesh does not have", effect.id, listed(standard)),
            fmt::format("choose from {}: [effects.{}] patches = [\"{}\"], {}", listed(patches), effect.id,
                        patches.front(), off));
    }
}

void check_signals(Section& root, const Draft& draft) {
    for (const physics::Signal& signal : physics::signals()) {
        std::vector<std::string> needing;
        for (const ActiveEffect& active : draft.problem.effects) {
            const auto reads = active.effect->reads;
            const bool can_act = draft.has_tire || !active.effect->needs_tire;
            if (can_act && std::find(reads.begin(), reads.end(), signal.name) != reads.end()) {
                needing.emplace_back(active.effect->id);
            }
        }
        if (!needing.empty() && !draft.given.contains(signal.name)) {
            const bool one = needing.size() == 1;
            root.mistakes().add(
                root.place("drive"),
                fmt::format("[drive] lacks {}, which {} {}", signal.name, listed(needing), one ? "needs" : "need"),
                fmt::format("add {} = {}, or switch {} off: [effects.{}] on = false", signal.name,
                            spell_example(wanted::of(signal)), one ? "the effect" : "the effects", needing.front()));
        }
    }
}

void warn_of_unread_signals(Section& root, const Draft& draft) {
    std::vector<std::string> unread;
    for (const physics::Signal& signal : physics::signals()) {
        const auto& effects = draft.problem.effects;
        if (draft.problem.drive.gives(signal) &&
            std::none_of(effects.begin(), effects.end(),
                         [&](const ActiveEffect& active) { return responds(active, draft.problem.tire, signal); })) {
            unread.emplace_back(signal.name);
        }
    }
    if (!unread.empty()) {
        root.mistakes().warn(root.place("drive"), fmt::format("no active effect uses {}", listed(unread)));
    }
}

}  // namespace tiretherm::cases
