// SPDX-License-Identifier: BSD-3-Clause
// A fit as a report: parameters with their intervals, directions the data do not see, misfit per channel.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "diagnosis/fit/fit.hpp"
#include "post/comparison/corner_sections.hpp"
#include "post/identification/fit_section.hpp"
#include "post/identification/identifiability_charts.hpp"
#include "post/identification/identification_headline.hpp"
#include "post/identification/identification_report.hpp"
#include "post/identification/law_charts.hpp"
#include "post/page/observed_series.hpp"
#include "post/page/page_origin.hpp"
#include "post/report/number_text.hpp"
#include "post/report/remark_text.hpp"
#include "post/report/table.hpp"
#include "solver/channel_unit.hpp"
#include "solver/compared_ranges.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Correlations from here on are shown.
constexpr double close = 0.9;
/// Parts of a direction smaller than this are not reported.
constexpr double small = 0.2;

std::string known_before(const solver::FreeParameter& parameter) {
    return std::isfinite(parameter.standard_deviation)
               ? fmt::format("{} +- {}", to_its_digits(parameter.prior, parameter.standard_deviation),
                             to_its_digits(parameter.standard_deviation, parameter.standard_deviation))
               : "-";
}

DataTable parameters(const IdentificationRecord& record) {
    const bool planned = record.planned;
    DataTable table;
    for (std::size_t j = 0; j < record.result.fitted.size(); ++j) {
        const Fitted& one = record.result.fitted[j];
        const solver::FreeParameter& parameter = record.experiment.parameters[j];
        const bool has_prior = std::isfinite(parameter.standard_deviation);
        table.add(
            {{"parameter", "name", parameter.name},
             {"unit", "unit", {parameter.unit, parameter.unit == "1" ? "-" : parameter.unit, false}},
             {"case", "case", shown("{:.5g}", one.before)},
             {planned ? "" : "fitted", "value", {one.value, planned ? "" : to_its_digits(one.value, half_width(one))}},
             data_only("standard_deviation", one.standard_deviation),
             page_only("95 %", right(interval_text(one, planned))),
             data_only("low", one.low),
             data_only("high", one.high),
             data_only("interval", one.profiled ? "profile" : "wald"),
             data_only("low_is_open", one.low_is_open),
             data_only("high_is_open", one.high_is_open),
             data_only("moved_by_grid_correction", one.by_grid),
             {"known before", "prior", {where(has_prior, parameter.prior), known_before(parameter)}},
             data_only("prior_standard_deviation", parameter.standard_deviation),
             {"what the data say", "identifiability", word_of(one.identifiability)}});
    }
    return table;
}

std::string channels_in_doubt(const Identification& result) {
    std::string names;
    for (const ChannelFit& fit : result.channels) {
        if (fit.is_in_doubt) {
            names += (names.empty() ? "" : ", ") + fit.name;
        }
    }
    if (result.numbers_off() > far_above_data_sheet) {
        names += (names.empty() ? "" : ", ") + std::string("the single numbers");
    }
    return names;
}

ReportSection numbers(const IdentificationRecord& record, DataTable table) {
    ReportSection section("Parameters", std::move(table));
    const std::vector<Fitted>& fitted = record.result.fitted;
    std::string moved;
    for (std::size_t j = 0; j < fitted.size(); ++j) {
        if (std::abs(fitted[j].by_grid) > 0.5 * fitted[j].standard_deviation) {
            moved += fmt::format("{}{} {:+.2g}", moved.empty() ? "" : ", ", record.experiment.parameters[j].name,
                                 fitted[j].by_grid);
        }
    }
    if (!moved.empty()) {
        section.say(
            fmt::format("Corrected for the error of grid and steps, of which a quarter is added to the intervals: {}. "
                        "Intervals are those of the noise and of this grid: a missing effect may be larger.",
                        moved));
    }
    if (std::ranges::any_of(fitted, &Fitted::profiled)) {
        section.say("The intervals are those of the profile likelihood.");
    }
    if (record.result.widened > 1.0) {
        section.say(fmt::format(
            "The differences of {} may be an error of the model (see Fit): what the data say of a parameter is in "
            "doubt, and what they add to its interval is {:.2g} times as wide as noise makes it.",
            channels_in_doubt(record.result), record.result.widened));
    }
    constexpr std::array meanings{
        std::pair(Identifiability::doubtful,
                  "doubtful: the data narrow it, but a missing effect may have moved it beyond its interval; run "
                  "diagnose."),
        std::pair(Identifiability::with_prior,
                  "with prior: the data narrow what was known before, but to no less than half of it."),
        std::pair(Identifiability::prior_only,
                  "prior only: the data do not see it; the interval is the one that was known before."),
        std::pair(Identifiability::not_determined,
                  "not determined: the data do not see it and nothing was known before; the value is where the search "
                  "ended and means nothing."),
        std::pair(Identifiability::at_bound,
                  "at bound: the data favour a value beyond the bound; a finding about the model.")};
    for (const auto& [identifiability, meaning] : meanings) {
        if (std::ranges::count(fitted, identifiability, &Fitted::identifiability) > 0) {
            section.say(meaning);
        }
    }
    return section;
}

ReportSection directions(const IdentificationRecord& record) {
    ReportSection section("What the data do not tell");
    for (const Direction& direction : record.result.directions) {
        if (direction.strength >= 1.0) {
            continue;
        }
        if (section.blocks().empty()) {
            section.say(
                "Moved together as written, within what was known of them, these parameters change all readings "
                "by less than one standard deviation of the noise:");
        }
        section.item(fmt::format("{}: {}", describe(direction, record.experiment, record.result.values),
                                 direction.strength < 1e-3
                                     ? "no change at all"
                                     : fmt::format("{:.2g} standard deviations", direction.strength)));
    }
    return section;
}

ReportSection correlations(const IdentificationRecord& record) {
    struct Pair {
        std::size_t a;
        std::size_t b;
        double value;
    };
    std::vector<Pair> pairs;
    const Eigen::MatrixXd& correlation = record.result.correlation;
    for (Eigen::Index a = 0; a < correlation.rows(); ++a) {
        for (Eigen::Index b = 0; b < a; ++b) {
            if (std::abs(correlation(a, b)) >= close) {
                pairs.push_back({static_cast<std::size_t>(b), static_cast<std::size_t>(a), correlation(a, b)});
            }
        }
    }
    std::ranges::sort(pairs, [](const Pair& x, const Pair& y) { return std::abs(x.value) > std::abs(y.value); });
    DataTable table;
    for (const Pair& pair : pairs) {
        table.add({page_only("", record.experiment.parameters[pair.a].name),
                   page_only("", record.experiment.parameters[pair.b].name),
                   page_only("", shown("{:+.3f}", pair.value))});
    }
    return {"Pairs that the data hardly tell apart (correlation)", std::move(table)};
}

}  // namespace

std::string describe(const Direction& direction, const input::Experiment& experiment, const Eigen::VectorXd& values) {
    const Eigen::VectorXd scale = scales_of(experiment, values);
    std::vector<Eigen::Index> order;
    for (Eigen::Index j = 0; j < direction.share.size(); ++j) {
        if (std::abs(direction.share[j]) >= small) {
            order.push_back(j);
        }
    }
    std::ranges::sort(order, [&](Eigen::Index a, Eigen::Index b) {
        return std::abs(direction.share[a]) > std::abs(direction.share[b]);
    });
    std::string text;
    const double sign = order.empty() || direction.share[order.front()] > 0.0 ? 1.0 : -1.0;
    for (const Eigen::Index j : order) {
        const solver::FreeParameter& parameter = experiment.parameters[static_cast<std::size_t>(j)];
        const std::string unit = parameter.unit == "1" ? "" : " " + parameter.unit;
        text += fmt::format("{}{} {:+.2g}{}", text.empty() ? "" : " with ", parameter.name,
                            sign * direction.share[j] * scale[j], unit);
    }
    return text;
}

Report identification_report(const IdentificationRecord& record, const std::vector<std::filesystem::path>& files) {
    const Identification& result = record.result;
    const auto values = static_cast<double>(record.observations.measured.size());
    const std::string seconds = to_its_digits(result.seconds, 0.05 * result.seconds);
    DataTable of_parameters = parameters(record);
    DataTable of_channels = fitted_channels(record);
    DataTable of_numbers = fitted_single_numbers(record);
    Value::List runs;
    for (const input::MeasuredRun& run : record.experiment.runs) {
        runs.push_back(run.name);
    }
    Value::List weak;
    for (const Direction& direction : result.directions) {
        weak.push_back({{"strength", direction.strength},
                        {"share", std::vector<double>(direction.share.begin(), direction.share.end())}});
    }
    Value::List correlation;
    for (const auto& row : result.correlation.rowwise()) {
        correlation.push_back(std::vector<double>(row.begin(), row.end()));
    }
    Report report{.title = record.experiment.runs.front().problem.title};
    report.lead = {
        fmt::format("{} {} {}, {} values", plural(result.fitted.size(), "parameter"),
                    record.planned ? "planned for" : "fitted to", plural(record.experiment.runs.size(), "run"),
                    grouped(values)),
        record.planned
            ? fmt::format("Predicted from the case as it stands, {} simulations in {} s: nothing was measured.",
                          result.simulations, seconds)
            : fmt::format("{} simulations, {} s{}", result.simulations, seconds,
                          result.converged ? "" : "; THE SEARCH DID NOT CONVERGE")};
    report.data = {{"case", record.case_file.generic_string()},
                   {"planned", record.planned},
                   {"converged", result.converged},
                   {"runs", runs},
                   {"parameters", of_parameters.data()},
                   {"directions", weak},
                   {"correlation", correlation},
                   {"channels", of_channels.data()},
                   {"numbers", of_numbers.data()},
                   {"intervals_widened", result.widened},
                   {"misfit", result.misfit},
                   {"freedom", result.freedom},
                   {"non_smooth_parameters", result.non_smooth_parameters}};
    report.verdict = identification_headline(record);
    const std::vector<std::string> not_driven = input::not_driven(record.experiment);
    report.verdict.insert(report.verdict.begin(), not_driven.begin(), not_driven.end());
    solver::Extrapolations extrapolations;
    for (const input::MeasuredRun& run : record.experiment.runs) {
        extrapolations.add(run.problem);
    }
    std::ranges::move(extrapolations.headline(), std::back_inserter(report.verdict));
    report.appendix.push_back(citations_section(record.experiment.runs.front().problem));
    report.add(numbers(record, std::move(of_parameters)));
    if (!record.planned) {
        report.add(law_charts(record));
    }
    std::vector<std::string> findings = texts_of(result.findings);
    findings.insert(findings.end(), record.findings.begin(), record.findings.end());
    report.add("Findings", "findings", findings);
    report.add(identifiability_section(record));
    report.add(directions(record));
    report.add(correlations(record));
    if (!record.planned) {
        report.add(fit_section(record, std::move(of_channels), std::move(of_numbers)));
        DataTable of_left_out = left_out_table(record);
        report.data.set("left_out", of_left_out.data());
        report.add(left_out_section(record, std::move(of_left_out)));
        add_observed_corners(report, record.experiment, record.observations, result.after, " after the fit");
        report.add(measured_section(observed_series(record.experiment, record.observations,
                                                    {{"case", &result.before}, {"fitted", &result.after}}),
                                    inputs_of_runs(record.experiment)));
    }
    ReportSection switches("At a switch or a clamp");
    if (!result.non_smooth_parameters.empty()) {
        switches.say(fmt::format("{}: the slope is that of one side, and the interval with it.",
                                 fmt::join(result.non_smooth_parameters, ", ")));
    }
    report.add(std::move(switches));
    report.add_warnings(record.warnings, extrapolations.warnings());
    report.add(files);
    report.data.set("simulations", result.simulations);
    report.data.set("seconds", result.seconds);
    return report;
}

}  // namespace tiretherm::post
