#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/comparison/comparison_report.hpp"
#include "post/comparison/comparison_sentences.hpp"
#include "post/report/number_text.hpp"
#include "post/report/page.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

std::string number_of(std::size_t n, const char* thing) { return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s"); }

std::string per_run(const Comparison& comparison) {
    Table table({true, true, true, false, false, false, false, false, false, false, false});
    table.add({"channel", "unit", "run", "samples", "bias", "+-", "rms", "scatter", "noise", "sensor", "rms model"});
    for (const ComparedChannel& channel : comparison.channels) {
        const auto figures = [&](const Figures& f) -> std::vector<std::string> {
            return {grouped(static_cast<double>(f.samples)), shown_signed(channel, f.bias),
                    shown(channel, f.bias_deviation), shown(channel, f.rmse), shown(channel, f.scatter)};
        };
        const auto add = [&](std::vector<std::string> row, const Figures& f, const std::vector<std::string>& rest) {
            for (const std::string& cell : figures(f)) {
                row.push_back(cell);
            }
            row.insert(row.end(), rest.begin(), rest.end());
            table.add(std::move(row));
        };
        add({channel.name, difference_unit(channel), "all"}, channel.figures,
            {shown(channel, channel.noise), shown(channel, channel.sensor) + (channel.sensor_is_stated ? "" : "*"),
             shown(channel, channel.model.removable)});
        if (comparison.runs.size() > 1) {
            for (const RunFigures& run : channel.runs) {
                add({"", "", comparison.runs[run.run]}, run.figures, {});
            }
        }
    }
    std::string text = table.text(2);
    text += wrap(
        "noise: what changes from one sample to the next; sensor: the standard deviation stated with it; rms model: "
        "rms without sensor noise: the part that a better model could remove.",
        2);
    if (std::any_of(comparison.channels.begin(), comparison.channels.end(),
                    [](const ComparedChannel& c) { return !c.sensor_is_stated; })) {
        text += wrap("* not stated, noise is taken; state standard_deviation with the sensor.", 2);
    }
    return text;
}

std::string interpretation(const Comparison& comparison) {
    std::string text;
    for (const ComparedChannel& channel : comparison.channels) {
        text += "  " + channel.name + "\n";
        for (const std::string& sentence : sentences(channel)) {
            text += wrap("- " + sentence, 4);
        }
    }
    return text;
}

/// Empty where every channel stays in one phase.
std::string by_phase(const Comparison& comparison) {
    Table table({true, true, false, false, false, false, false, true});
    table.add({"channel", "phase", "of the time", "samples", "bias", "+-", "rms", ""});
    bool any = false;
    for (const ComparedChannel& channel : comparison.channels) {
        any = any || channel.phases.size() > 1;
        for (std::size_t i = 0; i < channel.phases.size(); ++i) {
            const PhaseFigures& phase = channel.phases[i];
            const Figures& f = phase.figures;
            table.add({i == 0 ? channel.name : "", std::string(name_of(phase.phase)),
                       fmt::format("{:.0f} %", 100.0 * phase.share), grouped(static_cast<double>(f.samples)),
                       shown_signed(channel, f.bias), shown(channel, f.bias_deviation), shown(channel, f.rmse),
                       std::string(meaning_of(phase.phase))});
        }
    }
    return any ? table.text(2) : "";
}

/// The means in the fifths of every signal, the closest first.
std::string by_signal(const ComparedChannel& channel) {
    constexpr std::size_t most = 4;
    Table table({true, true, false, false, false, false, false, false, false});
    table.add({"signal", "unit", "corr.", "p", "the fifths, lowest first"});
    for (std::size_t i = 0; i < std::min(most, channel.regressors.size()); ++i) {
        const RegressorFigures& regressor = channel.regressors[i];
        const Association& a = regressor.association;
        std::vector<std::string> values{regressor.name, regressor.unit, fmt::format("{:+.2f}", a.correlation),
                                        chance_text(a.chance)};
        std::vector<std::string> ranges{"", "", "", "fifth starts at"};
        for (const Bin& bin : regressor.bins) {
            values.push_back(fmt::format("{} +- {}", shown_signed(channel, bin.mean), shown(channel, bin.deviation)));
            // An edge that is zero but for round-off is printed as zero.
            const double size = std::max(std::abs(regressor.bins.front().low), std::abs(regressor.bins.back().high));
            ranges.push_back(fmt::format("{:.4g}", std::abs(bin.low) < 1e-9 * size ? 0.0 : bin.low));
        }
        table.add(std::move(values));
        table.add(std::move(ranges));
    }
    return fmt::format(
               "  {}: mean difference [{}] in each fifth of the signal's range of samples\n    p: probability by "
               "chance\n",
               channel.name, difference_unit(channel)) +
           table.text(4);
}

std::string single_numbers(const Comparison& comparison) {
    Table table({true, true, true, false, false, false, false, true});
    table.add({"channel", "run", "at", "measured", "+-", "simulated", "off by", "source"});
    for (const ComparedNumber& number : comparison.numbers) {
        const double off = number.in_uncertainties();
        const std::string verdict = std::abs(off) <= 2.0
                                        ? fmt::format("{:+.1f} u, within", off)
                                        : fmt::format("{:+.1f} u, too {}", off, too(number.unit, off > 0.0));
        table.add({number.channel, comparison.runs[number.run],
                   number.at_end ? "the end" : fmt::format("{:.6g} s", number.time),
                   fmt::format("{:.4g} {}", number.unit.value(number.measured), number.unit.name),
                   fmt::format("{:.2g}", number.unit.difference(number.uncertainty)),
                   fmt::format("{:.2f}", number.unit.value(number.simulated)), verdict, number.source});
    }
    return table.text(2) + "  u: standard uncertainty of the measured number; within up to 2 u\n";
}

}  // namespace

std::string comparison_text(const Comparison& comparison, bool bold) {
    Page page(bold);
    page.add(fmt::format("{}: {}, simulated in {} s\nDifferences are simulated - measured.\n", comparison.name,
                         number_of(comparison.runs.size(), "run"),
                         to_its_digits(comparison.seconds, 0.05 * comparison.seconds)));
    if (!comparison.channels.empty()) {
        page.add("Channels", per_run(comparison));
        page.add("Interpretation", interpretation(comparison));
        page.add("By what the tire does", by_phase(comparison));
        std::string signals;
        for (const ComparedChannel& channel : comparison.channels) {
            signals += channel.regressors.empty() ? "" : by_signal(channel);
        }
        page.add("By signal", signals);
    }
    page.add("Cameras", cameras_text(comparison.images, comparison.runs));
    if (!comparison.numbers.empty()) {
        page.add("Single numbers", single_numbers(comparison));
    }
    page.add("Findings about the data", paragraphs(comparison.findings));
    page.add("Warnings", paragraphs(comparison.warnings));
    return page.text();
}

}  // namespace tiretherm::post
