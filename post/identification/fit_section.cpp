// SPDX-License-Identifier: BSD-3-Clause
// How channels and single measured numbers fit, as tables, and the cautions about their noise.
#include "post/identification/fit_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "post/comparison/comparison_sentences.hpp"
#include "post/report/number_text.hpp"
#include "post/report/remark_text.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

DataTable fitted_channels(const IdentificationRecord& record) {
    DataTable table;
    for (const ChannelFit& fit : record.result.channels) {
        const solver::Channel& channel = record.experiment.runs.front().problem.channels[fit.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        const auto show = [&](double si) { return shown("{:.3g}", unit.difference(si)); };
        table.add({{"channel", "name", fit.name},
                   {"unit", "unit", difference_unit(unit.name)},
                   {"samples", "samples", count(static_cast<std::size_t>(fit.samples))},
                   {"rms before", "rmse_before", show(fit.rmse_before)},
                   {"rms after", "rmse_after", show(fit.rmse_after)},
                   {"noise", "sigma", show(fit.noise.sigma)},
                   page_only("sensor", fit.stated > 0.0 ? show(fit.stated) : right("-")),
                   page_only("correlation time",
                             right(fit.noise.white_share < 1.0 ? fmt::format("{:.3g} s", fit.noise.correlation_time)
                                                               : "white")),
                   data_only("rho_1s", fit.noise.rho_1s()),
                   data_only("white_share", fit.noise.white_share),
                   data_only("grid_error", unit.difference(fit.grid_error)),
                   data_only("in_doubt", fit.is_in_doubt),
                   data_only("cautions", texts_of(fit.cautions))});
    }
    return table;
}

DataTable fitted_single_numbers(const IdentificationRecord& record) {
    DataTable table;
    for (const NumberFit& fit : record.result.numbers) {
        const Observations::Row& row = record.observations.rows[fit.row];
        const solver::Channel& channel = record.experiment.runs.front().problem.channels[row.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        const double measured = unit.value(fit.measured);
        table.add({{"channel", "channel", channel.name},
                   {"run", "run", record.experiment.runs[row.run].name},
                   data_only("unit", unit.name),
                   {"measured", "measured", {measured, fmt::format("{:.4g} {}", measured, unit.name)}},
                   {"+-", "uncertainty", shown("{:.2g}", unit.difference(fit.standard_deviation))},
                   {"case", "before", shown("{:.2f}", unit.value(fit.before))},
                   {"fitted", "after", shown("{:.2f}", unit.value(fit.after))},
                   page_only("off by", shown("{:+.1f} u", fit.off()))});
    }
    return table;
}

ReportSection fit_section(const IdentificationRecord& record, DataTable of_channels, DataTable of_numbers) {
    ReportSection section("Fit");
    if (!of_channels.empty()) {
        section.add(std::move(of_channels));
        if (!record.observations.images.empty()) {
            section.say(
                "A camera's frames are taken apart by size, so that what neighbouring pixels have in common counts as "
                "few values and not as thousands: white noise of the pixels is the same in all its rows, the camera's "
                "drift and missing effects stand in the lower ones.");
        }
        // Beside the noise of each: kelvins and pascals have no common scale.
        const auto most = std::ranges::max_element(record.result.channels, {}, [](const ChannelFit& one) {
            return one.grid_error / std::max(one.noise.sigma, 1e-9);
        });
        if (most->grid_error > 0.0) {
            const solver::Channel& channel = record.experiment.runs.front().problem.channels[most->channel];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            section.say(fmt::format("What is simulated is corrected for the error of grid and steps, {}.",
                                    grid_error_text(most->name, unit, most->grid_error)));
        }
        for (const ChannelFit& one : record.result.channels) {
            for (const std::string& caution : texts_of(one.cautions)) {
                section.item(caution);
            }
        }
    }
    if (!of_numbers.empty()) {
        section.gap();
        section.add(std::move(of_numbers));
        section.say("u: standard uncertainty of the measured value");
    }
    return section;
}

namespace {

/// The parameter that moves most. @returns its index, or -1
Eigen::Index largest_move(const LeftOut& one) {
    Eigen::Index which = -1;
    const double most = one.moves.size() > 0 ? one.moves.cwiseAbs().maxCoeff(&which) : 0.0;
    return most > 0.0 ? which : -1;
}

}  // namespace

DataTable left_out_table(const IdentificationRecord& record) {
    DataTable table;
    for (const LeftOut& one : record.result.left_out) {
        if (one.channels.empty()) {
            continue;  // a finding says so
        }
        const Eigen::Index moved = largest_move(one);
        const std::string move =
            moved < 0 ? ""
                      : fmt::format("{} {:+.1f} sd", record.experiment.parameters[static_cast<std::size_t>(moved)].name,
                                    one.moves[moved]);
        for (const LeftOutChannel& part : one.channels) {
            const bool is_first = &part == &one.channels.front();
            const solver::Channel& channel =
                record.experiment.runs.front().problem.channels[record.observations.channels[part.noise]];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            const auto show = [&](double si) { return shown("{:.3g}", unit.difference(si)); };
            table.add({{"left out", "left_out", {one.name, is_first ? one.name : "", false}},
                       {"channel", "channel", record.observations.names[part.noise]},
                       {"unit", "unit", difference_unit(unit.name)},
                       {"samples", "samples", count(static_cast<std::size_t>(part.samples))},
                       {"rms fitted", "rmse_fitted", show(part.rms_fitted)},
                       {"rms predicted", "rmse_predicted", show(part.rms_predicted)},
                       {"expected", "rmse_expected", show(part.rms_expected)},
                       page_only("moves most", is_first ? move : ""),
                       data_only("values", std::vector<double>(one.values.begin(), one.values.end())),
                       data_only("moves", std::vector<double>(one.moves.begin(), one.moves.end()))});
        }
    }
    return table;
}

ReportSection left_out_section(const IdentificationRecord& record, DataTable table) {
    ReportSection section("Left out in turn");
    if (table.empty()) {
        return section;
    }
    section.add(std::move(table));
    section.say(
        "Each is predicted by a fit without it. Expected: what the fit leaves of the rest, and what the rest does not "
        "know, if the model is right; a part that is wrong makes the noise and so this larger. sd: standard deviations "
        "of what chance would move a parameter, if the model is right.");
    if (record.observations.n_recordings() > 1) {
        section.say("The start of a run that is left out is fitted to the run itself.");
    }
    const double limit = least_move(record.result.left_out);
    for (const LeftOut& one : record.result.left_out) {
        for (Eigen::Index j = 0; j < one.moves.size(); ++j) {
            if (std::abs(one.moves[j]) > limit) {
                const auto index = static_cast<std::size_t>(j);
                section.item(fmt::format(
                    "without {} {} is {:.3g} and not {:.3g}, {:.1f} standard deviations of such a move: the model, or "
                    "what is said to be known before, is wrong there or in the rest; run diagnose",
                    one.name, record.experiment.parameters[index].name, one.values[j],
                    record.result.fitted[index].value, std::abs(one.moves[j])));
            }
        }
    }
    return section;
}

}  // namespace tiretherm::post
