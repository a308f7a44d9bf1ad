// SPDX-License-Identifier: BSD-3-Clause
// What the catalogue says of an effect, in the words of `tiretherm effects`, and the page docs/effects.md.
#include "post/reference/effect_reference.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace tiretherm::post {

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

std::vector<physics::PlausibleRange> ranges_of(const physics::Effect& effect) {
    std::vector<physics::PlausibleRange> ranges;
    for (const physics::PlausibleRange& range : physics::plausible_ranges()) {
        if (range.effect == effect.id) {
            ranges.push_back(range);
        }
    }
    return ranges;
}

std::string parameter_text(const physics::PlausibleRange& range) {
    const std::string_view sensor = physics::name_of(range.sensor);
    return fmt::format("{}{}{}", range.parameter == "*" ? "each" : range.parameter, sensor.empty() ? "" : ", ", sensor);
}

std::string range_unit(const physics::Effect& effect, const physics::PlausibleRange& range) {
    const int parameter = range.parameter == "*" ? 0 : physics::find_parameter(effect, range.parameter);
    return parameter >= 0                       ? unit_text(effect.parameters[static_cast<std::size_t>(parameter)].unit)
           : range.parameter == "heat_capacity" ? "J kg-1 K-1"
                                                : "W m-1 K-1";
}

namespace {

constexpr std::string_view page_head =
    "# Effects\n\n"
    "The catalogue of physical effects. This page is written by `tiretherm effects --markdown` from the catalogue "
    "itself (`physics/effects`);\ndo not edit it. A case switches an effect on with `[effects.NAME]`; the keys that "
    "all effects have are in the\n[case reference](case-reference.md). Effects of the thesis are on in every case with "
    "`[tire]`; all others are off unless named.\nBelow the parameters of an effect stand the ranges in which a tire "
    "engineer\nexpects them, with their sources; a case may go beyond them.\nHow to write a new one: "
    "[extending.md](extending.md#an-effect).\n";

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
    const auto ranges = ranges_of(effect);
    if (!ranges.empty()) {
        text += "\n| plausible | from | to | unit | source | a value beyond it means |\n|---|---|---|---|---|---|\n";
    }
    for (const physics::PlausibleRange& range : ranges) {
        text += fmt::format("| {} | {:g} | {:g} | {} | {} | {} |\n", parameter_text(range), range.low, range.high,
                            range_unit(effect, range), range.source, range.why);
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

}  // namespace

std::string effects_page() {
    using physics::Kind;
    constexpr std::array headings{std::pair{Kind::source, "Heat: sources and transfer"},
                                  std::pair{Kind::loss, "Heat: losses"},
                                  std::pair{Kind::property, "Properties and laws"},
                                  std::pair{Kind::input, "Inputs"},
                                  std::pair{Kind::state, "Initial state"},
                                  std::pair{Kind::sensor, "Sensor models"}};
    std::string text(page_head);
    for (const auto& [kind, heading] : headings) {
        text += fmt::format("\n## {}\n", heading);
        for (const physics::Effect* effect : physics::catalogue()) {
            text += effect->kind == kind ? markdown_of(*effect) : "";
        }
    }
    return text;
}

}  // namespace tiretherm::post
