// SPDX-License-Identifier: BSD-3-Clause
// Draws the temperature channels of a run against time, with the measured values beside them.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "post/page/charts.hpp"
#include "post/pictures/axes.hpp"
#include "post/pictures/picture.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr int page_width = 1600;  // px
constexpr int page_height = 820;
constexpr double left = 130.0;
constexpr double top = 100.0;
constexpr double bottom = 720.0;

/// The channels that are temperatures; the others have other units.
std::vector<std::size_t> temperatures(const solver::Problem& problem) {
    std::vector<std::size_t> found;
    for (std::size_t c = 0; c < problem.channels.size(); ++c) {
        if (problem.channels[c].quantity == solver::Quantity::temperature) {
            found.push_back(c);
        }
    }
    return found;
}

bool is_temperature(const solver::Problem& problem, const solver::Measured& measured) {
    return std::ranges::any_of(temperatures(problem),
                               [&](std::size_t c) { return problem.channels[c].name == measured.channel; });
}

/// Lowest and highest temperature to be shown, rounded outwards to ticks. degC
Scale temperature_scale(const solver::Problem& problem, const History& history) {
    double low = 1e300;
    double high = -1e300;
    const auto include = [&](double kelvin) {
        low = std::min(low, solver::celsius(kelvin));
        high = std::max(high, solver::celsius(kelvin));
    };
    for (const std::size_t c : temperatures(problem)) {
        std::ranges::for_each(history.channel(c), include);
    }
    for (const solver::Measured& measured : problem.measured) {
        if (is_temperature(problem, measured)) {
            include(measured.low);
            include(measured.high);
        }
    }
    const double least = std::max(high - low, 1.0);  // an even temperature is drawn as a straight line, not as noise
    const double step = ticks(low, low + least, 8).values.size() > 1
                            ? ticks(low, low + least, 8).values[1] - ticks(low, low + least, 8).values[0]
                            : least;
    return {.low = std::floor(low / step) * step,
            .high = std::ceil((low + least) / step) * step,
            .from = bottom,
            .to = top};
}

Colour line_colour(std::size_t channel) { return line_colours()[channel % line_colours().size()]; }

void draw_measured(Canvas& canvas, const solver::Problem& problem, const Scale& time, const Scale& temperature,
                   TimeUnit unit) {
    for (const solver::Measured& measured : problem.measured) {
        for (const std::size_t c : temperatures(problem)) {
            const double t = measured.time / unit.seconds;
            if (measured.channel != problem.channels[c].name || t < time.low || t > time.high) {
                continue;
            }
            const Dot low{time.px(t), temperature.px(solver::celsius(measured.low))};
            const Dot high{low.x, temperature.px(solver::celsius(measured.high))};
            canvas.line(std::array{low, high}, line_colour(c), 4.0);
            for (const Dot& end : {low, high}) {
                canvas.disc(end, 8.0, look::paper, line_colour(c), 4.0);
            }
        }
    }
}

/// Names at the right ends of the lines, pushed apart where they would cover one another.
void draw_names(Canvas& canvas, const solver::Problem& problem, const History& history, double x,
                const Scale& temperature) {
    struct Name {
        std::size_t channel;
        double y;
    };
    std::vector<Name> names;
    for (const std::size_t c : temperatures(problem)) {
        names.push_back({c, temperature.px(solver::celsius(history.channel(c).back()))});
    }
    std::ranges::sort(names, {}, &Name::y);
    constexpr double apart = 1.35 * look::text;
    for (std::size_t i = 1; i < names.size(); ++i) {
        names[i].y = std::max(names[i].y, names[i - 1].y + apart);
    }
    for (std::size_t i = names.size(); i-- > 0;) {
        const double limit = i + 1 == names.size() ? bottom : names[i + 1].y - apart;
        names[i].y = std::min(names[i].y, limit);
    }
    for (const Name& name : names) {
        canvas.write({x + 24.0, name.y}, problem.channels[name.channel].name,
                     {.size = look::text, .ink = line_colour(name.channel), .bold = true});
    }
}

double widest_name(const Canvas& canvas, const solver::Problem& problem) {
    double widest = 0.0;
    for (const solver::Channel& channel : problem.channels) {
        widest = std::max(widest, canvas.width_of(channel.name, {.size = look::text, .bold = true}));
    }
    return widest;
}

}  // namespace

void draw_channels(const std::filesystem::path& path, const solver::Problem& problem, const History& history) {
    Canvas canvas(page_width, page_height, look::paper);
    const double right = page_width - widest_name(canvas, problem) - 50.0;
    const TimeUnit unit = time_unit(history.time().back() - history.time().front());
    const Scale time{.low = history.time().front() / unit.seconds,
                     .high = history.time().back() / unit.seconds,
                     .from = left,
                     .to = right};
    const Scale temperature = temperature_scale(problem, history);
    const Ticks time_ticks = ticks(time.low, time.high, 10);
    const Ticks temperature_ticks = ticks(temperature.low, temperature.high, 8);

    canvas.write({left, 46.0}, problem.title.empty() ? problem.name : problem.title,
                 {.size = look::title, .ink = look::ink, .bold = true});
    for (const double t : time_ticks.values) {
        canvas.line(std::array{Dot{time.px(t), top}, Dot{time.px(t), bottom}}, look::grid, 1.5);
    }
    for (const double T : temperature_ticks.values) {
        canvas.line(std::array{Dot{left, temperature.px(T)}, Dot{right, temperature.px(T)}}, look::grid, 1.5);
    }
    for (const std::size_t c : temperatures(problem)) {
        std::vector<Dot> dots;
        const std::vector<double> kelvin = history.channel(c);
        for (std::size_t row = 0; row < kelvin.size(); ++row) {
            dots.push_back({time.px(history.time()[row] / unit.seconds), temperature.px(solver::celsius(kelvin[row]))});
        }
        canvas.line(dots, line_colour(c), 3.5);
    }
    draw_measured(canvas, problem, time, temperature, unit);
    draw_names(canvas, problem, history, right, temperature);
    if (!problem.measured.empty()) {
        const Writing writing{.size = look::text, .ink = look::faint, .align = Align::right};
        canvas.write({right, top - 26.0}, "measured", writing);
        canvas.disc({right - canvas.width_of("measured", writing) - 20.0, top - 26.0}, 8.0, look::paper, look::faint,
                    4.0);
    }
    draw_axis_below(canvas, time, time_ticks, bottom, fmt::format("time [{}]", unit.name));
    draw_axis_left(canvas, temperature, temperature_ticks, left, "temperature [°C]");
    canvas.save(path);
}

}  // namespace tiretherm::post
