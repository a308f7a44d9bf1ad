#include "post/diagnosis/residual_breakdown.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "diagnosis/compare/comparison_regressors.hpp"
#include "post/comparison/comparison_sentences.hpp"
#include "post/report/number_text.hpp"
#include "post/report/table.hpp"

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
        series.phase.push_back(phase_at(run.problem, block.time[i]));
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
std::vector<std::string> cells(const ComparedChannel& channel, const Figures& f) {
    const double half = 0.5 * channel.unit.difference(channel.figures.rmse);
    const auto show = [&](double si) { return to_its_digits(channel.unit.difference(si), half); };
    return {(f.bias >= 0.0 ? "+" : "") + show(f.bias), show(f.bias_deviation), show(f.rmse)};
}

std::string phases_text(const std::vector<ComparedChannel>& base, const std::vector<ComparedChannel>& extended) {
    const bool both = !extended.empty();
    Table table({true, true, true, false, false, false, false, false, false, false});
    std::vector<std::string> head{"channel", "unit", "while", "of the time", "base", "+-", "rms"};
    if (both) {
        head.insert(head.end(), {"extended", "+-", "rms"});
    }
    table.add(head);
    for (std::size_t c = 0; c < base.size(); ++c) {
        const auto add = [&](std::vector<std::string> row, const Figures& before, const Figures* after) {
            std::ranges::copy(cells(base[c], before), std::back_inserter(row));
            if (after != nullptr) {
                std::ranges::copy(cells(base[c], *after), std::back_inserter(row));
            }
            table.add(std::move(row));
        };
        add({base[c].name, difference_unit(base[c]), "all", ""}, base[c].figures,
            both ? &extended[c].figures : nullptr);
        for (std::size_t p = 0; p < base[c].phases.size() && base[c].phases.size() > 1; ++p) {
            const PhaseFigures& phase = base[c].phases[p];
            add({"", "", std::string(name_of(phase.phase)), fmt::format("{:.0f} %", 100.0 * phase.share)},
                phase.figures, both ? &extended[c].phases[p].figures : nullptr);
        }
    }
    return table.text(2);
}

std::string signals_text(const std::vector<ComparedChannel>& base, const std::vector<ComparedChannel>& extended) {
    Table table({true, true, false, false, false, false});
    table.add({"channel", "follows", "corr.", "p", extended.empty() ? "" : "extended", extended.empty() ? "" : "p"});
    bool any = false;
    for (std::size_t c = 0; c < base.size(); ++c) {
        for (std::size_t i = 0; i < std::min(most_signals, base[c].regressors.size()); ++i) {
            const RegressorFigures& signal = base[c].regressors[i];
            std::vector<std::string> row{i == 0 ? base[c].name : "", signal.name,
                                         fmt::format("{:+.2f}", signal.association.correlation),
                                         chance_text(signal.association.chance)};
            if (!extended.empty()) {
                const auto& after = extended[c].regressors;
                const auto same = std::ranges::find(after, signal.name, &RegressorFigures::name);
                if (same != after.end()) {
                    row.push_back(fmt::format("{:+.2f}", same->association.correlation));
                    row.push_back(chance_text(same->association.chance));
                }
            }
            table.add(std::move(row));
            any = true;
        }
    }
    return any ? table.text(2) : "";
}

/// Single numbers, with their distance in their own standard uncertainties.
std::string numbers_text(const DiagnosisRecord& record) {
    Table table({true, true, false, false, false, false, false, false});
    table.add({"channel", "run", "measured", "+-", "base", "off by", "extended", "off by"});
    bool any = false;
    for (const Block& block : record.observations.blocks) {
        for (std::size_t i = 0; block.channel < 0 && i < block.standard_deviation.size(); ++i) {
            const Eigen::Index k = block.first + static_cast<Eigen::Index>(i);
            const Observations::Row& row = record.observations.rows[static_cast<std::size_t>(k)];
            const input::MeasuredRun& run = record.experiment.runs[row.run];
            const solver::Channel& channel = run.problem.channels[row.channel];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            const double u = block.standard_deviation[i];
            const double measured = record.observations.measured[k];
            std::vector<std::string> cells{channel.name, run.name,
                                           fmt::format("{:.4g} {}", unit.value(measured), unit.name),
                                           fmt::format("{:.2g}", unit.difference(u))};
            for (const double simulated : {record.result.base[k], record.result.extended[k]}) {
                cells.push_back(fmt::format("{:.2f}", unit.value(simulated)));
                cells.push_back(fmt::format("{:+.1f} u", (simulated - measured) / u));
            }
            table.add(std::move(cells));
            any = true;
        }
    }
    return any ? table.text(2) + "  u: standard uncertainty of the measured number\n" : "";
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

std::string residual_breakdown_text(const DiagnosisRecord& record) {
    const std::vector<ComparedChannel> base = compare_with_measured(record, record.result.base);
    const std::string numbers = numbers_text(record);
    if (base.empty()) {
        return numbers;
    }
    std::vector<ComparedChannel> extended;
    if (record.result.extended != record.result.base) {
        extended = compare_with_measured(record, record.result.extended);
    }
    std::string text = phases_text(base, extended);
    if (const std::string signals = signals_text(base, extended); !signals.empty()) {
        text += "\n  The signals that it follows closest; p: probability by chance\n" + signals;
    }
    return text + (numbers.empty() ? "" : "\n") + numbers;
}

}  // namespace tiretherm::post
