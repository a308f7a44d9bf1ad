// SPDX-License-Identifier: BSD-3-Clause
// Takes the figures of a diagnosis as bars and maps.
#include "post/diagnosis/diagnosis_charts.hpp"

#include <algorithm>
#include <cmath>

#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/page/cell_chart.hpp"
#include "post/page/charts.hpp"
#include "post/report/number_text.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr std::size_t most_causes = 10;
constexpr double significant = 3.0;  ///< standard deviations, from which on missing heat is framed

std::vector<const Cause*> shown_causes(const Diagnosis& result) {
    std::vector<const Cause*> causes;
    for (const Cause& cause : result.causes) {
        if (cause.in_set || causes.size() < most_causes) {
            causes.push_back(&cause);
        }
    }
    return causes;
}

}  // namespace

void add_cause_charts(ReportSection& section, const Diagnosis& result) {
    std::vector<Bar> gains;
    std::vector<Bar> sigmas;
    for (const Cause* cause : shown_causes(result)) {
        const std::string name = name_of(*cause);
        gains.push_back({.name = name, .value = cause->gain, .is_marked = cause->in_set});
        sigmas.push_back({.name = name, .value = cause->sigma, .is_marked = cause->in_set});
    }
    if (gains.empty()) {
        return;
    }
    const std::string framed =
        std::ranges::any_of(result.causes, &Cause::in_set) ? " Framed: in the set of explanations." : "";
    section.chart("Gain of each cause",
                  "Natural logarithm of how much more likely the data are with this cause than without it, the free "
                  "parameters fitted anew." +
                      framed,
                  bar_chart("gain in log likelihood", "", gains));
    section.chart("Size of each cause",
                  "Standard deviations of its fitted parameter from no effect, or from the case's value." + framed,
                  bar_chart("size", "standard deviations", sigmas));
}

void add_channel_gain_charts(ReportSection& section, const DiagnosisRecord& record) {
    std::vector<std::string> units;
    const auto unit_name = [&](const ChannelGain& gain) -> std::string {
        const solver::Channel& channel = record.experiment.runs.front().problem.channels[gain.channel];
        return difference_unit(solver::shown_unit(channel.quantity).name);
    };
    for (const ChannelGain& gain : record.result.channels) {
        if (const std::string unit = unit_name(gain); std::ranges::find(units, unit) == units.end()) {
            units.push_back(unit);
        }
    }
    const bool held_out = std::ranges::any_of(
        record.result.channels, [](const ChannelGain& gain) { return std::isfinite(gain.heldout_before); });
    std::vector<std::string> series{"before", "after"};
    if (held_out) {
        series.insert(series.end(), {"held out, before", "held out, after"});
    }
    for (const std::string& unit : units) {
        std::vector<BarGroup> groups;
        for (const ChannelGain& gain : record.result.channels) {
            if (unit_name(gain) != unit) {
                continue;
            }
            const solver::Channel& channel = record.experiment.runs.front().problem.channels[gain.channel];
            const solver::ShownUnit shown = solver::shown_unit(channel.quantity);
            BarGroup group{.name = channel.name,
                           .values = {shown.difference(gain.rmse_before), shown.difference(gain.rmse_after)}};
            if (held_out) {
                group.values.insert(group.values.end(),
                                    {shown.difference(gain.heldout_before), shown.difference(gain.heldout_after)});
            }
            groups.push_back(std::move(group));
        }
        section.chart("Before and after, channel by channel",
                      "Root mean square of simulated - measured with the fitted base model and with the extended one. "
                      "Held out: on data that took no part in naming or fitting.",
                      grouped_bar_chart("rms of the difference", unit, series, groups));
    }
}

void add_held_out_chart(ReportSection& section, const DiagnosisRecord& record) {
    std::vector<Bar> bars;
    const auto add = [&](const std::string& name, const Gain& gain) {
        if (gain.measured) {
            bars.push_back({.name = name,
                            .value = 100.0 * gain.removable_removed,
                            .low = 100.0 * gain.low,
                            .high = 100.0 * gain.high,
                            .is_marked = gain.confirmed});
        }
    };
    add(record.by_run.runs.empty() ? "these data" : "all runs", record.result.gain);
    for (const RunVerdict& run : record.by_run.runs) {
        add(run.name, run.gain);
    }
    if (!bars.empty()) {
        section.chart("Gain on data left out",
                      "Share of the removable error (mean square beyond the noise) that the extension removes on data "
                      "that took no part in naming or fitting, with its 95 % interval; of each run alone on blocks of "
                      "it. Framed: confirmed. Below zero the extension makes it worse.",
                      bar_chart("removed error", "%", bars));
    }
}

void add_experiment_chart(ReportSection& section, const Diagnosis& result) {
    std::vector<BarGroup> groups;
    for (const NextExperiment& next : result.next) {
        groups.push_back({.name = next.name, .values = {next.now, next.then}});
    }
    if (!groups.empty()) {
        section.chart(
            "What further experiments would separate",
            "Standard deviations by which the explanations differ. From 2 to 3 on they can be told apart.",
            grouped_bar_chart("separation", "standard deviations", {"with these data", "with the experiment as well"},
                              groups, {{.name = "2", .value = 2.0}, {.name = "3", .value = 3.0}}));
    }
}

void add_missing_heat_maps(ReportSection& section, const DiagnosisRecord& record) {
    double reach = 0.0;  // one scale for all runs
    for (const MissingHeat& one : record.result.missing_heat) {
        reach = std::max(reach, std::abs(one.watts));
    }
    for (std::size_t run = 0; run < record.experiment.runs.size(); ++run) {
        std::vector<std::string> places;
        double low = 1e300;
        double high = -1e300;
        for (const MissingHeat& one : record.result.missing_heat) {
            if (one.run == run) {
                if (std::ranges::find(places, one.place) == places.end()) {
                    places.push_back(one.place);
                }
                low = std::min(low, one.from);
                high = std::max(high, one.to);
            }
        }
        if (places.empty()) {
            continue;
        }
        const TimeUnit unit = time_unit(high - low);
        std::vector<MapCell> cells;
        for (const MissingHeat& one : record.result.missing_heat) {
            if (one.run != run) {
                continue;
            }
            const auto row = static_cast<double>(std::ranges::find(places, one.place) - places.begin());
            cells.push_back({.x_from = one.from / unit.seconds,
                             .x_to = one.to / unit.seconds,
                             .y_from = row,
                             .y_to = row + 1.0,
                             .value = one.watts,
                             .is_marked = std::abs(one.sigma()) >= significant});
        }
        const std::string& name = record.experiment.runs[run].name;
        section.chart(
            "Inferred heat over place and time" + (name.empty() ? "" : ": " + name),
            "Heat that the base model would need at each place to fit, if it all entered there: all windows together. "
            "Framed: three standard deviations or more.",
            cell_chart({.name = "time", .unit = unit.name, .low = low / unit.seconds, .high = high / unit.seconds},
                       {.name = "", .words = std::move(places)},
                       {.name = "missing heat",
                        .unit = "W",
                        .is_signed = true,
                        .reach = reach,
                        .marked = "three standard deviations or more"},
                       cells));
    }
}

}  // namespace tiretherm::post
