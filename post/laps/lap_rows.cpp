// SPDX-License-Identifier: BSD-3-Clause
// Sorts the rows by channel, lap and run into tables and charts.

#include "post/laps/lap_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "physics/vehicle/vehicle.hpp"
#include "post/page/charts.hpp"
#include "post/report/csv.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

namespace {

/// Longer tables are for spreadsheets.
constexpr std::size_t most_rows = 60;

using Rows = std::vector<const LapRow*>;

template <typename Key>
std::vector<std::string> in_order(const Rows& rows, Key key) {
    std::vector<std::string> names;
    for (const LapRow* row : rows) {
        if (std::string name = key(*row); std::ranges::find(names, name) == names.end()) {
            names.push_back(std::move(name));
        }
    }
    return names;
}

std::vector<std::string> runs_of(const Rows& rows) {
    return in_order(rows, [](const LapRow& row) { return row.run; });
}

std::vector<Rows> by_channel(const std::vector<LapRow>& rows) {
    Rows all;
    for (const LapRow& row : rows) {
        all.push_back(&row);
    }
    std::vector<Rows> channels;
    for (const std::string& channel : in_order(all, [](const LapRow& row) { return row.channel; })) {
        Rows& own = channels.emplace_back();
        std::ranges::copy_if(all, std::back_inserter(own), [&](const LapRow* row) { return row->channel == channel; });
    }
    return channels;
}

std::vector<std::string> laps_of(const Rows& rows) {
    std::vector<std::vector<input::Lap>> laps(1);
    for (const LapRow* row : rows) {
        if (row->lap) {
            laps.front().push_back(*row->lap);
        }
    }
    return names_of_laps(laps);
}

const LapRow* find(const Rows& rows, const std::string& run, const std::string& lap) {
    const auto found = std::ranges::find_if(
        rows, [&](const LapRow* row) { return row->run == run && row->lap && lap_name(*row->lap) == lap; });
    return found == rows.end() ? nullptr : *found;
}

Cell cell(const LapRow& row, double si) {
    const double value = row.unit.value(si);
    return std::abs(value) < compact_from ? shown("{:.2f}", value) : shown("{:.4g}", value);
}

DataTable values(const Rows& rows) {
    const std::vector<std::string> runs = runs_of(rows);
    const std::vector<std::string> called = short_names(runs);
    const bool measured = std::ranges::any_of(rows, [](const LapRow* row) { return row->measured.has_value(); });
    DataTable table;
    for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
        const LapRow& row = *rows[i];
        const auto run = static_cast<std::size_t>(std::ranges::find(runs, row.run) - runs.begin());
        const bool is_first = i == 0 || rows[i - 1]->run != row.run;
        DataTable::Row line;
        if (runs.size() > 1 || !row.corner.empty()) {
            line.push_back(page_only(called == runs ? "run" : "corner", is_first ? called[run] : ""));
        }
        line.push_back(page_only("lap", right(row.lap ? lap_name(*row.lap) : "all")));
        line.push_back(page_only("time", right(input::lap_time(row.seconds))));
        const auto add = [&](const std::string& of, const diagnosis::StretchValues& values) {
            line.push_back(page_only(of + "mean", cell(row, values.mean)));
            line.push_back(page_only(of + "max", cell(row, values.highest)));
            line.push_back(page_only(of + "end", cell(row, values.end)));
        };
        if (measured) {
            add("measured ", row.measured.value_or(diagnosis::StretchValues{}));
        }
        add(measured ? "sim. " : "", row.simulated);
        table.add_to_page(std::move(line));
    }
    return table;
}

/// Means and maxima against laps, a colour for each run. @param laps in their order
Value lap_chart(const Rows& rows, const std::vector<std::string>& laps) {
    LineChart chart("lap", "", -0.5, static_cast<double>(laps.size()) - 0.5);
    chart.set_labels(laps);
    const std::vector<std::string> runs = runs_of(rows);
    const std::vector<std::string> called = short_names(runs);
    std::vector<double> places;
    for (std::size_t i = 0; i < laps.size(); ++i) {
        places.push_back(static_cast<double>(i));
    }
    using Member = double diagnosis::StretchValues::*;
    for (const auto& [name, of_row] : {std::pair<const char*, Member>{"mean", &diagnosis::StretchValues::mean},
                                       std::pair<const char*, Member>{"max", &diagnosis::StretchValues::highest}}) {
        const Member member = of_row;  // a lambda of clang 14 cannot capture a structured binding
        chart.add_panel(name, axis_unit(rows.front()->unit.name));
        for (std::size_t r = 0; r < runs.size(); ++r) {
            std::vector<double> simulated;
            std::vector<double> measured;
            for (const std::string& lap : laps) {
                const LapRow* row = find(rows, runs[r], lap);
                const auto value = [&](const diagnosis::StretchValues& values) {
                    return row->unit.value(values.*member);
                };
                simulated.push_back(row == nullptr ? std::nan("") : value(row->simulated));
                measured.push_back(row == nullptr || !row->measured ? std::nan("") : value(*row->measured));
            }
            chart.add_curve(called[r], called[r], CurveRole::line, places, simulated);
            if (std::ranges::any_of(measured, [](double v) { return std::isfinite(v); })) {
                chart.add_curve(called[r] + ", measured", called[r], CurveRole::points, places, measured);
            }
        }
    }
    return chart.data();
}

/// The bias of each lap, a column for each run.
void add_biases(DataTable& table, const Rows& rows, const std::vector<std::string>& laps) {
    const std::vector<std::string> runs = runs_of(rows);
    const std::vector<std::string> called = short_names(runs);
    for (const std::string& lap : laps) {
        const bool is_first = lap == laps.front();
        DataTable::Row line{page_only("channel", is_first ? rows.front()->channel : ""),
                            page_only("unit", is_first ? difference_unit(rows.front()->unit.name) : ""),
                            page_only("lap", right(lap))};
        for (std::size_t r = 0; r < runs.size(); ++r) {
            const LapRow* row = find(rows, runs[r], lap);
            line.push_back(page_only("bias " + called[r],
                                     row == nullptr ? right("-") : shown("{:+.2f}", row->unit.difference(row->bias))));
        }
        table.add_to_page(std::move(line));
    }
}

Value numbers(const LapRow& row, const diagnosis::StretchValues& values) {
    return {{"mean", row.unit.value(values.mean)},
            {"max", row.unit.value(values.highest)},
            {"end", row.unit.value(values.end)}};
}

}  // namespace

std::string lap_name(const input::Lap& lap) {
    switch (lap.kind) {
        case input::LapKind::out:
            return "out";
        case input::LapKind::in:
            return "in";
        default:
            return std::to_string(lap.number);
    }
}

std::vector<std::string> short_names(const std::vector<std::string>& runs) {
    const std::string recording = runs.empty() ? "" : runs.front().substr(0, runs.front().rfind('_') + 1);
    std::vector<std::string> corners;
    for (const std::string& run : runs) {
        const std::string corner = run.starts_with(recording) ? run.substr(recording.size()) : std::string();
        if (std::ranges::find(physics::corner_names, corner) == physics::corner_names.end()) {
            return runs;
        }
        corners.push_back(corner);
    }
    return corners;
}

std::vector<std::string> names_of_laps(const std::vector<std::vector<input::Lap>>& laps) {
    std::vector<std::pair<int, std::string>> found;
    for (const std::vector<input::Lap>& of_run : laps) {
        for (const input::Lap& lap : of_run) {
            constexpr int least = std::numeric_limits<int>::min();
            constexpr int most = std::numeric_limits<int>::max();
            const int rank = lap.kind == input::LapKind::out  ? least
                             : lap.kind == input::LapKind::in ? most
                                                              : lap.number;
            if (std::pair one{rank, lap_name(lap)}; std::ranges::find(found, one) == found.end()) {
                found.push_back(std::move(one));
            }
        }
    }
    std::ranges::sort(found);
    std::vector<std::string> names;
    std::ranges::transform(found, std::back_inserter(names), &std::pair<int, std::string>::second);
    return names;
}

bool have_laps_or_corners(const std::vector<LapRow>& rows) {
    return std::ranges::any_of(rows, [](const LapRow& row) { return row.lap.has_value() || !row.corner.empty(); });
}

ReportSection lap_section(const std::vector<LapRow>& rows, const std::string& of_model) {
    const bool has_laps = std::ranges::any_of(rows, [](const LapRow& row) { return row.lap.has_value(); });
    ReportSection section((has_laps ? "Laps" : "Means and maxima") + of_model);
    if (!have_laps_or_corners(rows)) {
        return section;
    }
    const std::vector<Rows> channels = by_channel(rows);
    DataTable biases;
    for (const Rows& own : channels) {
        const std::vector<std::string> laps = laps_of(own);
        const bool compared = std::ranges::any_of(own, [](const LapRow* row) { return std::isfinite(row->bias); });
        if (compared && laps.size() > 1) {
            add_biases(biases, own, laps);
        }
    }
    if (!biases.empty()) {
        section.add(std::move(biases));
        section.say("bias: mean of simulated - measured in the lap.");
    }
    for (const Rows& own : channels) {
        ReportSection part(fmt::format("{} [{}]", own.front()->channel, own.front()->unit.name));
        part.add(values(own));
        if (own.size() > most_rows) {
            part.say(fmt::format("{} more rows are in {} and in the JSON.", own.size() - most_rows, laps_name));
        }
        if (const std::vector<std::string> laps = laps_of(own); laps.size() > 1) {
            const bool measured = own.front()->measured.has_value();
            part.chart(own.front()->channel + " by lap",
                       measured ? "Lines are simulated; points are measured." : "Mean and maximum of each lap.",
                       lap_chart(own, laps));
        }
        section.add(std::move(part));
    }
    return section;
}

void add_lap_data(Value& data, const std::vector<LapRow>& rows) {
    Value::List laps;
    Value::List runs;
    for (const LapRow& row : rows) {
        Value one{{"channel", row.channel}, {"run", row.run}, {"corner", text_or_null(row.corner)}};
        if (row.lap) {
            one.set("lap", lap_name(*row.lap));
        }
        one.set({{"seconds", row.seconds}, {"unit", row.unit.name}});
        if (row.measured) {
            one.set({{"bias", row.unit.difference(row.bias)},
                     {"rmse", row.unit.difference(row.rmse)},
                     {"measured", numbers(row, *row.measured)}});
        }
        one.set("simulated", numbers(row, row.simulated));
        (row.lap ? laps : runs).push_back(std::move(one));
    }
    data.set({{"laps", std::move(laps)}, {"run_values", std::move(runs)}});
}

std::string laps_csv(const std::vector<LapRow>& rows) {
    Csv csv({"run", "corner", "lap", "seconds", "channel", "unit", "measured mean", "measured max", "measured end",
             "simulated mean", "simulated max", "simulated end", "bias", "rmse"});
    for (const LapRow& row : rows) {
        const auto value = [&](double si) { return Digits{row.unit.value(si), 6}; };
        const diagnosis::StretchValues measured = row.measured.value_or(diagnosis::StretchValues{});
        csv.row(row.run, row.corner, row.lap ? lap_name(*row.lap) : "all", Digits{row.seconds, 9}, row.channel,
                row.unit.name, value(measured.mean), value(measured.highest), value(measured.end),
                value(row.simulated.mean), value(row.simulated.highest), value(row.simulated.end),
                Digits{row.unit.difference(row.bias), 6}, Digits{row.unit.difference(row.rmse), 6});
    }
    return csv.text();
}

}  // namespace tiretherm::post
