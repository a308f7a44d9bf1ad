// SPDX-License-Identifier: BSD-3-Clause
// Channels against time: the one chart of every page that shows them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "input/laps/laps.hpp"
#include "post/page/charts.hpp"
#include "post/report/report.hpp"
#include "solver/channel_unit.hpp"
#include "solver/input_signals.hpp"

namespace tiretherm::post {

/// Values against time.
struct TimeCurve {
    std::string name;
    CurveRole role = CurveRole::line;
    std::vector<double> time;   ///< [points] s
    std::vector<double> value;  ///< [points] SI; not finite ones are gaps
};

/// Measured values or ranges at single moments.
struct TimeRanges {
    std::vector<double> time;  ///< [points] s
    std::vector<double> low;   ///< [points] SI
    std::vector<double> high;  ///< [points] SI
};

/// A value with a name: a level, or a point of a curve.
struct TimeMark {
    std::string name;
    double value = 0.0;  ///< SI
    double time = 0.0;   ///< s; of a level without meaning
};

/// One channel with all that belongs to it, in one colour.
struct TimeSeries {
    std::string channel;
    solver::ShownUnit unit;
    std::string panel{};    ///< its name; empty: "temperature", of another unit the first channel
    bool is_input = false;  ///< in a panel of inputs
    std::vector<TimeCurve> curves{};
    TimeRanges measured{};
    std::vector<TimeMark> levels{};
    std::vector<TimeMark> marks{};
    std::vector<TimeCurve> differences{};  ///< in a low panel below
    double noise = 0.0;  ///< SI, standard deviation; drawn as its 95 % about the differences; 0: not known
};

struct TimeChart {
    std::vector<TimeSeries> series{};
    std::optional<std::pair<double, double>> axis{};  ///< s, its ends; without them those of the curves
    std::string difference = "simulated - measured";
    const solver::InputSignals* inputs = nullptr;  ///< whose steps are bands; null: not shown
    bool has_input_panels = true;
    std::span<const input::Lap> laps{};  ///< of a circuit; bands in the place of steps
    std::size_t curves_of_page = 0;      ///< of all charts, which share the points of a page; 0: those of this one
};

/// Adds the chart: a panel for each unit in the order of the first, the differences below it, the inputs that change at the
/// bottom. All charts over time of a page zoom together. Nothing where the curves have no length.
/// @param caption a sentence behind it says what the bands are
void add_time_chart(ReportSection& section, const std::string& title, const std::string& caption, TimeChart chart);

}  // namespace tiretherm::post
