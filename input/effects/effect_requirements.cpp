// SPDX-License-Identifier: BSD-3-Clause
// Implements the checks of tire, cells, patches, placement weights and input signals; each error names the remedy.

#include "input/effects/effect_requirements.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/model/probes.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "solver/system.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;

bool uses(const Effect& effect, std::string_view signal) {
    const auto lists = {effect.reads, effect.may_read};
    return std::any_of(lists.begin(), lists.end(), [&](std::span<const std::string_view> list) {
        return std::find(list.begin(), list.end(), signal) != list.end();
    });
}

/// How a column of the run's file becomes an input, with the columns whose names say nothing; empty without one.
/// @param sensors names of the case's sensors
std::string mapping_to(std::string_view input, const RunInputs& run, const std::vector<std::string>& sensors) {
    constexpr std::size_t shown = 8;
    std::vector<std::string> free;
    for (const std::string& heading : run.headings) {
        const bool used = heading.empty() || heading == "time" || physics::find_signal(heading) != nullptr ||
                          std::ranges::find(sensors, heading) != sensors.end();
        if (!used && free.size() <= shown) {
            free.push_back(free.size() < shown ? heading : "...");
        }
    }
    return free.empty() ? ""
                        : fmt::format("map a column of the file ({}) to it, columns = {{ COLUMN = \"{}\" }}, or ",
                                      fmt::join(free, ", "), input);
}

}  // namespace

void check_requirements(TomlTable& root, const ActiveEffect& active, const SourceLocation& place, bool chosen,
                        const ProblemBuilder& builder) {
    const Effect& effect = *active.effect;
    const std::string off = fmt::format("or switch it off: [effects.{}] on = false", effect.id);
    if (effect.needs_tire && !builder.has_tire) {
        root.errors().add(place, fmt::format("{} needs a tire", effect.id), fmt::format("add [tire], {}", off));
        return;
    }
    if (builder.has_mesh && effect.needs_grid && builder.problem.mesh.is_lumped()) {
        root.errors().add(place, fmt::format("{} needs cells, and this mesh has two lumps", effect.id),
                          fmt::format("take layers or section, {}", off));
        return;
    }
    if (builder.has_mesh && effect.invalid_on_mesh != nullptr) {
        if (const std::string sentence = effect.invalid_on_mesh(active, builder.problem.mesh); !sentence.empty()) {
            root.errors().add(place, fmt::format("{}: {}", effect.id, sentence));
        }
    }
    if (builder.has_mesh && !chosen && !effect.patches.empty() && active.patches.empty()) {
        const std::vector<std::string> patches = names_of(builder.problem.mesh.patches);
        const std::vector<std::string> standard(effect.patches.begin(), effect.patches.end());
        root.errors().add(
            place, fmt::format("{} acts on the patch {}, which this mesh does not have", effect.id, listed(standard)),
            fmt::format("choose from {}: [effects.{}] patches = [\"{}\"], {}", listed(patches), effect.id,
                        patches.front(), off));
    }
}

void check_weights(TomlTable& root, const ProblemBuilder& builder) {
    const solver::System system(builder.problem);
    for (const ActiveEffect& active : system.effects()) {
        if (std::ranges::any_of(active.weights, [](double weight) { return !std::isfinite(weight); })) {
            const TomlValue* effects = root.content().find("effects");
            const TomlValue* table = effects != nullptr ? effects->find(active.effect->id) : nullptr;
            root.errors().add(table != nullptr ? table->place : root.place(),
                              fmt::format("the weights of {} are zero everywhere on this mesh", active.title()),
                              "let its table or its shares be positive somewhere");
        }
    }
}

void warn_of_doubles(TomlTable& root, const ProblemBuilder& builder) {
    for (const ActiveEffect& active : builder.problem.effects) {
        const std::string_view other = active.effect->instead_of;
        if (!other.empty() && std::ranges::any_of(builder.problem.effects,
                                                  [&](const ActiveEffect& a) { return a.effect->id == other; })) {
            const TomlValue* table = root.content().find("effects")->find(active.effect->id);
            root.errors().warn(table->place, fmt::format("{0} and {1} both act and count the same heat twice: "
                                                         "[effects.{1}] on = false",
                                                         active.effect->id, other));
        }
    }
}

void check_signals(TomlTable& root, const ProblemBuilder& builder) {
    for (const physics::Signal& signal : physics::signals()) {
        std::vector<std::string> needing;
        for (const ActiveEffect& active : builder.problem.effects) {
            const auto reads = active.effect->reads;
            const bool can_act = builder.has_tire || !active.effect->needs_tire;
            if (can_act && std::find(reads.begin(), reads.end(), signal.name) != reads.end()) {
                needing.emplace_back(active.effect->id);
            }
        }
        if (!needing.empty() && !builder.given.contains(signal.name)) {
            const bool one = needing.size() == 1;
            const std::string lacking =
                builder.run
                    ? fmt::format(
                          "run {}: {} is missing (no column of its file is mapped to it and [drive] does not set it)",
                          builder.run->name, signal.name)
                    : fmt::format("[drive] lacks {}", signal.name);
            const std::string column =
                builder.run ? mapping_to(signal.name, *builder.run, sensor_names(root.content())) : "";
            root.errors().add(
                builder.run ? builder.run->place : root.place("drive"),
                fmt::format("{}, which {} {}", lacking, listed(needing), one ? "needs" : "need"),
                fmt::format("{}add {} = {}{}, or switch {} off: [effects.{}] on = false", column, signal.name,
                            spell_example(quantity_specs::of(signal)), builder.run ? " to [drive]" : "",
                            one ? "the effect" : "the effects", needing.front()));
        }
    }
}

void warn_of_unread_signals(TomlTable& root, const ProblemBuilder& builder) {
    std::vector<std::string> unread;
    for (const physics::Signal& signal : physics::signals()) {
        const bool by_effect = std::ranges::any_of(builder.problem.effects,
                                                   [&](const ActiveEffect& a) { return uses(*a.effect, signal.name); });
        const bool by_channel = std::ranges::any_of(builder.problem.channels, [&](const solver::Channel& channel) {
            const solver::QuantityDescription& quantity = solver::description_of(channel.quantity);
            // The Magic Formula follows the camber where there is any, but does not need it.
            return std::ranges::count(quantity.signals, signal.name) > 0 ||
                   (quantity.needs_magic_formula && signal.name == "camber");
        });
        const bool by_own = std::ranges::count(builder.followed, signal.name) > 0;
        if (builder.problem.input_signals.gives(signal) && !by_effect && !by_channel && !by_own) {
            unread.emplace_back(signal.name);
        }
    }
    if (!unread.empty()) {
        root.errors().warn(root.place("drive"), fmt::format("no active effect and no sensor uses {}", listed(unread)));
    }
}

}  // namespace tiretherm::input
