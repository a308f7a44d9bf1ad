// SPDX-License-Identifier: BSD-3-Clause
// Names of additions, the values at which they are simulated, and cubics between these.

#include <array>

#include "diagnosis/quoted/addition.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace tiretherm::diagnosis::quoted {

namespace {

/// Slope at a node of the parabola through it and its neighbours, or the next two at an end; of two nodes the line.
double slope(const std::vector<double>& x, const std::vector<std::vector<double>>& y, std::size_t row, std::size_t i) {
    const auto line = [&](std::size_t a) { return (y[a + 1][row] - y[a][row]) / (x[a + 1] - x[a]); };
    if (x.size() == 2) {
        return line(0);
    }
    const std::size_t first = std::clamp(i, std::size_t{1}, x.size() - 2) - 1;
    const double bend = (line(first + 1) - line(first)) / (x[first + 2] - x[first]);
    return line(first) + bend * (2.0 * x[i] - x[first] - x[first + 1]);
}

}  // namespace

double Addition::value(std::size_t i) const {
    if (!is_fitted()) {
        return 1.0;
    }
    return low + (high - low) * static_cast<double>(i) / static_cast<double>(n_values - 1);
}

double Addition::penalty(double value) const {
    const double side = value > absent ? high - absent : absent - low;
    return is_fitted() && value != absent && side > 0.0 ? 4.0 * (value - absent) * (value - absent) / (side * side)
                                                        : 0.0;
}

std::vector<std::vector<double>> Addition::table() const {
    std::vector<std::vector<double>> all;
    if (!is_fitted()) {
        return {changes.back()};
    }
    for (std::size_t v = 0; v < n_values; ++v) {
        const double at = value(v);
        const auto above = std::clamp(static_cast<std::ptrdiff_t>(std::ranges::upper_bound(nodes, at) - nodes.begin()),
                                      std::ptrdiff_t{1}, static_cast<std::ptrdiff_t>(nodes.size()) - 1);
        const auto i = static_cast<std::size_t>(above) - 1;
        const double step = nodes[i + 1] - nodes[i];
        const double w = (at - nodes[i]) / step;
        std::vector<double>& row = all.emplace_back();
        for (std::size_t r = 0; r < changes.front().size(); ++r) {
            row.push_back((1.0 + 2.0 * w) * (1.0 - w) * (1.0 - w) * changes[i][r] +
                          w * (1.0 - w) * (1.0 - w) * step * slope(nodes, changes, r, i) +
                          w * w * (3.0 - 2.0 * w) * changes[i + 1][r] +
                          w * w * (w - 1.0) * step * slope(nodes, changes, r, i + 1));
        }
    }
    return all;
}

std::string Addition::name() const {
    switch (kind) {
        case AdditionKind::effect:
        case AdditionKind::number:
            return fmt::format("{}.{}{}", id, key, what.empty() ? "" : " (" + what + ")");
        case AdditionKind::mesh:
            return "mesh: " + what;
        case AdditionKind::input:
            return "input " + id;
        case AdditionKind::instrument:
            return fmt::format("{} of {}", key, id);
    }
    return id;
}

std::vector<double> trial_nodes(double absent, double low, double high) {
    std::vector<double> nodes{absent};
    for (const double end : {low, high}) {
        for (const double share : {0.4, 1.0}) {
            nodes.push_back(absent + share * (end - absent));
        }
    }
    std::ranges::sort(nodes);
    const double width = high - low;
    nodes.erase(std::unique(nodes.begin(), nodes.end(), [&](double a, double b) { return b - a < 1e-9 * width; }),
                nodes.end());
    return nodes;
}

}  // namespace tiretherm::diagnosis::quoted
