// SPDX-License-Identifier: BSD-3-Clause
// Seeds, parameters and noise of the shipped logs of the section bench and of the bench of layers.

#include "section/section_logs_truth.hpp"

#include "numerics/random_truth.hpp"
#include "section/section_columns_truth.hpp"

namespace hidden_effects {

namespace {

void add_noise(SectionTrace& trace, std::span<const double> deviations, const SectionProgramme& programme,
               Random& random) {
    for (std::size_t c = 0; c < trace.channel.size(); ++c) {
        const std::vector<double> noise = draw_noise({.standard_deviation = deviations[c]}, programme.time, random);
        for (std::size_t i = 0; i < noise.size(); ++i) {
            trace.channel[c][i] += noise[i];
        }
    }
}

}  // namespace

std::vector<ShippedLog> section_logs() {
    std::vector<ShippedLog> logs;
    for (std::uint64_t run = 1; run <= 3; ++run) {
        const SectionProgramme programme = draw_section_programme(400 + run);
        Random random(450 + run);
        const double start = programme.air_temperature.front() + 2.0 * random.normal();
        SectionTrace trace =
            drive_section({.lambda_h = 1.04, .lambda_sel = 0.95, .start = start, .gas_start = start}, programme);
        add_noise(trace, section_noise, programme, random);
        logs.push_back({"practice/section_run" + std::to_string(run) + ".csv", section_columns(programme, trace)});
    }
    return logs;
}

std::vector<ShippedLog> layers_logs() {
    constexpr std::array<double, layers_channels.size()> deviations{0.5, 0.3, 0.3};
    std::vector<ShippedLog> logs;
    for (std::uint64_t run = 1; run <= 3; ++run) {
        const SectionProgramme programme = draw_section_programme(600 + run);
        Random random(650 + run);
        const double start = programme.air_temperature.front() + 2.0 * random.normal();
        SectionTrace trace = drive_layers({.lambda_h = 0.96, .lambda_sel = 1.05, .start = start}, programme);
        add_noise(trace, deviations, programme, random);
        std::vector<Column> columns = section_columns(programme, trace, layers_channels);
        std::erase_if(columns, [](const Column& column) { return column.heading.starts_with("camber"); });
        logs.push_back({"practice/layers_run" + std::to_string(run) + ".csv", std::move(columns)});
    }
    return logs;
}

}  // namespace hidden_effects
