// SPDX-License-Identifier: BSD-3-Clause
// Tables by corner and by lap, and sentences about what the corners share.

#include "post/comparison/corner_sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "physics/vehicle/vehicle.hpp"
#include "post/comparison/comparison_sentences.hpp"
#include "post/comparison/figure_fields.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

Section corner_section(const std::vector<ComparedChannel>& channels, const std::string& heading, Value::List& data) {
    Section section(heading);
    DataTable table;
    for (const ComparedChannel& channel : channels) {
        for (const CornerFigures& corner : channel.corners) {
            const bool is_first = &corner == &channel.corners.front();
            DataTable::Row row{
                {"channel", "channel", {channel.name, is_first ? channel.name : "", false}},
                {"unit", "unit", {difference_unit(channel), is_first ? difference_unit(channel) : "", false}},
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

/// What the runs are called in a heading: by their corners alone where all are of one recording.
std::vector<std::string> short_names(const std::vector<std::string>& runs) {
    const std::string recording = runs.empty() ? "" : runs.front().substr(0, runs.front().rfind('_') + 1);
    std::vector<std::string> corners;
    for (const std::string& run : runs) {
        const std::string corner = run.starts_with(recording) ? run.substr(recording.size()) : std::string();
        if (std::ranges::find(physics::corner_names, corner) == physics::corner_names.end()) {
            return runs;
        }
        corners.push_back(corner);
    }
    return corners;
}

Section lap_section(const std::vector<ComparedChannel>& channels, const std::vector<std::string>& runs,
                    const std::string& heading, Value::List& data) {
    Section section(heading);
    DataTable table;
    const std::vector<std::string> called = short_names(runs);
    for (const ComparedChannel& channel : channels) {
        std::vector<std::pair<int, std::string>> numbers;  // in their order, and what they are called
        const auto called_of = [](const input::Lap& lap) -> std::pair<int, std::string> {
            switch (lap.kind) {
                case input::LapKind::out:
                    return {std::numeric_limits<int>::min(), "out"};
                case input::LapKind::in:
                    return {std::numeric_limits<int>::max(), "in"};
                default:
                    return {lap.number, std::to_string(lap.number)};
            }
        };
        for (const LapFigures& one : channel.laps) {
            const std::pair lap = called_of(one.lap);
            if (std::ranges::find(numbers, lap) == numbers.end()) {
                numbers.push_back(lap);
            }
            data.push_back({{"channel", channel.name},
                            {"run", runs[one.run]},
                            {"lap", lap.second},
                            {"seconds", one.lap.end - one.lap.start},
                            {"bias", channel.unit.difference(one.figures.bias)},
                            {"rmse", channel.unit.difference(one.figures.rmse)}});
        }
        if (numbers.size() < 2) {
            continue;
        }
        std::ranges::sort(numbers);
        for (const std::pair<int, std::string>& lap : numbers) {
            const bool is_first = lap == numbers.front();
            DataTable::Row row{page_only("channel", is_first ? channel.name : ""),
                               page_only("unit", is_first ? difference_unit(channel) : ""),
                               page_only("lap", right(lap.second))};
            for (const RunFigures& run : channel.runs) {
                const auto own = std::ranges::find_if(channel.laps, [&](const LapFigures& one) {
                    return one.run == run.run && called_of(one.lap) == lap;
                });
                row.push_back(page_only(
                    "bias " + called[run.run],
                    own == channel.laps.end() ? right("-") : right(shown_signed(channel, own->figures.bias))));
            }
            table.add_to_page(std::move(row));
        }
    }
    if (!table.empty()) {
        section.add(std::move(table));
        section.say("bias: mean of simulated - measured in the lap.");
    }
    return section;
}

}  // namespace

void add_corners_and_laps(Report& report, const std::vector<ComparedChannel>& channels,
                          const std::vector<std::string>& run_names, const std::string& of_model) {
    Value::List common;
    report.add(corner_section(channels, "Corners" + of_model, common));
    report.data.set("common_to_corners", std::move(common));
    Value::List laps;
    report.add(lap_section(channels, run_names, "Laps" + of_model, laps));
    report.data.set("laps", std::move(laps));
}

void add_observed_corners(Report& report, const input::Experiment& experiment, const Observations& observations,
                          const Eigen::VectorXd& simulated, const std::string& of_model) {
    std::vector<std::string> names;
    bool has_any = false;
    for (const input::MeasuredRun& run : experiment.runs) {
        names.push_back(run.name);
        has_any = has_any || !run.corner.empty() || run.laps.size() > 1;
    }
    if (has_any) {
        add_corners_and_laps(report, compare_observed(experiment, observations, simulated), names, of_model);
    }
}

}  // namespace tiretherm::post
