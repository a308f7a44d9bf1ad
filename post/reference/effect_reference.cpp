// SPDX-License-Identifier: BSD-3-Clause
// What the catalogue says of an effect as a report, and of all effects as the page docs/effects.md.
#include "post/reference/effect_reference.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "diagnosis/detect/confounded_effects.hpp"
#include "physics/plausible_ranges.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

namespace {

std::string kind_name(physics::EffectKind kind) {
    switch (kind) {
        case physics::EffectKind::source:
            return "source";
        case physics::EffectKind::loss:
            return "loss";
        case physics::EffectKind::property:
            return "property";
        case physics::EffectKind::input:
            return "input";
        case physics::EffectKind::state:
            return "initial state";
        case physics::EffectKind::sensor:
            return "sensor";
    }
    return "";
}

/// Whether it is part of the thesis's model.
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

/// A unit as a table shows it: "-" for a pure number.
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

/// The unit of a range: of its parameter, of any of the effect's for "*", or of a material law.
std::string range_unit(const physics::Effect& effect, const physics::PlausibleRange& range) {
    const int parameter = range.parameter == "*" ? 0 : physics::find_parameter(effect, range.parameter);
    return parameter >= 0                       ? unit_text(effect.parameters[static_cast<std::size_t>(parameter)].unit)
           : range.parameter == "heat_capacity" ? "J kg-1 K-1"
                                                : "W m-1 K-1";
}

DataTable parameters_of(const physics::Effect& effect) {
    DataTable table;
    for (const physics::ParameterSpec& p : effect.parameters) {
        table.add({{"parameter", "key", p.key},
                   {"default", "default", shown("{:g}", p.standard)},
                   {"from", "low", shown("{:g}", p.low)},
                   {"to", "high", shown("{:g}", p.high)},
                   {"unit", "unit", {std::string(p.unit), unit_text(p.unit), false}},
                   {"meaning", "meaning", p.meaning}});
    }
    return table;
}

/// Of "conduction" those of material laws.
DataTable ranges_of(const physics::Effect& effect) {
    DataTable table;
    for (const physics::PlausibleRange& range : effect.plausible) {
        const std::string_view sensor = physics::name_of(range.sensor);
        const std::string parameter = fmt::format("{}{}{}", range.parameter == "*" ? "each" : range.parameter,
                                                  sensor.empty() ? "" : ", ", sensor);
        table.add({page_only("plausible", parameter),
                   data_only("parameter", range.parameter),
                   data_only("sensor", sensor),
                   {"from", "low", shown("{:g}", range.low)},
                   {"to", "high", shown("{:g}", range.high)},
                   {"unit", "unit", range_unit(effect, range)},
                   {"source", "source", range.source},
                   {"a value beyond it means", "beyond", range.why}});
    }
    return table;
}

/// Groups that the effect or one of its parameters belongs to.
DataTable confounded_of(const physics::Effect& effect) {
    DataTable table;
    for (const physics::Effect* one : physics::catalogue()) {
        for (const physics::ConfoundedGroup& group : one->confounded) {
            const auto own = std::ranges::find_if(group.members, [&](std::string_view member) {
                return member.substr(0, member.find('.')) == effect.id;
            });
            if (own != group.members.end()) {
                table.add({{"like it", "confounded_with", diagnosis::others_of(group, *own)},
                           {"what tells them apart", "separated_by", group.separated}});
            }
        }
    }
    return table;
}

DataTable choices_of(const physics::Effect& effect) {
    DataTable table;
    for (const physics::Choice& choice : effect.choices) {
        const std::vector<std::string_view> options(choice.options.begin(), choice.options.end());
        table.add({{"word", "key", choice.key},
                   {"values, the first is the default",
                    "options",
                    {Value(options), fmt::format("{}", fmt::join(options, ", ")), false}},
                   {"meaning", "meaning", choice.meaning}});
    }
    return table;
}

DataTable tables_of(const physics::Effect& effect) {
    DataTable table;
    for (const physics::Table& t : effect.tables) {
        table.add({{"table", "key", t.key},
                   page_only("values", fmt::format("{} against {}", unit_text(t.value_unit), t.variable_unit)),
                   data_only("unit", t.value_unit),
                   data_only("against", t.variable_unit),
                   {"meaning", "meaning", t.meaning}});
    }
    return table;
}

/// Sections of one paragraph each, empty where there is nothing special.
void add(Report& report, const char* heading, const char* key, std::string_view text) {
    report.data.set(key, text);
    report.add(ReportSection(heading, {std::string(text)}));
}

void add(Report& report, const char* heading, const char* key, std::span<const std::string_view> names,
         std::string_view between = ", ") {
    report.data.set(key, std::vector<std::string_view>(names.begin(), names.end()));
    report.add(ReportSection(heading, {fmt::format("{}", fmt::join(names, between))}));
}

void add(Report& report, const char* heading, const char* key, DataTable table) {
    report.data.set(key, table.data());
    report.add(ReportSection(heading, std::move(table)));
}

}  // namespace

Report effect_report(const physics::Effect& effect) {
    Report report{.title = fmt::format("{} ({}, {})", effect.id, kind_name(effect.kind), origin(effect))};
    report.data = {{"name", effect.id}, {"kind", kind_name(effect.kind)}, {"on", effect.on}};
    add(report, "", "meaning", effect.meaning);
    add(report, "Equation", "equation", effect.equation);
    add(report, "Source", "source", effect.source);
    add(report, "Valid", "valid", effect.valid);
    add(report, "Parameters", "parameters", parameters_of(effect));
    add(report, "Plausible ranges, in which the parameters of a tire are expected", "plausible_ranges",
        ranges_of(effect));
    add(report, "Confounded in a diagnosis", "confounded", confounded_of(effect));
    add(report, "Words", "choices", choices_of(effect));
    add(report, "Tables", "tables", tables_of(effect));
    add(report, "From files", "from_files", field_text(effect));
    add(report, "Reads the signals", "reads", effect.reads);
    add(report, "Also, when given", "may_read", effect.may_read);
    add(report, "Acts on the patches", "patches", effect.patches, effect.one_patch ? " or else " : ", ");
    report.data.set("one_patch", effect.one_patch);
    add(report, "Acts on", "acts_on", acts_on_text(effect));
    add(report, "Needs", "needs", needs_text(effect));
    report.data.set("needs_tire", effect.needs_tire);
    report.data.set("needs_grid", effect.needs_grid);
    return report;
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

/// The report of an effect below a heading of its own: tables as they are, each paragraph behind its section's heading.
std::string markdown_of(const physics::Effect& effect) {
    std::string text = fmt::format("\n### {}\n\n*{}, {}.* ", effect.id, kind_name(effect.kind), origin(effect));
    for (const ReportSection& section : effect_report(effect).sections) {
        for (const PageItem& block : section.blocks()) {
            const std::string& heading = section.heading();
            text += block.kind == PageItem::Kind::table ? "\n" + markdown_text(block.table)
                    : heading.empty()                   ? block.text + "\n"
                    : heading == "Equation"             ? fmt::format("\n    {}\n", block.text)
                                                        : fmt::format("\n{}: {}.\n", heading, block.text);
        }
    }
    return text;
}

}  // namespace

std::string effects_page() {
    using physics::EffectKind;
    constexpr std::array headings{std::pair{EffectKind::source, "Heat: sources and transfer"},
                                  std::pair{EffectKind::loss, "Heat: losses"},
                                  std::pair{EffectKind::property, "Properties and laws"},
                                  std::pair{EffectKind::input, "Inputs"},
                                  std::pair{EffectKind::state, "Initial state"},
                                  std::pair{EffectKind::sensor, "Sensor models"}};
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
