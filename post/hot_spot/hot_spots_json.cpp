#include <cmath>

#include <nlohmann/json.hpp>

#include "mesh/place.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

/// null where nobody knows.
Json degrees(double kelvin) { return std::isnan(kelvin) ? Json() : Json(solver::celsius(kelvin)); }
Json number(double value) { return std::isnan(value) ? Json() : Json(value); }

Json moment(const TestMoment& moment) {
    Json json{{"time", moment.steady ? Json() : Json(moment.time)},
              {"speed", 3.6 * moment.speed},
              {"speed_unit", "km/h"},
              {"vertical_load", moment.load},
              {"surface", degrees(moment.surface)}};
    if (moment.step) {
        json["step"] = moment.step->number;
        json["ramp"] = moment.step->ramp;
        json["into_step"] = moment.time - moment.step->from;
    }
    return json;
}

Json steps(const HotSpots& all, const HotSpot& spot) {
    Json list = Json::array();
    for (std::size_t s = 0; s < all.steps.size(); ++s) {
        const solver::ScheduleStep& step = all.steps[s];
        list.push_back({{"step", step.number},
                        {"ramp", step.ramp},
                        {"from", step.from},
                        {"to", step.to},
                        {"speed", 3.6 * step.speed},
                        {"vertical_load", step.load},
                        {"hottest_at_end", degrees(spot.at_end[s].hottest)},
                        {"hottest_steady", degrees(spot.steady[s].hottest)},
                        {"surface_at_end", degrees(spot.at_end[s].surface)},
                        {"surface_steady", degrees(spot.steady[s].surface)}});
    }
    return list;
}

Json surface(const HotSpot& spot) {
    const bool both = spot.passing && !std::isnan(spot.surface_time);
    return {{"reading", spot.history.critical().surface_name},
            {"threshold", degrees(spot.surface_threshold)},
            {"time", number(spot.surface_time)},
            {"lag", both ? Json(spot.surface_time - spot.passing->time) : Json()}};
}

Json further(const FurtherSteps& further) {
    return {{"refusal", further.refusal.empty() ? Json() : Json(further.refusal)},
            {"rise", 3.6 * further.rise},
            {"step_duration", further.duration},
            {"passed", further.passing ? moment(*further.passing) : Json()},
            {"last_speed", 3.6 * further.last_speed},
            {"kelvin_per_step", further.kelvin_per_step}};
}

Json spread(const solver::Spread& spread, double critical) {
    Json drivers = Json::array();
    for (std::size_t d = 0; d < spread.drivers.size(); ++d) {
        const solver::Driver& driver = spread.drivers[d];
        drivers.push_back({{"name", driver.name},
                           {"unit", driver.unit},
                           {"value", driver.value},
                           {"standard_deviation", driver.standard_deviation},
                           {"kelvin", driver.kelvin},
                           {"share", spread.share(d)},
                           {"nonlinearity", number(driver.nonlinearity)}});
    }
    return {{"mean", solver::celsius(spread.mean)},
            {"standard_deviation", spread.standard_deviation},
            {"chance_above_critical", spread.chance_above(critical)},
            {"drivers", drivers}};
}

}  // namespace

std::string hot_spots_json(const HotSpots& hot_spots, const mesh::Mesh& mesh) {
    Json list = Json::array();
    for (const HotSpot& spot : hot_spots.spots) {
        const solver::Critical& critical = spot.history.critical();
        const std::size_t row = spot.history.hottest_row();
        const solver::HotSpotFinder::Found& found = spot.history.found(row);
        const mesh::Place place = mesh::place_of(mesh, found.node);
        Json json{
            {"name", critical.name},
            {"part", critical.part},
            {"critical", solver::celsius(critical.temperature)},
            {"unit", "degC"},
            {"hottest", solver::celsius(found.temperature)},
            {"margin", critical.temperature - found.temperature},
            {"layer", place.layer},
            {"zone", place.zone.empty() ? Json() : Json(place.zone)},
            {"position", place.position
                             ? Json{{"along", 1e3 * found.point[0]}, {"depth", 1e3 * found.point[2]}, {"unit", "mm"}}
                             : Json()},
            {"hottest_moment", moment(spot.hottest)},
            {"passed", spot.passing ? moment(*spot.passing) : Json()},
            {"steps", steps(hot_spots, spot)},
            {"surface", surface(spot)}};
        json["further_steps"] = spot.further ? further(*spot.further) : Json();
        json["uncertainty"] = spot.spread ? spread(*spot.spread, critical.temperature) : Json();
        list.push_back(std::move(json));
    }
    return Json{{"spots", list}, {"notes", hot_spots.notes}}.dump();
}

}  // namespace tiretherm::post
