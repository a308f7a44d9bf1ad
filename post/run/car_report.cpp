// SPDX-License-Identifier: BSD-3-Clause
// The runs of a car's tires on one page, and their channels in one table.
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "diagnosis/study/study_record.hpp"
#include "mesh/place.hpp"
#include "physics/celsius.hpp"
#include "post/laps/heat_by_lap.hpp"
#include "post/page/page_origin.hpp"
#include "post/report/csv.hpp"
#include "post/report/file.hpp"
#include "post/report/remark_text.hpp"
#include "post/run/run_sections.hpp"
#include "solver/channel_unit.hpp"
#include "solver/compared_ranges.hpp"

namespace tiretherm::post {

namespace {

/// The readings of all tires, a corner behind each channel.
DataTable readings_by_corner(std::span<const RunRecord> runs) {
    DataTable table;
    for (const RunRecord& run : runs) {
        Value unused;
        const DataTable own = readings(run, unused);
        for (const DataTable::Row& row : own.rows()) {
            DataTable::Row line{page_only("corner", &row == &own.rows().front() ? run.corner : "")};
            line.insert(line.end(), row.begin(), row.end());
            table.add_to_page(std::move(line));
        }
    }
    return table;
}

/// "FL, nearest of the tires to a critical temperature: belt edge 117.0 +- 4.1 degC: below its critical 120 degC with a
/// probability of 77 %; hottest 117.0 degC, tread, centre, at 620 s."
std::string hottest_of(const RunRecord& run, bool is_first) {
    const solver::MarchReport::Extreme& hottest = run.report.hottest;
    const std::optional<NearestSpot> spot = nearest_spot(run);
    const char* first = spot ? ", nearest of the tires to a critical temperature" : ", hottest of the tires";
    return fmt::format("{}{}: {}{:.1f} degC, {}, at {:.6g} s.", run.corner, is_first ? first : "",
                       spot ? spot->verdict + "; hottest " : "", celsius(hottest.temperature),
                       mesh::describe_place(run.problem.mesh, hottest.node), hottest.time);
}

/// What the tires come to, the one first that is nearest to a critical temperature, or where there is none the hottest.
std::vector<std::string> verdict_of(std::span<const RunRecord> runs) {
    std::vector<const RunRecord*> order;
    for (const RunRecord& run : runs) {
        if (run.history.rows() > 0 && run.report.hottest.node >= 0) {
            order.push_back(&run);
        }
    }
    std::ranges::stable_sort(order, {}, [](const RunRecord* run) {
        const std::optional<NearestSpot> spot = nearest_spot(*run);
        return spot ? spot->below : -run->report.hottest.temperature;
    });
    std::vector<std::string> verdict;
    for (const RunRecord* run : order) {
        verdict.push_back(hottest_of(*run, run == order.front()));
    }
    return verdict;
}

std::string case_title(const solver::Problem& problem) {
    return problem.title.empty() || problem.title == problem.name ? problem.name
                                                                  : fmt::format("{} ({})", problem.title, problem.name);
}

}  // namespace

Report car_report(std::span<const RunRecord> runs, const diagnosis::WhatIf* what_if, std::vector<std::string> warnings,
                  const std::vector<std::filesystem::path>& files) {
    const RunRecord& first = runs.front();
    Report page{.title = case_title(first.problem)};
    Value::List corners;
    std::vector<LapRow> laps;
    std::vector<diagnosis::RunHeat> heat;
    std::vector<std::vector<solver::RangeWarning>> left;
    solver::Extrapolations extrapolations;
    double seconds = 0.0;
    for (const RunRecord& run : runs) {
        seconds += run.seconds;
        extrapolations.add(run.problem);
        Value data{{"corner", run.corner}};
        data.set(run_report(run).data);
        corners.push_back(std::move(data));
        left.push_back(run.report.warnings);
        if (run.history.rows() == 0) {
            continue;
        }
        std::ranges::move(lap_rows(run), std::back_inserter(laps));
        heat.push_back(heat_of(run));
    }
    page.verdict = verdict_of(runs);
    std::ranges::move(extrapolations.headline(), std::back_inserter(page.verdict));
    page.lead.push_back(
        fmt::format("{} tires, simulated in {:.3g} s. Each has its folder with a page of its own: field, heat against "
                    "time, hot spots.",
                    runs.size(), seconds));
    page.data = {{"case", first.problem.name},
                 {"title", first.problem.title},
                 {"version", first.provenance.version},
                 {"seconds", seconds},
                 {"corners", std::move(corners)}};
    ReportSection sensors("Sensors", readings_by_corner(runs));
    add_channel_charts(sensors, runs);
    page.add(std::move(sensors));
    if (!first.problem.settings.steady) {
        page.add(lap_section(laps));
        page.add(heat_by_lap_section(heat, "Friction power and heat"));
        add_lap_data(page.data, laps);
        page.data.set("heat", heat_by_lap_data(heat));
    }
    if (what_if != nullptr) {
        page.add(what_if_section(*what_if, first.problem.channels));
        page.data.set("what_if", what_if_data(*what_if, first.problem.channels));
    }
    page.appendix.push_back(citations_section(first.problem));
    std::ranges::move(texts_of(diagnosis::left_ranges(left)), std::back_inserter(warnings));
    page.add_warnings(std::move(warnings), extrapolations.warnings());
    page.add("Cite", "sources", first.problem.sources);
    page.add(files);
    return page;
}

std::vector<std::filesystem::path> write_car_tables(const std::filesystem::path& directory,
                                                    std::span<const RunRecord> runs) {
    std::vector<std::string> headings{"time [s]"};
    std::vector<double> times;
    std::vector<LapRow> laps;
    std::vector<diagnosis::RunHeat> heat;
    for (const RunRecord& run : runs) {
        times.insert(times.end(), run.history.time().begin(), run.history.time().end());
        for (const solver::Channel& channel : run.problem.channels) {
            headings.push_back(
                fmt::format("{} {} [{}]", channel.name, run.corner, solver::shown_unit(channel.quantity).name));
        }
        std::ranges::move(lap_rows(run), std::back_inserter(laps));
        heat.push_back(heat_of(run));
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    Csv csv(headings);
    for (const double t : times) {
        csv.add(Digits{t, 12});
        for (const RunRecord& run : runs) {
            for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
                const solver::ShownUnit unit = solver::shown_unit(run.problem.channels[c].quantity);
                csv.add(Decimals{unit.value(run.history.at(c, t)), 4});
            }
        }
        csv.end_row();
    }
    std::vector<std::filesystem::path> files;
    const auto write = [&](const char* name, const std::string& text) {
        replace_file(files.emplace_back(directory / name), text);
    };
    write("channels.csv", csv.text());
    if (!runs.front().problem.settings.steady) {
        write(laps_name, laps_csv(laps));
        write(heat_name, heat_csv(heat));
    }
    return files;
}

}  // namespace tiretherm::post
