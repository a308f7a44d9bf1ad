// SPDX-License-Identifier: BSD-3-Clause
// A comparison as a report: each channel by run, phase and signal, cameras, single numbers.
#include "post/comparison/comparison_report.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "post/comparison/comparison_sentences.hpp"
#include "post/comparison/corner_sections.hpp"
#include "post/comparison/figure_fields.hpp"
#include "post/laps/heat_by_lap.hpp"
#include "post/page/measured_chart.hpp"
#include "post/report/number_text.hpp"
#include "post/report/phase_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

DataTable phases(const ComparedChannel& channel) {
    DataTable table;
    for (const PhaseFigures& phase : channel.phases) {
        DataTable::Row row{page_only("channel", table.empty() ? channel.name : ""),
                           {"phase", "phase", name_of(phase.phase)},
                           {"of the time", "share", {phase.share, fmt::format("{:.0f} %", 100.0 * phase.share)}}};
        row = joined(std::move(row), figures(channel, phase.figures, false));
        row.push_back(page_only("", meaning_of(phase.phase)));
        table.add(std::move(row));
    }
    return table;
}

Value regressors(const ComparedChannel& channel) {
    Value::List list;
    for (const RegressorFigures& regressor : channel.regressors) {
        const Association& a = regressor.association;
        Value::List bins;
        for (const Bin& bin : regressor.bins) {
            bins.push_back({{"low", bin.low},
                            {"high", bin.high},
                            {"samples", bin.samples},
                            {"bias", channel.unit.difference(bin.mean)},
                            {"bias_deviation", channel.unit.difference(bin.deviation)}});
        }
        list.push_back({{"name", regressor.name},
                        {"unit", regressor.unit},
                        {"correlation", a.correlation},
                        {"independent_samples", a.independent},
                        {"sigmas", a.sigmas},
                        {"chance", a.chance},
                        {"bins", bins}});
    }
    return list;
}

Value model(const ComparedChannel& channel) {
    const ModelUncertainty& m = channel.model;
    return {{"scatter", channel.unit.difference(m.scatter)},
            {"below_sensor", m.below_sensor},
            {"factor", where(m.compared > 0, m.factor)},
            {"relative", where(m.compared > 0, m.relative)},
            {"samples", m.compared}};
}

/// All of each channel. On the page: its figures over all runs and, of several, in each.
DataTable channels(const Comparison& comparison) {
    DataTable table;
    for (const ComparedChannel& channel : comparison.channels) {
        DataTable runs;
        for (const RunFigures& run : channel.runs) {
            runs.add(joined({page_only("", ""), page_only("", ""), {"run", "run", comparison.runs[run.run]}},
                            figures(channel, run.figures, true)));
        }
        const std::string sensor = shown(channel, channel.sensor) + (channel.sensor_is_stated ? "" : "*");
        DataTable::Row row{{"channel", "name", channel.name},
                           data_only("unit", channel.unit.name),
                           {"unit", "difference_unit", difference_unit(channel.unit.name)},
                           page_only("run", "all")};
        row = joined(std::move(row), figures(channel, channel.figures, true));
        table.add(joined(std::move(row), {{"noise", "noise", cell(channel, channel.noise)},
                                          {"sensor", "sensor", {channel.unit.difference(channel.sensor), sensor}},
                                          data_only("sensor_is_stated", channel.sensor_is_stated),
                                          {"rms model", "removable_rmse", cell(channel, channel.model.removable)},
                                          data_only("model", model(channel)),
                                          data_only("grid_error", where(channel.grid_error > 0.0,
                                                                        channel.unit.difference(channel.grid_error))),
                                          data_only("runs", runs.data()),
                                          data_only("phases", phases(channel).data()),
                                          data_only("regressors", regressors(channel)),
                                          data_only("significant_chance", channel.significant),
                                          data_only("interpretation", sentences(channel))}));
        for (const DataTable::Row& run : runs.rows()) {
            if (comparison.runs.size() > 1) {
                table.add_to_page(run);
            }
        }
    }
    return table;
}

ReportSection per_run(const Comparison& comparison, DataTable table) {
    ReportSection section("Channels", std::move(table));
    section.say(
        "noise: what changes from one sample to the next; sensor: the standard deviation stated with it; rms model: "
        "rms without sensor noise, the part that a better model could remove.");
    if (!std::ranges::all_of(comparison.channels, &ComparedChannel::sensor_is_stated)) {
        section.say("* not stated, noise is taken; state standard_deviation with the sensor.");
    }
    const auto most = std::ranges::max_element(comparison.channels, {}, [](const ComparedChannel& channel) {
        return channel.grid_error / std::max(channel.sensor, 1e-9);
    });
    if (most != comparison.channels.end() && most->grid_error > 0.0) {
        section.say(fmt::format("The error of grid and steps in what is simulated is {}.",
                                grid_error_text(most->name, most->unit, most->grid_error)));
    }
    if (const std::optional<GridLeftOut>& grid = comparison.grid_left_out) {
        section.say(fmt::format(
            "The error of the grid was not computed: {} cells over {} samples would take too long. Compare a part of "
            "the runs (from and to, or laps), or the same case with fewer cells: half of them have four times its "
            "error.",
            grouped(grid->cells), grouped(static_cast<double>(grid->samples))));
    }
    return section;
}

ReportSection interpretation(const Comparison& comparison) {
    ReportSection section("Interpretation");
    for (const ComparedChannel& channel : comparison.channels) {
        ReportSection part(channel.name);
        for (const std::string& sentence : sentences(channel)) {
            part.item(sentence);
        }
        section.add(std::move(part));
    }
    return section;
}

/// Empty where every channel stays in one phase.
ReportSection by_phase(const Comparison& comparison) {
    ReportSection section("By what the tire does");
    if (std::ranges::any_of(comparison.channels, [](const auto& channel) { return channel.phases.size() > 1; })) {
        DataTable all;
        for (const ComparedChannel& channel : comparison.channels) {
            const DataTable table = phases(channel);
            for (const DataTable::Row& row : table.rows()) {
                all.add_to_page(row);
            }
        }
        section.add(std::move(all));
    }
    return section;
}

/// The means in the fifths of every signal, the closest first.
ReportSection by_signal(const ComparedChannel& channel) {
    constexpr std::size_t most = 4;
    ReportSection section(fmt::format("{}: mean difference [{}] in each fifth of the signal's range of samples",
                                      channel.name, difference_unit(channel.unit.name)));
    DataTable table;
    for (std::size_t i = 0; i < std::min(most, channel.regressors.size()); ++i) {
        const RegressorFigures& regressor = channel.regressors[i];
        const Association& a = regressor.association;
        DataTable::Row values{page_only("signal", regressor.name), page_only("unit", regressor.unit),
                              page_only("corr.", shown("{:+.2f}", a.correlation)),
                              page_only("p", right(chance_text(a.chance)))};
        DataTable::Row ranges{page_only("", ""), page_only("", ""), page_only("", ""),
                              page_only("", "fifth starts at")};
        for (const Bin& bin : regressor.bins) {
            const char* heading = values.size() == 4 ? "the fifths, lowest first" : "";
            values.push_back(page_only(heading, right(fmt::format("{} +- {}", shown_signed(channel, bin.mean),
                                                                  shown(channel, bin.deviation)))));
            // An edge that is zero but for round-off is printed as zero.
            const double size = std::max(std::abs(regressor.bins.front().low), std::abs(regressor.bins.back().high));
            ranges.push_back(page_only("", shown("{:.4g}", std::abs(bin.low) < 1e-9 * size ? 0.0 : bin.low)));
        }
        table.add(std::move(values));
        table.add(std::move(ranges));
    }
    section.say("p: probability by chance");
    section.add(std::move(table));
    return section;
}

DataTable single_numbers(const Comparison& comparison) {
    DataTable table;
    for (const ComparedNumber& n : comparison.numbers) {
        const double off = n.in_uncertainties();
        const std::string verdict = std::abs(off) <= 2.0
                                        ? fmt::format("{:+.1f} u, within", off)
                                        : fmt::format("{:+.1f} u, too {}", off, too(n.unit, off > 0.0));
        const double measured = n.unit.value(n.measured);
        table.add({{"channel", "channel", n.channel},
                   {"run", "run", comparison.runs[n.run]},
                   {"at", "time", {n.time, n.at_end ? "the end" : fmt::format("{:.6g} s", n.time)}},
                   data_only("unit", n.unit.name),
                   {"measured", "measured", {measured, fmt::format("{:.4g} {}", measured, n.unit.name)}},
                   {"+-", "uncertainty", shown("{:.2g}", n.unit.difference(n.uncertainty))},
                   {"simulated", "simulated", shown("{:.2f}", n.unit.value(n.simulated))},
                   data_only("difference", n.unit.difference(n.simulated - n.measured)),
                   {"off by", "in_uncertainties", {off, verdict}},
                   {"source", "source", n.source}});
    }
    return table;
}

ReportSection numbers_section(DataTable table) {
    ReportSection section("Single values");
    if (!table.empty()) {
        section.add(std::move(table));
        section.say("u: standard uncertainty of the measured value; within up to 2 u");
    }
    return section;
}

std::vector<MeasuredSeries> series_of(const Comparison& comparison) {
    std::vector<MeasuredSeries> all;
    for (const ComparedChannel& channel : comparison.channels) {
        for (const ComparedSeries& series : channel.series) {
            all.push_back({.channel = channel.name,
                           .unit = channel.unit,
                           .run = comparison.runs[series.run],
                           .time = series.time,
                           .measured = series.measured,
                           .models = {{.name = "simulated", .simulated = series.simulated}}});
        }
    }
    return all;
}

/// The channels with the largest differences, in the order of their size against the sensor.
std::vector<std::string> verdict_of(const Comparison& comparison) {
    constexpr std::size_t most = 3;
    std::vector<const ComparedChannel*> channels;
    for (const ComparedChannel& channel : comparison.channels) {
        if (std::isfinite(channel.figures.rmse)) {
            channels.push_back(&channel);
        }
    }
    std::ranges::stable_sort(channels, std::greater<>(), [](const ComparedChannel* channel) {
        return channel->figures.rmse / (channel->sensor > 0.0 ? channel->sensor : 1.0);
    });
    std::vector<std::string> verdict;
    for (std::size_t i = 0; i < std::min(most, channels.size()); ++i) {
        verdict.push_back(headline(*channels[i], comparison.runs));
    }
    return verdict;
}

}  // namespace

Report comparison_report(const Comparison& comparison, const std::vector<std::filesystem::path>& files) {
    Value::List runs;
    for (std::size_t r = 0; r < comparison.runs.size(); ++r) {
        runs.push_back({{"name", comparison.runs[r]}, {"file", comparison.files[r]}});
    }
    DataTable of_channels = channels(comparison);
    DataTable numbers = single_numbers(comparison);
    Value cameras = Value::List{};
    Report report{.title = comparison.name + ", simulated against measured",
                  .lead = {fmt::format("{}, simulated in {} s; differences are simulated - measured",
                                       plural(comparison.runs.size(), "run"),
                                       to_its_digits(comparison.seconds, 0.05 * comparison.seconds))}};
    report.data = {{"case", comparison.name},        {"difference", "simulated - measured"},
                   {"seconds", comparison.seconds},  {"runs", runs},
                   {"channels", of_channels.data()}, {"numbers", numbers.data()}};
    report.verdict = verdict_of(comparison);
    report.verdict.insert(report.verdict.begin(), comparison.not_driven.begin(), comparison.not_driven.end());
    std::ranges::move(comparison.extrapolations.headline(), std::back_inserter(report.verdict));
    if (!comparison.channels.empty()) {
        report.add(per_run(comparison, std::move(of_channels)));
        report.add(interpretation(comparison));
        add_corners_and_laps(report, comparison.channels, comparison.runs);
        report.add(heat_by_lap_section(comparison.heat, "Friction power and heat"));
        std::vector<RunInputs> inputs;
        for (std::size_t r = 0; r < comparison.inputs.size(); ++r) {
            inputs.push_back({.run = comparison.runs[r], .inputs = &comparison.inputs[r], .laps = comparison.laps[r]});
        }
        report.add(measured_section(series_of(comparison), inputs));
        report.add(by_phase(comparison));
        ReportSection signals("By signal");
        for (const ComparedChannel& channel : comparison.channels) {
            if (!channel.regressors.empty()) {
                signals.add(by_signal(channel));
            }
        }
        report.add(std::move(signals));
    }
    report.add(cameras_section(comparison.images, comparison.runs, cameras));
    report.data.set({{"cameras", std::move(cameras)}, {"heat", heat_by_lap_data(comparison.heat)}});
    report.add(numbers_section(std::move(numbers)));
    report.add("Findings about the data", "findings", comparison.findings);
    report.add_warnings(comparison.warnings, comparison.extrapolations.warnings());
    report.add(files);
    return report;
}

}  // namespace tiretherm::post
