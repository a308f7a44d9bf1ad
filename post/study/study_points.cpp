// SPDX-License-Identifier: BSD-3-Clause
// The points of a study's grid: quantiles, probability with its interval, and what the linear regression says.
#include <fmt/format.h>

#include "diagnosis/study/study_drivers.hpp"
#include "diagnosis/study/study_statistics.hpp"
#include "physics/celsius.hpp"
#include "post/study/study_names.hpp"
#include "post/study/study_sections.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Numbers of the linear function, the strongest first.
DataTable drivers(const StudyRegression& line) {
    DataTable table;
    for (const StudyDriver& driver : line.drivers) {
        table.add({{"", "key", driver.key},
                   data_only("unit", driver.unit),
                   {"mean", "mean", shown("{:.4g}", driver.mean)},
                   {"+-", "standard_deviation", shown("{:.3g}", driver.standard_deviation)},
                   page_only("unit", driver.unit),
                   {"change K", "kelvin", shown("{:+.2f}", driver.kelvin)},
                   {"95 %", "uncertainty", shown("{:.2f}", driver.uncertainty)},
                   {"share %", "share", {driver.share, fmt::format("{:.1f}", 100.0 * driver.share)}}});
    }
    return table;
}

/// Null where there are too few samples.
Value drivers_data(const StudyRecord& study, const StudyRegression& line) {
    if (!line.exists()) {
        return {};
    }
    return {{"mean", celsius(line.mean)},
            {"standard_deviation", line.standard_deviation},
            {"residual", line.residual},
            {"r_squared", line.r_squared},
            {"passes_critical", study.critical ? Value(line.chance_above(*study.critical)) : Value()},
            {"numbers", drivers(line).data()}};
}

Value chance_data(const Chance& c) {
    return {{"times", c.times}, {"of", c.of}, {"share", c.share}, {"low", c.low}, {"high", c.high}};
}

std::string chance_text(const Chance& c) {
    return fmt::format("{:.1f} %, 95 % interval {:.1f} to {:.1f} % ({} of {})", 100.0 * c.share, 100.0 * c.low,
                       100.0 * c.high, c.times, c.of);
}

}  // namespace

Value study_values(const StudyRecord& study, std::size_t run, bool grid_only) {
    Value data = Value::Object{};
    for (const StudyColumn& column : study.columns) {
        if (!grid_only || !column.is_drawn) {
            data.set(column.key, column.texts[run]);
        }
    }
    return data;
}

std::string median_text(const std::vector<double>& hottest) {
    return hottest.empty() ? std::string("failed") : fmt::format("{:.1f}", quantile(hottest, 0.5));
}

DataTable study_points(const StudyRecord& study) {
    const bool sampled = study.is_sampled;
    const std::string above =
        sampled && study.critical ? fmt::format("above {:.6g} degC", celsius(*study.critical)) : "";
    DataTable table;
    for (std::size_t point = 0; point < study.points(); ++point) {
        const std::vector<double> hottest = hottest_at(study, point);
        const bool spread = sampled && !hottest.empty();
        const auto figure = [&](double share) {
            return right(spread ? fmt::format("{:.1f}", quantile(hottest, share)) : "");
        };
        const std::string name = study.sides.empty() ? plural(study.samples, "sample") : point_text(study, point);
        DataTable::Row row{
            page_only("", name), page_only(sampled ? "5 %" : "", figure(0.05)),
            page_only(sampled ? "median" : "", right(median_text(hottest))),
            page_only(sampled ? "95 %" : "", figure(0.95)),
            page_only(above, spread && study.critical ? chance_text(passes_critical(study, point)) : "")};
        Value::List parts;
        for (std::size_t part = 0; part < study.parts.size(); ++part) {
            const Chance passes = part_passes(study, point, part);
            row.push_back(page_only(sampled ? part_text(study, part) : "", spread ? chance_text(passes) : ""));
            parts.emplace_back(Value{{"name", study.parts[part]}, {"passes", chance_data(passes)}});
        }
        row.insert(row.end(),
                   {data_only("critical_parts", std::move(parts)),
                    data_only("values", study_values(study, point * study.samples, true)),
                    data_only("samples", study.samples), data_only("failed", study.samples - hottest.size())});
        if (spread) {
            row.push_back(data_only("hottest", {{"unit", "degC"},
                                                {"p05", quantile(hottest, 0.05)},
                                                {"median", quantile(hottest, 0.5)},
                                                {"p95", quantile(hottest, 0.95)}}));
        }
        if (study.critical) {
            row.push_back(data_only("passes_critical", chance_data(passes_critical(study, point))));
        }
        row.push_back(data_only("drivers", drivers_data(study, regression(study, point))));
        table.add(std::move(row));
    }
    return table;
}

ReportSection drivers_section(const StudyRecord& study) {
    ReportSection section("What drives it");
    for (std::size_t point = 0; study.is_sampled && point < study.points() && study.points() <= most_rows; ++point) {
        const StudyRegression line = regression(study, point);
        if (!line.exists()) {
            continue;
        }
        if (!study.sides.empty()) {
            section.line(point_text(study, point));
        }
        section.add(drivers(line));
        section.say("change K: for one standard deviation; 95 %: its uncertainty.");
        std::string worth = fmt::format(
            "a linear function of these explains {:.1f} % of the variance (R2); it is {:.1f} +- {:.1f} degC (one "
            "standard deviation), and leaves {:.2f} K over",
            100.0 * line.r_squared, celsius(line.mean), line.standard_deviation, line.residual);
        if (study.critical) {
            worth += fmt::format(
                "; a normal distribution of this mean and of both deviations passes {:.6g} degC with a probability "
                "of {:.1f} %",
                celsius(*study.critical), 100.0 * line.chance_above(*study.critical));
        }
        section.say(std::move(worth));
    }
    return section;
}

}  // namespace tiretherm::post
