// SPDX-License-Identifier: BSD-3-Clause
// Where and when a model and its measured runs differ: by phase, by signal, number by number.
#include "post/diagnosis/residual_breakdown.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "diagnosis/compare/comparison_regressors.hpp"
#include "post/comparison/comparison_sentences.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Signals reported for each channel.
constexpr std::size_t most_signals = 3;

/// One channel of one run.
ComparedSeries series_of(const DiagnosisRecord& record, const Block& block, const Eigen::VectorXd& simulated,
                         const std::vector<Regressor>& regressors) {
    const Observations::Row& first = record.observations.rows[static_cast<std::size_t>(block.first)];
    const input::MeasuredRun& run = record.experiment.runs[first.run];
    const bool is_temperature = run.problem.channels[first.channel].quantity == solver::Quantity::temperature;
    ComparedSeries series;
    series.run = first.run;
    series.regressor.resize(regressors.size());
    for (std::size_t i = 0; i < block.time.size(); ++i) {
        const Eigen::Index row = block.first + static_cast<Eigen::Index>(i);
        const physics::Inputs inputs = run.problem.input_signals.at(block.time[i], solver::JumpSide::after);
        series.time.push_back(block.time[i]);
        series.measured.push_back(record.observations.measured[row]);
        series.simulated.push_back(simulated[row]);
        series.surroundings.push_back(0.0);
        series.phase.push_back(phase_at(run.problem, block.time[i], diagnosis::has_forces(run)));
        const SampleContext moment{.run = run,
                                   .sample = block.sample[i],
                                   .inputs = inputs,
                                   .simulated = simulated[row],
                                   .is_temperature = is_temperature};
        for (std::size_t r = 0; r < regressors.size(); ++r) {
            series.regressor[r].push_back(regressors[r].value(moment));
        }
    }
    return series;
}

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
        add(names(base[c].name, difference_unit(base[c]), "all", ""), base[c].figures,
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
    for (const Block& block : record.observations.blocks) {
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

std::vector<ComparedChannel> compare_with_measured(const DiagnosisRecord& record, const Eigen::VectorXd& simulated) {
    const std::vector<Regressor> regressors = regressors_of(record.experiment);
    std::vector<std::pair<std::string, std::string>> names;
    for (const Regressor& regressor : regressors) {
        names.emplace_back(regressor.name, regressor.unit);
    }
    std::map<std::size_t, ComparedChannel> channels;  // in the case's order
    for (const Block& block : record.observations.blocks) {
        if (block.channel < 0 || block.time.empty()) {
            continue;
        }
        const Observations::Row& first = record.observations.rows[static_cast<std::size_t>(block.first)];
        const solver::Channel& channel = record.experiment.runs[first.run].problem.channels[first.channel];
        ComparedChannel& compared = channels[first.channel];
        compared.name = channel.name;
        compared.unit = solver::shown_unit(channel.quantity);
        compared.sensor = channel.standard_deviation.value_or(0.0);
        compared.sensor_is_stated = channel.standard_deviation.has_value();
        compared.series.push_back(series_of(record, block, simulated, regressors));
    }
    std::vector<ComparedChannel> result;
    for (auto& [index, channel] : channels) {
        evaluate(channel, names);
        result.push_back(std::move(channel));
    }
    return result;
}

Section residual_breakdown(const DiagnosisRecord& record) {
    Section section("Where it shows");
    const std::vector<ComparedChannel> base = compare_with_measured(record, record.result.base);
    if (!base.empty()) {
        std::vector<ComparedChannel> extended;
        if (record.result.extended != record.result.base) {
            extended = compare_with_measured(record, record.result.extended);
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
