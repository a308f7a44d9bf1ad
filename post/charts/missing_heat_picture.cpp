// SPDX-License-Identifier: BSD-3-Clause
// Draws the inferred missing heat as a map of place against time for each run, coloured by its standard deviations.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "post/diagnosis/diagnosis_report.hpp"
#include "post/pictures/axes.hpp"
#include "post/pictures/canvas.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double panel_width = 620.0;  // px
constexpr double row_height = 44.0;
constexpr double between = 60.0;  ///< panels
constexpr double left = 330.0;    ///< room for the names of the places
constexpr double top = 190.0;
constexpr double below = 120.0;  ///< room for the time axis
constexpr Colour more_heat = colour(0xd55e00);
constexpr Colour less_heat = colour(0x0072b2);
/// Standard deviations at which the colours are full at least, so that noise alone stays pale.
constexpr double least_full = 6.0;

Colour colour_of(double sigma, double full) {
    return mix(look::paper, sigma > 0.0 ? more_heat : less_heat, std::min(1.0, std::abs(sigma) / full));
}

void draw_legend(Canvas& canvas, double full) {
    constexpr int steps = 60;
    constexpr double width = 480.0;
    const double from = left;
    for (int i = 0; i < steps; ++i) {
        const double sigma = full * (2.0 * (i + 0.5) / steps - 1.0);
        canvas.rectangle({from + i * width / steps, 84.0}, width / steps + 0.5, 22.0, colour_of(sigma, full));
    }
    canvas.frame({from, 84.0}, width, 22.0, look::faint, 1.0);
    const Writing writing{.size = look::text, .ink = look::faint, .align = Align::centre};
    for (const double share : {-1.0, 0.0, 1.0}) {
        canvas.write({from + 0.5 * (1.0 + share) * width, 124.0},
                     share == 0.0 ? "0" : fmt::format("{:+.0f}", share * full), writing);
    }
    canvas.write({from + width + 24.0, 95.0},
                 "standard deviations; orange: heat is missing there and then, blue: too much",
                 {.size = look::text, .ink = look::faint});
}

}  // namespace

void draw_missing_heat(const std::filesystem::path& path, const DiagnosisRecord& record) {
    const std::vector<MissingHeat>& missing = record.result.missing_heat;
    const std::vector<input::MeasuredRun>& runs = record.experiment.runs;
    std::vector<std::string> places;
    double full = least_full;
    for (const MissingHeat& one : missing) {
        full = std::max(full, std::abs(one.sigma));
        if (std::ranges::find(places, one.place) == places.end()) {
            places.push_back(one.place);
        }
    }
    const double height = row_height * static_cast<double>(places.size());
    const double width = std::max(1700.0, left + static_cast<double>(runs.size()) * (panel_width + between));
    Canvas canvas(static_cast<int>(width), static_cast<int>(top + height + below), look::paper);
    const solver::Problem& problem = runs.front().problem;
    canvas.write(
        {left, 46.0},
        fmt::format("Missing heat, by place and time: {}", problem.title.empty() ? problem.name : problem.title),
        {.size = look::title, .ink = look::ink, .bold = true});
    draw_legend(canvas, full);
    for (std::size_t p = 0; p < places.size(); ++p) {
        canvas.write({left - 20.0, top + (static_cast<double>(p) + 0.5) * row_height}, places[p],
                     {.size = look::text, .ink = look::ink, .align = Align::right});
    }
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const double from = left + static_cast<double>(r) * (panel_width + between);
        const solver::Settings& settings = runs[r].problem.settings;
        const Scale x{
            .low = settings.start / 60.0, .high = settings.end / 60.0, .from = from, .to = from + panel_width};
        for (const MissingHeat& one : missing) {
            if (one.run == r) {
                const auto row = static_cast<double>(std::ranges::find(places, one.place) - places.begin());
                const double y = top + row * row_height;
                const double begin = x.px(one.from / 60.0);
                const double end = x.px(one.to / 60.0);
                canvas.tile(
                    std::array{Dot{begin, y}, Dot{end, y}, Dot{end, y + row_height}, Dot{begin, y + row_height}},
                    colour_of(one.sigma, full));
            }
        }
        canvas.frame({from, top}, panel_width, height, look::faint, 1.0);
        for (std::size_t p = 1; p < places.size(); ++p) {
            const double y = top + static_cast<double>(p) * row_height;
            canvas.line(std::array{Dot{from, y}, Dot{from + panel_width, y}}, look::grid, 1.5);
        }
        draw_axis_below(canvas, x, ticks(x.low, x.high, 6), top + height, "time [min]");
        canvas.write({from, top - 24.0}, runs[r].name, {.size = look::text, .ink = look::ink, .bold = true});
    }
    canvas.save(path);
}

}  // namespace tiretherm::post
