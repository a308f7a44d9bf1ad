// SPDX-License-Identifier: BSD-3-Clause
// Differences in units of the measurement's uncertainty (within 2 u), verdicts in words, and bias, rms and scatter of a
// model.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/validation/validation_table.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double within = 2.0;  ///< u: the usual expanded uncertainty, 95 % of a normal distribution

/// What a number that is too large is, and one that is too small.
std::pair<const char*, const char*> words(const std::string& unit) {
    if (unit == "degC") {
        return {"hot", "cold"};
    }
    if (unit == "s") {
        return {"late", "early"};
    }
    return {"large", "small"};
}

}  // namespace

bool ValidationRow::is_open() const { return is_measured && std::isinf(high - low); }

std::optional<double> difference(const ValidationRow& row, std::size_t model) {
    const std::optional<double>& value = row.models[model].value;
    return row.is_measured && value ? std::optional(*value - std::clamp(*value, row.low, row.high)) : std::nullopt;
}

std::string verdict(const ValidationRow& row, std::size_t model) {
    const ModelValue& found = row.models[model];
    if (found.applicable && !found.value) {
        return "failed";
    }
    const std::optional<double> off = difference(row, model);
    if (!off) {
        return "";
    }
    if (row.is_open()) {
        return *off == 0.0 && *found.value != row.low && *found.value != row.high ? "holds" : "does not hold";
    }
    const double score = std::abs(*off) / row.uncertainty;
    if (score <= within) {
        return *off == 0.0 ? "within" : fmt::format("within ({:.1f} u)", score);
    }
    const auto [large, small] = words(row.unit);
    return fmt::format("{:.1f} u too {}", score, *off > 0.0 ? large : small);
}

ModelFigures figures(const ValidationRecord& record, std::size_t model, bool common) {
    ModelFigures result;
    double sum = 0.0;
    double squares = 0.0;
    double measured_squares = 0.0;
    for (const ValidationRow& row : record.rows) {
        const bool everywhere =
            std::all_of(row.models.begin(), row.models.end(), [](const ModelValue& m) { return m.value.has_value(); });
        const std::optional<double> off = difference(row, model);
        if (!off || (common && !everywhere)) {
            continue;
        }
        if (row.is_open()) {
            ++result.orders;
            result.holding += verdict(row, model) == "holds" ? 1 : 0;
        } else if (row.unit == "degC") {
            ++result.temperatures;
            result.within += std::abs(*off) <= within * row.uncertainty ? 1 : 0;
            sum += *off;
            squares += *off * *off;
            measured_squares += row.uncertainty * row.uncertainty;
        }
    }
    if (result.temperatures > 0) {
        const auto n = static_cast<double>(result.temperatures);
        result.bias = sum / n;
        result.rms = std::sqrt(squares / n);
        result.scatter = std::sqrt(std::max(0.0, squares / n - result.bias * result.bias - measured_squares / n));
    }
    return result;
}

}  // namespace tiretherm::diagnosis
