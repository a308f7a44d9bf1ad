// SPDX-License-Identifier: BSD-3-Clause
// Implements the checks of tire, cells, patches, placement weights and input signals; each error names the remedy.

#include "input/effects/effect_requirements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/model/probes.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"
#include "physics/contact/travelling.hpp"
#include "physics/tire_laws/rolling_resistance.hpp"
#include "solver/quantity_inputs.hpp"
#include "solver/system.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Effect;

bool has(std::span<const std::string_view> list, std::string_view signal) {
    return std::ranges::find(list, signal) != list.end();
}

/// The word of the effect that needs what the effect itself does not, a tire and its signals; null where there is none.
const physics::Choice* choice_that_needs_more(const ActiveEffect& active) {
    const auto choices = active.effect->choices;
    const auto found = std::ranges::find_if(choices, [&](const physics::Choice& choice) {
        return !choice.reads.empty() && active.choices[static_cast<std::size_t>(&choice - choices.data())] > 0;
    });
    return found == choices.end() ? nullptr : &*found;
}

bool needs(const ActiveEffect& active, std::string_view signal) {
    const physics::Choice* more = choice_that_needs_more(active);
    return has(active.effect->reads, signal) || (more != nullptr && has(more->reads, signal));
}

/// What an effect with such a word may read, it reads with that word alone.
bool uses(const ActiveEffect& active, std::string_view signal) {
    const bool has_such = std::ranges::any_of(active.effect->choices,
                                              [](const physics::Choice& choice) { return !choice.reads.empty(); });
    const bool reads_more = !has_such || choice_that_needs_more(active) != nullptr;
    return has(active.effect->reads, signal) || (reads_more && has(active.effect->may_read, signal));
}

/// How a column of the run's file becomes an input, with the columns whose names say nothing; empty without one.
/// @param sensors names of the case's sensors
std::string mapping_to(std::string_view input, const RunInputs& run, const std::vector<std::string>& sensors) {
    // A logger has hundreds of columns; the message is to show how they are called.
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

/// Whether any slip is given that makes heat.
bool gives_slip(const GivenSignals& given) {
    return std::ranges::any_of(std::array<std::string_view, 3>{"slip_angle", "slip_ratio", "slip_speed"},
                               [&](std::string_view name) { return given.contains(name); });
}

/// Sensors, and sensor models of them, that read a signal.
std::vector<std::string> sensors_that_read(const solver::Problem& problem, std::string_view signal) {
    std::vector<std::string> found;
    for (std::size_t c = 0; c < problem.n_sensors(); ++c) {
        const solver::Channel& channel = problem.channels[c];
        const solver::QuantityDescription& quantity = solver::description_of(channel.quantity);
        const bool by_model = std::ranges::any_of(problem.effects, [&](const ActiveEffect& a) {
            return uses(a, signal) && std::ranges::count(a.channels, static_cast<int>(c)) > 0;
        });
        if (std::ranges::count(quantity.signals, signal) > 0 || by_model ||
            std::ranges::count(solver::optional_signals(channel.quantity), signal) > 0) {
            found.push_back(channel.name);
        }
    }
    return found;
}

/// Whether an effect lets heat or a law of it follow a signal; sensor models do not.
bool heats_by(const ActiveEffect& active, std::string_view signal) {
    return active.effect->sensor_model() == nullptr && uses(active, signal);
}

}  // namespace

void check_requirements(TomlTable& root, const ActiveEffect& active, const SourceLocation& place, bool chosen,
                        bool has_tire, const mesh::Mesh& mesh) {
    const Effect& effect = *active.effect;
    const bool has_mesh = mesh.n_nodes > 0;
    const std::string off = fmt::format("or switch it off: [effects.{}] on = false", effect.id);
    const physics::Choice* more = choice_that_needs_more(active);
    if (!effect.needs_tire && more != nullptr && !has_tire) {
        const int word = active.choices[static_cast<std::size_t>(more - effect.choices.data())];
        root.errors().add(place,
                          fmt::format("{} of {} = \"{}\" needs a tire", effect.id, more->key,
                                      more->options[static_cast<std::size_t>(word)]),
                          fmt::format("add [tire], or write {} = \"{}\"", more->key, more->options.front()));
        return;
    }
    if (effect.needs_tire && !has_tire) {
        root.errors().add(place, fmt::format("{} needs a tire", effect.id), fmt::format("add [tire], {}", off));
        return;
    }
    if (has_mesh && effect.needs_grid && mesh.is_lumped()) {
        root.errors().add(place, fmt::format("{} needs cells, and this mesh has two lumps", effect.id),
                          fmt::format("take layers or section, {}", off));
        return;
    }
    if (has_mesh && effect.invalid_on_mesh != nullptr) {
        if (const std::string sentence = effect.invalid_on_mesh(active, mesh); !sentence.empty()) {
            root.errors().add(place, fmt::format("{}: {}", effect.id, sentence));
        }
    }
    if (has_mesh && !chosen && !effect.patches.empty() && active.patches.empty()) {
        const std::vector<std::string> patches = names_of(mesh.patches);
        const std::vector<std::string> standard(effect.patches.begin(), effect.patches.end());
        root.errors().add(
            place, fmt::format("{} acts on the patch {}, which this mesh does not have", effect.id, listed(standard)),
            fmt::format("choose from {}: [effects.{}] patches = [\"{}\"], {}", listed(patches), effect.id,
                        patches.front(), off));
    }
}

void check_weights(TomlTable& root, const solver::Problem& problem) {
    // Weights are made when the system is: only a sound problem may become one.
    const solver::System system(problem);
    for (const ActiveEffect& active : system.effects()) {
        if (std::ranges::any_of(active.weights, [](double weight) { return !std::isfinite(weight); })) {
            const TomlValue* table = root.content().find({"effects", active.effect->id});
            root.errors().add(table != nullptr ? table->place : root.place(),
                              fmt::format("the weights of {} are zero everywhere on this mesh", active.title()),
                              "let its table or its shares be positive somewhere");
        }
    }
}

void warn_of_doubles(TomlTable& root, const solver::Problem& problem) {
    for (const ActiveEffect& active : problem.effects) {
        const std::string_view other = active.effect->instead_of;
        if (!other.empty() &&
            std::ranges::any_of(problem.effects, [&](const ActiveEffect& a) { return a.effect->id == other; })) {
            const TomlValue* table = root.content().find("effects")->find(active.effect->id);
            root.errors().warn(table->place,
                               "{0} and {1} both act and count the same heat twice: [effects.{1}] on = false",
                               active.effect->id, other);
        }
    }
}

void check_road(TomlTable& root, const solver::Problem& problem) {
    const auto is_on = [&](std::string_view id) {
        return std::ranges::any_of(problem.effects, [&](const ActiveEffect& a) { return a.effect->id == id; });
    };
    InputErrors& errors = root.errors();
    const physics::Tire& tire = problem.tire;
    if (tire.loss_drum_diameter > 0.0 && root.has("vehicle") && !is_on("drum_curvature")) {
        const TomlValue* key = root.content().find({"tire", "loss_drum_diameter"});
        errors.warn(key != nullptr ? key->place : root.place("tire"),
                    "the loss was measured on a drum of {:g} m, and a car drives on a flat road, where it is {:.3f} of "
                    "that: add [effects.drum_curvature] curvature = \"0 1/m\"",
                    tire.loss_drum_diameter,
                    physics::to_drum(1.0, tire.curvature_of_loss(), 0.0, tire.unloaded_radius));
    }
    if (!is_on("drum_heating")) {
        return;
    }
    const SourceLocation place = root.content().find({"effects", "drum_heating"})->place;
    const std::string off = "remove [effects.drum_heating]";
    if (root.has("vehicle")) {
        errors.add(place,
                   "drum_heating is of a drum or a belt, and the car of [vehicle] drives on a road: it meets fresh "
                   "road everywhere and does not warm it",
                   off);
    }
    for (const solver::Channel& channel : problem.channels) {
        if (channel.quantity == solver::Quantity::surface_at_entry ||
            channel.quantity == solver::Quantity::surface_at_exit) {
            const std::string_view kind = solver::description_of(channel.quantity).kind;
            errors.add(place,
                       fmt::format("{} is of the kind {}, which knows a road of road_temperature alone, and "
                                   "drum_heating lets the drum warm up",
                                   channel.name, kind),
                       fmt::format("remove the sensor {}, or {}", channel.name, off));
        }
    }
    const physics::Signal& road = *physics::find_signal("road_temperature");
    const bool is_series = std::ranges::any_of(problem.input_signals.series(), [&](const solver::Series& series) {
        return series.signal == &road &&
               std::ranges::adjacent_find(series.value, std::ranges::not_equal_to{}) != series.value.end();
    });
    if (is_series) {
        errors.warn(place,
                    "road_temperature changes along the run: the drum of drum_heating starts at its first value "
                    "and then follows its own heat, and the later values do not count");
    }
}

void warn_of_two_shares(TomlTable& root, const GivenSignals& given, const solver::Problem& problem) {
    const std::vector<ActiveEffect>& effects = problem.effects;
    const auto sliding =
        std::ranges::find_if(effects, [](const ActiveEffect& a) { return a.effect->id == "sliding_friction"; });
    if (sliding == effects.end() || !gives_slip(given)) {
        return;
    }
    const double share = (*sliding)[static_cast<std::size_t>(physics::find_parameter(*sliding->effect, "partition"))];
    const bool by_number =
        sliding->choices[static_cast<std::size_t>(physics::find_choice(*sliding->effect, "partition"))] == 0;
    const std::string_view taking = physics::travels(*sliding) ? "travelling_contact" : "resolved_contact";
    const bool resolved = std::ranges::any_of(effects, [&](const ActiveEffect& a) { return a.effect->id == taking; });
    if (by_number && resolved && share > 0.0 && share < 1.0) {
        const TomlValue* tables = root.content().find("effects");
        const TomlValue* key = tables->find({"sliding_friction", "partition"});
        root.errors().warn(key != nullptr ? key->place : tables->find(taking)->place,
                           "partition = {:g} gives the road {:g} of the heat of sliding, and {} lets the road take a "
                           "share of the rest in the contact: the road's share counts twice; write "
                           "[effects.sliding_friction] partition = \"charm\", or 1 for heat that is made in the tread",
                           share, 1.0 - share, taking);
    }
}

void check_signals(TomlTable& root, const EffectSurroundings& in, const solver::Problem& problem) {
    const RunInputs* const run = in.run;
    for (const physics::Signal& signal : physics::signals()) {
        std::vector<std::string> needing;
        for (const ActiveEffect& active : problem.effects) {
            const bool can_act =
                in.has_tire || !(active.effect->needs_tire || choice_that_needs_more(active) != nullptr);
            if (can_act && needs(active, signal.name)) {
                needing.emplace_back(active.effect->id);
            }
        }
        if (!needing.empty() && !in.signals.given.contains(signal.name)) {
            const bool one = needing.size() == 1;
            const std::string lacking =
                run ? fmt::format(
                          "run {}: {} is missing (no column of its file is mapped to it and [drive] does not set it)",
                          run->name, signal.name)
                    : fmt::format("[drive] lacks {}", signal.name);
            const std::string column =
                run != nullptr ? mapping_to(signal.name, *run, sensor_names(root.content())) : "";
            root.errors().add(run != nullptr ? run->place : root.place("drive"),
                              {.what = fmt::format("{}, which {} {}", lacking, listed(needing), one ? "needs" : "need"),
                               .remedy = fmt::format("{}add {} = {}{}, or switch {} off: [effects.{}] on = false",
                                                     column, signal.name, spell_example(quantity_specs::of(signal)),
                                                     run != nullptr ? " to [drive]" : "",
                                                     one ? "the effect" : "the effects", needing.front()),
                               .code = run != nullptr ? ErrorCode::other : ErrorCode::missing_input,
                               .about = std::string(signal.name)});
        }
    }
}

void warn_of_unread_signals(TomlTable& root, const GivenSignals& given_signals,
                            const std::vector<std::string>& followed, const solver::Problem& problem) {
    std::vector<std::string> unread;
    std::vector<std::string> read_by_sensors;
    std::vector<std::string> sensors;
    for (const physics::Signal& signal : physics::signals()) {
        const bool by_heat =
            std::ranges::any_of(problem.effects, [&](const ActiveEffect& a) { return heats_by(a, signal.name); });
        const bool by_own = std::ranges::count(followed, signal.name) > 0;
        // What [vehicle] computes nobody gave in vain.
        const auto given = given_signals.find(signal.name);
        const bool by_vehicle = given != given_signals.end() && root.has("vehicle") &&
                                given->second.file == root.place("vehicle").file &&
                                given->second.line == root.place("vehicle").line;
        if (!problem.input_signals.gives(signal) || by_heat || by_own || by_vehicle) {
            continue;
        }
        const std::vector<std::string> readers = sensors_that_read(problem, signal.name);
        if (readers.empty()) {
            unread.emplace_back(signal.name);
            continue;
        }
        read_by_sensors.emplace_back(signal.name);
        for (const std::string& reader : readers) {
            if (std::ranges::count(sensors, reader) == 0) {
                sensors.push_back(reader);
            }
        }
    }
    if (!read_by_sensors.empty()) {
        root.errors().warn(root.place("drive"), "no heat effect depends on {}; only {} {} it", listed(read_by_sensors),
                           listed(sensors), sensors.size() == 1 ? "uses" : "use");
    }
    if (!unread.empty()) {
        root.errors().warn(root.place("drive"), "no active effect and no sensor uses {}", listed(unread));
    }
}

}  // namespace tiretherm::input
