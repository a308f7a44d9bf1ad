// SPDX-License-Identifier: BSD-3-Clause
// Draws the residuals of a diagnosis by channel and run, for the base model and the extended one, with the 95 % band of
// the noise.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "post/diagnosis/diagnosis_report.hpp"
#include "post/pictures/axes.hpp"
#include "post/pictures/canvas.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double panel_width = 620.0;  // px
constexpr double panel_height = 300.0;
constexpr double between = 60.0;        ///< panels of a row
constexpr double between_rows = 130.0;  ///< room for the axis below each
constexpr double left = 140.0;
constexpr double top = 170.0;
constexpr double band = 1.959964;  ///< standard deviations of the noise: 95 %
constexpr double windows = 40.0;   ///< means along a run
constexpr Colour noise_band = colour(0x888888, 0.16);
constexpr Colour base_ink = colour(0xd55e00);
constexpr Colour extended_ink = colour(0x0072b2);

/// A channel in a run: simulated less measured, in the unit of its differences.
struct Panel {
    const Block* block = nullptr;
    std::vector<double> base;
    std::vector<double> extended;  ///< empty where nothing was added
    double sigma = 0.0;
};

Colour faded(const Colour& ink) {
    Colour faint = ink;
    faint.alpha = 0.25;
    return faint;
}

std::vector<Dot> line_through(const std::vector<double>& time, const std::vector<double>& value, const Scale& x,
                              const Scale& y) {
    std::vector<Dot> dots;
    for (std::size_t i = 0; i < time.size(); ++i) {
        dots.push_back({x.px(time[i]), y.px(value[i])});
    }
    return dots;
}

/// Means over equal parts of the run, which show what the noise hides.
std::vector<Dot> means(const std::vector<double>& time, const std::vector<double>& value, const Scale& x,
                       const Scale& y) {
    struct Mean {
        double time = 0.0;
        double value = 0.0;
        double n = 0.0;
    };
    std::map<int, Mean> parts;
    const double width = (time.back() - time.front()) / windows;
    for (std::size_t i = 0; i < time.size(); ++i) {
        Mean& part = parts[width > 0.0 ? static_cast<int>((time[i] - time.front()) / width) : 0];
        part.time += time[i];
        part.value += value[i];
        part.n += 1.0;
    }
    std::vector<Dot> dots;
    for (const auto& [index, part] : parts) {
        dots.push_back({x.px(part.time / part.n), y.px(part.value / part.n)});
    }
    return dots;
}

/// Panels by channel (index into Problem::channels) and run.
std::map<std::size_t, std::map<std::size_t, Panel>> panels_of(const DiagnosisRecord& record) {
    std::map<std::size_t, std::map<std::size_t, Panel>> panels;
    const bool extended = record.result.extended != record.result.base;
    for (const Block& block : record.observations.blocks) {
        if (block.channel < 0 || block.time.empty()) {
            continue;
        }
        const Observations::Row& first = record.observations.rows[static_cast<std::size_t>(block.first)];
        const solver::Channel& channel = record.experiment.runs[first.run].problem.channels[first.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        Panel& panel = panels[first.channel][first.run];
        panel.block = &block;
        panel.sigma = unit.difference(record.result.noise[static_cast<std::size_t>(block.channel)].sigma);
        const auto rest = [&](const Eigen::VectorXd& simulated) {
            std::vector<double> values;
            for (Eigen::Index i = block.first; i < block.first + block.rows(); ++i) {
                values.push_back(unit.difference(simulated[i] - record.observations.measured[i]));
            }
            return values;
        };
        panel.base = rest(record.result.base);
        if (extended) {
            panel.extended = rest(record.result.extended);
        }
    }
    return panels;
}

/// One scale for all runs of a channel, about 0.
Scale scale_of(const std::map<std::size_t, Panel>& runs, double y) {
    double most = 0.0;
    for (const auto& [run, panel] : runs) {
        most = std::max(most, 2.0 * panel.sigma);
        for (const auto* values : {&panel.base, &panel.extended}) {
            for (const double value : *values) {
                most = std::max(most, std::abs(value));
            }
        }
    }
    return {.low = -1.05 * most, .high = 1.05 * most, .from = y + panel_height, .to = y};
}

void draw_panel(Canvas& canvas, const Panel& panel, const Scale& x, const Scale& y, const Ticks& ticks) {
    const double width = x.to - x.from;
    canvas.rectangle({x.from, y.px(band * panel.sigma)}, width, y.px(-band * panel.sigma) - y.px(band * panel.sigma),
                     noise_band);
    for (const double value : ticks.values) {
        canvas.line(std::array{Dot{x.from, y.px(value)}, Dot{x.to, y.px(value)}},
                    value == 0.0 ? look::faint : look::grid, 1.5);
    }
    std::vector<double> shown_time;
    for (const double seconds : panel.block->time) {
        shown_time.push_back(seconds / 60.0);
    }
    for (const auto& [values, ink] : {std::pair(&panel.base, base_ink), std::pair(&panel.extended, extended_ink)}) {
        if (!values->empty()) {
            canvas.line(line_through(shown_time, *values, x, y), faded(ink), 1.2);
        }
    }
    for (const auto& [values, ink] : {std::pair(&panel.base, base_ink), std::pair(&panel.extended, extended_ink)}) {
        if (!values->empty()) {
            canvas.line(means(shown_time, *values, x, y), ink, 3.5);
        }
    }
}

void draw_legend(Canvas& canvas, bool extended) {
    double x = left;
    const auto entry = [&](const std::string& text, const Colour& ink, double width) {
        canvas.line(std::array{Dot{x, 92.0}, Dot{x + 40.0, 92.0}}, ink, width);
        const Writing writing{.size = look::text, .ink = look::ink};
        canvas.write({x + 52.0, 92.0}, text, writing);
        x += 92.0 + canvas.width_of(text, writing);
    };
    entry("base model, fitted - measured", base_ink, 3.5);
    if (extended) {
        entry("extended model - measured", extended_ink, 3.5);
    }
    entry("noise, 95 %", noise_band, 20.0);
    canvas.write({x, 92.0}, "thin: every sample; thick: means over a fortieth of the run",
                 {.size = look::text, .ink = look::faint});
}

}  // namespace

void draw_residuals(const std::filesystem::path& path, const DiagnosisRecord& record) {
    const auto panels = panels_of(record);
    const std::vector<input::MeasuredRun>& runs = record.experiment.runs;
    const double row = panel_height + between_rows;
    const double width = std::max(1600.0, left + static_cast<double>(runs.size()) * (panel_width + between));
    Canvas canvas(static_cast<int>(width), static_cast<int>(top + row * static_cast<double>(panels.size())),
                  look::paper);
    const solver::Problem& problem = runs.front().problem;
    canvas.write({left, 46.0}, problem.title.empty() ? problem.name : problem.title,
                 {.size = look::title, .ink = look::ink, .bold = true});
    draw_legend(canvas, record.result.extended != record.result.base);
    double y = top;
    for (const auto& [c, in_runs] : panels) {
        const solver::Channel& channel = problem.channels[c];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        const char* unit_name = channel.quantity == solver::Quantity::temperature ? "K" : unit.name;
        const Scale vertical = scale_of(in_runs, y);
        const Ticks levels = ticks(vertical.low, vertical.high, 6);
        draw_axis_left(canvas, vertical, levels, left, fmt::format("too high [{}]", unit_name));
        for (const auto& [r, panel] : in_runs) {
            const double from = left + static_cast<double>(r) * (panel_width + between);
            const std::vector<double>& time = panel.block->time;
            const Scale x{
                .low = time.front() / 60.0, .high = time.back() / 60.0, .from = from, .to = from + panel_width};
            draw_panel(canvas, panel, x, vertical, levels);
            draw_axis_below(canvas, x, ticks(x.low, x.high, 6), y + panel_height, "time [min]");
            canvas.write({from, y - 22.0}, fmt::format("{}, {}", channel.name, runs[r].name),
                         {.size = look::text, .ink = look::ink, .bold = true});
        }
        y += row;
    }
    canvas.save(path);
}

}  // namespace tiretherm::post
