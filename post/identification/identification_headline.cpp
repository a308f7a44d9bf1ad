// SPDX-License-Identifier: BSD-3-Clause
// Words the first parameters with their intervals and counts what the data determine.
#include "post/identification/identification_headline.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "post/report/number_text.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr std::size_t most_parameters = 3;
constexpr std::size_t most_channels = 4;

/// "2 of 6 parameters are determined by the data, 3 doubtful, 1 at bound."
std::string counts(const IdentificationRecord& record) {
    const std::vector<Fitted>& fitted = record.result.fitted;
    const auto count_of = [&](Identifiability what) {
        return static_cast<std::size_t>(std::ranges::count(fitted, what, &Fitted::identifiability));
    };
    const std::size_t determined = count_of(Identifiability::determined);
    std::string text = fmt::format("{} of {} {} determined by the data", determined, plural(fitted.size(), "parameter"),
                                   record.planned    ? "would be"
                                   : determined == 1 ? "is"
                                                     : "are");
    for (const Identifiability what :
         {Identifiability::doubtful, Identifiability::with_prior, Identifiability::prior_only,
          Identifiability::not_determined, Identifiability::at_bound}) {
        if (const std::size_t n = count_of(what); n > 0) {
            text += fmt::format(", {} {}", n, word_of(what));
        }
    }
    return text + ".";
}

/// "air_convection.lambda_h 1.09 (95 %: 1.05 to 1.13), doubtful"
std::string value_text(const IdentificationRecord& record, std::size_t j) {
    const Fitted& one = record.result.fitted[j];
    const solver::FreeParameter& parameter = record.experiment.parameters[j];
    const std::string unit = parameter.unit == "1" ? "" : " " + slashed_unit(parameter.unit);
    const std::string interval = interval_text(one, record.planned);
    std::string text = parameter.name;
    if (record.planned) {
        text += interval == "-" ? "" : fmt::format(" {}{} (95 %)", interval, unit);
    } else {
        text += fmt::format(" {}{}", to_its_digits(one.value, half_width(one)), unit);
        text += interval == "-" ? "" : fmt::format(" (95 %: {})", interval);
    }
    return one.identifiability == Identifiability::determined
               ? text
               : fmt::format("{}, {}", text, word_of(one.identifiability));
}

/// The parameters that are asked for, those that the data determine first; where a run starts is none of them.
std::vector<std::size_t> of_interest(const IdentificationRecord& record) {
    std::vector<std::size_t> all;
    for (std::size_t j = 0; j < record.result.fitted.size(); ++j) {
        if (record.experiment.parameters[j].kind != solver::FreeParameter::Kind::initial) {
            all.push_back(j);
        }
    }
    std::ranges::stable_sort(
        all, {}, [&](std::size_t j) { return record.result.fitted[j].identifiability != Identifiability::determined; });
    return all;
}

/// "rms after the fit: surface_temperature 0.98 K (data sheet 0.5)"
std::string misfits(const IdentificationRecord& record) {
    std::vector<std::string> parts;
    for (const ChannelFit& fit : record.result.channels) {
        const solver::Channel& channel = record.experiment.runs.front().problem.channels[fit.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        std::string part =
            fmt::format("{} {:.3g} {}", fit.name, unit.difference(fit.rmse_after), difference_unit(unit.name));
        part += fit.stated > 0.0 ? fmt::format(" (data sheet {:.3g})", unit.difference(fit.stated)) : "";
        parts.push_back(std::move(part));
    }
    if (parts.empty() || parts.size() > most_channels) {
        return "";
    }
    return fmt::format("rms after the fit: {}.", fmt::join(parts, ", "));
}

}  // namespace

std::string interval_text(const Fitted& one, bool planned) {
    if (one.identifiability == Identifiability::not_determined && !one.profiled) {
        return "-";
    }
    if (planned) {
        return fmt::format("+- {}", to_its_digits(half_width(one), half_width(one)));
    }
    return fmt::format("{}{} to {}{}", one.low_is_open ? "< " : "", to_its_digits(one.low, half_width(one)),
                       one.high_is_open ? "> " : "", to_its_digits(one.high, half_width(one)));
}

std::vector<std::string> identification_headline(const IdentificationRecord& record) {
    std::vector<std::size_t> shown = of_interest(record);
    const std::size_t left_out = shown.size() - std::min(shown.size(), most_parameters);
    shown.resize(shown.size() - left_out);
    std::vector<std::string> values;
    std::ranges::transform(shown, std::back_inserter(values), [&](std::size_t j) { return value_text(record, j); });
    std::vector<std::string> sentences;
    if (!values.empty()) {
        sentences.push_back(fmt::format("{}{}.", fmt::join(values, "; "),
                                        left_out > 0 ? fmt::format("; {} more below", left_out) : ""));
    }
    sentences.push_back(counts(record));
    if (std::string fit = record.planned ? "" : misfits(record); !fit.empty()) {
        sentences.push_back(std::move(fit));
    }
    return sentences;
}

}  // namespace tiretherm::post
