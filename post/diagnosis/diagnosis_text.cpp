#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/detect/confounded_effects.hpp"
#include "post/diagnosis/diagnosis_report.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/diagnosis/residual_breakdown.hpp"
#include "post/report/number_text.hpp"
#include "post/report/page.hpp"
#include "post/report/table.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Causes that are reported beside those of the set.
constexpr std::size_t most_others = 6;
/// Windows of missing heat that are listed.
constexpr std::size_t most_windows = 5;
/// Letters of a cause's name in a row.
constexpr std::size_t widest_name = 36;

std::string unit_or_dash(const std::string& unit) { return unit == "1" ? "-" : slashed_unit(unit); }

/// A source without a name, as a case may have it.
std::string unknown_text(const UnknownSource& unknown, const input::Experiment& experiment) {
    const solver::ShownUnit unit = unit_of(unknown, experiment);
    std::string text;
    if (unknown.run.empty() && unknown.follows != "1") {
        text =
            fmt::format("{:.3g} {} per {}{} of {}. ", unit.difference(unknown.per), unit.name,
                        unknown.unit == "1" || unknown.unit == "-" || unknown.unit.empty() ? "1" : "1 ",
                        unknown.unit == "1" || unknown.unit == "-" ? "" : slashed_unit(unknown.unit), unknown.follows);
    }
    text += unknown.sensor
                ? "A reading that changes faster than heat could make it is the sensor's or the logger's."
                : "In extended.toml it is a [[source]] of the case's own, to go on with until it has a name.";
    return wrap(text, 2);
}

/// What each cause of the set is, and what is confounded with it.
std::string meanings_text(const DiagnosisRecord& record) {
    const Diagnosis& result = record.result;
    std::string text = result.unknown ? unknown_text(*result.unknown, record.experiment) : "";
    for (const Cause& cause : result.causes) {
        if (!cause.in_set) {
            continue;
        }
        text += fmt::format("  {}\n", name_of(cause)) + wrap(meaning_of(cause), 4);
        if (!cause.bound.empty()) {
            text += wrap(cause.bound, 4);
        }
        for (const ConfoundedGroup* group : confounded_groups_of(cause.id)) {
            text += wrap(fmt::format("Confounded with {}. What separates them: {}.", others_of(*group, cause.id),
                                     group->separated),
                         4);
        }
    }
    return text;
}

/// A cause's rows, one for each of its numbers; a long name goes on in the second.
void add_rows(Table& table, const Cause& cause) {
    std::vector<std::string> names{name_of(cause)};
    if (names.front().size() > widest_name) {
        names = {cause.id, names.front().substr(cause.id.size())};
    }
    for (std::size_t i = 0; i < std::max({names.size(), cause.numbers.size()}); ++i) {
        std::vector<std::string> row{i == 0 ? fmt::format("{}", cause.rank) : "", i < names.size() ? names[i] : ""};
        if (i < cause.numbers.size()) {
            const CauseNumber& number = cause.numbers[i];
            const double half = 0.5 * (number.high - number.low);
            row.insert(row.end(), {number.key, to_its_digits(number.value, half), unit_or_dash(number.unit),
                                   half > 0.0 ? fmt::format("{} to {}", to_its_digits(number.low, half),
                                                            to_its_digits(number.high, half))
                                              : "on trial"});
        } else {
            row.insert(row.end(), 4, "");
        }
        if (i == 0) {
            row.insert(row.end(), {fmt::format("{:.1f}", cause.sigma), fmt::format("{:.1f}", cause.gain),
                                   cause.in_set ? "*" : ""});
        }
        table.add(std::move(row));
    }
}

std::string causes_table(const Diagnosis& result) {
    Table table({false, true, true, false, true, false, false, false, true});
    table.add({"", "cause", "number", "fitted", "unit", "95 %", "sigma", "gain", ""});
    std::size_t others = 0;
    for (const Cause& cause : result.causes) {
        if (cause.in_set || ++others <= most_others) {
            add_rows(table, cause);
        }
    }
    const bool any = std::ranges::any_of(result.causes, &Cause::in_set);
    std::string text = table.text(2);
    text += wrap(std::string(any ? "*: in the set; " : "") +
                     "sigma: standard deviations from no effect or from the case's number; gain: in log likelihood "
                     "over the model without it, the "
                     "free numbers fitted anew each time.",
                 2);
    if (others > most_others) {
        text += wrap(
            fmt::format("{} more are less likely; all of them stand in diagnosis.json.", others - most_others), 2);
    }
    return text;
}

std::string limits_table(const Diagnosis& result) {
    Table table({true, true, true, false, false});
    table.add({"cause", "number", "unit", "95 % from", "to"});
    for (const UpperLimit& limit : result.limits) {
        const double half = 0.5 * (limit.high - limit.low);
        table.add({name_of(Cause{.id = limit.id, .channel = limit.channel, .place = limit.place}), limit.key,
                   unit_or_dash(limit.unit), to_its_digits(limit.low, half), to_its_digits(limit.high, half)});
    }
    return table.text(2);
}

std::string next_text(const Diagnosis& result) {
    Table table({true, false, false});
    table.add({"additional experiment", "sigma now", "then"});
    for (const NextExperiment& next : result.next) {
        table.add({next.name, fmt::format("{:.2g}", next.now), fmt::format("{:.2g}", next.then)});
    }
    return table.text(2) + "  sigma: standard deviations by which the explanations differ\n";
}

std::string gain_text(const DiagnosisRecord& record) {
    const Diagnosis& result = record.result;
    const std::vector<solver::Channel>& channels = record.experiment.runs.front().problem.channels;
    Table table({true, true, false, false, false, false});
    table.add({"channel", "unit", "rms before", "after", "held out before", "after"});
    for (const ChannelGain& gain : result.channels) {
        const solver::ShownUnit unit = solver::shown_unit(channels[gain.channel].quantity);
        const auto show = [&](double si) {
            return std::isfinite(si) ? fmt::format("{:.3g}", unit.difference(si)) : std::string("-");
        };
        const bool is_temperature = channels[gain.channel].quantity == solver::Quantity::temperature;
        table.add({channels[gain.channel].name, is_temperature ? "K" : unit.name, show(gain.rmse_before),
                   show(gain.rmse_after), show(gain.heldout_before), show(gain.heldout_after)});
    }
    std::string text = table.text(2);
    if (!result.gain.measured) {
        return text;
    }
    const Gain& gain = result.gain;
    return text + wrap(fmt::format(
                                 "On {} that took no part in naming or fitting, {:.0f} % of the error that a model "
                                 "could remove is removed (95 %: {:.0f} to {:.0f} %); {}.",
                                 gain.within_run ? "blocks of the run" : "runs", 100.0 * gain.removable_removed,
                                 100.0 * gain.low, 100.0 * gain.high,
                                 gain.confirmed
                                     ? fmt::format("confirmed there, at odds of 10^{:.0f}", gain.log_e / std::log(10.0))
                                     : "detected, but not confirmed there"),
                             2);
}

/// The windows in which most heat is missing.
std::string missing_heat_table(const DiagnosisRecord& record) {
    std::vector<MissingHeat> missing = record.result.missing_heat;
    const auto largest = missing.begin() + static_cast<std::ptrdiff_t>(std::min(most_windows, missing.size()));
    std::partial_sort(missing.begin(), largest, missing.end(),
                      [](const MissingHeat& a, const MissingHeat& b) { return std::abs(a.sigma) > std::abs(b.sigma); });
    missing.erase(largest, missing.end());
    Table table({true, true, false, false, false, false});
    table.add({"run", "place", "from s", "to s", "W", "sigma"});
    for (const MissingHeat& one : missing) {
        table.add({record.experiment.runs[one.run].name, one.place, fmt::format("{:.0f}", one.from),
                   fmt::format("{:.0f}", one.to), fmt::format("{:+.3g}", one.watts),
                   fmt::format("{:+.1f}", one.sigma)});
    }
    return table.text(2) +
           wrap(
               "The heat that is missing in a window if all else is as in the base model; all windows are listed in "
               "missing_heat.csv. A large sigma here is no verdict: there are many windows.",
               2);
}

std::string noise_table(const DiagnosisRecord& record) {
    const std::vector<solver::Channel>& channels = record.experiment.runs.front().problem.channels;
    Table table({true, true, false, false, false, false});
    table.add({"channel", "unit", "sigma", "data sheet", "correlation time", "white-noise share"});
    for (std::size_t i = 0; i < record.result.noise.size(); ++i) {
        const Noise& noise = record.result.noise[i];
        const solver::Channel& channel = channels[record.observations.channels[i]];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        const auto show = [&](double si) { return fmt::format("{:.3g}", unit.difference(si)); };
        table.add({channel.name, channel.quantity == solver::Quantity::temperature ? "K" : unit.name, show(noise.sigma),
                   channel.standard_deviation ? show(*channel.standard_deviation) : "-",
                   noise.white_share < 1.0 ? fmt::format("{:.3g} s", noise.correlation_time) : "white",
                   fmt::format("{:.0f} %", 100.0 * noise.white_share)});
    }
    std::string text = table.text(2);
    if (record.result.numerical_error_sigma > 0.0) {
        text += wrap(fmt::format("The discretisation error of steps and grid amounts to {:.2g} standard deviations.",
                                 record.result.numerical_error_sigma),
                     2);
    }
    return text;
}

}  // namespace

std::string diagnosis_text(const DiagnosisRecord& record, bool bold) {
    const Diagnosis& result = record.result;
    const std::size_t n_runs = record.experiment.runs.size();
    const std::size_t n_free = record.experiment.parameters.size();
    Page page(bold);
    page.add(fmt::format(
        "{}\n{} run{}, {} values, {} free number{}; {} simulations, {} s\nDifferences are simulated - measured.\n",
        record.experiment.runs.front().problem.title, n_runs, n_runs == 1 ? "" : "s",
        grouped(static_cast<double>(record.observations.measured.size())), n_free, n_free == 1 ? "" : "s",
        result.simulations, to_its_digits(result.seconds, 0.05 * result.seconds)));
    page.add("Verdict", wrap(reason_of(record), 2));
    page.add("Interpretation", meanings_text(record));
    page.add("Discriminating experiments", result.next.empty() ? "" : next_text(result));
    page.add("Where it shows", residual_breakdown_text(record));
    page.add("Inferred heat source", result.missing_heat.empty() ? "" : missing_heat_table(record));
    page.add("Candidate causes", result.causes.empty() ? "" : causes_table(result));
    page.add("Upper limits (95 %)", result.limits.empty() ? "" : limits_table(result));
    page.add("Gain", result.channels.empty() ? "" : gain_text(record));
    page.add("Noise", result.noise.empty() ? "" : noise_table(record));
    page.add("Remarks", paragraphs(result.remarks));
    page.add("Findings about the data", paragraphs(record.findings));
    page.add("Warnings", paragraphs(record.warnings));
    return page.text();
}

}  // namespace tiretherm::post
