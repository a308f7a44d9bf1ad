// SPDX-License-Identifier: BSD-3-Clause
// Final, lowest and highest reading of each sensor, with measured values beside them.
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "post/report/number_text.hpp"
#include "post/run/measured_values.hpp"
#include "post/run/run_sections.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

namespace {

std::string measured_text(const Comparison& c, const solver::ShownUnit& unit) {
    const std::string value = c.low == c.high ? fmt::format("{:.4g}", unit.value(c.low))
                                              : fmt::format("{:.4g} to {:.4g}", unit.value(c.low), unit.value(c.high));
    return c.at_end ? value : fmt::format("{} at {:.6g} s", value, c.time);
}

/// The measured values of a channel: on the page beside its figures, or below them.
DataTable measured(const RunRecord& run, const std::vector<Comparison>& compared, std::size_t channel) {
    DataTable table;
    const solver::ShownUnit unit = solver::shown_unit(run.problem.channels[channel].quantity);
    for (const Comparison& c : compared) {
        if (c.channel != channel) {
            continue;
        }
        const double difference = unit.difference(c.difference);
        const bool within = c.difference == 0.0 && c.low < c.high;
        table.add({data_only("channel", run.problem.channels[channel].name),
                   data_only("time", c.time),
                   data_only("unit", unit.name),
                   data_only("low", unit.value(c.low)),
                   data_only("high", unit.value(c.high)),
                   data_only("simulated", unit.value(c.simulated)),
                   page_only("measured", right(measured_text(c, unit))),
                   {"sim - meas", "difference", {difference, within ? "within" : fmt::format("{:+.2f}", difference)}},
                   {"source", "source", c.source}});
    }
    return table;
}

}  // namespace

DataTable readings(const RunRecord& run, Value& data) {
    const std::vector<Comparison> compared = compare(run.problem, run.history);
    DataTable table;
    Value::List all_measured;
    const DataTable::Row blank{page_only("", ""), page_only("", ""), page_only("", right("")), page_only("", right("")),
                               page_only("", right(""))};
    for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
        const solver::Channel& channel = run.problem.channels[c];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        const auto show = [&](double si) {
            const double value = unit.value(si);
            return std::abs(value) < compact_from ? shown("{:.2f}", value) : shown("{:.4g}", value);
        };
        DataTable::Row row{{"channel", "name", channel.name},
                           {"unit", "unit", unit.name},
                           {"final", "final", show(run.report.channel_final[c])},
                           {"min", "min", show(run.report.channel_min[c])},
                           {"max", "max", show(run.report.channel_max[c])},
                           data_only("meaning", channel.meaning)};
        const DataTable values = measured(run, compared, c);
        for (const DataTable::Row& value : values.rows()) {
            for (Field field : value) {
                field.key.clear();
                row.push_back(std::move(field));
            }
            table.add(std::exchange(row, blank));
        }
        if (values.empty()) {
            if (!compared.empty()) {
                const DataTable::Row none{page_only("measured", right("")), page_only("sim - meas", right("")),
                                          page_only("source", "")};
                row.insert(row.end(), none.begin(), none.end());
            }
            table.add(std::move(row));
        }
        const Value of_channel = values.data();
        const auto& list = std::get<Value::List>(of_channel.held());
        all_measured.insert(all_measured.end(), list.begin(), list.end());
    }
    data.set("channels", table.data());
    data.set("measured", std::move(all_measured));
    return table;
}

}  // namespace tiretherm::post
