// SPDX-License-Identifier: BSD-3-Clause
// Exact integrals of piecewise linear basis functions over an interval, and the grouping of scattered points into rows
// of equal coordinate.

#include "physics/field_transfer/field_line.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>

namespace tiretherm::physics {

namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<double> FieldLine::integrals(double low, double high) const {
    const std::size_t n = at_.size();
    std::vector<double> found(n);
    const auto part = [&](double from, double to) { return std::max(0.0, std::min(to, high) - std::max(from, low)); };
    found.front() += part(n > 1 ? at_[0] - 0.5 * (at_[1] - at_[0]) : -boundless, at_.front());
    found.back() += part(at_.back(), n > 1 ? at_[n - 1] + 0.5 * (at_[n - 1] - at_[n - 2]) : boundless);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const double width = part(at_[i], at_[i + 1]);
        if (width > 0.0) {
            const double middle = 0.5 * (std::max(low, at_[i]) + std::min(high, at_[i + 1]));
            const double share = (middle - at_[i]) / (at_[i + 1] - at_[i]);
            found[i] += width * (1.0 - share);
            found[i + 1] += width * share;
        }
    }
    return found;
}

std::vector<FieldRow> rows_of(std::size_t n, const std::vector<double>& by, const std::vector<double>& then) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto value = [](const std::vector<double>& of, std::size_t i) { return of.empty() ? 0.0 : of[i]; };
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return value(by, i); });
    std::vector<FieldRow> rows;
    for (const std::size_t i : order) {
        if (rows.empty() || value(by, i) - rows.back().at > same_place) {
            rows.push_back({.at = value(by, i), .points = {}});
        }
        rows.back().points.push_back(i);
    }
    for (FieldRow& row : rows) {
        std::ranges::stable_sort(row.points, {}, [&](std::size_t i) { return value(then, i); });
    }
    return rows;
}

std::vector<double> values_of(const std::vector<FieldRow>& rows) {
    std::vector<double> values;
    std::ranges::transform(rows, std::back_inserter(values), &FieldRow::at);
    return values;
}

Places places_of(const FieldRow& row, const std::vector<double>& coordinate) {
    Places places;
    for (const std::size_t i : row.points) {
        const double x = coordinate.empty() ? 0.0 : coordinate[i];
        if (places.at.empty() || x - places.at.back() > same_place) {
            places.at.push_back(x);
            places.together.push_back(0.0);
        }
        places.of.push_back(places.at.size() - 1);
        places.together.back() += 1.0;
    }
    return places;
}

}  // namespace tiretherm::physics
