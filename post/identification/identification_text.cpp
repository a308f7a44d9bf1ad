#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/fit/fit.hpp"
#include "post/identification/identification_report.hpp"
#include "post/report/number_text.hpp"
#include "post/report/page.hpp"
#include "post/report/table.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Correlations from here on are shown.
constexpr double close = 0.9;
/// Parts of a direction smaller than this are not reported.
constexpr double small = 0.2;

double half_width(const Fitted& one) { return 0.5 * (one.high - one.low); }

std::string interval(const Fitted& one, bool planned) {
    if (one.identifiability == Identifiability::not_determined && !one.profiled) {
        return "-";
    }
    if (planned) {
        return fmt::format("+- {}", to_its_digits(half_width(one), half_width(one)));
    }
    return fmt::format("{}{} to {}{}", one.low_is_open ? "< " : "", to_its_digits(one.low, half_width(one)),
                       one.high_is_open ? "> " : "", to_its_digits(one.high, half_width(one)));
}

std::string known_before(const solver::FreeParameter& parameter) {
    return std::isfinite(parameter.standard_deviation)
               ? fmt::format("{} +- {}", to_its_digits(parameter.prior, parameter.standard_deviation),
                             to_its_digits(parameter.standard_deviation, parameter.standard_deviation))
               : "-";
}

std::string numbers_table(const IdentificationRecord& record) {
    const bool planned = record.planned;
    Table table({true, true, false, false, false, false, true});
    table.add({"number", "unit", "case", planned ? "" : "fitted", "95 %", "known before", "what the data say"});
    bool profiled = false;
    for (std::size_t j = 0; j < record.result.fitted.size(); ++j) {
        const Fitted& one = record.result.fitted[j];
        const solver::FreeParameter& parameter = record.experiment.parameters[j];
        profiled = profiled || one.profiled;
        table.add({parameter.name, parameter.unit == "1" ? "-" : parameter.unit, fmt::format("{:.5g}", one.before),
                   planned ? "" : to_its_digits(one.value, half_width(one)), interval(one, planned),
                   known_before(parameter), std::string(word_of(one.identifiability))});
    }
    std::string text = table.text(2);
    const auto any = [&](Identifiability identifiability) {
        return std::ranges::any_of(record.result.fitted,
                                   [&](const Fitted& one) { return one.identifiability == identifiability; });
    };
    std::string moved;
    for (std::size_t j = 0; j < record.result.fitted.size(); ++j) {
        const Fitted& one = record.result.fitted[j];
        if (std::abs(one.by_grid) > 0.5 * one.standard_deviation) {
            moved += fmt::format("{}{} {:+.2g}", moved.empty() ? "" : ", ", record.experiment.parameters[j].name,
                                 one.by_grid);
        }
    }
    if (!moved.empty()) {
        text += wrap(
            fmt::format("Corrected for the error of grid and steps, of which a quarter is added to the intervals: {}. "
                        "Intervals are those of the noise and of this grid: a missing effect may be larger.",
                        moved),
            2);
    }
    if (profiled) {
        text += wrap("The intervals are those of the profile likelihood.", 2);
    }
    if (any(Identifiability::with_prior)) {
        text += wrap("with prior: the data narrow what was known before, but to no less than half of it.", 2);
    }
    if (any(Identifiability::prior_only)) {
        text += wrap("prior only: the data do not see it; the interval is the one that was known before.", 2);
    }
    if (any(Identifiability::not_determined)) {
        text += wrap(
            "not determined: the data do not see it and nothing was known before; the value is where "
            "the search ended and means nothing.",
            2);
    }
    if (any(Identifiability::at_bound)) {
        text += wrap("at bound: the data want a value beyond what is allowed; a finding about the model.", 2);
    }
    return text;
}

std::string directions_text(const IdentificationRecord& record) {
    std::string text;
    bool any = false;
    for (const Direction& direction : record.result.directions) {
        if (direction.strength < 1.0) {
            any = true;
            text += wrap(
                fmt::format("- {}: {}", describe(direction, record.experiment, record.result.values),
                            direction.strength < 1e-3 ? "no change at all"
                                                      : fmt::format("{:.2g} standard deviations", direction.strength)),
                4);
        }
    }
    return !any ? ""
                : wrap(
                      "Moved together as written, within what was known of them, these numbers change all readings "
                      "by less than one standard deviation of the noise:",
                      2) +
                      text;
}

std::string correlations_text(const IdentificationRecord& record) {
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
    Table table({true, true, false});
    for (const Pair& pair : pairs) {
        table.add({record.experiment.parameters[pair.a].name, record.experiment.parameters[pair.b].name,
                   fmt::format("{:+.3f}", pair.value)});
    }
    return pairs.empty() ? "" : table.text(2);
}

std::string fit_text(const IdentificationRecord& record) {
    const std::vector<solver::Channel>& channels = record.experiment.runs.front().problem.channels;
    const Identification& result = record.result;
    std::string text;
    if (!result.channels.empty()) {
        Table table({true, true, false, false, false, false, false, false});
        table.add({"channel", "unit", "samples", "rms before", "rms after", "noise", "sensor", "correlation time"});
        for (const ChannelFit& fit : result.channels) {
            const solver::Channel& channel = channels[fit.channel];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            const auto show = [&](double si) { return fmt::format("{:.3g}", unit.difference(si)); };
            table.add({fit.name, channel.quantity == solver::Quantity::temperature ? "K" : unit.name,
                       grouped(static_cast<double>(fit.samples)), show(fit.rmse_before), show(fit.rmse_after),
                       show(fit.noise.sigma), fit.stated > 0.0 ? show(fit.stated) : "-",
                       fit.noise.white_share < 1.0 ? fmt::format("{:.3g} s", fit.noise.correlation_time) : "white"});
        }
        text += table.text(2);
        if (!record.observations.images.empty()) {
            text += wrap(
                "A camera's frames are taken apart by size, so that what neighbouring pixels have in common counts as "
                "few values and not as thousands: white noise of the pixels is the same in all its rows, the camera's "
                "drift and missing effects stand in the lower ones.",
                2);
        }
        for (const ChannelFit& fit : result.channels) {
            for (const std::string& caution : fit.cautions) {
                text += wrap("- " + caution, 2);
            }
        }
    }
    if (!result.numbers.empty()) {
        Table table({true, true, false, false, false, false, false});
        table.add({"channel", "run", "measured", "+-", "case", "fitted", "off by"});
        for (const NumberFit& fit : result.numbers) {
            const Observations::Row& row = record.observations.rows[fit.row];
            const solver::Channel& channel = channels[row.channel];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            const double measured = record.observations.measured[static_cast<Eigen::Index>(fit.row)];
            table.add({channel.name, record.experiment.runs[row.run].name,
                       fmt::format("{:.4g} {}", unit.value(measured), unit.name),
                       fmt::format("{:.2g}", unit.difference(fit.standard_deviation)),
                       fmt::format("{:.2f}", unit.value(fit.before)), fmt::format("{:.2f}", unit.value(fit.after)),
                       fmt::format("{:+.1f} u", (fit.after - measured) / fit.standard_deviation)});
        }
        text += (text.empty() ? "" : "\n") + table.text(2) + "  u: standard uncertainty of the measured number\n";
    }
    return text;
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

std::string identification_text(const IdentificationRecord& record, bool bold) {
    const Identification& result = record.result;
    const std::size_t n_runs = record.experiment.runs.size();
    Page page(bold);
    page.add(fmt::format("{}\n{} number{} {} {} run{}, {} values\n", record.experiment.runs.front().problem.title,
                         result.fitted.size(), result.fitted.size() == 1 ? "" : "s",
                         record.planned ? "planned for" : "fitted to", n_runs, n_runs == 1 ? "" : "s",
                         grouped(static_cast<double>(record.observations.measured.size()))));
    const std::string seconds = to_its_digits(result.seconds, 0.05 * result.seconds);
    page.add(record.planned
                 ? fmt::format("Predicted from the case as it stands, {} simulations in {} s: nothing was measured.\n",
                               result.simulations, seconds)
                 : fmt::format("{} simulations, {} s{}\n", result.simulations, seconds,
                               result.converged ? "" : "; THE SEARCH DID NOT CONVERGE"));
    page.add("Numbers", numbers_table(record));
    page.add("What the data do not tell", directions_text(record));
    page.add("Pairs that the data hardly tell apart (correlation)", correlations_text(record));
    if (!record.planned) {
        page.add("Fit", fit_text(record));
    }
    if (!result.non_smooth_parameters.empty()) {
        page.add("At a switch or a clamp",
                 wrap(fmt::format("{}: the slope is that of one side, and the interval with it.",
                                  fmt::join(result.non_smooth_parameters, ", ")),
                      2));
    }
    page.add("Findings about the data", paragraphs(record.findings));
    page.add("Warnings", paragraphs(record.warnings));
    return page.text();
}

}  // namespace tiretherm::post
