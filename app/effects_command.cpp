// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm effects`: lists the catalogue of effects, or one of them, as text or JSON, or writes
// docs/effects.md.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "input/text/suggestions.hpp"
#include "physics/effect.hpp"
#include "physics/plausible_ranges.hpp"
#include "post/reference/effect_reference.hpp"
#include "post/report/table.hpp"

namespace tiretherm::app {

namespace {

using Json = nlohmann::ordered_json;

/// The sentence up to its full stop.
std::string first_sentence(std::string_view text) {
    const auto stop = text.find(". ");
    return std::string(stop == std::string_view::npos ? text : text.substr(0, stop + 1));
}

void print_list() {
    for (const physics::Effect* effect : physics::catalogue()) {
        fmt::print("{} ({}, {})\n", effect->id, post::kind_name(effect->kind), post::origin(*effect));
        fmt::print("{}", post::wrap(first_sentence(effect->meaning), 4, prose_width()));
        fmt::print("{}", post::wrap(std::string(effect->equation), 6, prose_width()));
    }
    fmt::print("\nOne of them in full: tiretherm effects EFFECT\n");
}

void print_section(const char* name, std::string_view text) {
    if (!text.empty()) {
        fmt::print("\n{}\n{}", name, post::wrap(std::string(text), 4, prose_width()));
    }
}

void print_one(const physics::Effect& effect) {
    fmt::print("{} ({}, {})\n", effect.id, post::kind_name(effect.kind), post::origin(effect));
    fmt::print("{}", post::wrap(std::string(effect.meaning), 4, prose_width()));
    print_section("Equation", effect.equation);
    print_section("Source", effect.source);
    print_section("Valid", effect.valid);
    if (!effect.parameters.empty()) {
        post::Table table({true, false, false, false, true, true});
        table.add({"name", "default", "from", "to", "unit", "meaning"});
        for (const physics::ParameterSpec& p : effect.parameters) {
            table.add({std::string(p.key), fmt::format("{:g}", p.standard), fmt::format("{:g}", p.low),
                       fmt::format("{:g}", p.high), post::unit_text(p.unit), std::string(p.meaning)});
        }
        fmt::print("\nParameters\n{}\n", fmt::join(table.lines(4), "\n"));
    }
    if (const auto ranges = post::ranges_of(effect); !ranges.empty()) {
        fmt::print("\nPlausible ranges, in which the parameters of a tire are expected\n");
        for (const physics::PlausibleRange& range : ranges) {
            fmt::print("    {}: {:g} to {:g} {}\n", post::parameter_text(range), range.low, range.high,
                       post::range_unit(effect, range));
            fmt::print("{}", post::wrap(fmt::format("source: {}", range.source), 8, prose_width()));
            fmt::print("{}", post::wrap(fmt::format("beyond: {}", range.why), 8, prose_width()));
        }
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
            table.add({std::string(t.key), fmt::format("{} against {}", post::unit_text(t.value_unit), t.variable_unit),
                       std::string(t.meaning)});
        }
        fmt::print("\nTables\n{}\n", fmt::join(table.lines(4), "\n"));
    }
    print_section("From files", post::field_text(effect));
    print_section("Reads the signals", fmt::format("{}", fmt::join(effect.reads, ", ")));
    print_section("Also, when given", fmt::format("{}", fmt::join(effect.may_read, ", ")));
    print_section("Acts on the patches",
                  fmt::format("{}", fmt::join(effect.patches, effect.one_patch ? " or else " : ", ")));
    print_section("Acts on", post::acts_on_text(effect));
    print_section("Needs", post::needs_text(effect));
}

Json as_json(const physics::Effect& effect) {
    Json json{{"name", effect.id},
              {"kind", post::kind_name(effect.kind)},
              {"on", effect.on},
              {"equation", effect.equation},
              {"source", effect.source},
              {"valid", effect.valid},
              {"meaning", effect.meaning},
              {"parameters", Json::array()},
              {"plausible_ranges", Json::array()},
              {"choices", Json::array()},
              {"reads", effect.reads},
              {"patches", effect.patches},
              {"needs_tire", effect.needs_tire},
              {"from_files", post::field_text(effect)}};
    for (const physics::ParameterSpec& p : effect.parameters) {
        json["parameters"].push_back({{"key", p.key},
                                      {"unit", p.unit},
                                      {"default", p.standard},
                                      {"low", p.low},
                                      {"high", p.high},
                                      {"meaning", p.meaning}});
    }
    for (const physics::PlausibleRange& range : post::ranges_of(effect)) {
        json["plausible_ranges"].push_back({{"parameter", range.parameter},
                                            {"sensor", physics::name_of(range.sensor)},
                                            {"unit", post::range_unit(effect, range)},
                                            {"low", range.low},
                                            {"high", range.high},
                                            {"source", range.source},
                                            {"beyond", range.why}});
    }
    for (const physics::Choice& choice : effect.choices) {
        json["choices"].push_back({{"key", choice.key}, {"options", choice.options}, {"meaning", choice.meaning}});
    }
    return json;
}

int show(const std::string& name, bool json, bool markdown) {
    if (markdown) {
        fmt::print("{}", post::effects_page());
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
    struct EffectsOptions {
        std::string name;
        bool json = false;
        bool markdown = false;
    };
    CLI::App* command = program.add_subcommand("effects", "List the catalogue of physical effects, or one in full");
    const auto options = std::make_shared<EffectsOptions>();
    command->add_option("EFFECT", options->name, "Name of an effect; without it all are listed")->option_text(" ");
    CLI::Option* json = command->add_flag("--json", options->json, "One JSON object");
    command->add_flag("--markdown", options->markdown, "The page docs/effects.md")->excludes(json);
    command->footer(
        "Example:\n"
        "  tiretherm effects\n"
        "  tiretherm effects air_convection");
    command->callback([options, &exit_code] { exit_code = show(options->name, options->json, options->markdown); });
}

}  // namespace tiretherm::app
