// SPDX-License-Identifier: BSD-3-Clause
// The two-node bench as a rig of the exam, and the look-up of rigs by name.

#include "exam/exam_rig_truth.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace hidden_effects {

namespace {

RigProgramme of_tire(Programme programme) {
    RigProgramme whole;
    static_cast<Programme&>(whole) = std::move(programme);
    return whole;
}

RigProgramme draw_two_node(std::uint64_t seed, double interval) { return of_tire(draw_programme(seed, interval)); }

RigTrace drive_two_node(std::span<const double> numbers, const std::vector<Cause>& causes,
                        const RigProgramme& programme, double tolerance) {
    BenchTrace trace = drive_bench({.lambda_h = numbers[0],
                                    .lambda_sel = numbers[1],
                                    .surface_start = numbers[2],
                                    .bulk_start = numbers[3],
                                    .causes = causes},
                                   programme, tolerance);
    return {std::move(trace.surface), std::move(trace.bulk)};
}

std::vector<Column> log_two_node(const RigProgramme& programme, const RigTrace& trace) {
    return bench_columns(programme, {.surface = trace[0], .bulk = trace[1]});
}

constexpr std::array rigs{two_node_rig, layers_rig, section_rig, laser_rig};

}  // namespace

std::vector<RigChannel> rig_channels(std::span<const std::string_view> names, std::span<const double> deviations) {
    std::vector<RigChannel> all;
    for (std::size_t c = 0; c < names.size(); ++c) {
        all.push_back({.name = std::string(names[c]), .noise = {.standard_deviation = deviations[c]}});
    }
    return all;
}

std::vector<FreeNumber> tire_scales() {
    return {{.name = "lambda_h", .expected = 1.0, .prior = 0.1, .spread = 0.07},
            {.name = "lambda_SEL", .expected = 1.0, .prior = 0.1, .spread = 0.07}};
}

const Rig& two_node_rig() {
    static const Rig rig{
        .name = "two_node",
        .case_file = "two_node_bench.toml",
        .of_bench = tire_scales(),
        .of_run = {{.name = "surface", .prior = 3.0, .spread = 2.0}, {.name = "bulk", .prior = 3.0, .spread = 2.0}},
        .channels = rig_channels(std::array<std::string_view, 2>{"surface_temperature", "bulk_temperature"},
                                 std::array{0.5, 0.3}),
        .variants = &single_variants(),
        .sources = {{.id = "unknown_surface", .place = "surface"}, {.id = "unknown_bulk", .place = "bulk"}},
        .draw = draw_two_node,
        .drive = drive_two_node,
        .log = log_two_node,
        .finds_twins = true,
        .every_kind = true};
    return rig;
}

bool is_rig(const std::string& name) {
    return std::ranges::any_of(rigs, [&](const auto& rig) { return rig().name == name; });
}

const Rig& rig_of(const std::string& name) {
    std::string all;
    for (const auto& rig : rigs) {
        if (rig().name == name) {
            return rig();
        }
        all += (all.empty() ? "" : ", ") + rig().name;
    }
    throw std::invalid_argument("no bench is called '" + name + "'; there are " + all);
}

}  // namespace hidden_effects
