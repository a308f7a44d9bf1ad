// SPDX-License-Identifier: BSD-3-Clause
// The histories of the hot spots as a table, a row for each row of the run.
#include <limits>

#include "mesh/place.hpp"
#include "physics/celsius.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "post/report/csv.hpp"
#include "post/report/file.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

void write_hot_spots_csv(const std::filesystem::path& path, const HotSpots& hot_spots, const solver::Problem& problem) {
    std::vector<std::string> headings{"time [s]", "speed [km/h]", "vertical_load [N]"};
    for (const HotSpot& spot : hot_spots.spots) {
        for (const char* what :
             {"[degC]", "margin [K]", "layer", "zone", "along [mm]", "depth [mm]", "surface [degC]"}) {
            headings.push_back(spot.history.critical().name + " " + what);
        }
    }
    Csv csv(headings);
    const std::size_t rows = hot_spots.spots.empty() ? 0 : hot_spots.spots.front().history.rows();
    for (std::size_t row = 0; row < rows; ++row) {
        const double time = hot_spots.spots.front().history.time()[row];
        const physics::Inputs inputs = problem.input_signals.at(time, solver::JumpSide::before);
        csv.add(Digits{time, 12});
        csv.add(Digits{3.6 * inputs.speed, 6});
        csv.add(Digits{inputs.vertical_load, 6});
        for (const HotSpot& spot : hot_spots.spots) {
            const solver::HotSpotFinder::Found& found = spot.history.found(row);
            const mesh::Place place = mesh::place_of(problem.mesh, found.node);
            const double unknown = std::numeric_limits<double>::quiet_NaN();
            csv.add(Decimals{celsius(found.temperature), 4});
            csv.add(Decimals{spot.history.critical().temperature - found.temperature, 4});
            csv.add(place.layer);
            csv.add(place.zone);
            csv.add(Decimals{place.position ? 1e3 * found.point[0] : unknown, 3});
            csv.add(Decimals{place.position ? 1e3 * found.point[2] : unknown, 3});
            csv.add(Decimals{celsius(spot.history.surface()[row]), 4});
        }
        csv.end_row();
    }
    replace_file(path, csv.text());
}

}  // namespace tiretherm::post
