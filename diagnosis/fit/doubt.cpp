// SPDX-License-Identifier: BSD-3-Clause
// The words of doubt; the factor by which a doubtful noise widens intervals, and the widening beside a prior.
#include "diagnosis/fit/doubt.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "input/text/word_lists.hpp"

namespace tiretherm::diagnosis {

namespace {

/// The upper limit of a correlation time is a tenth of the longest run: noise as slow as the run has ten times the
/// variance in what is slow.
const double without_data_sheet = std::sqrt(10.0);

/// The standard deviation when the data count for less. @param prior standard deviation known before, may be infinite
double widened(double deviation, double prior, double factor) {
    const double known = std::isfinite(prior) ? 1.0 / (prior * prior) : 0.0;
    const double from_data = std::max(0.0, 1.0 / (deviation * deviation) - known);
    const double precision = from_data / (factor * factor) + known;
    return precision > 0.0 ? 1.0 / std::sqrt(precision) : deviation;
}

void doubt(Fitted& one) {
    if (one.identifiability == Identifiability::determined) {
        one.identifiability = Identifiability::doubtful;
    }
}

}  // namespace

void widen_doubtful(const std::vector<solver::FreeParameter>& parameters, Identification& into) {
    bool is_in_doubt = false;
    for (const ChannelFit& channel : into.channels) {
        if (channel.is_in_doubt) {
            is_in_doubt = true;
            const double error =
                channel.is_missed() ? std::max(channel.noise.sigma, channel.rmse_after) : channel.noise.sigma;
            const double ratio = channel.stated > 0.0 ? error / channel.stated : without_data_sheet;
            into.widened = std::max(into.widened, ratio);
        }
    }
    if (const double off = into.numbers_off(); off > far_above_data_sheet) {
        is_in_doubt = true;
        into.widened = std::max(into.widened, off);
        into.findings.push_back(remark::numbers_are_missed(off));
    }
    if (!is_in_doubt) {
        return;
    }
    for (std::size_t j = 0; j < into.fitted.size(); ++j) {
        Fitted& one = into.fitted[j];
        doubt(one);
        if (!(one.standard_deviation > 0.0) || !std::isfinite(one.standard_deviation)) {
            continue;
        }
        const solver::FreeParameter& parameter = parameters[j];
        const double deviation = widened(one.standard_deviation, parameter.standard_deviation, into.widened);
        const double factor = deviation / one.standard_deviation;
        const double low = one.value - (one.value - one.low) * factor;
        const double high = one.value + (one.high - one.value) * factor;
        one.standard_deviation = deviation;
        one.low_is_open = one.low_is_open || low < parameter.low;
        one.high_is_open = one.high_is_open || high > parameter.high;
        one.low = std::max(parameter.low, low);
        one.high = std::min(parameter.high, high);
    }
}

double Identification::numbers_off() const {
    double sum = 0.0;
    for (const NumberFit& number : numbers) {
        sum += number.off() * number.off();
    }
    return numbers.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(numbers.size()));
}

void doubt_beside(const solver::FreeParameter& unexpected, Identification& into) {
    if (unexpected.kind == solver::FreeParameter::Kind::initial) {
        return;
    }
    std::ranges::for_each(into.fitted, doubt);
}

void doubt_input_numbers(const std::vector<solver::FreeParameter>& parameters, Identification& into) {
    std::vector<std::string> names;
    for (std::size_t j = 0; j < into.fitted.size(); ++j) {
        Fitted& one = into.fitted[j];
        const bool is_moved = one.identifiability == Identifiability::determined ||
                              one.identifiability == Identifiability::doubtful ||
                              one.identifiability == Identifiability::with_prior;
        if (parameters[j].kind == solver::FreeParameter::Kind::input && is_moved) {
            names.push_back(parameters[j].name);
            doubt(one);
        }
    }
    if (!names.empty()) {
        into.findings.push_back(remark::number_of_car(input::listed(names)));
    }
}

}  // namespace tiretherm::diagnosis
