// SPDX-License-Identifier: BSD-3-Clause
// Where and when a model and its measured runs differ: by phase, by signal, number by number.
#include "post/diagnosis/residual_breakdown.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "diagnosis/compare/observed_comparison.hpp"
#include "post/comparison/comparison_sentences.hpp"
#include "post/report/number_text.hpp"
#include "post/report/phase_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Signals reported for each channel.
constexpr std::size_t most_signals = 3;

/// Mean, its deviation and rms, all to the digits that the channel's rms with the base model deserves.
void add_figures(DataTable::Row& row, const char* heading, const ComparedChannel& channel, const Figures& f) {
    const double half = 0.5 * channel.unit.difference(channel.figures.rmse);
    const auto show = [&](double si) { return to_its_digits(channel.unit.difference(si), half); };
    row.push_back(page_only(heading, right((f.bias >= 0.0 ? "+" : "") + show(f.bias))));
    row.push_back(page_only("+-", right(show(f.bias_deviation))));
    row.push_back(page_only("rms", right(show(f.rmse))));
}

DataTable phases(const std::vector<ComparedChannel>& base, const std::vector<ComparedChannel>& extended) {
    DataTable table;
    for (std::size_t c = 0; c < base.size(); ++c) {
        const auto add = [&](DataTable::Row row, const Figures& before, const Figures* after) {
            add_figures(row, "base", base[c], before);
            if (after != nullptr) {
                add_figures(row, "extended", base[c], *after);
            }
            table.add(std::move(row));
        };
        const auto names = [](std::string name, std::string unit, std::string_view phase, std::string share) {
            return DataTable::Row{page_only("channel", std::move(name)), page_only("unit", std::move(unit)),
                                  page_only("while", phase), page_only("of the time", right(std::move(share)))};
        };
        add(names(base[c].name, difference_unit(base[c].unit.name), "all", ""), base[c].figures,
            extended.empty() ? nullptr : &extended[c].figures);
        for (std::size_t p = 0; p < base[c].phases.size() && base[c].phases.size() > 1; ++p) {
            const PhaseFigures& phase = base[c].phases[p];
            add(names("", "", name_of(phase.phase), fmt::format("{:.0f} %", 100.0 * phase.share)), phase.figures,
                extended.empty() ? nullptr : &extended[c].phases[p].figures);
        }
    }
    return table;
}

DataTable signals(const std::vector<ComparedChannel>& base, const std::vector<ComparedChannel>& extended) {
    DataTable table;
    for (std::size_t c = 0; c < base.size(); ++c) {
        for (std::size_t i = 0; i < std::min(most_signals, base[c].regressors.size()); ++i) {
            const RegressorFigures& signal = base[c].regressors[i];
            DataTable::Row row{page_only("channel", i == 0 ? base[c].name : ""), page_only("follows", signal.name)};
            const auto add = [&](const char* heading, const Association* a) {
                row.push_back(page_only(heading, a == nullptr ? right("") : shown("{:+.2f}", a->correlation)));
                row.push_back(page_only("p", right(a == nullptr ? "" : chance_text(a->chance))));
            };
            add("corr.", &signal.association);
            if (!extended.empty()) {
                const auto& after = extended[c].regressors;
                const auto same = std::ranges::find(after, signal.name, &RegressorFigures::name);
                add("extended", same == after.end() ? nullptr : &same->association);
            }
            table.add(std::move(row));
        }
    }
    return table;
}

/// Single numbers, with their distance in their own standard uncertainties.
DataTable single_numbers(const DiagnosisRecord& record) {
    DataTable table;
    for (const NoiseBlock& block : record.observations.blocks) {
        for (std::size_t i = 0; block.channel < 0 && i < block.standard_deviation.size(); ++i) {
            const Eigen::Index k = block.first + static_cast<Eigen::Index>(i);
            const Observations::Row& row = record.observations.rows[static_cast<std::size_t>(k)];
            const input::MeasuredRun& run = record.experiment.runs[row.run];
            const solver::Channel& channel = run.problem.channels[row.channel];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            const double u = block.standard_deviation[i];
            const double measured = record.observations.measured[k];
            const auto value = [&](double si) { return shown("{:.2f}", unit.value(si)); };
            const auto off = [&](double si) { return shown("{:+.1f} u", (si - measured) / u); };
            table.add({page_only("channel", channel.name), page_only("run", run.name),
                       page_only("measured", right(fmt::format("{:.4g} {}", unit.value(measured), unit.name))),
                       page_only("+-", shown("{:.2g}", unit.difference(u))),
                       page_only("base", value(record.result.base[k])), page_only("off by", off(record.result.base[k])),
                       page_only("extended", value(record.result.extended[k])),
                       page_only("off by", off(record.result.extended[k]))});
        }
    }
    return table;
}

}  // namespace

ReportSection residual_breakdown(const DiagnosisRecord& record) {
    ReportSection section("Where it shows");
    const std::vector<ComparedChannel> base =
        compare_observed(record.experiment, record.observations, record.result.base);
    if (!base.empty()) {
        std::vector<ComparedChannel> extended;
        if (record.result.extended != record.result.base) {
            extended = compare_observed(record.experiment, record.observations, record.result.extended);
        }
        section.add(phases(base, extended));
        if (DataTable closest = signals(base, extended); !closest.empty()) {
            section.gap();
            section.say("The signals that it follows closest; p: probability by chance");
            section.add(std::move(closest));
        }
    }
    if (DataTable numbers = single_numbers(record); !numbers.empty()) {
        section.gap();
        section.add(std::move(numbers));
        section.say("u: standard uncertainty of the measured value");
    }
    return section;
}

}  // namespace tiretherm::post
