// SPDX-License-Identifier: BSD-3-Clause
// [drive], [initial], [time] and [[critical]] of a case of a durability test, and the effects of a drum.
#include <algorithm>

#include <fmt/format.h>

#include "input/new_case/case_tables.hpp"

namespace tiretherm::input {

namespace {

std::string row_text(const DrumRow& row, double load, bool loads_differ) {
    const std::string share = loads_differ ? fmt::format(", {:.0f}", load * row.load_share) : "";
    return fmt::format("[{:g}, {:g}{}]", row.minutes, row.kmh, share);
}

}  // namespace

void write_drum_drive(CaseDraft& draft, const DrumTest& test) {
    CaseWriter& writer = draft.writer;
    const double share = test.rows.front().load_share;
    const bool loads_differ =
        std::ranges::any_of(test.rows, [&](const DrumRow& row) { return row.load_share != share; });
    const std::string room = fmt::format("{:g} degC", test.room);
    writer.table("drive", test.title);
    writer.remark("Source: " + test.origin + ".");
    if (!loads_differ) {
        writer.entry("vertical_load", fmt::format("{:.0f} N", share * test.load),
                     fmt::format("{:g} % of {:.0f} N, load index {}", 100.0 * share, test.load,
                                 draft.request.size.service->load_index));
    }
    writer.entry("inflation_pressure", fmt::format("{:g} kPa", test.pressure * 1e-3), test.pressure_ground);
    writer.entry("air_temperature", room, "of the room, recalled");
    writer.entry("road_temperature", room, "of the drum when the test begins; assumed: as warm as the room");
    writer.table("drive.schedule", "steps; two rows at one time are a jump");
    writer.entry("columns", loads_differ ? "[\"time [min]\", \"speed [km/h]\", \"vertical_load [N]\"]"
                                         : "[\"time [min]\", \"speed [km/h]\"]");
    std::string rows = "[";
    for (std::size_t i = 0; i + 1 < test.rows.size(); i += 2) {
        rows += fmt::format("\n    {}, {},", row_text(test.rows[i], test.load, loads_differ),
                            row_text(test.rows[i + 1], test.load, loads_differ));
    }
    writer.entry("rows", rows + "\n]");
    writer.table("initial");
    writer.entry("temperature", room, "the tire has stood in the room");
    writer.table("time");
    writer.entry("end", fmt::format("{:g} min", test.rows.back().minutes), "of the schedule");
    writer.entry("output", "10 s");
}

void write_drum_effects(CaseDraft& draft, const DrumTest& test) {
    CaseWriter& writer = draft.writer;
    writer.table("effects.drum_curvature", "a drum of 1.707 m in the place of a road");
    writer.entry("curvature", "1.1716 1/m", "2 / 1.707 m");
    writer.table("effects.drum_heating", "the tire heats the drum");
    writer.entry("capacity", "2e5 J/K", "assumed: a steel shell of 0.5 m x 20 mm");
    writer.entry("cooling", "150 W/K", "to the air at 100 km/h; estimated");
    if (const std::optional<double> limit = draft.request.size.service->speed()) {
        writer.table("effects.standing_wave", "the loss rises near the tire's limit");
        writer.entry("critical_speed", fmt::format("{:.0f} km/h", 0.8 * *limit * 3.6),
                     fmt::format("assumed: 0.8 of the symbol's {:.0f} km/h", *limit * 3.6));
        writer.entry("gain", "1e-4 1/(km/h)^2", "assumed");
    }
    writer.table("effects.inflation_pressure_rise", "the gas that warms up raises the pressure");
    writer.entry("exponent", "0.45", "loss ~ pressure^-0.45, SAE J2452, recalled");
    writer.entry("reference", fmt::format("{:g} degC", test.room), "of the gas as it was filled");
}

void write_drum_critical(CaseDraft& draft) {
    CaseWriter& writer = draft.writer;
    writer.table("critical", "when does the belt's edge get too hot, and how sure is that?");
    writer.entry("name", "belt edge");
    writer.entry("temperature", "110 degC", "assumed: put that of your compound here");
    writer.entry("layers", "[\"belt\"]");
    writer.entry("zones", "[\"outside_shoulder\", \"inside_shoulder\"]");
    writer.table("critical");
    writer.entry("name", "whole tire");
    writer.entry("temperature", "110 degC", "assumed");
    writer.blank();
    writer.remark(
        "What is not known of the tire, one standard deviation each: `tiretherm run` says what it does to the peak.");
    write_parameter(writer, "strain_energy_loss", "tan_delta_a", "0.2e15", "about 10 %");
    write_parameter(writer, "strain_energy_loss", "belt_edge_gain", "0.3", "not measured for this tire");
    write_parameter(writer, "air_convection", "lambda_h", "0.1", "films are known to 10 %");
    draft.assume("critical", "110 degC", "an example; the belt's edge is assumed to lose twice as much as the rest");
    draft.assume("drive.inflation_pressure", "by the test",
                 "see [drive]; --pressure says at which the tire's laws hold");
}

}  // namespace tiretherm::input
