// SPDX-License-Identifier: BSD-3-Clause
// Differences in units of the uncertainty (within 2 u), verdicts at the ends of the ranges of unknown inputs, and
// bias, rms and scatter of a model.

#include <algorithm>
#include <cmath>

#include "diagnosis/validation/validation_table.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double within = 2.0;  ///< u: the usual expanded uncertainty, 95 % of a normal distribution

}  // namespace

bool ValidationRow::is_open() const { return is_measured && std::isinf(high - low); }

std::optional<double> difference(const ValidationRow& row, std::size_t model) {
    const std::optional<double>& value = row.models[model].value;
    return row.is_measured && value ? std::optional(*value - std::clamp(*value, row.low, row.high)) : std::nullopt;
}

Reach reach(const ValidationRow& row, std::size_t model) {
    const double value = row.models[model].value.value();
    Reach found;
    double widest = 0.0;
    for (const InputEffect& input : row.inputs) {
        double down = 0.0;
        double up = 0.0;
        for (const std::optional<double>& end : input.at_ends[model]) {
            down = std::max(down, end ? value - *end : 0.0);
            up = std::max(up, end ? *end - value : 0.0);
        }
        const double change = std::max(down, up);
        found.down = std::hypot(found.down, down);
        found.up = std::hypot(found.up, up);
        found.spread = std::hypot(found.spread, change / std::sqrt(3.0));
        if (change > widest) {
            widest = change;
            found.widest = input.name;
        }
    }
    return found;
}

double total_uncertainty(const ValidationRow& row, std::size_t model) {
    return std::hypot(row.uncertainty, reach(row, model).spread);
}

std::optional<double> sensitivity(const InputEffect& input, std::size_t model) {
    const std::vector<std::optional<double>>& ends = input.at_ends[model];
    return input.numbers.size() == 2 && ends.size() == 2 && ends[0] && ends[1]
               ? std::optional((*ends[1] - *ends[0]) / (input.numbers[1] - input.numbers[0]))
               : std::nullopt;
}

Judgement judge(const ValidationRow& row, std::size_t model) {
    const ModelValue& found = row.models[model];
    const auto lost = [&](const InputEffect& input) {
        return std::ranges::any_of(input.at_ends[model], [](const auto& end) { return !end.has_value(); });
    };
    if (found.applicable && (!found.value || std::ranges::any_of(row.inputs, lost))) {
        return Judgement::no_result;
    }
    const std::optional<double> off = difference(row, model);
    if (!off) {
        return Judgement::none;
    }
    if (std::ranges::any_of(row.inputs, &InputEffect::inferred_from_it)) {
        return Judgement::not_decidable;
    }
    const Reach by_inputs = reach(row, model);
    const double lowest = *found.value - by_inputs.down;
    const double highest = *found.value + by_inputs.up;
    if (row.is_open()) {
        const bool low_holds = lowest > row.low && lowest < row.high;
        const bool high_holds = highest > row.low && highest < row.high;
        return low_holds != high_holds ? Judgement::not_decidable : low_holds ? Judgement::passes : Judgement::fails;
    }
    const double margin = within * row.uncertainty;
    if (lowest >= row.low - margin && highest <= row.high + margin) {
        return Judgement::passes;
    }
    const bool outside = lowest > row.high + margin || highest < row.low - margin;
    return outside && std::abs(*off) > within * total_uncertainty(row, model) ? Judgement::fails
                                                                              : Judgement::not_decidable;
}

ModelFigures figures(const ValidationRecord& record, std::size_t model, bool common) {
    ModelFigures result;
    double sum = 0.0;
    double squares = 0.0;
    double explained = 0.0;
    for (const ValidationRow& row : record.rows) {
        const std::optional<double> off = difference(row, model);
        const Judgement judgement = judge(row, model);
        const auto decided = [&](std::size_t m) {
            const Judgement other = judge(row, m);
            return other == Judgement::passes || other == Judgement::fails;
        };
        bool everywhere = true;
        for (std::size_t m = 0; m < row.models.size(); ++m) {
            everywhere = everywhere && row.models[m].value.has_value() && (!row.is_measured || decided(m));
        }
        result.not_decidable += judgement == Judgement::not_decidable ? 1 : 0;
        if (!decided(model) || (common && !everywhere)) {
            continue;
        }
        if (row.is_open()) {
            ++result.orders;
            result.holding += judgement == Judgement::passes ? 1 : 0;
        } else if (row.unit == "degC") {
            const double u = total_uncertainty(row, model);
            ++result.temperatures;
            result.within += judgement == Judgement::passes ? 1 : 0;
            sum += *off;
            squares += *off * *off;
            explained += u * u;
        }
    }
    if (result.temperatures > 0) {
        const auto n = static_cast<double>(result.temperatures);
        result.bias = sum / n;
        result.rms = std::sqrt(squares / n);
        result.scatter = std::sqrt(std::max(0.0, squares / n - result.bias * result.bias - explained / n));
    }
    return result;
}

}  // namespace tiretherm::diagnosis
