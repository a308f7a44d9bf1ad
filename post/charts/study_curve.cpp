// SPDX-License-Identifier: BSD-3-Clause
// Draws the hottest temperature against one varied quantity; with samples the median and the range of nine tenths of
// them.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "post/charts/study_axis.hpp"
#include "post/charts/study_plots.hpp"
#include "post/pictures/field_layout.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double top = 175.0;  // px
constexpr double bottom = 800.0;
constexpr double right = 1540.0;
constexpr int page_height = 900;
constexpr Colour red = colour(0xa00000);

/// What the runs at a place of the axis came to. degC
struct Station {
    double x = 0.0;
    bool failed = true;  ///< all of them
    double low = 0.0;    ///< nine tenths of the samples lie between low and high
    double middle = 0.0;
    double high = 0.0;
};

std::vector<Station> stations_of(const StudyRecord& study, const StudyAxis& axis, std::size_t side) {
    std::vector<Station> stations;
    for (const std::size_t i : axis.order()) {
        const std::vector<double> hottest = hottest_at(study, i * stride(study, side));
        Station station{.x = axis.at[i], .failed = hottest.empty()};
        if (!hottest.empty()) {
            station.low = quantile(hottest, 0.05);
            station.middle = quantile(hottest, 0.5);
            station.high = quantile(hottest, 0.95);
        }
        stations.push_back(station);
    }
    return stations;
}

/// From tick to tick about all that is drawn. @returns the axis as numbers
StudyAxis temperature_axis(const StudyRecord& study, const std::vector<Station>& stations) {
    double low = study.critical ? solver::celsius(*study.critical) : 1e300;
    double high = study.critical ? solver::celsius(*study.critical) : -1e300;
    for (const Station& station : stations) {
        low = station.failed ? low : std::min(low, station.low);
        high = station.failed ? high : std::max(high, station.high);
    }
    const double margin = std::max(0.08 * (high - low), 0.5);
    return {.name = "hottest temperature [°C]", .at = {}, .labels = {}, .low = low - margin, .high = high + margin};
}

void draw_grid(Canvas& canvas, const Scale& across, const StudyAxis& x, const Scale& up, const StudyAxis& y) {
    for (const double value : x.ticks(10).values) {
        canvas.line(std::array{Dot{across.px(value), top}, Dot{across.px(value), bottom}}, look::grid, 1.5);
    }
    for (const double value : y.ticks(8).values) {
        canvas.line(std::array{Dot{across.from, up.px(value)}, Dot{right, up.px(value)}}, look::grid, 1.5);
    }
}

}  // namespace

void draw_study_curve(const std::filesystem::path& path, const StudyRecord& study) {
    const std::size_t side = wide_sides(study).front();
    const StudyAxis x = study_axis(study, side);
    const std::vector<Station> stations = stations_of(study, x, side);
    const StudyAxis y = temperature_axis(study, stations);
    Canvas canvas(look::page_width, page_height, look::paper);
    const double left = room_left(canvas, y) + 10.0;
    // Runs at the ends stand inside the frame, with their marks whole.
    const Scale across = x.scale(left + 30.0, right - 30.0);
    const Scale up = y.scale(bottom, top);
    draw_grid(canvas, across, x, up, y);

    std::vector<std::string> heads{fmt::format("Hottest temperature over the run, {}", study.case_name)};
    if (study.is_sampled) {
        heads.push_back(fmt::format("median of {} samples; nine tenths of them lie in the band", study.samples));
    }
    draw_heads(canvas, study, heads);
    const Colour line = line_colours()[0];
    std::vector<Dot> middle;
    std::vector<Dot> band;
    for (const Station& station : stations) {
        if (!station.failed) {
            middle.push_back({across.px(station.x), up.px(station.middle)});
            band.push_back({across.px(station.x), up.px(station.low)});
        }
    }
    for (auto station = stations.rbegin(); station != stations.rend(); ++station) {
        if (!station->failed) {
            band.push_back({across.px(station->x), up.px(station->high)});
        }
    }
    if (study.is_sampled && x.is_number) {
        canvas.tile(band, mix(line, look::paper, 0.75));
    }
    if (study.critical) {
        const double level = up.px(solver::celsius(*study.critical));
        canvas.line(std::array{Dot{left, level}, Dot{right, level}}, red, 3.0, true);
        canvas.write({left + 14.0, level - 20.0}, fmt::format("critical: {:.6g} °C", solver::celsius(*study.critical)),
                     {.size = look::text, .ink = red, .halo = look::paper});
    }
    if (x.is_number) {
        canvas.line(middle, line, 3.5);
    }
    for (const Station& station : stations) {
        if (station.failed) {
            canvas.write({across.px(station.x), bottom - 24.0}, "× failed",
                         {.size = look::text, .ink = red, .align = Align::centre, .bold = true});
            continue;
        }
        if (study.is_sampled) {
            canvas.line(std::array{Dot{across.px(station.x), up.px(station.low)},
                                   Dot{across.px(station.x), up.px(station.high)}},
                        line, 3.0);
        }
        canvas.disc({across.px(station.x), up.px(station.middle)}, 7.0, look::paper, line, 3.5);
    }
    canvas.frame({left, top}, right - left, bottom - top, look::ink, 1.5);
    draw_below(canvas, x, across, bottom);
    draw_left(canvas, y, up, left);
    canvas.save(path);
}

}  // namespace tiretherm::post
