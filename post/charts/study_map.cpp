// SPDX-License-Identifier: BSD-3-Clause
// Draws the hottest temperature over two varied quantities as a coloured map with isotherms, one panel for each value
// of the others.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "post/charts/study_plane.hpp"
#include "post/charts/study_plots.hpp"
#include "post/pictures/colour_bar.hpp"
#include "post/pictures/field_layout.hpp"
#include "post/pictures/isotherms.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr std::size_t most_dots = 600;
constexpr Colour turquoise = colour(0x35f0d0);
constexpr Colour grey = colour(0xb8b8b8);
constexpr double top = 165.0;         // px, below the heads
constexpr double line_height = 32.0;  // px, of a panel's own title
constexpr double below = 105.0;       // px, of its axis
constexpr double between = 36.0;      // px

/// The line of the critical temperature, turquoise with a dark edge, over the colours of a plane.
void trace_critical(const Raster& raster, double critical, std::vector<Colour>& colours) {
    for (int y = 0; y < raster.height; ++y) {
        for (int x = 0; x < raster.width; ++x) {
            const double distance = raster.distance(x, y, critical);
            Colour& here = colours[static_cast<std::size_t>(y) * static_cast<std::size_t>(raster.width) +
                                   static_cast<std::size_t>(x)];
            here = mix(here, colour(0x000000), 0.6 * std::clamp(4.0 - distance, 0.0, 1.0));
            here = mix(here, turquoise, std::clamp(2.6 - distance, 0.0, 1.0));
        }
    }
}

/// One panel of the picture.
class Panel {
public:
    Panel(Canvas& canvas, const StudyPlane& plane, const Dot& corner, double width, double height)
        : canvas_(canvas),
          plane_(plane),
          corner_(corner),
          width_(static_cast<int>(width)),
          height_(static_cast<int>(height)),
          x_(plane.x.scale(corner.x, corner.x + width_)),
          y_(plane.y.scale(corner.y + height_, corner.y)) {}

    void draw(double low, double high, const Ticks& levels, std::optional<double> critical) {
        const bool smooth = plane_.smooth();
        const Raster raster = rasterise(plane_, width_, height_, low, high);
        std::vector<Colour> colours =
            shade(raster, smooth ? std::span<const double>(levels.values) : std::span<const double>{});
        if (smooth && critical) {
            trace_critical(raster, *critical, colours);
        }
        canvas_.image(corner_, width_, height_, colours);
        grey_out();
        if (smooth) {
            write_levels(raster, levels, critical);
        }
        canvas_.frame(corner_, width_, height_, look::ink, 1.5);
        draw_runs(raster, critical);
        for (std::size_t i = 0; i < plane_.title.size(); ++i) {
            const double up = 22.0 + line_height * static_cast<double>(plane_.title.size() - 1 - i);
            canvas_.write({corner_.x, corner_.y - up}, fitting(canvas_, plane_.title[i], width_),
                          {.size = look::text, .ink = look::ink});
        }
        draw_below(canvas_, plane_.x, x_, corner_.y + height_);
        draw_left(canvas_, plane_.y, y_, corner_.x);
    }

private:
    struct Box {
        double left;
        double top;
        double width;
        double height;
    };

    /// What lies between a run that failed and its neighbours is not known.
    void grey_out() {
        for (std::size_t i = 0; i < plane_.x.at.size(); ++i) {
            for (std::size_t j = 0; j < plane_.y.at.size(); ++j) {
                if (!std::isfinite(plane_.at(i, j))) {
                    const auto [left, right] = reach(plane_.x, i, x_);
                    const auto [bottom, upper] = reach(plane_.y, j, y_);
                    const Dot from{std::floor(left), std::floor(upper)};
                    unknown_.push_back({from.x, from.y, std::ceil(right) - from.x, std::ceil(bottom) - from.y});
                    canvas_.rectangle(from, unknown_.back().width, unknown_.back().height, grey);
                }
            }
        }
    }

    static std::pair<double, double> reach(const StudyAxis& axis, std::size_t i, const Scale& scale) {
        if (!axis.is_number) {
            return {scale.px(axis.at[i] - 0.5), scale.px(axis.at[i] + 0.5)};
        }
        return {scale.px(axis.at[i > 0 ? i - 1 : 0]), scale.px(axis.at[std::min(i + 1, axis.at.size() - 1)])};
    }

    void write_levels(const Raster& raster, const Ticks& levels, std::optional<double> critical) {
        constexpr double size = 19.0;
        std::vector<double> wanted = levels.values;
        if (critical) {
            wanted.push_back(*critical);
            std::sort(wanted.begin(), wanted.end());
        }
        for (const LevelMark& mark : level_marks(raster, wanted, 2.0 * size)) {
            const bool limit = critical && mark.level == *critical;
            const Dot at{corner_.x + mark.place.x, corner_.y + mark.place.y};
            const auto covers = [&](const Box& box) {
                return at.x > box.left - size && at.x < box.left + box.width + size && at.y > box.top - size &&
                       at.y < box.top + box.height + size;
            };
            if (std::any_of(unknown_.begin(), unknown_.end(), covers)) {
                continue;
            }
            canvas_.write(at, limit ? fmt::format("{:.6g}", mark.level) : levels.label(mark.level),
                          {.size = size,
                           .ink = limit ? turquoise : level_ink(raster, mark.level),
                           .align = Align::centre,
                           .bold = limit,
                           .halo = limit ? colour(0x000000, 0.75) : heat_colour(raster.share(mark.level))});
        }
    }

    void draw_runs(const Raster& raster, std::optional<double> critical) {
        if (plane_.value.size() > most_dots) {
            return;
        }
        for (std::size_t i = 0; i < plane_.x.at.size(); ++i) {
            for (std::size_t j = 0; j < plane_.y.at.size(); ++j) {
                const Dot at{x_.px(plane_.x.at[i]), y_.px(plane_.y.at[j])};
                const double value = plane_.at(i, j);
                if (!std::isfinite(value)) {
                    const Writing writing{.size = 30.0, .ink = colour(0xa00000), .align = Align::centre, .bold = true};
                    canvas_.write(at, "×", writing);
                } else if (plane_.smooth()) {
                    canvas_.disc(at, 3.5, colour(0xffffff), look::ink, 1.2);
                } else {
                    const bool passes = critical && value > *critical;
                    canvas_.write(at, fmt::format("{:.1f}", value),
                                  {.size = 21.0,
                                   .ink = passes ? turquoise : level_ink(raster, value),
                                   .align = Align::centre,
                                   .bold = passes,
                                   .halo = passes ? colour(0x000000, 0.75) : heat_colour(raster.share(value))});
                }
            }
        }
    }

    Canvas& canvas_;
    const StudyPlane& plane_;
    Dot corner_;
    int width_;
    int height_;
    Scale x_;
    Scale y_;
    std::vector<Box> unknown_{};
};

std::vector<std::string> heads(const StudyRecord& study, bool smooth, double low, double high, bool more, bool failed) {
    const char* mark = smooth ? "dot" : "number";
    std::string first =
        fmt::format("Hottest temperature over the run, {}; {}", study.case_name,
                    study.is_sampled ? fmt::format("median of {} samples at each {}", study.samples, mark)
                                     : fmt::format("a {} for each run", mark));
    std::string second;
    if (study.critical) {
        const double limit = solver::celsius(*study.critical);
        const char* what = limit >= high  ? "nothing here passes the critical"
                           : limit <= low ? "all here passes the critical"
                           : smooth       ? "turquoise: the critical"
                                          : "turquoise: above the critical";
        second = fmt::format("{} {:.6g} °C", what, limit);
    }
    if (more) {
        second += std::string(second.empty() ? "" : "; ") + "other values of what else is varied are not drawn";
    }
    if (failed) {
        second += std::string(second.empty() ? "" : "; ") + "grey: next to a run that failed (×)";
    }
    return {first, second};
}

}  // namespace

void draw_study_map(const std::filesystem::path& path, const StudyRecord& study) {
    bool more = false;
    const std::vector<StudyPlane> planes = study_planes(study, more);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    bool failed = false;
    for (const StudyPlane& plane : planes) {
        for (const double value : plane.value) {
            failed = failed || !std::isfinite(value);
            low = std::isfinite(value) ? std::min(low, value) : low;
            high = std::isfinite(value) ? std::max(high, value) : high;
        }
    }
    low = std::isfinite(low) ? low : 0.0;  // all that is drawn has failed
    high = std::max(high, low + 1.0);
    Ticks levels = ticks(low, high, 9);
    const double edge = 0.02 * (high - low);
    Ticks lines = levels;
    std::erase_if(lines.values, [&](double v) {
        const bool beside_critical = study.critical && std::abs(v - solver::celsius(*study.critical)) < edge;
        return v < low + edge || v > high - edge || beside_critical;
    });

    const std::size_t columns = planes.size() == 4 ? 2 : std::min<std::size_t>(planes.size(), 3);
    const std::size_t rows = (planes.size() + columns - 1) / columns;
    const double height = planes.size() == 1 ? 720.0 : 400.0;
    const double above = 12.0 + line_height * static_cast<double>(planes.front().title.size());
    const double bottom = top + static_cast<double>(rows) * (above + height + below);
    Canvas canvas(look::page_width, static_cast<int>(bottom + 130.0), look::paper);
    draw_heads(canvas, study, heads(study, planes.front().smooth(), low, high, more, failed));
    const double left = room_left(canvas, planes.front().y) + 10.0;
    const double cell = (look::page_width - between) / static_cast<double>(columns);
    for (std::size_t p = 0; p < planes.size(); ++p) {
        const Dot corner{static_cast<double>(p % columns) * cell + left,
                         top + static_cast<double>(p / columns) * (above + height + below) + above};
        Panel(canvas, planes[p], corner, cell - left - between, height)
            .draw(low, high, lines, study.critical ? std::optional(solver::celsius(*study.critical)) : std::nullopt);
    }
    draw_colour_bar(canvas, low, high, levels, bottom + 20.0);
    canvas.save(path);
}

}  // namespace tiretherm::post
