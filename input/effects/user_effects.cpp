// SPDX-License-Identifier: BSD-3-Clause
// Reads the two lists, checks formulas, places and names, and adds each entry to the problem as an effect.

#include "input/effects/user_effects.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/effects/effects.hpp"
#include "input/effects/user_formula.hpp"
#include "input/effects/user_signals.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::input {

namespace {

constexpr std::string_view air = "air_temperature";

const std::vector<TomlValue>& items_of(const TomlValue& document, std::string_view list) {
    static const std::vector<TomlValue> none;
    const TomlValue* found = document.find(list);
    return found != nullptr ? found->items : none;
}

bool is_number(std::string_view text) { return leading_number(text).has_value(); }

/// Where a piece of a text in quotes stands, if the text is in one line without escapes; else the whole.
SourceLocation piece(const SourceLocation& text, const std::string& written, const Formula::Wrong& wrong) {
    if (wrong.length == 0 || text.length != static_cast<int>(written.size()) + 2) {
        return text;
    }
    return {.file = text.file,
            .line = text.line,
            .column = text.column + 1 + static_cast<int>(wrong.from),
            .length = static_cast<int>(std::min(wrong.length, written.size() - wrong.from))};
}

/// What a formula may refer to in this run.
std::vector<std::string> known_signals(const EffectSurroundings& in) {
    std::vector<std::string> known;
    for (const physics::Signal& signal : physics::signals()) {
        if (in.signals.given.contains(signal.name)) {
            known.emplace_back(signal.name);
        }
    }
    known.emplace_back("time");
    if (in.run != nullptr) {
        std::ranges::copy(in.run->headings, std::back_inserter(known));
    }
    std::ranges::sort(known);
    known.erase(std::unique(known.begin(), known.end()), known.end());
    // Columns without a heading have no name to follow.
    std::erase(known, "");
    return known;
}

/// Whether a signal can be followed. What is missing is an error; what could not be read has been reported.
bool can_follow(const TomlTable& table, std::string_view key, const std::string& signal, const EffectSurroundings& in,
                const solver::Problem& problem) {
    if (signal == "time") {
        return true;
    }
    if (const UserColumn* column = find_column(in.signals.columns, signal)) {
        return !column->signal.time.empty();
    }
    if (const physics::Signal* input = physics::find_signal(signal);
        input != nullptr && in.signals.given.contains(signal)) {
        return problem.input_signals.gives(*input);
    }
    if (in.run != nullptr && in.run->unreadable) {
        return false;
    }
    const std::string remedy = suggest(signal, known_signals(in), "signals");
    if (in.run != nullptr) {
        table.errors().add(in.run->place,
                           fmt::format("run {}: {} is missing (no column of its file is mapped to it and [drive] does "
                                       "not set it), which {} at {} follows",
                                       in.run->name, signal, table.title(), table.errors().spell(table.place(key))),
                           remedy);
    } else {
        table.add_error(key, fmt::format("[drive] gives no signal \"{}\"", signal), remedy);
    }
    return false;
}

/// The signal of a formula under a key.
std::optional<solver::SignalHistory> read_signal_history(TomlTable& table, std::string_view key,
                                                         const std::string& text, const EffectSurroundings& in,
                                                         const solver::Problem& problem) {
    Formula::Wrong wrong;
    const std::optional<Formula> formula =
        find_column(in.signals.columns, text) != nullptr ? Formula::of_signal(text) : Formula::read(text, key, wrong);
    if (!formula) {
        return table.errors().add(piece(table.place(key), text, wrong), wrong.error);
    }
    bool known = true;
    for (const std::string& signal : formula->signals()) {
        known = can_follow(table, key, signal, in, problem) && known;
    }
    if (!known) {
        return std::nullopt;
    }
    const solver::Settings& settings = problem.settings;
    FormulaSamples samples = signal_history_of(*formula, problem.input_signals, in.signals.columns, settings);
    if (std::optional<ErrorText> error = formula_error(samples, settings)) {
        error->what = fmt::format("{} {}", key, error->what);
        return table.errors().add(table.place(key), std::move(*error));
    }
    if (samples.undefined > 0.0) {
        table.errors().warn(table.place(key),
                            "{} is not a finite number for {:.6g} s, for at most {:.6g} s from {:.6g} s on: it is "
                            "taken as straight between its neighbours",
                            key, samples.undefined, samples.longest_gap, samples.gap_from);
    }
    return std::move(samples.history);
}

/// The temperature of the surroundings: an input, a column or a constant. @returns false after an error
bool read_surroundings(TomlTable& table, const EffectSurroundings& in, const solver::Problem& problem,
                       solver::UserEffect& user_effect) {
    user_effect.temperature = table.text("temperature").value_or(std::string(air));
    if (is_number(user_effect.temperature)) {
        const auto constant = table.quantity("temperature");
        user_effect.surroundings = {{problem.settings.start}, {constant.value_or(0.0)}};
        return constant.has_value();
    }
    const auto history = read_signal_history(table, "temperature", user_effect.temperature, in, problem);
    const physics::Signal* input = physics::find_signal(user_effect.temperature);
    const UserColumn* column = find_column(in.signals.columns, user_effect.temperature);
    // Spelled out: a choice between a text and a literal would be a text of its own, gone before it is looked at.
    std::string_view unit;
    if (input != nullptr) {
        unit = input->unit;
    } else if (column != nullptr) {
        unit = column->unit;
    }
    if (history && unit != "K") {
        table.add_error("temperature", fmt::format("{} is not a temperature", user_effect.temperature),
                        "name an input or a column in degC or K, or write a value such as \"25 degC\"");
        return false;
    }
    if (history && user_effect.temperature != air) {  // the air's is taken from the input signals, its drift included
        user_effect.surroundings = *history;
    }
    return history.has_value();
}

void read_places(TomlTable& table, const mesh::Mesh& mesh, solver::UserEffect& user_effect) {
    const std::vector<LocatedString> words = table.texts("at", Need::required);
    if (table.has("at") && words.empty()) {
        table.add_error("at", "at names no place", "write at = \"surface\"");
    }
    for (const LocatedString& word : words) {
        user_effect.places.push_back(word.text);
        if (mesh.n_nodes > 0 && physics::nodes_of_place(mesh, word.text).empty()) {
            table.errors().add(word.place, fmt::format("the mesh has no place \"{}\"", word.text),
                               suggest(word.text, physics::names_of_places(mesh), "places"));
        }
    }
}

/// A name that nothing else has.
std::string read_name(TomlTable& table, const std::vector<solver::UserEffect>& before) {
    const std::string name = table.name("name", Need::required).value_or("");
    if (physics::find_effect(name) != nullptr) {
        table.add_error("name", fmt::format("{} is an effect of the catalogue", name), "choose another name");
    }
    if (std::ranges::count(before, name, &solver::UserEffect::name) > 0 && !name.empty()) {
        table.add_error("name", fmt::format("a second effect is called \"{}\"", name), "choose another name");
    }
    return name;
}

void read_list(TomlTable& root, const EffectSurroundings& in, const solver::Problem& problem,
               const UserEffectKind& kind, std::vector<solver::UserEffect>& sound,
               std::vector<solver::UserEffect>& all) {
    root.each(kind.list, [&](TomlTable& table) {
        const std::size_t before = table.errors().count();
        solver::UserEffect user_effect;
        user_effect.exchange = kind.list == user_heat_transfer.list;
        user_effect.name = read_name(table, all);
        read_places(table, problem.mesh, user_effect);
        const physics::ParameterSpec& number = physics::find_effect(kind.effect)->parameters.front();
        user_effect.amount = table.quantity(kind.number, quantity_specs::of(number), Need::required).value_or(0.0);
        user_effect.follows =
            table.text("follows", user_effect.exchange ? Need::optional : Need::required).value_or("1");
        all.push_back(user_effect);
        const bool readable = table.has("follows") || user_effect.exchange;
        const auto history =
            readable ? read_signal_history(table, "follows", user_effect.follows, in, problem) : std::nullopt;
        const bool surrounded = !user_effect.exchange || read_surroundings(table, in, problem, user_effect);
        if (!history || !surrounded || problem.mesh.n_nodes == 0 || table.errors().count() != before) {
            return;
        }
        user_effect.signal = *history;
        for (const solver::UserEffectDefect& defect : solver::defects(problem, user_effect)) {
            table.errors().add(
                table.place(), fmt::format("{}: {}", user_effect.name, defect.what),
                defect.is_negative_signal
                    ? fmt::format("follow what is never negative, such as \"max(0, {})\"", user_effect.follows)
                    : "");
        }
        if (table.errors().count() == before) {
            sound.push_back(std::move(user_effect));
        }
    });
}

}  // namespace

std::vector<std::string> followed_names(const TomlValue& document) {
    std::vector<std::string> names;
    const auto add_name = [&](const std::string& name) {
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    };
    const auto add = [&](const std::string& text) {
        add_name(text);  // which may be the name of a column, whatever it looks like
        Formula::Wrong wrong;
        if (const std::optional<Formula> formula = Formula::read(text, "follows", wrong)) {
            std::ranges::for_each(formula->signals(), add_name);
        }
    };
    for (const UserEffectKind& kind : {user_heat_source, user_heat_transfer}) {
        for (const TomlValue& item : items_of(document, kind.list)) {
            for (const std::string_view key : {"follows", "temperature"}) {
                const TomlValue* text = item.find(key);
                if (text != nullptr && text->kind == TomlValue::Kind::text) {
                    add(text->text);
                }
            }
            if (kind.list == user_heat_transfer.list && item.find("temperature") == nullptr) {
                add(std::string(air));
            }
        }
    }
    return names;
}

std::vector<std::string> user_effect_names(const TomlValue& document, std::string_view list) {
    std::vector<std::string> names;
    for (const TomlValue& item : items_of(document, list)) {
        if (const TomlValue* name = item.find("name"); name != nullptr) {
            names.push_back(name->text);
        }
    }
    return names;
}

/// All signals are read before the first effect is on: its samples are no business of the others.
void read_user_effects(TomlTable& root, const EffectSurroundings& in, solver::Problem& problem) {
    std::vector<solver::UserEffect> sound;
    std::vector<solver::UserEffect> all;
    for (const UserEffectKind& kind : {user_heat_source, user_heat_transfer}) {
        read_list(root, in, problem, kind, sound, all);
    }
    for (const solver::UserEffect& user_effect : sound) {
        solver::add_user_effect(problem, user_effect);
    }
}

}  // namespace tiretherm::input
