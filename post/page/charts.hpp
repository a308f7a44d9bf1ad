// SPDX-License-Identifier: BSD-3-Clause
// Data of the charts of a page, in the units that are shown, as report.js takes them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "post/report/value.hpp"

namespace tiretherm::post {

/// Seconds, minutes or hours, whichever gives an axis without large numbers.
struct TimeUnit {
    const char* name;
    double seconds;
};
/// @param span s
[[nodiscard]] TimeUnit time_unit(double span);

/// A unit as it is written beside an axis: "degC" as °C.
[[nodiscard]] std::string axis_unit(std::string_view unit);

/// How a curve is drawn.
enum class CurveRole { line, dashed, dotted, faint, points };

/// Curves above one another over one axis. Of a long curve the lowest and the highest value of each of some hundred pieces are
/// kept, so that no peak is lost; numbers have six digits.
class LineChart {
public:
    /// @param x name of the shared axis  @param unit as it is shown  @param low, high ends of the axis, in this unit
    LineChart(std::string x, std::string unit, double low, double high);

    /// The shared axis has places 0, 1, ... with names in the place of numbers.
    /// @param notes longer names for who points at a place; empty: none
    void set_labels(const std::vector<std::string>& labels, const std::vector<std::string>& notes = {});
    /// A further panel below those that are there; what follows goes into it. @param is_short a low one, of residuals or inputs
    void add_panel(std::string name, std::string unit, bool is_short = false);
    /// @param group curves of one group have one colour; empty: the name  @param x, y [points], not finite ones are gaps
    void add_curve(const std::string& name, const std::string& group, CurveRole role, std::span<const double> x,
                   std::span<const double> y);
    /// Ranges at single places. @param x, low, high [points]
    void add_ranges(const std::string& name, const std::string& group, std::span<const double> x,
                    std::span<const double> low, std::span<const double> high);
    /// The area between two curves. @param x, low, high [points]
    void add_band(const std::string& name, const std::string& group, std::span<const double> x,
                  std::span<const double> low, std::span<const double> high);
    /// A horizontal line with a name.
    void add_level(const std::string& name, double value);
    /// A point with a name, such as the moment at which a level is passed.
    void add_mark(const std::string& name, const std::string& group, double x, double y);
    /// A part of the shared axis with a name: a step, a lap, a run. Without a name it is shaded alike.
    void add_span(const std::string& name, double from, double to);
    /// Of many curves fewer points each are shown, so that a page stays small. Holds for later curves.
    void share_points(std::size_t in_all, std::size_t curves) {
        most_points_ = std::clamp<std::size_t>(in_all / std::max<std::size_t>(curves, 1), 200, 2400);
    }
    /// Charts of one page with the same link zoom and show their cursors together.
    void set_link(std::string link) { link_ = std::move(link); }

    [[nodiscard]] bool empty() const { return panels_.empty(); }
    [[nodiscard]] Value data() const;

private:
    struct Panel {
        std::string name;
        std::string unit;
        bool is_short = false;
        Value::List series{};
        Value::List levels{};
        Value::List marks{};
    };
    void add_areas(const std::string& role, const std::string& name, const std::string& group,
                   std::span<const double> x, std::span<const double> low, std::span<const double> high);

    Value axis_;
    std::vector<Panel> panels_;
    std::size_t most_points_ = 2400;  ///< more than a wide screen has pixels
    Value::List spans_;
    std::string link_;
};

/// A value with a name, and its interval where there is one.
struct Bar {
    std::string name;
    double value = 0.0;
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    bool is_marked = false;  ///< stands out: in the set
};

/// Signed values by name. @param what the values are, "heat"  @param unit as it is shown  @param levels lines with a name
[[nodiscard]] Value bar_chart(std::string_view what, std::string_view unit, const std::vector<Bar>& bars,
                              const std::vector<Bar>& levels = {});

/// Several values of each name side by side. Not finite: no bar.
struct BarGroup {
    std::string name;
    std::vector<double> values;  ///< [series]
};
/// @param series what the values of each name are: "before", "after"
[[nodiscard]] Value grouped_bar_chart(std::string_view what, std::string_view unit,
                                      const std::vector<std::string>& series, const std::vector<BarGroup>& groups,
                                      const std::vector<Bar>& levels = {});

/// Each value as a chart shows it: in other units.
template <typename Convert>
[[nodiscard]] std::vector<double> converted(std::vector<double> values, Convert convert) {
    for (double& value : values) {
        value = convert(value);
    }
    return values;
}
[[nodiscard]] inline std::vector<double> scaled(std::vector<double> values, double factor) {
    return converted(std::move(values), [&](double value) { return factor * value; });
}

/// A step of 1, 2, 2.5 or 5 times a power of ten, no smaller than the one that is asked for. @pre about > 0
[[nodiscard]] double round_step(double about);

/// A number with so many digits as a chart shows.
[[nodiscard]] double rounded(double value, int digits = 6);

}  // namespace tiretherm::post
