// SPDX-License-Identifier: BSD-3-Clause
// Draws the distribution of the hottest temperature over a study's samples, with bins after Freedman and Diaconis
// (1981).

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "post/charts/study_axis.hpp"
#include "post/charts/study_plots.hpp"
#include "post/pictures/field_layout.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double top = 210.0;  // px
constexpr double bottom = 800.0;
constexpr double right = 1540.0;
constexpr int page_height = 900;
constexpr Colour red = colour(0xa00000);

/// Equal steps from a round temperature on. degC
struct Bins {
    double from = 0.0;
    double step = 1.0;
    std::vector<double> count;

    [[nodiscard]] double edge(std::size_t i) const { return from + static_cast<double>(i) * step; }
};

/// Steps of D. Freedman and P. Diaconis (1981), 2 IQR / n^(1/3), rounded to those of an axis.
Bins bins_of(const std::vector<double>& sorted) {
    const double spread = std::max(sorted.back() - sorted.front(), 1e-3);
    const double wanted =
        2.0 * (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / std::cbrt(static_cast<double>(sorted.size()));
    const int about = wanted > 0.0 ? std::clamp(static_cast<int>(spread / wanted), 4, 40) : 4;
    const Ticks round = ticks(sorted.front(), sorted.front() + spread, about);
    const double step = round.values.size() > 1 ? round.values[1] - round.values[0] : spread;
    Bins bins{.from = std::floor(sorted.front() / step) * step, .step = step, .count = {}};
    for (const double value : sorted) {
        const auto i = static_cast<std::size_t>((value - bins.from) / step);
        bins.count.resize(std::max(bins.count.size(), i + 1));
        bins.count[i] += 1.0;
    }
    return bins;
}

std::string chance_text(const StudyRecord& study) {
    const Chance c = passes_critical(study, 0);
    return fmt::format("{} of {} samples pass {:.6g} °C: {:.1f} %, 95 % interval {:.1f} to {:.1f} %", c.times, c.of,
                       solver::celsius(*study.critical), 100.0 * c.share, 100.0 * c.low, 100.0 * c.high);
}

}  // namespace

void draw_study_histogram(const std::filesystem::path& path, const StudyRecord& study) {
    const std::vector<double> sorted = hottest_at(study, 0);
    const Bins bins = bins_of(sorted);
    StudyAxis x{.name = "hottest temperature [°C]",
                .at = {},
                .labels = {},
                .low = bins.from,
                .high = bins.edge(bins.count.size())};
    if (study.critical) {
        x.low = std::min(x.low, solver::celsius(*study.critical) - bins.step);
        x.high = std::max(x.high, solver::celsius(*study.critical) + bins.step);
    }
    const double most = *std::max_element(bins.count.begin(), bins.count.end());
    const StudyAxis y{.name = "samples [-]", .at = {}, .labels = {}, .low = 0.0, .high = 1.08 * most};

    Canvas canvas(look::page_width, page_height, look::paper);
    const double left = room_left(canvas, y) + 10.0;
    const Scale across = x.scale(left, right);
    const Scale up = y.scale(bottom, top);
    std::vector<std::string> heads{
        fmt::format("Hottest temperature over the run, {}", study.case_name),
        fmt::format("{} samples: half lie below {:.1f} °C, nine tenths from {:.1f} to {:.1f} °C", sorted.size(),
                    quantile(sorted, 0.5), quantile(sorted, 0.05), quantile(sorted, 0.95))};
    if (study.critical) {
        heads.push_back(chance_text(study));
    }
    draw_heads(canvas, study, heads);
    for (const double value : y.ticks(8).values) {
        canvas.line(std::array{Dot{left, up.px(value)}, Dot{right, up.px(value)}}, look::grid, 1.5);
    }
    const Colour fill = mix(line_colours()[0], look::paper, 0.45);
    for (std::size_t i = 0; i < bins.count.size(); ++i) {
        const Dot corner{across.px(bins.edge(i)), up.px(bins.count[i])};
        const double width = across.px(bins.edge(i + 1)) - corner.x;
        canvas.rectangle(corner, width, bottom - corner.y, fill);
        canvas.frame(corner, width, bottom - corner.y, look::paper, 1.5);
    }
    if (study.critical) {
        const double place = across.px(solver::celsius(*study.critical));
        canvas.line(std::array{Dot{place, top}, Dot{place, bottom}}, red, 3.0, true);
        const bool room = place + 330.0 < right;
        canvas.write({place + (room ? 14.0 : -14.0), top + 24.0},
                     fmt::format("critical: {:.6g} °C", solver::celsius(*study.critical)),
                     {.size = look::text, .ink = red, .align = room ? Align::left : Align::right, .halo = look::paper});
    }
    canvas.frame({left, top}, right - left, bottom - top, look::ink, 1.5);
    draw_below(canvas, x, across, bottom);
    draw_left(canvas, y, up, left);
    canvas.save(path);
}

}  // namespace tiretherm::post
