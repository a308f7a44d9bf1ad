#include <cmath>

#include <fmt/format.h>

#include "mesh/place.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "post/report/table.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr std::size_t indent = 4;

std::string minutes(double seconds) { return fmt::format("{:.1f} min", seconds / 60.0); }

/// Of a lag, which may be short.
std::string span(double seconds) { return seconds < 120.0 ? fmt::format("{:.0f} s", seconds) : minutes(seconds); }

std::string degrees(double kelvin) { return std::isnan(kelvin) ? "-" : fmt::format("{:.1f}", solver::celsius(kelvin)); }

std::string kmh(double metres_per_second) { return fmt::format("{:.0f}", 3.6 * metres_per_second); }

std::string line(const std::string& text) { return wrap(text, indent); }

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

std::string steps_table(const HotSpots& all, const HotSpot& spot) {
    Table table(std::vector<bool>(8, false));
    table.add({"step", "km/h", "N", "min", "at its end", "steady state", "surface at its end", "steady state"});
    for (std::size_t s = 0; s < all.steps.size(); ++s) {
        const solver::ScheduleStep& step = all.steps[s];
        table.add({step.ramp ? "ramp" : fmt::format("{}", step.number),
                   step.ramp ? "to " + kmh(step.speed) : kmh(step.speed), fmt::format("{:.0f}", step.load),
                   fmt::format("{:.4g}", step.duration() / 60.0), degrees(spot.at_end[s].hottest),
                   degrees(spot.steady[s].hottest), degrees(spot.at_end[s].surface), degrees(spot.steady[s].surface)});
    }
    return table.text(indent);
}

std::string surface_text(const HotSpots& all, const HotSpot& spot) {
    const std::string& name = spot.history.critical().surface_name;
    if (!spot.passing || name.empty()) {
        return {};
    }
    if (std::isnan(spot.surface_threshold)) {
        return line(fmt::format(
            "No alarm threshold for {}: {}.", name,
            all.steps.empty() ? "the speed does not come from a schedule, so the steps are not known"
                              : "no two steady states of the steps lie on either side of the critical temperature"));
    }
    const std::string threshold =
        fmt::format("In a steady state with the hot spot at its critical temperature {} would read {} degC. ", name,
                    degrees(spot.surface_threshold));
    if (std::isnan(spot.surface_time)) {
        return line(threshold + "It has not read so much by the end: it does not show what is inside.");
    }
    const double lag = spot.surface_time - spot.passing->time;
    return line(threshold + fmt::format("It passes that {} {} the hot spot passes its own.", span(std::abs(lag)),
                                        lag > 0.0 ? "after" : "before"));
}

std::string further_text(const HotSpot& spot) {
    if (!spot.further) {
        return {};
    }
    const FurtherSteps& further = *spot.further;
    if (!further.refusal.empty()) {
        return line("Not gone on with: " + further.refusal + ".");
    }
    const std::string pattern =
        fmt::format("Gone on with by {} km/h every {}, ", kmh(further.rise), minutes(further.duration));
    if (!further.passing) {
        return line(pattern + fmt::format("the test does not pass {} degC up to {} km/h; the hottest is {} degC.",
                                          degrees(spot.history.critical().temperature), kmh(further.last_speed),
                                          degrees(further.hottest)));
    }
    std::string text = pattern + fmt::format("the test passes {} degC {}", degrees(spot.history.critical().temperature),
                                             moment_text(*further.passing));
    if (spot.spread && further.kelvin_per_step > 0.0) {
        text += fmt::format("; one standard deviation is {:.1f} steps either way",
                            spot.spread->standard_deviation / further.kelvin_per_step);
    }
    return line(text + surface_then(spot, *further.passing) + ".");
}

std::string spread_text(const HotSpot& spot) {
    if (!spot.spread) {
        return {};
    }
    const solver::Spread& spread = *spot.spread;
    Table table({true, false, false, true, false, false, false});
    table.add({"what drives it", "value", "+-", "unit", "change K", "share %", "nonlinear K"});
    for (std::size_t d = 0; d < spread.drivers.size(); ++d) {
        const solver::Driver& driver = spread.drivers[d];
        table.add({driver.name, fmt::format("{:.4g}", driver.value), fmt::format("{:.3g}", driver.standard_deviation),
                   driver.unit, fmt::format("{:+.2f}", driver.kelvin), fmt::format("{:.1f}", 100.0 * spread.share(d)),
                   std::isnan(driver.nonlinearity) ? "" : fmt::format("{:+.2f}", driver.nonlinearity)});
    }
    const double critical = spot.history.critical().temperature;
    return table.text(indent) +
           line("change K: for one standard deviation; nonlinear K: deviation from a straight line.") +
           line(fmt::format("Together {} +- {:.1f} degC (one standard deviation, first order): above {} degC with a "
                            "probability of {:.1f} %.",
                            degrees(spread.mean), spread.standard_deviation, degrees(critical),
                            100.0 * spread.chance_above(critical)));
}

std::string spot_text(const HotSpots& all, const HotSpot& spot, const mesh::Mesh& mesh) {
    const solver::Critical& critical = spot.history.critical();
    const std::size_t row = spot.history.hottest_row();
    const double hottest = spot.history.temperature()[row];
    std::string text =
        fmt::format("  {}{}: critical {} degC\n", critical.name,
                    critical.part.empty() ? "" : " (" + critical.part + ")", degrees(critical.temperature));
    if (spot.passing) {
        text += line("passed " + moment_text(*spot.passing) + surface_then(spot, *spot.passing));
    }
    const double margin = critical.temperature - hottest;
    text += line(fmt::format("hottest {} degC {}", degrees(hottest), moment_text(spot.hottest)) +
                 surface_then(spot, spot.hottest) +
                 fmt::format("; {:.1f} K {}", std::abs(margin), margin > 0.0 ? "are left" : "too hot"));
    text += line("place: " + place_text(spot.history.found(row), mesh));
    if (!all.steps.empty()) {
        text += steps_table(all, spot);
    }
    return text + surface_text(all, spot) + further_text(spot) + spread_text(spot);
}

}  // namespace

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

std::string hot_spots_text(const HotSpots& hot_spots, const mesh::Mesh& mesh) {
    std::string text;
    for (const HotSpot& spot : hot_spots.spots) {
        text += spot_text(hot_spots, spot, mesh);
    }
    for (const std::string& note : hot_spots.notes) {
        text += wrap(note, 2);
    }
    return text;
}

}  // namespace tiretherm::post
