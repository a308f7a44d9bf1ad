// SPDX-License-Identifier: BSD-3-Clause
// The summary of a study as JSON: runs, statistics at the points of its grid, regression and cost.

#include <algorithm>

#include <nlohmann/json.hpp>

#include "diagnosis/study/study_drivers.hpp"
#include "diagnosis/study/study_statistics.hpp"
#include "post/study/study_summary.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

Json values_json(const StudyRecord& study, std::size_t run, bool grid_only) {
    Json json = Json::object();
    for (const StudyColumn& column : study.columns) {
        if (!grid_only || !column.is_drawn) {
            json[column.key] = column.texts[run];
        }
    }
    return json;
}

Json run_json(const StudyRecord& study, std::size_t run) {
    const StudyOutcome& outcome = study.outcomes[run];
    Json json{{"run", run + 1}, {"values", values_json(study, run, false)}};
    if (!outcome.ok()) {
        json["error"] = outcome.failure;
        return json;
    }
    json["temperature"] = solver::celsius(outcome.hottest);
    json["unit"] = "degC";
    json["time"] = outcome.hottest_time;
    json["layer"] = outcome.hottest_layer;
    json["zone"] = outcome.hottest_zone.empty() ? Json() : Json(outcome.hottest_zone);
    return json;
}

Json point_json(const StudyRecord& study, std::size_t point) {
    Json json{{"values", values_json(study, point * study.samples, true)}};
    const std::vector<double> hottest = hottest_at(study, point);
    json["samples"] = study.samples;
    json["failed"] = study.samples - hottest.size();
    if (!hottest.empty()) {
        json["hottest"] = {{"unit", "degC"},
                           {"p05", quantile(hottest, 0.05)},
                           {"median", quantile(hottest, 0.5)},
                           {"p95", quantile(hottest, 0.95)}};
    }
    if (study.critical) {
        const Chance c = passes_critical(study, point);
        json["passes_critical"] = {
            {"times", c.times}, {"of", c.of}, {"share", c.share}, {"low", c.low}, {"high", c.high}};
    }
    return json;
}

/// null where there are too few samples.
Json drivers_json(const StudyRecord& study, std::size_t point) {
    const StudyRegression line = regression(study, point);
    if (!line.exists()) {
        return {};
    }
    Json list = Json::array();
    for (const StudyDriver& driver : line.drivers) {
        list.push_back({{"key", driver.key},
                        {"unit", driver.unit},
                        {"mean", driver.mean},
                        {"standard_deviation", driver.standard_deviation},
                        {"kelvin", driver.kelvin},
                        {"uncertainty", driver.uncertainty},
                        {"share", driver.share}});
    }
    return {{"mean", solver::celsius(line.mean)},
            {"standard_deviation", line.standard_deviation},
            {"residual", line.residual},
            {"r_squared", line.r_squared},
            {"passes_critical", study.critical ? Json(line.chance_above(*study.critical)) : Json()},
            {"numbers", list}};
}

}  // namespace

std::string study_json(const StudyRecord& study, const StudyCall& call) {
    Json json{{"title", study.title}, {"case", study.case_name}, {"version", study.version}};
    json["runs"] = study.outcomes.size();
    json["kept"] = call.kept;
    json["made"] = study.outcomes.size() - call.kept;
    json["seconds"] = call.seconds;
    json["threads"] = call.threads;
    json["critical"] = study.critical ? Json(solver::celsius(*study.critical)) : Json();
    json["failed"] = Json::array();
    for (const std::size_t run : study.failed()) {
        json["failed"].push_back(run_json(study, run));
    }
    std::vector<std::size_t> order;
    for (std::size_t run = 0; run < study.outcomes.size(); ++run) {
        if (study.outcomes[run].ok()) {
            order.push_back(run);
        }
    }
    if (!order.empty()) {
        const auto [coldest, hottest] = std::minmax_element(
            order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return study.outcomes[a].hottest < study.outcomes[b].hottest; });
        json["hottest"] = run_json(study, *hottest);
        json["coldest"] = run_json(study, *coldest);
    }
    if (study.is_sampled) {
        json["points"] = Json::array();
        for (std::size_t point = 0; point < study.points(); ++point) {
            json["points"].push_back(point_json(study, point));
            json["points"].back()["drivers"] = drivers_json(study, point);
        }
    }
    json["warnings"] = study.warnings;
    json["outputs"] = Json::array();
    for (const std::filesystem::path& file : call.files) {
        json["outputs"].push_back(file.string());
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tiretherm::post
