// SPDX-License-Identifier: BSD-3-Clause
// The table by corner with sentences about what the corners share, and the figures of each lap.

#include "post/comparison/corner_sections.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "post/comparison/comparison_sentences.hpp"
#include "post/comparison/figure_fields.hpp"
#include "post/report/phase_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

ReportSection corner_section(const std::vector<ComparedChannel>& channels, const std::string& heading,
                             Value::List& data) {
    ReportSection section(heading);
    DataTable table;
    for (const ComparedChannel& channel : channels) {
        for (const CornerFigures& corner : channel.corners) {
            const bool is_first = &corner == &channel.corners.front();
            DataTable::Row row{
                {"channel", "channel", {channel.name, is_first ? channel.name : "", false}},
                {"unit",
                 "unit",
                 {difference_unit(channel.unit.name), is_first ? difference_unit(channel.unit.name) : "", false}},
                {"corner", "corner", corner.corner}};
            row = joined(std::move(row), figures(channel, corner.figures, true));
            for (const Phase phase : diagnosis::phases) {
                const auto one = std::ranges::find(corner.phases, phase, &PhaseFigures::phase);
                if (std::ranges::find(channel.phases, phase, &PhaseFigures::phase) != channel.phases.end()) {
                    const double bias = one == corner.phases.end() ? std::nan("") : one->figures.bias;
                    row.push_back(
                        {fmt::format("bias {}", name_of(phase)),
                         fmt::format("bias_{}", name_of(phase)),
                         {channel.unit.difference(bias), std::isnan(bias) ? "-" : shown_signed(channel, bias)}});
                }
            }
            table.add(std::move(row));
        }
    }
    if (table.empty()) {
        return section;
    }
    section.add(std::move(table));
    for (const ComparedChannel& channel : channels) {
        for (const CommonBias& common : channel.common) {
            const std::string sentence = corner_sentence(channel, common);
            data.push_back({{"channel", channel.name},
                            {"phase", name_of(common.phase)},
                            {"corners", common.corners},
                            {"group", text_or_null(common.group)},
                            {"least_bias", channel.unit.difference(common.least)},
                            {"most_bias", channel.unit.difference(common.most)},
                            {"sentence", sentence}});
            section.item(sentence);
        }
    }
    return section;
}

}  // namespace

std::vector<LapRow> lap_rows(const std::vector<ComparedChannel>& channels, const std::vector<std::string>& run_names) {
    std::vector<LapRow> rows;
    for (const ComparedChannel& channel : channels) {
        for (std::size_t s = 0; s < channel.runs.size(); ++s) {
            const RunFigures& run = channel.runs[s];
            const auto add = [&](const auto& of, std::optional<input::Lap> lap, double seconds) {
                rows.push_back({.run = run_names[run.run],
                                .corner = run.corner,
                                .lap = lap,
                                .seconds = seconds,
                                .channel = channel.name,
                                .unit = channel.unit,
                                .simulated = of.simulated,
                                .measured = of.measured,
                                .bias = of.figures.bias,
                                .rmse = of.figures.rmse});
            };
            for (const LapFigures& lap : channel.laps) {
                if (lap.run == run.run) {
                    add(lap, lap.lap, lap.lap.end - lap.lap.start);
                }
            }
            const std::vector<double>& time = channel.series[s].time;
            add(run, std::nullopt, time.empty() ? 0.0 : time.back() - time.front());
        }
    }
    return rows;
}

void add_corners_and_laps(Report& report, const std::vector<ComparedChannel>& channels,
                          const std::vector<std::string>& run_names, const std::string& of_model) {
    Value::List common;
    report.add(corner_section(channels, "Corners" + of_model, common));
    report.data.set("common_to_corners", std::move(common));
    const std::vector<LapRow> rows = lap_rows(channels, run_names);
    report.add(lap_section(rows, of_model));
    add_lap_data(report.data, rows);
}

namespace {

bool has_corners_or_laps(const input::Experiment& experiment) {
    return std::ranges::any_of(
        experiment.runs, [](const input::MeasuredRun& run) { return !run.corner.empty() || run.laps.size() > 1; });
}

std::vector<std::string> names_of_runs(const input::Experiment& experiment) {
    std::vector<std::string> names;
    for (const input::MeasuredRun& run : experiment.runs) {
        names.push_back(run.name);
    }
    return names;
}

}  // namespace

std::vector<LapRow> observed_lap_rows(const input::Experiment& experiment, const Observations& observations,
                                      const Eigen::VectorXd& simulated) {
    return has_corners_or_laps(experiment)
               ? lap_rows(compare_observed(experiment, observations, simulated), names_of_runs(experiment))
               : std::vector<LapRow>{};
}

void add_observed_corners(Report& report, const input::Experiment& experiment, const Observations& observations,
                          const Eigen::VectorXd& simulated, const std::string& of_model) {
    if (has_corners_or_laps(experiment)) {
        add_corners_and_laps(report, compare_observed(experiment, observations, simulated), names_of_runs(experiment),
                             of_model);
    }
}

}  // namespace tiretherm::post
