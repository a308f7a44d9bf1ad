// SPDX-License-Identifier: BSD-3-Clause
// The hot spots of a run as a section of its page and as data.
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "mesh/place.hpp"
#include "physics/celsius.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "post/page/time_chart.hpp"
#include "post/report/number_text.hpp"
#include "post/report/remark_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

std::string minutes(double seconds) { return fmt::format("{:.1f} min", seconds / 60.0); }

/// Of a lag, which may be short.
std::string span(double seconds) { return seconds < 120.0 ? fmt::format("{:.0f} s", seconds) : minutes(seconds); }

std::string degrees(double kelvin) { return std::isnan(kelvin) ? "-" : fmt::format("{:.1f}", celsius(kelvin)); }

std::string kmh(double metres_per_second) { return fmt::format("{:.0f}", 3.6 * metres_per_second); }

/// degC; a dash, and null, where nobody knows.
Cell celsius_cell(double kelvin) { return shown("{:.1f}", celsius(kelvin)); }

/// Where the hot spot is, between the cells.
std::string place_text(const solver::HotSpotFinder::Found& found, const mesh::Mesh& mesh) {
    const mesh::Place place = mesh::place_of(mesh, found.node);
    std::string text = place.layer;
    if (!place.zone.empty()) {
        text += fmt::format(", {}, {:.1f} mm along the meridian", place.zone, 1e3 * found.point[0]);
    }
    return place.position ? text + fmt::format(", {:.2f} mm deep", 1e3 * found.point[2]) : text;
}

std::string surface_then(const HotSpot& spot, const TestMoment& moment) {
    return std::isnan(moment.surface) ? std::string()
                                      : fmt::format("; at that moment {} reads {} degC",
                                                    spot.history.critical().surface_name, degrees(moment.surface));
}

DataTable steps(const HotSpots& all, const HotSpot& spot) {
    DataTable table;
    // A run that failed has not come to its last steps.
    const std::size_t known = std::min({all.steps.size(), spot.at_end.size(), spot.steady.size()});
    for (std::size_t s = 0; s < known; ++s) {
        const solver::ScheduleStep& step = all.steps[s];
        const std::string speed = (step.ramp ? "to " : "") + kmh(step.speed);
        table.add({{"step", "step", {step.number, step.ramp ? "ramp" : fmt::format("{}", step.number)}},
                   data_only("ramp", step.ramp),
                   data_only("from", step.from),
                   data_only("to", step.to),
                   {"km/h", "speed", {3.6 * step.speed, speed}},
                   {"N", "vertical_load", shown("{:.0f}", step.load)},
                   page_only("min", shown("{:.4g}", step.duration() / 60.0)),
                   {"at its end", "hottest_at_end", celsius_cell(spot.at_end[s].hottest)},
                   {"steady state", "hottest_steady", celsius_cell(spot.steady[s].hottest)},
                   {"surface at its end", "surface_at_end", celsius_cell(spot.at_end[s].surface)},
                   {"steady state", "surface_steady", celsius_cell(spot.steady[s].surface)}});
    }
    return table;
}

std::string surface_text(const HotSpots& all, const HotSpot& spot) {
    const std::string& name = spot.history.critical().surface_name;
    if (!spot.passing || name.empty()) {
        return {};
    }
    if (std::isnan(spot.surface_threshold)) {
        return fmt::format("No alarm threshold for {}: {}.", name,
                           all.steps.empty()
                               ? "the speed is logged, and no steps of constant speed and load were recognised in it"
                               : "no two steady states of the steps lie on either side of the critical temperature");
    }
    const std::string threshold =
        fmt::format("In a steady state with the hot spot at its critical temperature {} would read {} degC. ", name,
                    degrees(spot.surface_threshold));
    if (std::isnan(spot.surface_time)) {
        return threshold + "It stays below that until the end: the sensor does not reveal the hot spot.";
    }
    const double lag = spot.surface_time - spot.passing->time;
    return threshold + fmt::format("It passes that {} {} the hot spot passes its own.", span(std::abs(lag)),
                                   lag > 0.0 ? "after" : "before");
}

std::string further_text(const HotSpot& spot) {
    if (!spot.further) {
        return {};
    }
    const FurtherSteps& further = *spot.further;
    if (!further.refusal.empty()) {
        return "Not continued: " + further.refusal + ".";
    }
    const std::string pattern =
        fmt::format("Continued in steps of {} km/h every {}, ", kmh(further.rise), minutes(further.duration));
    if (!further.passing) {
        return pattern + fmt::format("the test does not pass {} degC up to {} km/h; the hottest is {} degC.",
                                     degrees(spot.history.critical().temperature), kmh(further.last_speed),
                                     degrees(further.hottest));
    }
    std::string text = pattern + fmt::format("the test passes {} degC {}", degrees(spot.history.critical().temperature),
                                             moment_text(*further.passing));
    if (spot.spread && further.kelvin_per_step > 0.0) {
        text += fmt::format("; one standard deviation is {:.1f} steps either way",
                            spot.spread->standard_deviation / further.kelvin_per_step);
    }
    return text + surface_then(spot, *further.passing) + ".";
}

DataTable drivers(const solver::Spread& spread) {
    DataTable table;
    for (std::size_t d = 0; d < spread.drivers.size(); ++d) {
        const solver::Driver& driver = spread.drivers[d];
        const bool checked = !std::isnan(driver.nonlinearity);
        const bool is_number = !std::isnan(driver.value);
        table.add({{"what drives it", "name", driver.name},
                   data_only("unit", driver.unit),
                   {"value", "value", {driver.value, is_number ? fmt::format("{:.4g}", driver.value) : "alternative"}},
                   {"+-",
                    "standard_deviation",
                    {driver.standard_deviation, is_number ? fmt::format("{:.3g}", driver.standard_deviation) : ""}},
                   page_only("unit", slashed_unit(driver.unit)),
                   {"change K", "kelvin", shown("{:+.2f}", driver.kelvin)},
                   {"share %", "share", {spread.share(d), fmt::format("{:.1f}", 100.0 * spread.share(d))}},
                   {"nonlinear K",
                    "nonlinearity",
                    {driver.nonlinearity, checked ? fmt::format("{:+.2f}", driver.nonlinearity) : ""}}});
    }
    return table;
}

void say_spread(ReportSection& section, const solver::Spread& spread, double critical) {
    section.add(drivers(spread));
    section.say("change K: for one standard deviation; nonlinear K: deviation from a straight line.");
    section.say(
        fmt::format("Together {} +- {:.1f} degC (one standard deviation, first order): above {} degC with a "
                    "probability of {}.",
                    degrees(spread.mean), spread.standard_deviation, degrees(critical),
                    probability_text(spread.chance_above(critical))));
}

ReportSection spot_part(const HotSpots& all, const HotSpot& spot, const mesh::Mesh& mesh) {
    const solver::Critical& critical = spot.history.critical();
    const std::size_t row = spot.history.hottest_row();
    const double hottest = spot.hottest.temperature;
    const double margin = critical.temperature - hottest;
    ReportSection part(fmt::format("{}{}: critical {} degC", critical.name,
                                   critical.part.empty() ? "" : " (" + critical.part + ")",
                                   degrees(critical.temperature)));
    if (spot.passing) {
        part.say("passed " + moment_text(*spot.passing) + surface_then(spot, *spot.passing));
    }
    part.say(fmt::format("hottest {} degC {}{}; {:.1f} K {}", degrees(hottest), moment_text(spot.hottest),
                         surface_then(spot, spot.hottest), std::abs(margin), margin > 0.0 ? "are left" : "too hot"));
    part.say("place: " + place_text(spot.history.found(row), mesh));
    part.add(steps(all, spot));
    part.say(surface_text(all, spot));
    part.say(further_text(spot));
    if (spot.spread) {
        say_spread(part, *spot.spread, critical.temperature);
    }
    return part;
}

Value moment(const TestMoment& moment) {
    Value data{{"time", where(!moment.steady, moment.time)},
               {"speed", 3.6 * moment.speed},
               {"speed_unit", "km/h"},
               {"vertical_load", moment.load},
               {"surface", celsius(moment.surface)}};
    if (moment.step) {
        data.set({{"step", moment.step->number},
                  {"ramp", moment.step->ramp},
                  {"into_step", moment.time - moment.step->from}});
    }
    return data;
}

Value moment(const std::optional<TestMoment>& one) { return one ? moment(*one) : Value(); }

Value surface(const HotSpot& spot) {
    const bool both = spot.passing && !std::isnan(spot.surface_time);
    return {{"reading", spot.history.critical().surface_name},
            {"threshold", celsius(spot.surface_threshold)},
            {"time", spot.surface_time},
            {"lag", both ? Value(spot.surface_time - spot.passing->time) : Value()}};
}

Value further(const HotSpot& spot) {
    if (!spot.further) {
        return {};
    }
    const FurtherSteps& further = *spot.further;
    return {{"refusal", text_or_null(further.refusal)}, {"rise", 3.6 * further.rise},
            {"step_duration", further.duration},        {"passed", moment(further.passing)},
            {"last_speed", 3.6 * further.last_speed},   {"kelvin_per_step", further.kelvin_per_step}};
}

Value uncertainty(const HotSpot& spot) {
    if (!spot.spread) {
        return {};
    }
    return {{"mean", celsius(spot.spread->mean)},
            {"standard_deviation", spot.spread->standard_deviation},
            {"chance_above_critical", spot.spread->chance_above(spot.history.critical().temperature)},
            {"drivers", drivers(*spot.spread).data()}};
}

/// The hottest places and the surfaces above them against time, with the critical temperatures.
void add_history_chart(ReportSection& section, const HotSpots& hot_spots) {
    if (hot_spots.spots.empty() || hot_spots.spots.front().history.time().size() < 2) {
        return;
    }
    const std::vector<double>& time = hot_spots.spots.front().history.time();
    TimeChart chart;
    std::set<std::string> drawn;
    for (const HotSpot& spot : hot_spots.spots) {
        const solver::Critical& critical = spot.history.critical();
        TimeSeries series{.channel = critical.name, .unit = solver::shown_unit(solver::Quantity::temperature)};
        if (drawn.insert(critical.name).second) {
            series.curves.push_back({critical.name, CurveRole::line, time, spot.history.temperature()});
        }
        if (!critical.surface_name.empty() && drawn.insert(critical.surface_name).second) {
            series.curves.push_back({critical.surface_name, CurveRole::dashed, time, spot.history.surface()});
        }
        series.levels = {{fmt::format("{}: critical {:.6g} °C", critical.name, celsius(critical.temperature)),
                          critical.temperature}};
        chart.series.push_back(std::move(series));
    }
    add_time_chart(section, "Hot spots against time", "Solid: the hottest place; dashed: the surface above it.",
                   std::move(chart));
}

}  // namespace

std::string probability_text(double probability) {
    return probability < 0.01   ? "less than 1 %"
           : probability > 0.99 ? "more than 99 %"
                                : fmt::format("{:.1f} %", 100.0 * probability);
}

std::string moment_text(const TestMoment& moment) {
    const std::string when = fmt::format("after {}", minutes(moment.time));
    const std::string how = fmt::format("{} km/h, {:.0f} N", kmh(moment.speed), moment.load);
    if (moment.steady) {
        return fmt::format("in the steady state of {}", how);
    }
    if (!moment.step) {
        return fmt::format("{}, at {}", when, how);
    }
    const double into = moment.time - moment.step->from;
    if (moment.step->ramp) {
        return fmt::format("{}, {} up the ramp to step {} ({})", when, minutes(into), moment.step->number, how);
    }
    return fmt::format("{}, {} into step {} ({})", when, minutes(into), moment.step->number, how);
}

ReportSection hot_spots_section(const HotSpots& hot_spots, const mesh::Mesh& mesh) {
    ReportSection section("Hot spots");
    for (const HotSpot& spot : hot_spots.spots) {
        section.add(spot_part(hot_spots, spot, mesh));
    }
    add_history_chart(section, hot_spots);
    for (const std::string& note : texts_of(hot_spots.notes)) {
        section.say(note);
    }
    return section;
}

Value hot_spots_data(const HotSpots& hot_spots, const mesh::Mesh& mesh) {
    Value::List list;
    for (const HotSpot& spot : hot_spots.spots) {
        const solver::Critical& critical = spot.history.critical();
        const solver::HotSpotFinder::Found& found = spot.history.found(spot.history.hottest_row());
        const mesh::Place place = mesh::place_of(mesh, found.node);
        const Value position{{"along", 1e3 * found.point[0]}, {"depth", 1e3 * found.point[2]}, {"unit", "mm"}};
        list.push_back({{"name", critical.name},
                        {"part", critical.part},
                        {"critical", celsius(critical.temperature)},
                        {"unit", "degC"},
                        {"hottest", celsius(spot.hottest.temperature)},
                        {"margin", critical.temperature - spot.hottest.temperature},
                        {"layer", place.layer},
                        {"zone", text_or_null(place.zone)},
                        {"position", where(place.position.has_value(), position)},
                        {"hottest_moment", moment(spot.hottest)},
                        {"passed", moment(spot.passing)},
                        {"steps", steps(hot_spots, spot).data()},
                        {"surface", surface(spot)},
                        {"further_steps", further(spot)},
                        {"uncertainty", uncertainty(spot)}});
    }
    return {{"spots", list}, {"notes", texts_of(hot_spots.notes)}};
}

}  // namespace tiretherm::post
