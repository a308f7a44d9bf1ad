// SPDX-License-Identifier: BSD-3-Clause
// A run as a report: readings beside measured values, extremes, hot spots, heat budget, cost.
#include "post/run/run_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "input/text/word_lists.hpp"
#include "mesh/place.hpp"
#include "physics/celsius.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "post/laps/heat_by_lap.hpp"
#include "post/page/charts.hpp"
#include "post/page/page_origin.hpp"
#include "post/report/number_text.hpp"
#include "post/run/measured_values.hpp"
#include "post/run/run_sections.hpp"
#include "post/run/tire_laws.hpp"
#include "solver/channel_unit.hpp"
#include "solver/compared_ranges.hpp"

namespace tiretherm::post {

namespace {

/// Beyond this nothing of a tire is left, and a run that did not come to its end has left what its laws hold for. K
constexpr double beyond_any_tire = 5000.0;

/// Whether a run failed in temperatures that mean nothing.
bool is_meaningless(const solver::MarchReport& report) {
    const auto strange = [](const solver::MarchReport::Extreme& extreme) {
        return extreme.node >= 0 && !(extreme.temperature >= 0.0 && extreme.temperature <= beyond_any_tire);
    };
    return !report.status.ok() && report.status.outcome != solver::Outcome::stopped &&
           (strange(report.hottest) || strange(report.coldest));
}

DataTable extremes(const RunRecord& run) {
    DataTable table;
    const auto add = [&](const char* name, const solver::MarchReport::Extreme& extreme) {
        if (extreme.node >= 0) {
            const std::string degrees = with_decimals(celsius(extreme.temperature), 2) + " degC";
            table.add({page_only("", name), page_only("", right(degrees)),
                       page_only("", fmt::format("at {:.6g} s", extreme.time)),
                       page_only("", mesh::describe_place(run.problem.mesh, extreme.node))});
        }
    };
    add("hottest", run.report.hottest);
    add("coldest", run.report.coldest);
    return table;
}

/// What rows that are far apart leave out of the channels' courses: named where a temperature goes further between two rows
/// than in all of them. Its extremes are of every step.
std::string missed_between_rows(const RunRecord& run) {
    constexpr double noticed = 1.0;         // K
    constexpr double noticed_share = 0.05;  // of all that the channel changes by
    double most = 0.0;
    std::size_t where = 0;
    for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
        if (run.problem.channels[c].quantity != solver::Quantity::temperature) {
            continue;
        }
        const std::vector<double> rows = run.history.channel(c);
        const auto [low, high] = std::ranges::minmax(rows);
        const double missed = std::max(run.report.channel_max[c] - high, low - run.report.channel_min[c]);
        if (missed > std::max(noticed, noticed_share * (run.report.channel_max[c] - run.report.channel_min[c])) &&
            missed > most) {
            most = missed;
            where = c;
        }
    }
    return most == 0.0 ? ""
                       : fmt::format(
                             "The output interval of {:.4g} s misses peaks of {} by up to {:.1f} K: charts and files "
                             "do not show them. A smaller `output` under [time] does.",
                             run.problem.settings.output_interval, run.problem.channels[where].name, most);
}

Value extreme(const RunRecord& run, const solver::MarchReport::Extreme& found) {
    const mesh::Place place = mesh::place_of(run.problem.mesh, found.node);
    Value position;  // null for a lump
    if (place.position) {
        const auto [x, y, depth] = *place.position;
        position = {{"x", 1e3 * x}, {"y", 1e3 * y}, {"depth", 1e3 * depth}, {"unit", "mm"}};
    }
    return {{"temperature", celsius(found.temperature)},
            {"unit", "degC"},
            {"time", found.time},
            {"layer", place.layer},
            {"zone", text_or_null(place.zone)},
            {"patch", place.patch},
            {"position", position}};
}

Value budget(const RunRecord& run) {
    Value::List list;
    for (std::size_t e = 0; e < run.problem.effects.size(); ++e) {
        Value effect{{"effect", run.problem.effects[e].title()},
                     {"watts_final", run.problem.symmetry * run.report.watts[e]},
                     {"joules", run.problem.symmetry * run.report.joules[e]}};
        if (std::isfinite(run.report.law_watts[e])) {
            effect.set("law_watts_final", run.problem.symmetry * run.report.law_watts[e]);
        }
        list.push_back(std::move(effect));
    }
    return list;
}

Value seconds_by_part(const solver::MarchReport& report) {
    constexpr std::array parts{"assembly", "factor", "solve", "output"};
    Value data;
    for (std::size_t i = 0; i < std::min(parts.size(), report.seconds.size()); ++i) {
        data.set(parts[i], report.seconds[i]);
    }
    return data;
}

void add_results(Report& page, const RunRecord& run) {
    const mesh::Mesh& mesh = run.problem.mesh;
    ReportSection section("Sensors", readings(run, page.data));
    section.add(extremes(run));
    if (const std::string missed = missed_between_rows(run); !missed.empty()) {
        section.say(missed);
    }
    add_channel_charts(section, std::span(&run, 1));
    if (is_meaningless(run.report)) {
        ReportSection nothing("Results");
        nothing.say(fmt::format(
            "No valid results: temperatures reached {:.3g} degC, beyond the range of all laws of a tire. What the rows "
            "have up to there is in channels.csv and results.h5. Look for a power, a film or a time in the wrong unit",
            celsius(run.report.hottest.temperature)));
        page.sections.push_back(std::move(nothing));
    } else {
        page.add(std::move(section));
    }
    if (run.laps.size() > 1 && !run.problem.settings.steady) {
        const std::vector<LapRow> laps = lap_rows(run);
        page.add(lap_section(laps));
        add_lap_data(page.data, laps);
        page.add(heat_by_lap_section({heat_of(run)}, "Friction power and heat by lap"));
        page.data.set("heat", heat_by_lap_data({heat_of(run)}));
    }
    page.data.set({{"budget", budget(run)},
                   {"stored_joules", run.problem.symmetry * run.report.stored},
                   {"symmetry", run.problem.symmetry},
                   {"hottest", extreme(run, run.report.hottest)},
                   {"coldest", extreme(run, run.report.coldest)}});
    if (run.fields != nullptr && !run.fields->empty()) {
        ReportSection field("Temperature field");
        field.chart("Temperature field", run.fields->caption(run.hot_spots), run.fields->chart(run.hot_spots));
        if (const TreadFrames* tread = run.fields->tread()) {
            field.chart("Tread, unrolled", tread->caption(), tread->chart());
        }
        page.add(std::move(field));
    }
    if (run.hot_spots != nullptr) {
        page.add(hot_spots_section(*run.hot_spots, mesh));
        page.data.set("hot_spots", hot_spots_data(*run.hot_spots, mesh));
    }
    if (!is_meaningless(run.report)) {
        ReportSection heat = heat_budget_section(run);
        add_heat_course(heat, run);
        add_heat_charts(heat, run);
        page.add(std::move(heat));
    }
}

/// "Simulated - measured: spot +6.2 K, liner within the range." Empty where nothing was measured.
std::string measured_sentence(const RunRecord& run) {
    constexpr std::size_t most = 4;
    std::vector<std::string> parts;
    for (const Comparison& c : compare(run.problem, run.history)) {
        const solver::Channel& channel = run.problem.channels[c.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        parts.push_back(c.difference == 0.0 && c.low < c.high
                            ? channel.name + " within the range"
                            : fmt::format("{} {:+.3g} {}", channel.name, unit.difference(c.difference),
                                          difference_unit(unit.name)));
    }
    const std::size_t left_out = parts.size() - std::min(parts.size(), most);
    parts.resize(parts.size() - left_out);
    return parts.empty() ? ""
                         : fmt::format("Simulated - measured: {}{}.", fmt::join(parts, ", "),
                                       left_out > 0 ? fmt::format(", {} more below", left_out) : "");
}

/// Whether a hot spot passes its critical temperature, and how sure that is.
std::string spot_verdict(const diagnosis::HotSpot& spot) {
    const solver::Critical& critical = spot.history.critical();
    const double level = celsius(critical.temperature);
    std::string text;
    if (spot.spread) {
        const double above = spot.spread->chance_above(critical.temperature);
        text = fmt::format("{} {:.1f} +- {:.1f} degC: {} its critical {:.5g} degC with a probability of {}",
                           critical.name, celsius(spot.spread->mean), spot.spread->standard_deviation,
                           above > 0.5 ? "above" : "below", level, probability_text(std::max(above, 1.0 - above)));
        text += spot.passing ? "; it passes " + moment_text(*spot.passing) : "";
    } else {
        const double peak = spot.hottest.temperature;
        text = fmt::format("{} comes to {:.1f} degC ", critical.name, celsius(peak));
        text += spot.passing ? fmt::format("and passes its critical {:.5g} degC {}", level, moment_text(*spot.passing))
                             : fmt::format("and stays {:.1f} K below its critical {:.5g} degC",
                                           critical.temperature - peak, level);
        text += "; no uncertainty was computed (see [[uncertain]])";
    }
    return text;
}

/// Of each hot spot whether and when it passes its critical temperature, the hottest place of the run, and what was measured.
std::vector<std::string> verdict_of(const RunRecord& run, const solver::Extrapolations& extrapolations) {
    std::vector<std::string> verdict;
    const solver::MarchReport::Extreme& hottest = run.report.hottest;
    if (hottest.node < 0 || is_meaningless(run.report)) {
        return verdict;
    }
    const TimeUnit unit = time_unit(run.report.simulated);
    const mesh::Place place = mesh::place_of(run.problem.mesh, hottest.node);
    const std::string where = in_words(place.layer + (place.zone.empty() ? "" : ", " + place.zone));
    for (const diagnosis::HotSpot& spot :
         run.hot_spots != nullptr ? run.hot_spots->spots : std::vector<diagnosis::HotSpot>{}) {
        verdict.push_back(spot_verdict(spot) + ".");
    }
    if (run.hot_spots != nullptr) {
        std::ranges::move(extrapolations.headline(), std::back_inserter(verdict));
    }
    verdict.push_back(fmt::format(
        "Hottest: {:.1f} degC in {}{}.", celsius(hottest.temperature), where,
        run.problem.settings.steady ? "" : fmt::format(", after {:.4g} {}", hottest.time / unit.seconds, unit.name)));
    if (std::string measured = measured_sentence(run); !measured.empty()) {
        verdict.push_back(std::move(measured));
    }
    return verdict;
}

}  // namespace

std::optional<NearestSpot> nearest_spot(const RunRecord& run) {
    std::optional<NearestSpot> nearest;
    for (const diagnosis::HotSpot& spot :
         run.hot_spots != nullptr ? run.hot_spots->spots : std::vector<diagnosis::HotSpot>{}) {
        const double peak = spot.spread ? spot.spread->mean : spot.hottest.temperature;
        const double below = spot.history.critical().temperature - peak;
        if (!nearest || below < nearest->below) {
            nearest = {.below = below, .verdict = spot_verdict(spot)};
        }
    }
    return nearest;
}

Report run_report(const RunRecord& run) {
    const solver::MarchReport& report = run.report;
    const std::string& name = run.problem.name;
    const std::string& title = run.problem.title;
    Report page{.title = title.empty() || title == name ? name : fmt::format("{} ({})", title, name)};
    if (run.runs.size() > 1) {
        std::vector<std::string> others = run.runs;
        std::erase(others, run.run);
        page.lead.push_back(fmt::format("run {}, one of {}; the others are {} (--run NAME)", run.run, run.runs.size(),
                                        input::listed(others)));
    }
    page.data = {{"case", name},
                 {"title", title},
                 {"run", text_or_null(run.run)},
                 {"version", run.provenance.version},
                 {"cells", run.problem.mesh.n_cells},
                 {"steps", report.steps},
                 {"rejected", report.rejected},
                 {"factorisations", report.factorisations},
                 {"newton_iterations", report.newton_iterations},
                 {"linear_iterations", report.linear_iterations},
                 {"linear_solver", report.linear_solver},
                 {"seconds", run.seconds},
                 {"seconds_by_part", seconds_by_part(report)},
                 {"simulated_seconds", report.simulated},
                 {"energy_closure", report.energy_closure},
                 // W/K; null where it has no meaning
                 {"effective_two_node_conductance", run.problem.symmetry * report.effective_two_node_conductance}};
    if (run.history.rows() > 0) {
        add_results(page, run);
    }
    if (run.what_if != nullptr) {
        page.add(what_if_section(*run.what_if, run.problem.channels));
        page.data.set("what_if", what_if_data(*run.what_if, run.problem.channels));
    }
    solver::Extrapolations extrapolations;
    extrapolations.add(run.problem);
    page.verdict = verdict_of(run, extrapolations);
    if (!report.status.ok()) {
        page.verdict.insert(page.verdict.begin(), "ended early: " + report.status.message);
    }
    page.add(tire_laws_section(run.problem));
    if (Value tire = tire_laws_data(run.problem); tire.held().index() != 0) {
        page.data.set("tire", std::move(tire));
    }
    page.appendix.push_back(citations_section(run.problem));
    page.add(cost_section(run));
    std::vector<std::string> warnings = run.warnings;
    std::ranges::transform(report.warnings, std::back_inserter(warnings), &solver::RangeWarning::text);
    page.add_warnings(std::move(warnings), extrapolations.warnings());
    page.add("Cite", "sources", run.problem.sources);
    page.add(run.files);
    if (!report.status.ok()) {
        page.data.set({{"error", report.status.message}, {"errors", Value::List{}}, {"mistakes", Value::List{}}});
    }
    return page;
}

}  // namespace tiretherm::post
