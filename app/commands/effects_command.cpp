// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm effects`: lists the catalogue of effects, or one of them, as text or JSON, or writes
// docs/effects.md.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "input/text/suggestions.hpp"
#include "physics/effect.hpp"
#include "post/reference/effect_reference.hpp"
#include "post/report/table.hpp"

namespace tiretherm::app {

namespace {

/// The sentence up to its full stop.
std::string first_sentence(std::string_view text) {
    const auto stop = text.find(". ");
    return std::string(stop == std::string_view::npos ? text : text.substr(0, stop + 1));
}

void print_list() {
    for (const physics::Effect* effect : physics::catalogue()) {
        fmt::print("{}\n", post::effect_report(*effect).title);
        fmt::print("{}", post::wrap(first_sentence(effect->meaning), 4, prose_width()));
        fmt::print("{}", post::wrap(std::string(effect->equation), 6, prose_width()));
    }
    fmt::print("\nOne of them in full: tiretherm effects EFFECT\n");
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
        post::Value::List all;
        for (const physics::Effect* effect : physics::catalogue()) {
            all.push_back(post::effect_report(*effect).data);
        }
        fmt::print("{}", post::json_text({{"effects", all}}));
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
    print_report(post::effect_report(*effect), json);
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
