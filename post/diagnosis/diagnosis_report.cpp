// SPDX-License-Identifier: BSD-3-Clause
// A diagnosis as a report: verdict, causes with their sizes, where it shows, limits, gain and noise.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "post/comparison/corner_sections.hpp"
#include "post/diagnosis/cause_sections.hpp"
#include "post/diagnosis/diagnosis_charts.hpp"
#include "post/diagnosis/diagnosis_report.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/diagnosis/residual_breakdown.hpp"
#include "post/diagnosis/run_verdicts.hpp"
#include "post/diagnosis/tried_sections.hpp"
#include "post/diagnosis/unused_columns.hpp"
#include "post/page/observed_series.hpp"
#include "post/page/page_origin.hpp"
#include "post/report/number_text.hpp"
#include "post/report/remark_text.hpp"
#include "post/report/stage_text.hpp"
#include "post/report/table.hpp"
#include "solver/channel_unit.hpp"
#include "solver/compared_ranges.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Windows of missing heat that are listed.
constexpr std::size_t most_windows = 5;

ReportSection next_section(const Diagnosis& result) {
    ReportSection section("Discriminating experiments");
    DataTable table;
    for (const NextExperiment& next : result.next) {
        table.add({page_only("additional experiment", next.name), page_only("sigma now", shown("{:.2g}", next.now)),
                   page_only("then", shown("{:.2g}", next.then))});
    }
    if (!table.empty()) {
        section.add(std::move(table));
        section.say(fmt::format(
            "sigma: standard deviations by which {} differ",
            result.told_apart.empty() ? "the explanations" : fmt::format("{}", fmt::join(result.told_apart, " and "))));
        add_experiment_chart(section, result);
    }
    return section;
}

DataTable channels(const DiagnosisRecord& record) {
    DataTable table;
    for (const ChannelGain& gain : record.result.channels) {
        const solver::Channel& channel = record.experiment.runs.front().problem.channels[gain.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        const auto show = [&](double si) { return shown("{:.3g}", unit.difference(si)); };
        table.add({{"channel", "name", channel.name},
                   {"unit", "unit", difference_unit(unit.name)},
                   {"rms before", "rmse_before", show(gain.rmse_before)},
                   {"after", "rmse_after", show(gain.rmse_after)},
                   {"held out before", "heldout_before", show(gain.heldout_before)},
                   {"after", "heldout_after", show(gain.heldout_after)}});
    }
    return table;
}

/// The model that a gain is measured against; empty where that is the fitted one.
std::string base_of(const Gain& gain) {
    constexpr std::array<const char*, 4> words{
        // [BaseModel]
        "", "the case fitted with correlated noise", "the case fitted with white noise", "the case as it stands"};
    return gain.over == BaseModel::other_mesh ? gain.over_mesh : words[static_cast<std::size_t>(gain.over)];
}

ReportSection gain_section(const DiagnosisRecord& record, DataTable table) {
    ReportSection section("Gain");
    const Gain& gain = record.result.gain;
    if (table.empty() || !gain.measured) {  // what is left of each sensor is said where it shows
        return section;
    }
    section.add(std::move(table));
    const double decades = gain.log_e / std::log(10.0);
    section.say(fmt::format(
        "On {} that took no part in fitting, {:.0f} % of the error that a model could remove (mean square) is "
        "removed (95 %: {:.0f} to {:.0f} %){}; {}.",
        gain.within_run ? "blocks of the run" : "runs", 100.0 * gain.removable_removed, 100.0 * gain.low,
        100.0 * gain.high, gain.over == BaseModel::none ? "" : ", measured against " + base_of(gain),
        gain.confirmed ? fmt::format("confirmed there, at odds of {}",
                                     decades > 6.0 ? "more than 10^6" : fmt::format("10^{:.0f}", decades))
                       : "not confirmed there"));
    add_channel_gain_charts(section, record);
    add_held_out_chart(section, record);
    return section;
}

Value gain_data(const Gain& gain) {
    return {{"removable_error_removed", where(gain.measured, gain.removable_removed)},
            {"low", where(gain.measured, gain.low)},
            {"high", where(gain.measured, gain.high)},
            {"confirmed", gain.confirmed},
            {"error_removed", where(gain.measured, gain.removed)},
            {"error_removed_low", where(gain.measured, gain.removed_low)},
            {"error_removed_high", where(gain.measured, gain.removed_high)},
            {"over", text_or_null(base_of(gain))},
            {"within_run", gain.within_run},
            {"log_e", where(gain.measured, gain.log_e)}};
}

/// The noise of its sensor to each series.
void add_noise(std::vector<MeasuredSeries>& series, const DiagnosisRecord& record) {
    for (const NoiseBlock& block : record.observations.blocks) {
        if (block.channel < 0 || block.time.empty()) {
            continue;
        }
        const Observations::Row& row = record.observations.rows[static_cast<std::size_t>(block.first)];
        const input::MeasuredRun& run = record.experiment.runs[row.run];
        for (MeasuredSeries& one : series) {
            if (one.run == run.name && one.channel == run.problem.channels[row.channel].name) {
                one.noise = record.result.noise[static_cast<std::size_t>(block.channel)].sigma;
            }
        }
    }
}

/// The windows in which missing heat is most significant.
DataTable missing_heat(const DiagnosisRecord& record) {
    std::vector<MissingHeat> missing = record.result.missing_heat;
    const auto largest = missing.begin() + static_cast<std::ptrdiff_t>(std::min(most_windows, missing.size()));
    std::partial_sort(missing.begin(), largest, missing.end(), [](const MissingHeat& a, const MissingHeat& b) {
        return std::abs(a.sigma()) > std::abs(b.sigma());
    });
    missing.erase(largest, missing.end());
    DataTable table;
    for (const MissingHeat& one : missing) {
        const auto to_its = [&](double watts) { return to_its_digits(watts, 1.96 * one.deviation); };
        table.add({{"run", "run", record.experiment.runs[one.run].name},
                   {"place", "place", one.place},
                   {"from s", "from", shown("{:.0f}", one.from)},
                   {"to s", "to", shown("{:.0f}", one.to)},
                   {"W", "watts", {one.watts, to_its(one.watts)}},
                   {"95 % from", "low", {one.low(), to_its(one.low())}},
                   {"to", "high", {one.high(), to_its(one.high())}},
                   {"sigma", "sigma", shown("{:+.1f}", one.sigma())}});
    }
    return table;
}

/// These windows, and all of them as a map.
ReportSection missing_heat_section(const DiagnosisRecord& record, DataTable table) {
    ReportSection section("Inferred heat source");
    if (table.empty()) {
        return section;
    }
    section.add(std::move(table));
    section.say(
        "The heat that the base model lacks if all of it enters at the place; it is estimated in all windows together, "
        "beside the "
        "free parameters. All windows are listed in missing_heat.csv. A large sigma here is no verdict: there are many "
        "windows.");
    add_missing_heat_maps(section, record);
    return section;
}

/// What is left beyond the sensors' noise.
Value model_error_data(const DiagnosisRecord& record) {
    Value::List list;
    for (const ModelError& error : record.result.model_error) {
        const solver::Channel& channel = record.experiment.runs.front().problem.channels[error.channel];
        list.push_back({{"channel", channel.name},
                        {"size", solver::shown_unit(channel.quantity).difference(error.size)},
                        {"time_scale", error.time_scale}});
    }
    return list;
}

DataTable free_numbers(const std::vector<FreeNumber>& numbers) {
    DataTable table;
    for (const FreeNumber& one : numbers) {
        const double half = 0.5 * (one.high - one.low);
        table.add({{"parameter", "name", one.name},
                   {"unit", "unit", {slashed_unit(one.unit), unit_or_dash(one.unit), false}},
                   {"fitted", "value", {one.value, to_its_digits(one.value, half)}},
                   {"95 % from", "low", {one.low, to_its_digits(one.low, half)}},
                   {"to", "high", {one.high, to_its_digits(one.high, half)}}});
    }
    return table;
}

Value richer_meshes_data(const Diagnosis& result) {
    Value::List list;
    for (const RicherMesh& mesh : result.richer_meshes) {
        list.push_back({{"name", mesh.name},
                        {"better", mesh.is_better},
                        {"taken", mesh.is_taken},
                        {"error_removed", mesh.removed},
                        {"low", mesh.low},
                        {"high", mesh.high},
                        {"free_numbers", free_numbers(mesh.numbers).data()}});
    }
    return list;
}

Value held_out_data(const Diagnosis& result) {
    Value::List list;
    for (const HeldOutGain& one : result.held_out_gains) {
        Value::List ids;
        for (const std::size_t cause : one.causes) {
            ids.push_back(result.causes[cause].id);
        }
        list.push_back({{"causes", ids}, {"error_removed", one.removed}, {"low", one.low}, {"high", one.high}});
    }
    return list;
}

Value cannot_see_data(const Diagnosis& result) {
    Value::List list;
    for (const Lookalike& one : result.cannot_see) {
        list.push_back({{"cause", one.cause},
                        {"key", one.key},
                        {"value", one.value},
                        {"like", one.number},
                        {"fitted", one.fitted},
                        {"known", one.known},
                        {"correlation", one.correlation}});
    }
    return list;
}

DataTable noise(const DiagnosisRecord& record) {
    DataTable table;
    for (std::size_t i = 0; i < record.result.noise.size(); ++i) {
        const Noise& noise = record.result.noise[i];
        const solver::Channel& channel =
            record.experiment.runs.front().problem.channels[record.observations.channels[i]];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        const auto show = [&](double si) { return shown("{:.3g}", unit.difference(si)); };
        const std::string time = noise.white_share < 1.0 ? fmt::format("{:.3g} s", noise.correlation_time) : "white";
        const auto error =
            std::ranges::find(record.result.model_error, record.observations.channels[i], &ModelError::channel);
        const bool has_error = error != record.result.model_error.end();
        table.add(
            {{"channel", "channel", channel.name},
             page_only("unit", difference_unit(unit.name)),
             {"sigma", "sigma", show(noise.sigma)},
             page_only("data sheet", channel.standard_deviation ? show(*channel.standard_deviation) : right("-")),
             page_only("correlation time", right(time)),
             data_only("rho_1s", noise.rho_1s()),
             {"white share", "white_share", {noise.white_share, fmt::format("{:.0f} %", 100.0 * noise.white_share)}},
             page_only("left", has_error ? show(error->size) : right("-")),
             page_only("for", right(has_error ? fmt::format("{:.2g} s", error->time_scale) : "-"))});
    }
    return table;
}

}  // namespace

Report diagnosis_report(const DiagnosisRecord& record, const std::vector<std::filesystem::path>& files) {
    const Diagnosis& result = record.result;
    DataTable of_channels = channels(record);
    DataTable of_noise = noise(record);
    DataTable of_numbers = free_numbers(result.free_numbers);
    DataTable of_heat = missing_heat(record);
    Report report{.title = record.experiment.runs.front().problem.title};
    report.lead = {fmt::format("{}, {} values, {}; {} simulations, {}", plural(record.experiment.runs.size(), "run"),
                               grouped(static_cast<double>(record.observations.measured.size())),
                               plural(record.experiment.parameters.size(), "free parameter"), result.simulations,
                               seconds_text(result.seconds)),
                   "Differences are simulated - measured."};
    const std::vector<std::string> not_driven = input::not_driven(record.experiment);
    report.lead.insert(report.lead.begin(), not_driven.begin(), not_driven.end());
    report.data = {{"case", record.case_file.generic_string()},
                   {"verdict", word_of(result.overall())},
                   {"causes", causes_data(result)},
                   {"set", set_data(result)},
                   {"unknown", result.unknown ? unknown_data(*result.unknown, record.experiment) : Value()},
                   {"reason", reason_of(record)},
                   {"next_experiment", result.next.empty() ? "" : text_of(result.next.front())},
                   {"told_apart", result.told_apart},
                   {"channels", of_channels.data()},
                   {"gain", gain_data(result.gain)},
                   {"limits", limits_table(result).data()},
                   {"tried", tried_table(record).data()},
                   {"candidates", result.n_candidates},
                   {"richer_meshes", richer_meshes_data(result)},
                   {"numerical_error_sigma", result.numerical_error_sigma},
                   {"noise", of_noise.data()},
                   {"model_error", model_error_data(record)},
                   {"free_numbers", of_numbers.data()},
                   {"held_out_gains", held_out_data(result)},
                   {"cannot_see", cannot_see_data(result)},
                   {"missing_heat", of_heat.data()},
                   {"columns", unused_columns_table(record.experiment).data()},
                   {"runs", run_verdicts_data(record)},
                   {"stopped", text_or_null(std::string(text_of(result.stopped)))}};
    std::vector<std::string> verdict{reason_of(record)};
    std::ranges::move(certainty_of(record), std::back_inserter(verdict));
    if (result.stopped != Part::none && result.verdict != Verdict::cannot_tell) {
        verdict.push_back(fmt::format("Best answer after {}: {}", seconds_text(result.seconds), stop_text(result)));
    }
    report.add_verdict(std::move(verdict));
    report.appendix.push_back(ReportSection("All additions that were fitted", tried_table(record)));
    report.appendix.push_back(ReportSection("Upper limits of all causes (95 %)", limits_table(result)));
    report.appendix.push_back(citations_section(record.experiment.runs.front().problem));
    report.add(interpretation(record));
    report.add(run_verdicts_section(record));
    std::vector<std::pair<std::string, const Eigen::VectorXd*>> models{{"base", &result.base}};
    if (result.extended.size() == result.base.size() && result.extended != result.base) {
        models.emplace_back("extended", &result.extended);
    }
    std::vector<MeasuredSeries> series = observed_series(record.experiment, record.observations, models);
    add_noise(series, record);
    report.add(measured_section(series, inputs_of_runs(record.experiment)));
    report.add(tried_section(record));
    report.add(next_section(result));
    report.add(residual_breakdown(record));
    const bool is_extended = models.size() > 1;
    add_observed_corners(report, record.experiment, record.observations, is_extended ? result.extended : result.base,
                         is_extended ? " with the extended model" : " after the fit");
    report.add(missing_heat_section(record, std::move(of_heat)));
    report.add(causes_section(result));
    report.add(limits_section(record));
    report.add(gain_section(record, std::move(of_channels)));
    ReportSection of_numbers_section("Free parameters", std::move(of_numbers));
    if (!result.model_error.empty() && of_numbers_section.has_text()) {
        of_numbers_section.say("The intervals are widened by what the model leaves beyond the sensors' noise.");
    }
    report.add(std::move(of_numbers_section));
    ReportSection of_noise_section = ReportSection("Noise", std::move(of_noise));
    if (!result.noise.empty() && result.numerical_error_sigma > 0.0) {
        of_noise_section.say(
            fmt::format("The discretisation error of steps and grid amounts to {:.2g} standard deviations.",
                        result.numerical_error_sigma));
    }
    if (!result.model_error.empty()) {
        of_noise_section.say("left: rms of the model's error beyond the noise, and how long it lasts at a time.");
    }
    report.add(std::move(of_noise_section));
    report.add(unused_columns_section(record.experiment));
    report.add("Remarks", "remarks", texts_of(result.remarks));
    report.add("Findings about the data", "findings", record.findings);
    solver::Extrapolations extrapolations;
    for (const input::MeasuredRun& run : record.experiment.runs) {
        extrapolations.add(run.problem);
    }
    report.add_warnings(record.warnings, extrapolations.warnings());
    report.add(files);
    report.data.set("simulations", result.simulations);
    report.data.set("seconds", result.seconds);
    return report;
}

}  // namespace tiretherm::post
