// SPDX-License-Identifier: BSD-3-Clause
// Chooses between a linear axis and equal steps, divides long numbers by powers of ten, and draws axes and titles of
// study pictures.

#include "post/charts/study_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double left_edge = 60.0;  // px

/// Whether neighbours would fall on one another on a straight axis.
bool uneven(std::vector<double> values) {
    std::ranges::sort(values);
    double least = values.back() - values.front();
    for (std::size_t i = 1; i < values.size(); ++i) {
        least = std::min(least, values[i] - values[i - 1]);
    }
    return least < 0.002 * (values.back() - values.front());
}

/// The power of ten, a multiple of three, by which long numbers are divided; 0 where they are not long.
int thousands(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::max(largest, std::abs(value));
    }
    const bool is_short = largest == 0.0 || (largest >= 0.01 && largest < 1e5);
    return is_short ? 0 : 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
}

int about(double px) { return std::clamp(static_cast<int>(px / 110.0), 2, 12); }

}  // namespace

std::vector<std::size_t> StudyAxis::order() const {
    std::vector<std::size_t> order(at.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at[a] < at[b]; });
    return order;
}

Scale StudyAxis::scale(double from, double to) const { return {.low = low, .high = high, .from = from, .to = to}; }

Ticks StudyAxis::ticks(int wanted) const { return is_number ? post::ticks(low, high, wanted) : Ticks{}; }

StudyAxis StudyAxis::in_steps() const {
    StudyAxis steps = *this;
    const std::vector<std::size_t> ranked = order();
    for (std::size_t rank = 0; rank < ranked.size(); ++rank) {
        steps.at[ranked[rank]] = static_cast<double>(rank);
    }
    steps.is_number = false;
    steps.low = -0.5;
    steps.high = static_cast<double>(at.size()) - 0.5;
    return steps;
}

StudyAxis study_axis(const StudyRecord& study, std::size_t side) {
    const StudyColumn& column = study.columns[side];
    StudyAxis axis{.name = column.heading(), .is_number = column.is_number, .at = {}, .labels = {}};
    for (std::size_t i = 0; i < study.sides[side]; ++i) {
        const std::size_t run = i * stride(study, side) * study.samples;
        axis.at.push_back(column.is_number ? column.numbers[run] : static_cast<double>(i));
        axis.labels.push_back(column.texts[run]);
    }
    if (!column.is_number || uneven(axis.at)) {
        return axis.in_steps();
    }
    const int power = thousands(axis.at);
    if (power != 0) {
        axis.name = fmt::format("{} [1e{}{}{}]", column.key, power, column.unit.empty() ? "" : " ", column.unit);
        std::ranges::for_each(axis.at, [&](double& value) { value /= std::pow(10.0, power); });
    }
    const auto [low, high] = std::ranges::minmax(axis.at);
    axis.low = low;
    axis.high = high;
    return axis;
}

std::string fitting(const Canvas& canvas, const std::string& name, double room) {
    const std::size_t dot = name.rfind('.', name.find_first_of(" ["));
    return canvas.width_of(name, {.size = look::text}) <= room || dot == std::string::npos ? name
                                                                                           : name.substr(dot + 1);
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

void draw_below(Canvas& canvas, const StudyAxis& axis, const Scale& scale, double y) {
    const double room = std::abs(scale.to - scale.from);
    draw_axis_below(canvas, scale, axis.ticks(about(room)), y, fitting(canvas, axis.name, room));
    double widest = 1.0;
    for (const std::string& label : axis.labels) {
        widest = std::max(widest, canvas.width_of(label, {.size = look::text}) + look::text);
    }
    // Where not all have room, every second one stands, or every third.
    const auto every = static_cast<std::size_t>(std::ceil(widest * static_cast<double>(axis.at.size()) / room));
    for (std::size_t i = 0; !axis.is_number && i < axis.at.size(); i += std::max<std::size_t>(1, every)) {
        canvas.write({scale.px(axis.at[i]), y + look::tick + 0.8 * look::text}, axis.labels[i],
                     {.size = look::text, .ink = look::ink, .align = Align::centre});
    }
}

void draw_left(Canvas& canvas, const StudyAxis& axis, const Scale& scale, double x) {
    const double room = std::abs(scale.to - scale.from);
    const std::string name = fitting(canvas, axis.name, room);
    if (axis.is_number) {
        draw_axis_left(canvas, scale, axis.ticks(about(1.5 * room)), x, name);
        return;
    }
    for (std::size_t i = 0; i < axis.at.size(); ++i) {
        canvas.write({x - 1.8 * look::tick, scale.px(axis.at[i])}, axis.labels[i],
                     {.size = look::text, .ink = look::ink, .align = Align::right});
    }
    canvas.write({x - room_left(canvas, axis) + look::text, 0.5 * (scale.from + scale.to)}, name,
                 {.size = look::text, .ink = look::faint, .align = Align::centre, .upwards = true});
}

double room_left(const Canvas& canvas, const StudyAxis& axis) {
    double widest = 0.0;
    const Writing writing{.size = look::text};
    const Ticks numbers = axis.ticks(12);
    for (const double value : numbers.values) {
        widest = std::max(widest, canvas.width_of(numbers.label(value), writing));
    }
    for (std::size_t i = 0; !axis.is_number && i < axis.labels.size(); ++i) {
        widest = std::max(widest, canvas.width_of(axis.labels[i], writing));
    }
    return widest + 1.8 * look::tick + 2.2 * look::text;
}

void draw_heads(Canvas& canvas, const StudyRecord& study, const std::vector<std::string>& lines) {
    canvas.write({left_edge, 40.0}, study.title, {.size = look::title, .ink = look::ink, .bold = true});
    double y = 88.0;
    for (const std::string& line : lines) {
        canvas.write({left_edge, y}, line, {.size = look::text, .ink = look::faint});
        y += 36.0;
    }
}

}  // namespace tiretherm::post
