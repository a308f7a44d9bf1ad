// SPDX-License-Identifier: BSD-3-Clause
// [mesh], [[mesh.layer]], [[material]] and the effects of a new case.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "input/case_text/shipped_cases.hpp"
#include "input/new_case/case_tables.hpp"
#include "physics/effect.hpp"
#include "physics/tire.hpp"

namespace tiretherm::input {

namespace {

/// Makes a layer of the library's case thicker by `more`, or thinner, with cells of the same size.
void thicken(CasePart& layer, double more_mm) {
    double thickness = 0.0;
    int cells = 0;
    const std::string written = layer.text("thickness");
    const std::string count = layer.value("cells");
    const auto read = std::from_chars(written.data(), written.data() + written.size(), thickness);
    std::from_chars(count.data(), count.data() + count.size(), cells);
    const double thicker = thickness + more_mm;
    layer.replace(
        "thickness", fmt::format("{:g}{}", thicker, read.ptr),
        fmt::format("assumed: {:g} mm {} than a passenger tire's", std::abs(more_mm), more_mm > 0.0 ? "more" : "less"));
    layer.replace("cells", fmt::format("{}", std::lround(cells * thicker / thickness)), "through the thickness");
}

/// The numbers of the effects that a user adjusts; others are listed by `tiretherm effects EFFECT`.
struct Adjusted {
    std::string_view effect;
    std::array<std::string_view, 3> keys;
};
constexpr std::array adjusted{Adjusted{"strain_energy_loss", {"lambda_srf", "lambda_blk"}},
                              Adjusted{"sliding_friction", {"partition", "lambda_x", "lambda_y"}},
                              Adjusted{"air_convection", {"lambda_h", "floor"}},
                              Adjusted{"road_contact", {"Hc"}},
                              Adjusted{"resolved_contact", {"scale", "interface_h"}},
                              Adjusted{"sidewall_convection", {"disk_scale"}},
                              Adjusted{"rim_conduction", {"bead", "capacity", "area"}},
                              Adjusted{"inner_gas", {"nusselt", "capacity"}},
                              Adjusted{"groove_convection", {"area_share", "depth"}},
                              Adjusted{"radiation", {"emissivity"}},
                              Adjusted{"inflation_pressure_rise", {"exponent"}},
                              Adjusted{"camber_asymmetry", {"c"}}};

/// @param named the effect as the library's case has it, or null
void write_effect(CaseWriter& writer, std::string_view id, const CasePart* named, const NewCaseRequest& request) {
    const bool on_drum = request.test.has_value();
    const physics::Effect* effect = physics::find_effect(id);
    const auto found = std::ranges::find(adjusted, id, &Adjusted::effect);
    if (effect == nullptr) {
        return;
    }
    const std::string_view meaning = effect->meaning.substr(0, effect->meaning.find_first_of(".;:"));
    const std::string table = fmt::format("effects.{}", id);
    writer.table(table, meaning);
    const auto has = [&](std::string_view key) { return named != nullptr && !named->value(key).empty(); };
    for (const physics::ParameterSpec& parameter : effect->parameters) {
        const bool is_adjusted =
            found != adjusted.end() && std::ranges::find(found->keys, parameter.key) != found->keys.end();
        if (!is_adjusted || has("on") || has(parameter.key)) {
            continue;
        }
        if (parameter.key == "disk_scale" && request.size.is_motorcycle_front()) {
            writer.entry(parameter.key, "2",
                         "assumed: a motorcycle's front wheel stands in the travel wind; 1 behind the engine");
        } else {
            writer.entry(parameter.key, parameter.standard);
        }
    }
    if (named != nullptr) {
        const auto heading = std::ranges::find_if(named->lines, [](const auto& line) { return line.starts_with('['); });
        if (heading != named->lines.end()) {
            writer.lines({heading + 1, named->lines.end()}, table);
        }
    }
    if (on_drum && id == "strain_energy_loss") {
        writer.entry("belt_edge_gain", "1.0",
                     "assumed: at its edges the belt loses twice as much per mass as elsewhere");
    }
    if (on_drum && id == "resolved_contact") {
        writer.entry("road_conductivity", "50 W/mK", "of the drum's steel");
        writer.entry("road_capacity", "3.8e6 J/m3K");
    }
    if (on_drum && id == "air_convection" && !has("exponential")) {
        writer.entry("exponential", "off", "that of thesis (33) was fitted on a road at surfaces below 100 degC");
    }
}

}  // namespace

void write_mesh(CaseDraft& draft) {
    const physics::Tire thesis;
    const bool by_literature = draft.request.literature;
    const std::vector<CasePart> literature = cut_case(shipped_case("section/literature_conductivities.toml"));
    if (draft.mesh.name == "section") {
        draft.assume("material", by_literature ? "0.25 and 0.30 W/mK" : "K1 and K2 of the thesis",
                     by_literature
                         ? "conductivities of rubber and of cords in rubber, as literature has them"
                         : "equivalent conductivities of one 225/50 R17; --materials literature takes those of "
                           "rubber and cords");
    }
    for (CasePart part : draft.mesh.mesh) {
        const std::string name = part.text("name");
        const double more = name == "tread"      ? draft.tread_thickness - thesis.tread_thickness
                            : name == "sidewall" ? draft.sidewall_thickness - thesis.sidewall_thickness
                                                 : 0.0;
        if (part.table == "mesh.layer" && std::abs(more) > 1e-9) {
            thicken(part, std::round(more * 1e6) * 1e-3);
        }
        if (by_literature && part.table == "material") {
            const auto same = [&](const CasePart& other) { return other.text("name") == part.text("name"); };
            const auto found = std::ranges::find_if(literature, same);
            part = found != literature.end() ? *found : part;
        }
        draft.writer.blank();
        draft.writer.lines(part.lines, part.table);
    }
}

void write_effects(CaseDraft& draft) {
    CaseWriter& writer = draft.writer;
    writer.blank();
    writer.remark(
        "What heats and cools the tire. Values are the program's own: a line that is removed changes nothing. "
        "`tiretherm effects` lists all effects, `tiretherm effects air_convection` one with all its numbers and "
        "where they come from. [effects.NAME] switches one on, on = false below it one off.");
    const bool on_drum = draft.request.test.has_value();
    constexpr std::size_t prefix = std::string_view("effects.").size();
    for (const Adjusted& effect : adjusted) {
        const physics::Effect* known = physics::find_effect(effect.effect);
        const auto named = std::ranges::find_if(
            draft.mesh.effects, [&](const CasePart& part) { return part.table.substr(prefix) == effect.effect; });
        const bool is_named = named != draft.mesh.effects.end();
        const bool of_drum = on_drum && effect.effect == "inflation_pressure_rise";  // write_drum_effects has them
        if (known != nullptr && (known->on || is_named) && !of_drum) {
            write_effect(writer, effect.effect, is_named ? &*named : nullptr, draft.request);
        }
    }
    for (const CasePart& part : draft.mesh.effects) {
        const std::string id = part.table.substr(prefix);
        if (std::ranges::find(adjusted, id, &Adjusted::effect) == adjusted.end() &&
            !(on_drum && id == "drum_curvature")) {
            write_effect(writer, id, &part, draft.request);
        }
    }
}

namespace {

/// The array that looks across the tread of each tire of a car.
void write_infrared(CaseDraft& draft, int zones) {
    CaseWriter& writer = draft.writer;
    const double half = 0.5e3 * draft.request.size.width;
    writer.table("sensor");
    writer.entry("name", "infrared", fmt::format("the channels infrared_1 to infrared_{}", zones));
    writer.entry("kind", "strips");
    writer.entry("count", fmt::format("{}", zones));
    writer.entry("from", fmt::format("{:g} mm", -half), "assumed: it sees the whole tread, as wide as the tire");
    writer.entry("to", fmt::format("{:g} mm", half));
    writer.entry("first", "outboard", "assumed; or \"inboard\"");
    writer.suggestion("standard_deviation", "1 K", "of one reading, by its data sheet");
    draft.assume("infrared_1", "outboard", "number 1 of the array; first = \"inboard\" in its [[sensor]] turns it");
}

}  // namespace

void write_sensors(CaseDraft& draft) {
    draft.writer.blank();
    draft.writer.remark("What is recorded, one channel each. A sensor's standard_deviation is that of one reading.");
    for (const TemplateSensor& sensor : draft.mesh.sensors) {
        const LogColumn* column = draft.column(sensor.name);
        if (!sensor.shipped && column == nullptr) {
            continue;
        }
        draft.writer.blank();
        draft.writer.lines(sensor.lines, "sensor");
        if (column != nullptr) {
            const std::string_view example = sensor.spec.unit == "K" ? "0.5 K" : "...";
            draft.writer.suggestion("standard_deviation", example,
                                    fmt::format("of one reading of {}, by its data sheet", column->title()));
        }
    }
    if (draft.column("infrared_1") != nullptr) {
        write_infrared(draft, draft.log()->infrared_zones);
    }
}

}  // namespace tiretherm::input
