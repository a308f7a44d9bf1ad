// SPDX-License-Identifier: BSD-3-Clause
// The benches of a section and of its crown in layers, cases/practice/section_bench.md, as rigs of the exam.
#include <algorithm>
#include <array>

#include "exam/exam_rig_truth.hpp"
#include "section/section_columns_truth.hpp"
#include "section/section_logs_truth.hpp"

namespace hidden_effects {

namespace {

RigProgramme draw_leaning(std::uint64_t seed, double interval) {
    RigProgramme whole;
    static_cast<SectionProgramme&>(whole) = draw_section_programme(seed, interval);
    return whole;
}

RigTrace drive_of_layers(std::span<const double> numbers, const std::vector<Cause>& causes,
                         const RigProgramme& programme, double tolerance) {
    const SectionBench bench{.lambda_h = numbers[0], .lambda_sel = numbers[1], .start = numbers[2], .causes = causes};
    return drive_layers(bench, programme, {.tolerance = tolerance}).channel;
}

std::vector<Column> log_layers(const RigProgramme& programme, const RigTrace& trace) {
    std::vector<Column> columns = section_columns(programme, {.channel = trace}, layers_channels);
    std::erase_if(columns, [](const Column& column) { return column.heading.starts_with("camber"); });
    return columns;
}

RigTrace drive_of_section(std::span<const double> numbers, const std::vector<Cause>& causes,
                          const RigProgramme& programme, double tolerance) {
    const SectionBench bench{.lambda_h = numbers[0],
                             .lambda_sel = numbers[1],
                             .start = numbers[2],
                             .gas_start = numbers[2],
                             .causes = causes};
    return drive_section(bench, programme, {.tolerance = tolerance}).channel;
}

std::vector<Column> log_section(const RigProgramme& programme, const RigTrace& trace) {
    return section_columns(programme, {.channel = trace});
}

}  // namespace

// Steps of 1e-4 K err by 2e-5 K and cost 0.1 s a run; those of 1e-3 K err by 1e-3 K at single samples and cost 0.04 s, but
// what a cause changes, which is all that the oracle asks for, is the same to six digits. The crown's volume is that of both
// layers, of which the carcass is the bulk.
const Rig& layers_rig() {
    static const Rig rig{.name = "layers",
                         .case_file = "layers_bench.toml",
                         .of_bench = tire_scales(),
                         .of_run = {{.name = "start", .prior = 3.0, .spread = 2.0}},
                         .channels = rig_channels(layers_channels, std::array{0.5, 0.3, 0.3}),
                         .variants = &layers_variants(),
                         .sources = {{.id = "unknown_surface", .place = "surface"},
                                     {.id = "unknown_crown", .place = "crown", .or_at = {"bulk", "carcass", "tread"}}},
                         .draw = draw_leaning,
                         .drive = drive_of_layers,
                         .log = log_layers,
                         .interval = 4.0,
                         .tolerance = 1e-4,
                         .oracle_error = 1e-4,
                         .costly = true,
                         .finds_twins = true};
    return rig;
}

// Steps of 1e-3 K err by 1e-3 K at most and cost a second a run; those of 1e-4 K err by 1e-5 K and cost two to three.
const Rig& section_rig() {
    static const Rig rig{.name = "section",
                         .case_file = "section_bench.toml",
                         .of_bench = tire_scales(),
                         .of_run = {{.name = "start", .prior = 3.0, .spread = 2.0}},
                         .channels = rig_channels(section_channels, section_noise),
                         .variants = &section_variants(),
                         .sources = {{.id = "unknown_surface", .place = "surface"},
                                     {.id = "unknown_inside_shoulder", .place = "inside_shoulder"},
                                     {.id = "unknown_crown", .place = "crown"}},
                         .draw = draw_leaning,
                         .drive = drive_of_section,
                         .log = log_section,
                         .interval = 4.0,
                         .tolerance = 1e-4,
                         .oracle_error = 1e-3,
                         .size_error = 0.05,
                         .costly = true};
    return rig;
}

}  // namespace hidden_effects
