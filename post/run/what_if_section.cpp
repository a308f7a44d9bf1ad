// SPDX-License-Identifier: BSD-3-Clause
// What changes of single values do to a run: a row for each change.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/page/charts.hpp"
#include "post/report/remark_text.hpp"
#include "post/run/run_sections.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

using diagnosis::WhatIf;
using diagnosis::WhatIfRow;

namespace {

std::string failure_of(const diagnosis::WhatIfRow& row) {
    return row.has_other_sensors ? "it has other sensors" : row.failure;
}

constexpr std::size_t most_channels = 4;  ///< on the page; the data have all

std::string unit_of(const solver::ShownUnit& unit) { return std::string_view(unit.name) == "degC" ? "K" : unit.name; }

std::string called(const WhatIfRow& row) {
    const std::size_t dot = row.key.rfind("drive.", 0) == 0 ? row.key.find('.') + 1 : 0;
    return row.key.substr(dot) + (row.change.starts_with('+') || row.change.starts_with('-') ? " " : " = ") +
           row.change;
}

DataTable table_of(const WhatIf& what_if, const std::vector<solver::Channel>& channels) {
    DataTable table;
    std::string before;
    for (const WhatIfRow& row : what_if.rows) {
        const std::string name = called(row);
        DataTable::Row line{page_only("change", name == before ? "" : name)};
        before = name;
        if (!row.corner.empty()) {
            line.push_back(page_only("corner", row.corner));
        }
        if (!row.has_values()) {
            line.push_back(page_only("hottest K", failure_of(row)));
            table.add_to_page(std::move(line));
            continue;
        }
        line.push_back(page_only("hottest K", shown("{:+.2f}", row.hottest)));
        for (std::size_t c = 0; c < std::min(channels.size(), most_channels); ++c) {
            const solver::ShownUnit unit = solver::shown_unit(channels[c].quantity);
            line.push_back(page_only(fmt::format("{} max {}", channels[c].name, unit_of(unit)),
                                     shown("{:+.3g}", unit.difference(row.highest[c]))));
            line.push_back(page_only("end", shown("{:+.3g}", unit.difference(row.end[c]))));
        }
        table.add_to_page(std::move(line));
    }
    return table;
}

}  // namespace

ReportSection what_if_section(const WhatIf& what_if, const std::vector<solver::Channel>& channels) {
    ReportSection section("What if");
    if (!what_if.rows.empty()) {
        section.add(table_of(what_if, channels));
        section.say(
            "Differences to the run as it stands: of the hottest place, of each sensor's maximum and of its last "
            "value. An input is moved in all of its course; the temperatures at the start stay.");
        if (channels.size() > most_channels) {
            section.say(fmt::format("{} more sensors are in the JSON.", channels.size() - most_channels));
        }
    }
    for (const std::string& remark : texts_of(what_if.remarks)) {
        section.item(remark);
    }
    std::vector<std::string> tires;
    std::vector<BarGroup> groups;
    for (const WhatIfRow& row : what_if.rows) {
        if (std::ranges::find(tires, row.corner) == tires.end()) {
            tires.push_back(row.corner);
        }
        if (groups.empty() || groups.back().name != called(row)) {
            groups.push_back({.name = called(row), .values = {}});
        }
        groups.back().values.push_back(row.has_values() ? row.hottest : std::nan(""));
    }
    if (!groups.empty()) {
        const std::vector<std::string> series = tires.size() == 1 ? std::vector<std::string>{"hottest place"} : tires;
        section.chart("Change of the hottest temperature", "Against the run as it stands.",
                      grouped_bar_chart("change", "K", series, groups));
    }
    return section;
}

Value what_if_data(const WhatIf& what_if, const std::vector<solver::Channel>& channels) {
    Value::List rows;
    for (const WhatIfRow& row : what_if.rows) {
        Value::List sensors;
        for (std::size_t c = 0; c < row.highest.size(); ++c) {
            const solver::ShownUnit unit = solver::shown_unit(channels[c].quantity);
            sensors.push_back({{"name", channels[c].name},
                               {"unit", unit_of(unit)},
                               {"max", unit.difference(row.highest[c])},
                               {"end", unit.difference(row.end[c])}});
        }
        rows.push_back({{"key", row.key},
                        {"change", row.change},
                        {"run", text_or_null(row.run)},
                        {"corner", text_or_null(row.corner)},
                        {"failure", text_or_null(failure_of(row))},
                        {"hottest", where(row.has_values(), row.hottest)},
                        {"channels", std::move(sensors)}});
    }
    return {{"changes", std::move(rows)}, {"remarks", texts_of(what_if.remarks)}};
}

}  // namespace tiretherm::post
