// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm effects`: lists the catalogue of effects, or one of them, as text or JSON; with Markdown it makes
// docs/effects.md.

#include <array>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "input/text/suggestions.hpp"
#include "physics/effect.hpp"
#include "post/report/table.hpp"

namespace tiretherm::app {

namespace {

using Json = nlohmann::ordered_json;

std::string kind_name(physics::Kind kind) {
    switch (kind) {
        case physics::Kind::source:
            return "source";
        case physics::Kind::loss:
            return "loss";
        case physics::Kind::property:
            return "property";
        case physics::Kind::input:
            return "input";
        case physics::Kind::state:
            return "initial state";
        case physics::Kind::sensor:
            return "sensor";
    }
    return "";
}

std::string origin(const physics::Effect& effect) { return effect.on ? "thesis, on by default" : "off by default"; }

/// What a file of a structural code may give an effect, and what else may replace its total.
std::string field_text(const physics::Effect& effect) {
    switch (effect.field()) {
        case physics::FieldOf::nothing:
            return "";
        case physics::FieldOf::pressure:
            return "field = FILE places it by a structural code's contact pressure";
        case physics::FieldOf::friction:
            return "field = FILE places it by a structural code's friction power; use = \"watts\" takes its watts too";
        case physics::FieldOf::loss:
            return "field = FILE places it by a structural code's loss_density; use = \"watts\" takes its watts too. "
                   "total = FILE or coastdown = { alpha, beta, a, b, c } measures the total (SAE J2452 in kPa, N, "
                   "km/h)";
    }
    return "";
}

std::string unit_text(std::string_view unit) { return unit == "1" ? std::string("-") : std::string(unit); }

/// What an effect acts on, and what it needs; empty where it is nothing special.
std::string acts_on_text(const physics::Effect& effect) {
    return effect.on_layers                   ? "the layers that a case names: layers = [...]"
           : effect.sensor_model() != nullptr ? "the sensors that a case names: channels = [...]"
                                              : "";
}

std::string needs_text(const physics::Effect& effect) {
    return effect.needs_tire && effect.needs_grid ? "a [tire] and a mesh of cells"
           : effect.needs_tire                    ? "a [tire]"
           : effect.needs_grid                    ? "a mesh of cells"
                                                  : "";
}

/// The sentence up to its full stop.
std::string first_sentence(std::string_view text) {
    const auto stop = text.find(". ");
    return std::string(stop == std::string_view::npos ? text : text.substr(0, stop + 1));
}

void print_list() {
    for (const physics::Effect* effect : physics::catalogue()) {
        fmt::print("{} ({}, {})\n", effect->id, kind_name(effect->kind), origin(*effect));
        fmt::print("{}", post::wrap(first_sentence(effect->meaning), 4));
        fmt::print("{}", post::wrap(std::string(effect->equation), 6));
    }
    fmt::print("\nOne of them in full: tiretherm effects NAME\n");
}

void print_section(const char* name, std::string_view text) {
    if (!text.empty()) {
        fmt::print("\n{}\n{}", name, post::wrap(std::string(text), 4));
    }
}

void print_one(const physics::Effect& effect) {
    fmt::print("{} ({}, {})\n", effect.id, kind_name(effect.kind), origin(effect));
    fmt::print("{}", post::wrap(std::string(effect.meaning), 4));
    print_section("Equation", effect.equation);
    print_section("Source", effect.source);
    print_section("Valid", effect.valid);
    if (!effect.parameters.empty()) {
        post::Table table({true, false, false, false, true, true});
        table.add({"name", "default", "from", "to", "unit", "meaning"});
        for (const physics::ParameterSpec& p : effect.parameters) {
            table.add({std::string(p.key), fmt::format("{:g}", p.standard), fmt::format("{:g}", p.low),
                       fmt::format("{:g}", p.high), unit_text(p.unit), std::string(p.meaning)});
        }
        fmt::print("\nParameters\n{}\n", fmt::join(table.lines(4), "\n"));
    }
    if (!effect.choices.empty()) {
        post::Table table({true, true, true});
        for (const physics::Choice& choice : effect.choices) {
            table.add({std::string(choice.key), fmt::format("{}", fmt::join(choice.options, " | ")),
                       std::string(choice.meaning)});
        }
        fmt::print("\nChoices, the first is the default\n{}\n", fmt::join(table.lines(4), "\n"));
    }
    if (!effect.tables.empty()) {
        post::Table table({true, true, true});
        for (const physics::Table& t : effect.tables) {
            table.add({std::string(t.key), fmt::format("{} against {}", unit_text(t.value_unit), t.variable_unit),
                       std::string(t.meaning)});
        }
        fmt::print("\nTables\n{}\n", fmt::join(table.lines(4), "\n"));
    }
    print_section("From files", field_text(effect));
    print_section("Reads the signals", fmt::format("{}", fmt::join(effect.reads, ", ")));
    print_section("Also, when given", fmt::format("{}", fmt::join(effect.may_read, ", ")));
    print_section("Acts on the patches",
                  fmt::format("{}", fmt::join(effect.patches, effect.one_patch ? " or else " : ", ")));
    print_section("Acts on", acts_on_text(effect));
    print_section("Needs", needs_text(effect));
}

Json as_json(const physics::Effect& effect) {
    Json json{{"name", effect.id},
              {"kind", kind_name(effect.kind)},
              {"on", effect.on},
              {"equation", effect.equation},
              {"source", effect.source},
              {"valid", effect.valid},
              {"meaning", effect.meaning},
              {"parameters", Json::array()},
              {"choices", Json::array()},
              {"reads", effect.reads},
              {"patches", effect.patches},
              {"needs_tire", effect.needs_tire},
              {"from_files", field_text(effect)}};
    for (const physics::ParameterSpec& p : effect.parameters) {
        json["parameters"].push_back({{"key", p.key},
                                      {"unit", p.unit},
                                      {"default", p.standard},
                                      {"low", p.low},
                                      {"high", p.high},
                                      {"meaning", p.meaning}});
    }
    for (const physics::Choice& choice : effect.choices) {
        json["choices"].push_back({{"key", choice.key}, {"options", choice.options}, {"meaning", choice.meaning}});
    }
    return json;
}

constexpr std::string_view page_head =
    "# Effects\n\n"
    "The catalogue of physical effects. This page is written by `tiretherm effects --markdown` from the catalogue "
    "itself "
    "(`physics/effects`);\ndo not edit it. A case switches an effect on with `[effects.NAME]`; the keys that all "
    "effects "
    "have are in the\n[case reference](case-reference.md). Effects of the thesis are on in every case with `[tire]`; "
    "all others "
    "are off unless named.\nHow to write a new one: [extending.md](extending.md#an-effect).\n";

std::string markdown_of(const physics::Effect& effect) {
    std::string text =
        fmt::format("\n### {}\n\n*{}, {}.* {}\n\n", effect.id, kind_name(effect.kind), origin(effect), effect.meaning);
    text += fmt::format("    {}\n\nSource: {}\n\nValid: {}.\n", effect.equation, effect.source, effect.valid);
    if (!effect.parameters.empty()) {
        text += "\n| parameter | default | from | to | unit | meaning |\n|---|---|---|---|---|---|\n";
    }
    for (const physics::ParameterSpec& p : effect.parameters) {
        text += fmt::format("| `{}` | {:g} | {:g} | {:g} | {} | {} |\n", p.key, p.standard, p.low, p.high,
                            unit_text(p.unit), p.meaning);
    }
    if (!effect.choices.empty() || !effect.tables.empty()) {
        text += "\n| word or table | values | meaning |\n|---|---|---|\n";
    }
    for (const physics::Choice& choice : effect.choices) {
        text += fmt::format("| `{}` | `{}` (the first is the default) | {} |\n", choice.key,
                            fmt::join(choice.options, "`, `"), choice.meaning);
    }
    for (const physics::Table& t : effect.tables) {
        text += fmt::format("| `{}` | {} against {} | {} |\n", t.key, unit_text(t.value_unit),
                            unit_text(t.variable_unit), t.meaning);
    }
    const std::string patches = fmt::format("{}", fmt::join(effect.patches, effect.one_patch ? " or else " : ", "));
    const auto add = [&](std::string_view name, const std::string& what) {
        text += what.empty() ? "" : fmt::format("\n{}: {}.\n", name, what);
    };
    add("From files", field_text(effect));
    add("Inputs", fmt::format("{}", fmt::join(effect.reads, ", ")));
    add("Inputs, when given", fmt::format("{}", fmt::join(effect.may_read, ", ")));
    add("Acts on the patches", patches);
    add("Acts on", acts_on_text(effect));
    add("Needs", needs_text(effect));
    return text;
}

/// The page docs/effects.md: the effects by what they change.
void print_markdown() {
    using physics::Kind;
    constexpr std::array headings{std::pair{Kind::source, "Heat: sources and transfer"},
                                  std::pair{Kind::loss, "Heat: losses"},
                                  std::pair{Kind::property, "Properties and laws"},
                                  std::pair{Kind::input, "Inputs"},
                                  std::pair{Kind::state, "Initial state"},
                                  std::pair{Kind::sensor, "Sensor models"}};
    fmt::print("{}", page_head);
    for (const auto& [kind, heading] : headings) {
        fmt::print("\n## {}\n", heading);
        for (const physics::Effect* effect : physics::catalogue()) {
            fmt::print("{}", effect->kind == kind ? markdown_of(*effect) : "");
        }
    }
}

int show(const std::string& name, bool json, bool markdown) {
    if (markdown) {
        print_markdown();
        return Exit::done;
    }
    if (name.empty()) {
        if (!json) {
            print_list();
            return Exit::done;
        }
        Json all{{"effects", Json::array()}};
        for (const physics::Effect* effect : physics::catalogue()) {
            all["effects"].push_back(as_json(*effect));
        }
        fmt::print("{}\n", all.dump(2));
        return Exit::done;
    }
    const physics::Effect* effect = physics::find_effect(name);
    if (effect == nullptr) {
        std::vector<std::string> known;
        for (const physics::Effect* one : physics::catalogue()) {
            known.emplace_back(one->id);
        }
        report_error(fmt::format("there is no effect \"{}\"", name), input::suggest(name, known, "effects"), json);
        return Exit::input_error;
    }
    if (json) {
        fmt::print("{}\n", as_json(*effect).dump(2));
    } else {
        print_one(*effect);
    }
    return Exit::done;
}

}  // namespace

void add_effects_command(CLI::App& program, int& exit_code) {
    struct Options {
        std::string name;
        bool json = false;
        bool markdown = false;
    };
    CLI::App* command = program.add_subcommand("effects", "The catalogue of physical causes");
    const auto options = std::make_shared<Options>();
    command->add_option("NAME", options->name, "Name of an effect; without it all are listed")->option_text(" ");
    CLI::Option* json = command->add_flag("--json", options->json, "One JSON object");
    command->add_flag("--markdown", options->markdown, "The page docs/effects.md")->excludes(json);
    command->footer(
        "Example:\n"
        "  tiretherm effects\n"
        "  tiretherm effects air_convection");
    command->callback([options, &exit_code] { exit_code = show(options->name, options->json, options->markdown); });
}

}  // namespace tiretherm::app
