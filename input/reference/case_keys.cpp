// SPDX-License-Identifier: BSD-3-Clause
// Joins what the readers ask (KeyRecord) with the sentences of keys.list.
#include "input/reference/case_keys.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "physics/effect.hpp"

namespace tiretherm::input {

namespace {

/// A line of keys.list; `key` is empty for a table.
struct Sentence {
    std::string_view table;
    std::string_view key;
    std::string_view text;
    bool is_table;
};

constexpr Sentence sentences[] = {
#define TABLE(path, text) {path, "", text, true},
#define KEY(path, key, text) {path, key, text, false},
#include "input/reference/keys.list"
#undef TABLE
#undef KEY
};

/// Tables whose keys are names that the user chooses.
constexpr std::array tables_of_names{
    "run.columns",  "corner.columns",    "corner.units",       "corner.unit_names",  "run.units",
    "run.frames",   "data.columns",      "data.units",         "drive.file.columns", "drive.file.units",
    "number.files", "number.over.files", "number.minus.files", "number.uncertainty", "number.over.minus.files"};
/// Laws of the load, which are tables of columns and rows.
constexpr std::array laws_of_the_load{"tire.contact_length", "tire.contact_area", "tire.loaded_radius",
                                      "tire.rolling_radius"};
constexpr std::array laws_of_temperature{"material.heat_capacity", "material.conductivity",
                                         "material.conductivity_meridian", "material.conductivity_circumference",
                                         "mesh.link_conductivity"};

bool is_one_of(const auto& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

bool is_of_effect(const physics::Effect& effect, std::string_view key) {
    const auto is = [&](const auto& item) { return item.key == key; };
    const auto begins = [&](const auto& item) { return key.starts_with(fmt::format("{}_by_", item.key)); };
    return std::ranges::any_of(effect.parameters, is) || std::ranges::any_of(effect.choices, is) ||
           std::ranges::any_of(effect.tables, is) || std::ranges::any_of(effect.parameters, begins);
}

/// In [effects.NAME].
std::optional<KeyName> name_in_effect(const std::string& path, const std::string& key) {
    const std::string id = path.substr(path.find('.') + 1);
    if (id == "strain_energy_loss.coastdown") {
        return KeyName{path, key};
    }
    const physics::Effect* effect = physics::find_effect(id);
    return effect == nullptr || is_of_effect(*effect, key) ? std::nullopt : std::optional(KeyName{"effects.NAME", key});
}

/// The more particular of two forms stands first: a name is a text, too, and what is declared is read elsewhere.
bool is_more_particular(const KeyUse& a, const KeyUse& b) { return a.form > b.form; }

bool is_alike(const KeyUse& a, const KeyUse& b) {
    return a.form == b.form && a.unit == b.unit && a.spec.low == b.spec.low && a.spec.high == b.spec.high &&
           a.options == b.options && a.low == b.low && a.high == b.high;
}

void join(CaseKey& into, const std::vector<const KeyUse*>& uses, const std::set<std::string>& variants_of_table) {
    std::set<std::string> variants;
    bool asked = false;
    // A value that is a quantity or a table is asked for as the one that it is; the call for a quantity says the need.
    const bool has_quantity = std::ranges::find(uses, KeyForm::quantity, &KeyUse::form) != uses.end();
    into.required = true;
    for (const KeyUse* use : uses) {
        variants.insert(use->variant);
        if (use->form == KeyForm::mentioned) {
            continue;
        }
        if (!has_quantity || (use->form != KeyForm::any && use->form != KeyForm::table)) {
            asked = true;
            into.required = into.required && use->required;
            into.sometimes_required = into.sometimes_required || use->required;
        }
        if (std::ranges::none_of(into.uses, [&](const KeyUse& known) { return is_alike(known, *use); })) {
            into.uses.push_back(*use);
        }
    }
    into.required = into.required && asked;
    std::ranges::stable_sort(into.uses, is_more_particular);
    if (variants.size() < variants_of_table.size()) {
        variants.erase("");
        into.variants.assign(variants.begin(), variants.end());
    }
}

}  // namespace

std::optional<KeyName> name_in_reference(const KeyUse& use) {
    std::string path = use.table;
    path = path == "the case" ? "" : path == "the study" ? "study:" : path == "the table" ? "table:" : path;
    std::erase_if(path, [](char c) { return c == '[' || c == ']'; });
    if (is_one_of(tables_of_names, path) || is_one_of(laws_of_the_load, path)) {
        return std::nullopt;
    }
    if (is_one_of(laws_of_temperature, path)) {
        return KeyName{"law", use.key};
    }
    if (path == "mesh.y" || path == "mesh.radius") {
        return KeyName{"mesh.x", use.key};
    }
    if (path == "number.over" || path == "number.over.minus") {
        return use.key == "minus" ? std::nullopt : std::optional(KeyName{"number.minus", use.key});
    }
    if (path == "effects") {
        return KeyName{path, "NAME"};
    }
    if (path.starts_with("effects.")) {
        return name_in_effect(path, use.key);
    }
    if (path == "initial" && use.key != "temperature") {
        return std::nullopt;
    }
    return KeyName{path, use.key};
}

std::vector<CaseTable> case_tables(std::vector<std::string>* unknown) {
    const std::vector<KeyUse> asked = keys_asked({});
    std::map<KeyName, std::vector<const KeyUse*>> uses;
    std::map<std::string, std::set<std::string>> variants;
    std::set<std::string> lists;
    for (const KeyUse& use : asked) {
        if (const std::optional<KeyName> name = name_in_reference(use)) {
            uses[*name].push_back(&use);
            variants[name->table].insert(use.variant);
            if (use.table.starts_with("[[")) {
                lists.insert(name->table);
            }
        }
    }
    std::vector<CaseTable> tables;
    for (const Sentence& line : sentences) {
        if (line.is_table) {
            const std::string path(line.table);
            tables.push_back(
                {.path = path, .is_list = lists.contains(path), .sentence = std::string(line.text), .keys = {}});
            continue;
        }
        const auto found = uses.find(KeyName{std::string(line.table), std::string(line.key)});
        if (found == uses.end() || tables.empty() || tables.back().path != line.table) {
            if (unknown != nullptr) {
                unknown->push_back(
                    fmt::format("keys.list has {} of [{}], which no reader asks for", line.key, line.table));
            }
            continue;
        }
        CaseKey key{.key = std::string(line.key), .sentence = std::string(line.text), .uses = {}, .variants = {}};
        join(key, found->second, variants[found->first.table]);
        tables.back().keys.push_back(std::move(key));
        uses.erase(found);
    }
    if (unknown != nullptr) {
        for (const auto& [name, what] : uses) {
            unknown->push_back(fmt::format("{} of [{}] has no line in keys.list", name.key, name.table));
        }
    }
    return tables;
}

}  // namespace tiretherm::input
