#include "cases/active.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "cases/wanted.hpp"
#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

using physics::ActiveEffect;
using physics::Effect;
using physics::Parameter;

/// An option by its word; true and false stand for "on" and "off" where an effect has these.
void read_choice(Section& section, const physics::Choice& choice, int& chosen) {
    const Node* value = section.value(choice.key);
    if (value != nullptr && value->kind == Node::Kind::boolean) {
        const std::string_view word = value->truth ? "on" : "off";
        const auto found = std::find(choice.options.begin(), choice.options.end(), word);
        if (found != choice.options.end()) {
            chosen = static_cast<int>(found - choice.options.begin());
            return;
        }
    }
    if (const auto index = section.choice(choice.key, choice.options)) {
        chosen = static_cast<int>(*index);
    }
}

void read_patches(Section& section, const Effect& effect, const Draft& draft, ActiveEffect& active) {
    if (effect.patches.empty()) {
        return;
    }
    const std::vector<Word> words = section.texts("patches");
    if (!draft.has_mesh || !section.has("patches")) {
        return;
    }
    if (words.empty()) {
        section.mistake("patches", "patches is an empty list",
                        fmt::format("name one, or switch the effect off: on = false"));
    }
    const mesh::Mesh& mesh = draft.problem.mesh;
    active.patches.clear();
    for (const Word& word : words) {
        const int patch = mesh.find_patch(word.text);
        if (patch < 0) {
            section.mistakes().add(word.place, fmt::format("the mesh has no patch \"{}\"", word.text),
                                   suggest(word.text, names_of(mesh.patches), "patches"));
        } else if (std::find(active.patches.begin(), active.patches.end(), patch) != active.patches.end()) {
            section.mistakes().add(word.place, fmt::format("the patch \"{}\" is named twice", word.text), "remove one");
        } else {
            active.patches.push_back(patch);
        }
    }
}

/// The table `<parameter>_by_patch`: other values on some of the effect's patches.
void read_by_patch(Section& section, const Parameter& parameter, std::size_t index, const Draft& draft,
                   ActiveEffect& active) {
    Section table = section.section(std::string(parameter.key) + "_by_patch");
    if (!table.exists()) {
        return;
    }
    if (!draft.has_mesh) {
        table.forgive();
        return;
    }
    const std::size_t n = active.parameters.size();
    if (active.by_patch.empty()) {
        for (std::size_t i = 0; i < active.patches.size(); ++i) {
            active.by_patch.insert(active.by_patch.end(), active.parameters.begin(), active.parameters.end());
        }
    }
    for (std::size_t i = 0; i < active.patches.size(); ++i) {
        const std::string& patch = draft.problem.mesh.patches[static_cast<std::size_t>(active.patches[i])].name;
        if (const auto value = table.quantity(patch, wanted::of(parameter))) {
            active.by_patch[i * n + index] = *value;
        }
    }
}

}  // namespace

ActiveEffect read_active(Section& section, const Effect& effect, const Draft& draft) {
    ActiveEffect active = physics::activate(effect, draft.problem.mesh);
    for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
        const Parameter& parameter = effect.parameters[i];
        active.parameters[i] = section.quantity(parameter.key, wanted::of(parameter)).value_or(parameter.standard);
    }
    for (std::size_t i = 0; i < effect.choices.size(); ++i) {
        read_choice(section, effect.choices[i], active.choices[i]);
    }
    read_patches(section, effect, draft, active);
    if (!effect.patches.empty()) {
        for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
            read_by_patch(section, effect.parameters[i], i, draft, active);
        }
    }
    return active;
}

}  // namespace tiretherm::cases
