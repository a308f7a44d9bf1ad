#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "mesh/place.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "post/report/file.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

std::string degrees(double kelvin) { return std::isnan(kelvin) ? "" : fmt::format("{:.4f}", solver::celsius(kelvin)); }

}  // namespace

void write_hot_spots_csv(const std::filesystem::path& path, const HotSpots& hot_spots, const solver::Problem& problem) {
    std::string text = "time [s],speed [km/h],vertical_load [N]";
    for (const HotSpot& spot : hot_spots.spots) {
        const std::string& name = spot.history.critical().name;
        text += fmt::format(
            ",{0} [degC],{0} margin [K],{0} layer,{0} zone,{0} along [mm],{0} depth [mm],{0} surface [degC]", name);
    }
    text += "\n";
    const std::size_t rows = hot_spots.spots.empty() ? 0 : hot_spots.spots.front().history.rows();
    for (std::size_t row = 0; row < rows; ++row) {
        const double time = hot_spots.spots.front().history.time()[row];
        const physics::Inputs inputs = problem.input_signals.at(time, solver::JumpSide::before);
        fmt::format_to(std::back_inserter(text), "{:.12g},{:.6g},{:.6g}", time, 3.6 * inputs.speed,
                       inputs.vertical_load);
        for (const HotSpot& spot : hot_spots.spots) {
            const solver::HotSpotFinder::Found& found = spot.history.found(row);
            const mesh::Place place = mesh::place_of(problem.mesh, found.node);
            fmt::format_to(std::back_inserter(text), ",{},{:.4f},{},{},", degrees(found.temperature),
                           spot.history.critical().temperature - found.temperature, place.layer, place.zone);
            if (place.position) {
                fmt::format_to(std::back_inserter(text), "{:.3f},{:.3f},", 1e3 * found.point[0], 1e3 * found.point[2]);
            } else {
                text += ",,";
            }
            text += degrees(spot.history.surface()[row]);
        }
        text += "\n";
    }
    replace_file(path, text);
}

}  // namespace tiretherm::post
