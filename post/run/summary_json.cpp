#include <algorithm>
#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "mesh/place.hpp"
#include "post/run/comparison.hpp"
#include "post/run/summary.hpp"
#include "solver/celsius.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

namespace {

using Json = nlohmann::ordered_json;

Json channels(const RunRecord& run) {
    Json list = Json::array();
    for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
        const solver::ShownUnit unit = solver::shown_unit(run.problem.channels[c].quantity);
        list.push_back({{"name", run.problem.channels[c].name},
                        {"unit", unit.name},
                        {"final", unit.value(run.report.channel_final[c])},
                        {"min", unit.value(run.report.channel_min[c])},
                        {"max", unit.value(run.report.channel_max[c])},
                        {"meaning", run.problem.channels[c].meaning}});
    }
    return list;
}

Json budget(const RunRecord& run) {
    Json list = Json::array();
    for (std::size_t e = 0; e < run.problem.effects.size(); ++e) {
        list.push_back({{"effect", run.problem.effects[e].title()},
                        {"watts_final", run.problem.symmetry * run.report.watts[e]},
                        {"joules", run.problem.symmetry * run.report.joules[e]}});
        if (std::isfinite(run.report.law_watts[e])) {
            list.back()["law_watts_final"] = run.problem.symmetry * run.report.law_watts[e];
        }
    }
    return list;
}

Json extreme(const RunRecord& run, const solver::Report::Extreme& found) {
    const mesh::Place place = mesh::place_of(run.problem.mesh, found.node);
    Json position;  // null for a lump
    if (place.position) {
        const auto [x, y, depth] = *place.position;
        position = {{"x", 1e3 * x}, {"y", 1e3 * y}, {"depth", 1e3 * depth}, {"unit", "mm"}};
    }
    return {{"temperature", solver::celsius(found.temperature)},
            {"unit", "degC"},
            {"time", found.time},
            {"layer", place.layer},
            {"zone", place.zone.empty() ? Json() : Json(place.zone)},
            {"patch", place.patch},
            {"position", position}};
}

Json measured(const RunRecord& run) {
    Json list = Json::array();
    for (const Comparison& c : compare(run.problem, run.history)) {
        const solver::Channel& channel = run.problem.channels[c.channel];
        const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
        list.push_back({{"channel", channel.name},
                        {"time", c.time},
                        {"unit", unit.name},
                        {"low", unit.value(c.low)},
                        {"high", unit.value(c.high)},
                        {"simulated", unit.value(c.simulated)},
                        {"difference", unit.difference(c.difference)},
                        {"source", c.source}});
    }
    return list;
}

}  // namespace

std::string summary_json(const RunRecord& run) {
    const solver::Report& report = run.report;
    Json json;
    json["case"] = run.problem.name;
    json["title"] = run.problem.title;
    json["version"] = run.provenance.version;
    json["cells"] = run.problem.mesh.n_cells;
    json["steps"] = report.steps;
    json["rejected"] = report.rejected;
    json["factorisations"] = report.factorisations;
    json["newton_iterations"] = report.newton_iterations;
    json["linear_iterations"] = report.linear_iterations;
    json["linear_solver"] = report.linear_solver;
    json["seconds"] = run.seconds;
    constexpr std::array parts{"assembly", "factor", "solve", "output"};
    for (std::size_t i = 0; i < std::min(parts.size(), report.seconds.size()); ++i) {
        json["seconds_by_part"][parts[i]] = report.seconds[i];
    }
    json["simulated_seconds"] = report.simulated;
    json["energy_closure"] = report.energy_closure;
    json["effective_two_node_conductance"] =
        run.problem.symmetry * report.effective_two_node_conductance;  // W/K; null where it has no meaning
    if (run.history.rows() > 0) {
        json["channels"] = channels(run);
        json["measured"] = measured(run);
        json["budget"] = budget(run);
        json["stored_joules"] = run.problem.symmetry * report.stored;
        json["symmetry"] = run.problem.symmetry;
        json["hottest"] = extreme(run, report.hottest);
        json["coldest"] = extreme(run, report.coldest);
        if (run.hot_spots != nullptr) {
            json["hot_spots"] = Json::parse(hot_spots_json(*run.hot_spots, run.problem.mesh));
        }
    }
    json["warnings"] = run.warnings;
    for (const std::string& warning : report.warnings) {
        json["warnings"].push_back(warning);
    }
    json["sources"] = run.problem.sources;
    json["outputs"] = Json::array();
    for (const std::filesystem::path& file : run.files) {
        json["outputs"].push_back(file.string());
    }
    if (!report.status.ok()) {
        json["error"] = report.status.message;
        json["mistakes"] = Json::array();
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tiretherm::post
