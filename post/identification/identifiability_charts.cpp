// SPDX-License-Identifier: BSD-3-Clause
// Standard deviations against what was known before, correlations, and the weakest singular directions.
#include "post/identification/identifiability_charts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/page/cell_chart.hpp"
#include "post/page/charts.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr Eigen::Index most_numbers = 30;  ///< of a matrix that can still be read
constexpr std::size_t most_directions = 6;

std::vector<std::string> names_of(const IdentificationRecord& record) {
    std::vector<std::string> names;
    for (const solver::FreeParameter& parameter : record.experiment.parameters) {
        names.push_back(parameter.name);
    }
    return names;
}

/// Two charts, because a share of what was known and a share of the value are no common scale.
void add_uncertainties(ReportSection& section, const IdentificationRecord& record) {
    std::vector<Bar> of_known;
    std::vector<Bar> of_value;
    for (std::size_t j = 0; j < record.result.fitted.size(); ++j) {
        const Fitted& one = record.result.fitted[j];
        const solver::FreeParameter& parameter = record.experiment.parameters[j];
        const double before = parameter.standard_deviation;
        if (std::isfinite(before) && before > 0.0) {
            const double share = std::isfinite(one.standard_deviation) ? one.standard_deviation / before : 1.0;
            of_known.push_back({.name = parameter.name, .value = 100.0 * share});
        } else if (std::isfinite(one.standard_deviation) && one.value != 0.0) {
            of_value.push_back({.name = parameter.name, .value = 100.0 * std::abs(one.standard_deviation / one.value)});
        }
    }
    if (!of_known.empty()) {
        section.chart(
            "What is left of the uncertainty",
            "One standard deviation after the fit, in percent of what was known before it. 100 %: the data say nothing "
            "of this parameter; below 50 % they say more of it than was known.",
            bar_chart("left of the uncertainty", "%", of_known, {{.name = "as known before", .value = 100.0}}));
    }
    if (!of_value.empty()) {
        section.chart("Uncertainty of the parameters of which nothing was known",
                      "One standard deviation after the fit, in percent of the fitted value.",
                      bar_chart("standard deviation", "% of the value", of_value));
    }
}

void add_correlations(ReportSection& section, const IdentificationRecord& record) {
    const Eigen::MatrixXd& correlation = record.result.correlation;
    const Eigen::Index n = correlation.rows();
    if (n < 2 || n > most_numbers || n != static_cast<Eigen::Index>(record.experiment.parameters.size())) {
        return;
    }
    std::vector<MapCell> cells;
    for (Eigen::Index row = 0; row < n; ++row) {
        for (Eigen::Index column = 0; column < row; ++column) {
            const auto x = static_cast<double>(column);
            const auto y = static_cast<double>(row - 1);
            cells.push_back(
                {.x_from = x, .x_to = x + 1.0, .y_from = y, .y_to = y + 1.0, .value = correlation(row, column)});
        }
    }
    std::vector<std::string> columns = names_of(record);
    std::vector<std::string> rows(columns.begin() + 1, columns.end());
    columns.pop_back();
    section.chart("Which parameters the data tell apart",
                  "Correlation of each pair. Near 0 each is determined by itself. Near -1 only the sum of the two is "
                  "known, near +1 only their difference: a change of one can be made up for by the other.",
                  cell_chart({.name = "", .words = std::move(columns)}, {.name = "", .words = std::move(rows)},
                             {.name = "correlation", .is_signed = true, .reach = 1.0}, cells));
}

void add_directions(ReportSection& section, const IdentificationRecord& record) {
    std::vector<const Direction*> weakest;
    for (const Direction& direction : record.result.directions) {
        if (direction.share.size() == static_cast<Eigen::Index>(record.experiment.parameters.size())) {
            weakest.push_back(&direction);
        }
    }
    std::ranges::sort(weakest, {}, [](const Direction* direction) { return direction->strength; });
    weakest.resize(std::min(weakest.size(), most_directions));
    if (weakest.size() < 2 || weakest.front()->share.size() > most_numbers) {
        return;
    }
    std::vector<MapCell> cells;
    std::vector<std::string> rows;
    for (std::size_t r = 0; r < weakest.size(); ++r) {
        const Direction& direction = *weakest[r];
        rows.push_back(direction.strength < 1e-3  ? std::string("not seen")
                       : direction.strength < 1.0 ? fmt::format("hardly seen: {:.2g}", direction.strength)
                                                  : fmt::format("seen: {:.3g}", direction.strength));
        const auto y = static_cast<double>(r);
        // The sign of a direction means nothing: its largest part is positive.
        Eigen::Index largest = 0;
        direction.share.cwiseAbs().maxCoeff(&largest);
        const double sign = direction.share[largest] < 0.0 ? -1.0 : 1.0;
        for (Eigen::Index j = 0; j < direction.share.size(); ++j) {
            const auto x = static_cast<double>(j);
            cells.push_back(
                {.x_from = x, .x_to = x + 1.0, .y_from = y, .y_to = y + 1.0, .value = sign * direction.share[j]});
        }
    }
    section.chart(
        "Combinations that the data see least",
        "Each row is a combination of the parameters, the least seen first. Beside it: how many times smaller its "
        "uncertainty is by the data than by what was known before; below 1 the data add little. Moving all parameters "
        "of a row as coloured, each in its own uncertainty, changes the readings least.",
        cell_chart({.name = "", .words = names_of(record)}, {.name = "", .words = std::move(rows)},
                   {.name = "part", .is_signed = true, .reach = 1.0}, cells));
}

}  // namespace

ReportSection identifiability_section(const IdentificationRecord& record) {
    ReportSection section("How well the parameters are determined");
    add_uncertainties(section, record);
    add_correlations(section, record);
    add_directions(section, record);
    return section;
}

}  // namespace tiretherm::post
