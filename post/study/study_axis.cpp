// SPDX-License-Identifier: BSD-3-Clause
// Chooses between a linear axis and equal steps.
#include "post/study/study_axis.hpp"

#include <algorithm>
#include <numeric>

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Whether neighbours would fall on one another on a straight axis.
bool uneven(std::vector<double> values) {
    std::ranges::sort(values);
    double least = values.back() - values.front();
    for (std::size_t i = 1; i < values.size(); ++i) {
        least = std::min(least, values[i] - values[i - 1]);
    }
    return least < 0.002 * (values.back() - values.front());
}

}  // namespace

std::vector<std::size_t> StudyAxis::order() const {
    std::vector<std::size_t> order(at.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at[a] < at[b]; });
    return order;
}

StudyAxis StudyAxis::in_steps() const {
    StudyAxis steps = *this;
    const std::vector<std::size_t> ranked = order();
    for (std::size_t rank = 0; rank < ranked.size(); ++rank) {
        steps.at[ranked[rank]] = static_cast<double>(rank);
    }
    steps.is_number = false;
    steps.unit.clear();  // the labels have it
    steps.low = -0.5;
    steps.high = static_cast<double>(at.size()) - 0.5;
    return steps;
}

std::vector<std::string> StudyAxis::labels_in_order() const {
    std::vector<std::string> sorted;
    for (const std::size_t i : order()) {
        sorted.push_back(labels[i]);
    }
    return sorted;
}

StudyAxis study_axis(const StudyRecord& study, std::size_t side) {
    const StudyColumn& column = study.columns[side];
    StudyAxis axis{.name = column.key, .unit = column.unit, .is_number = column.is_number, .at = {}, .labels = {}};
    for (std::size_t i = 0; i < study.sides[side]; ++i) {
        const std::size_t run = i * stride(study, side) * study.samples;
        axis.at.push_back(column.is_number ? column.numbers[run] : static_cast<double>(i));
        axis.labels.push_back(column.texts[run]);
    }
    if (!column.is_number || uneven(axis.at)) {
        return axis.in_steps();
    }
    const auto [low, high] = std::ranges::minmax(axis.at);
    axis.low = low;
    axis.high = high;
    return axis;
}

std::vector<std::size_t> wide_sides(const StudyRecord& study) {
    std::vector<std::size_t> wide;
    for (std::size_t side = 0; side < study.sides.size(); ++side) {
        if (study.sides[side] > 1) {
            wide.push_back(side);
        }
    }
    return wide;
}

std::size_t stride(const StudyRecord& study, std::size_t side) {
    std::size_t points = 1;
    for (std::size_t later = side + 1; later < study.sides.size(); ++later) {
        points *= study.sides[later];
    }
    return points;
}

}  // namespace tiretherm::post
