// SPDX-License-Identifier: BSD-3-Clause
// A diagnosis of quoted numbers as page and data: the verdict, the additions by what they remove, the rows before and
// after.
#include "post/quoted/quoted_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "post/page/charts.hpp"
#include "post/page/html_page.hpp"
#include "post/report/file.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;          // whose verdicts and
using namespace diagnosis::quoted;  // whose results are rendered here

namespace {

constexpr std::array<std::string_view, 5> kind_names{"effect", "number of the model", "mesh", "unprinted input",
                                                     "instrument"};  ///< [AdditionKind]

constexpr std::size_t most_shown = 12;  ///< additions on the page; all are in the data

constexpr const char* legend =
    "Removed: how much smaller the rms error on experiments left out becomes, in total uncertainties u, which are "
    "those stated with the ranges of unknown inputs; each experiment is left out in turn and the number fitted to the "
    "others. The interval is 95 % of a bootstrap over experiments: where it includes zero it is no proof. Left K: what "
    "temperatures left out keep. Fit u: what is left where it was fitted, which proves nothing. Fitted: to all "
    "experiments, with the plausible range as two standard deviations. Numbers of one id, and those that are read from "
    "the same test, are one experiment.";

/// A difference of a row; 0 within a measured range.
Cell off_cell(const QuotedResult& row, double off) { return {off, off == 0.0 ? "0" : in_digits_of(row.unit, off)}; }

std::string fitted_text(const Addition& addition, const AdditionFit& fit, std::size_t k) {
    if (!addition.is_fitted()) {
        return "-";
    }
    const double half = std::max(0.5 * (fit.high[k] - fit.low[k]), 1e-3 * (addition.high - addition.low));
    return to_its_digits(fit.values[k], half) + (addition.unit == "1" ? "" : " " + slashed_unit(addition.unit)) +
           (fit.is_bound[k] ? ", at its limit" : "");
}

Value share_data(const ShareInterval& share) {
    return {{"value", share.value}, {"low", share.low}, {"high", share.high}};
}

Value parameters_data(const SingleAddition& attempt) {
    Value parameters = Value::Object{};
    if (attempt.addition.is_fitted()) {
        parameters.set(attempt.addition.key, {{"value", attempt.fit.values[0]},
                                              {"unit", slashed_unit(attempt.addition.unit)},
                                              {"low", attempt.fit.low[0]},
                                              {"high", attempt.fit.high[0]}});
    }
    return parameters;
}

std::string share_cell(double share) { return fmt::format("{}", std::lround(100.0 * share)); }

/// What each addition removes, the best first. @param most additions
DataTable attempt_table(const Analysis& analysis, std::size_t most) {
    DataTable table;
    for (std::size_t i = 0; i < std::min(most, analysis.attempts.size()); ++i) {
        const SingleAddition& attempt = analysis.attempts[i];
        const Addition& addition = attempt.addition;
        const ShareInterval& removed = attempt.held_out.removed;
        const double sigma = std::sqrt(std::max(0.0, analysis.chi_squared - attempt.fit.chi_squared));
        table.add(
            {page_only("", right(fmt::format("{}", i + 1))),
             data_only("id", addition.id),
             {"addition", "name", addition.name()},
             data_only("kind", kind_names[static_cast<std::size_t>(addition.kind)]),
             data_only("channel", where(addition.kind == AdditionKind::instrument, addition.id)),
             page_only("fitted", right(fitted_text(addition, attempt.fit, 0))),
             data_only("parameters", parameters_data(attempt)),
             data_only("plausible", {{"low", addition.low}, {"high", addition.high}, {"source", addition.source}}),
             data_only("at_bound", static_cast<bool>(attempt.fit.is_bound[0])),
             page_only("removed %", right(share_cell(removed.value))),
             page_only("95 %", right(share_cell(removed.low) + " to " + share_cell(removed.high))),
             data_only("removed", share_data(removed)),
             data_only("heldout_rms_u", attempt.held_out.rms_after),
             {"left K", "heldout_rms_K", shown("{:.1f}", attempt.held_out.kelvin_after)},
             {"fit u", "fitted_rms_u", shown("{:.1f}", attempt.rms_fitted)},
             {"better in", "better_experiments", count(attempt.held_out.better.size())},
             data_only("fits", attempt.fits),
             data_only("chi_squared", attempt.fit.chi_squared),
             data_only("sigma", sigma),
             {"", "in_set", {attempt.in_set, attempt.in_set ? "*" : "", false}},
             data_only("rank", i + 1)});
    }
    return table;
}

/// "sidewall_convection.conductance 12.0 W/K"
std::string set_text(const SetOfAdditions& set) {
    std::string text;
    for (std::size_t k = 0; k < set.additions.size(); ++k) {
        text += fmt::format("{}{} {}", text.empty() ? "" : "; ", set.additions[k].name(),
                            fitted_text(set.additions[k], set.fit, k));
    }
    return text;
}

/// Sets of additions: the best on experiments left out of each size, then those that agree where they are fitted.
DataTable set_table(const Analysis& analysis) {
    DataTable table;
    const auto add = [&](const SetOfAdditions& set, const char* why) {
        Value::List names;
        for (std::size_t k = 0; k < set.additions.size(); ++k) {
            names.push_back({{"name", set.additions[k].name()}, {"value", set.fit.values[k]}});
        }
        const ShareInterval& removed = set.held_out.removed;
        table.add({{"", "chosen_by", why},
                   page_only("additions", set_text(set)),
                   data_only("additions", std::move(names)),
                   page_only("removed %", right(share_cell(removed.value))),
                   page_only("95 %", right(share_cell(removed.low) + " to " + share_cell(removed.high))),
                   data_only("removed", share_data(removed)),
                   {"fit u", "fitted_rms_u", shown("{:.1f}", set.rms_fitted)},
                   {"agrees", "fits", {set.fits, set.fits ? "yes" : "no", false}}});
    };
    for (const SetOfAdditions& set : analysis.sizes) {
        add(set, "prediction");
    }
    for (const SetOfAdditions& set : analysis.agreeing) {
        add(set, "fit");
    }
    return table;
}

/// What is left of each row, with the additions that were accepted, or else with the best set that agrees.
DataTable row_table(const QuotedDiagnosis& result, const Analysis& analysis) {
    DataTable table;
    for (std::size_t r = 0; r < result.numbers.rows.size(); ++r) {
        const QuotedResult& row = result.numbers.rows[r];
        if (!analysis.counts[r]) {
            continue;
        }
        const double after = row.residual(row.value + analysis.after[r]);
        const std::string spread = row.is_open ? "" : " +- " + in_digits_of(row.unit, row.uncertainty);
        table.add({{"", "id", row.id},
                   {"what", "what", row.what},
                   page_only("measured", right(range_text(row.unit, row.low, row.high) + spread)),
                   {"unit", "unit", row.unit},
                   data_only("experiment", result.numbers.experiments[row.experiment]),
                   data_only("low", row.low),
                   data_only("high", row.high),
                   data_only("decidable", row.decidable),
                   {"model", "value", {row.value, in_digits_of(row.unit, row.value)}},
                   {"off", "before", off_cell(row, row.residual(row.value))},
                   {"u", "uncertainty", {row.total(), in_digits_of(row.unit, row.total())}},
                   {"left", "after", off_cell(row, after)},
                   page_only("left / u", shown("{:.1f}", after / row.total()))});
    }
    return table;
}

/// What each addition removes, as bars, and the rows that count before and after.
ReportSection quoted_charts(const QuotedRecord& record) {
    const QuotedDiagnosis& result = record.result;
    ReportSection section("Before and after");
    std::vector<Bar> removed;
    for (const SingleAddition& attempt : result.decidable.attempts) {
        if (removed.size() < most_shown) {
            removed.push_back(
                {attempt.addition.name() + (attempt.in_set ? " *" : ""), 100.0 * attempt.held_out.removed.value});
        }
    }
    if (!removed.empty()) {
        section.chart("What each addition removes",
                      "Of the error on experiments that were left out, decidable numbers; *: in the set.",
                      bar_chart("removed", "%", removed));
    }
    std::vector<std::string> labels;
    std::vector<std::string> notes;
    std::vector<double> place;
    std::vector<double> before;
    std::vector<double> after;
    const Analysis& all = result.all;
    for (std::size_t r = 0; r < result.numbers.rows.size(); ++r) {
        const QuotedResult& row = result.numbers.rows[r];
        if (all.counts[r]) {
            place.push_back(static_cast<double>(place.size()));
            labels.push_back(row.id);
            notes.push_back(fmt::format("{}: {}", row.id, row.what));
            before.push_back(row.residual(row.value) / row.total());
            after.push_back(row.residual(row.value + all.after[r]) / row.total());
        }
    }
    if (!place.empty()) {
        LineChart chart("experiment", "", -0.5, static_cast<double>(place.size()) - 0.5);
        chart.set_labels(labels, notes);
        chart.add_panel("simulated - measured", "u");
        chart.add_band("within 2 u", "", std::array{-0.5, static_cast<double>(place.size()) - 0.5},
                       std::array{-2.0, -2.0}, std::array{2.0, 2.0});
        chart.add_curve("before", "", CurveRole::points, place, before);
        if (all.accepted || !all.agreeing.empty()) {
            chart.add_curve("after", "", CurveRole::points, place, after);
        }
        section.chart("Differences in units of their uncertainty",
                      "All numbers; u counts the ranges of unknown inputs. To the nearest end of a measured range.",
                      chart.data());
    }
    return section;
}

Value names_data(const QuotedDiagnosis& result, const std::vector<std::size_t>& experiments) {
    Value::List list;
    for (const std::size_t one : experiments) {
        list.push_back(result.numbers.experiments[one]);
    }
    return list;
}

Value gain_data(const Analysis& analysis) {
    const bool any = analysis.accepted.has_value();
    const ShareInterval removed = any ? analysis.accepted->held_out.removed : ShareInterval{};
    return {{"removable_error_removed", where(any, removed.value)},
            {"low", where(any, removed.low)},
            {"high", where(any, removed.high)},
            {"confirmed", any}};
}

/// The set by ids, as a diagnosis of logs gives it; what is no effect keeps its name.
Value ids_data(const Analysis& analysis) {
    Value::List set;
    for (const std::vector<std::string>& one : analysis.set) {
        Value::List ids;
        for (const std::string& name : one) {
            const auto known = std::ranges::find_if(
                analysis.attempts, [&](const SingleAddition& attempt) { return attempt.addition.name() == name; });
            const bool is_effect = known != analysis.attempts.end() && (known->addition.kind == AdditionKind::effect ||
                                                                        known->addition.kind == AdditionKind::number);
            ids.push_back(is_effect ? known->addition.id : name);
        }
        set.push_back(std::move(ids));
    }
    return set;
}

Value analysis_data(const QuotedDiagnosis& result, const Analysis& analysis) {
    Value::List steps;
    for (std::size_t k = 0; analysis.accepted && k < analysis.accepted->additions.size(); ++k) {
        const SetOfAdditions& accepted = *analysis.accepted;
        steps.push_back({{"name", accepted.additions[k].name()},
                         {"value", where(accepted.additions[k].is_fitted(), accepted.fit.values[k])},
                         {"removed", share_data(accepted.held_out.removed)},
                         {"further", share_data(accepted.further.removed)},
                         {"with_the_choice_left_out", share_data(accepted.choice.removed)}});
    }
    Value::List set;
    for (const std::vector<std::string>& one : analysis.set) {
        set.push_back(Value(one));
    }
    return {{"verdict", word_of(analysis.verdict)},
            {"numbers", analysis.n_rows},
            {"experiments", names_data(result, analysis.experiments)},
            {"off", names_data(result, analysis.off)},
            {"rms_u", analysis.rms},
            {"rms_K", analysis.kelvin},
            {"significance", analysis.significance},
            {"significance_after", where(analysis.accepted.has_value(), analysis.significance_after)},
            {"causes", attempt_table(analysis, analysis.attempts.size()).data()},
            {"without_effect", analysis.without_effect},
            {"steps", std::move(steps)},
            {"sets", set_table(analysis).data()},
            {"sets_that_agree", analysis.n_agreeing},
            {"set", std::move(set)},
            {"gain", gain_data(analysis)},
            {"rows", row_table(result, analysis).data()}};
}

ReportSection attempt_section(const char* heading, const Analysis& analysis) {
    ReportSection section(heading);
    if (analysis.attempts.empty()) {
        return section;
    }
    section.add(attempt_table(analysis, most_shown));
    if (analysis.attempts.size() > most_shown) {
        section.say(fmt::format("{} more remove less; {} move none of these numbers. All stand in diagnosis.json.",
                                analysis.attempts.size() - most_shown, analysis.without_effect));
    }
    if (const DataTable sets = set_table(analysis); !analysis.sizes.empty()) {
        section.add(sets);
        section.say(
            "Sets of up to five additions. Prediction: the best of each size on experiments left out. Fit: of the "
            "fewest "
            "additions that agree with all of these numbers those that cost least.");
    }
    if (std::ranges::any_of(analysis.attempts, &SingleAddition::in_set)) {
        section.say("*: in the set that these numbers cannot tell apart");
    }
    return section;
}

}  // namespace

Report quoted_report(const QuotedRecord& record, const std::vector<std::filesystem::path>& files) {
    const QuotedDiagnosis& result = record.result;
    const std::vector<std::string> sentences = quoted_sentences(record);
    Report report{.title = record.title};
    report.lead = {
        fmt::format("{}: {}; {} simulations, {:.1f} s", record.model,
                    plural(result.numbers.rows.size(), "measured number"), result.simulations, record.seconds),
        "Differences are simulated - measured."};
    const Value decidable = analysis_data(result, result.decidable);
    report.data = {{"table", record.table.generic_string()},
                   {"model", record.model},
                   {"verdict", decidable["verdict"]},
                   {"causes", decidable["causes"]},
                   {"set", ids_data(result.decidable)},
                   {"unknown", Value()},
                   {"reason", fmt::format("{}", fmt::join(sentences, " "))},
                   {"next_experiment",
                    result.next ? fmt::format("{} at the end of {}", result.next->channel, result.next->run) : ""},
                   {"channels", Value::List{}},
                   {"gain", decidable["gain"]},
                   {"numerical_error_sigma", Value()},
                   {"noise", Value::List{}},
                   {"decidable", decidable},
                   {"all", analysis_data(result, result.all)}};
    report.add_verdict(sentences);
    report.add(quoted_charts(record));
    report.add(attempt_section("What each addition removes: decidable numbers", result.decidable));
    report.add(attempt_section("What each addition removes: all numbers", result.all));
    ReportSection method("");
    method.say(legend);
    report.add(std::move(method));
    report.add(ReportSection("Decidable numbers, before and after", row_table(result, result.decidable)));
    report.add(ReportSection("All numbers, before and after", row_table(result, result.all)));
    std::vector<std::string> remarks;
    for (const std::string& addition : result.not_simulated) {
        remarks.push_back(addition + ": no simulation with it came to its end");
    }
    if (result.numbers.without_scale > 0) {
        remarks.push_back(fmt::format("{} left out: an order in a unit in which no uncertainty is stated.",
                                      plural(result.numbers.without_scale, "number")));
    }
    if (result.numbers.about_the_model > 0) {
        remarks.push_back(fmt::format("{} left out: the source says it of its own model.",
                                      plural(result.numbers.about_the_model, "number")));
    }
    report.add("Remarks", "remarks", remarks);
    report.add("Warnings", "warnings", record.warnings);
    report.add(files);
    report.data.set("simulations", result.simulations);
    report.data.set("seconds", record.seconds);
    return report;
}

std::string quoted_markdown(const QuotedRecord& record) {
    const QuotedDiagnosis& result = record.result;
    std::string text;
    for (const std::string& sentence : quoted_sentences(record)) {
        text += sentence + "\n\n";
    }
    const std::array<std::pair<const char*, const Analysis*>, 2> analyses{
        {{"Decidable numbers", &result.decidable}, {"All numbers", &result.all}}};
    for (const auto& [heading, analysis] : analyses) {
        text += fmt::format("{}:\n\n{}\n", heading, markdown_text(attempt_table(*analysis, most_shown)));
        if (!analysis->sizes.empty()) {
            text += fmt::format("{}, sets of additions:\n\n{}\n", heading, markdown_text(set_table(*analysis)));
        }
    }
    return text + "Before and after:\n\n" + markdown_text(row_table(result, result.all));
}

std::vector<std::string> quoted_names() {
    std::vector<std::string> names = page_names();
    names.push_back("diagnosis.json");
    return names;
}

std::vector<std::filesystem::path> write_quoted(const QuotedRecord& record, const std::filesystem::path& directory) {
    const std::filesystem::path file = directory / "diagnosis.json";
    replace_file(file, json_text(quoted_report(record, {file}).data));
    return {file};
}

}  // namespace tiretherm::post
