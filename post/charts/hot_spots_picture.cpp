// SPDX-License-Identifier: BSD-3-Clause
// Draws the histories of hot spots and their surfaces with the critical temperatures, as a picture of channels.

#include <algorithm>

#include <fmt/format.h>

#include "post/hot_spot/hot_spots_report.hpp"
#include "post/pictures/picture.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

void draw_hot_spots(const std::filesystem::path& path, const HotSpots& hot_spots, const solver::Problem& problem) {
    // The picture of channels, of courses that are none.
    solver::Problem drawn;
    drawn.name = problem.name;
    drawn.title = (problem.title.empty() ? problem.name : problem.title) + ": hot spots";
    drawn.settings = problem.settings;
    std::vector<const std::vector<double>*> histories;
    std::vector<double> levels;
    const auto add = [&](std::string name, const std::vector<double>* history, double level) {
        if (std::ranges::find(drawn.channels, name, &solver::Channel::name) == drawn.channels.end()) {
            drawn.channels.push_back({.name = std::move(name), .meaning = "", .where = {}});
            histories.push_back(history);
            levels.push_back(level);
        }
    };
    for (const HotSpot& spot : hot_spots.spots) {
        const solver::Critical& critical = spot.history.critical();
        add(critical.name, &spot.history.temperature(), 0.0);
        if (!critical.surface_name.empty()) {
            add(critical.surface_name, &spot.history.surface(), 0.0);
        }
        add(fmt::format("critical {:.6g} degC", solver::celsius(critical.temperature)), nullptr, critical.temperature);
    }
    History history;
    const std::vector<double>& time = hot_spots.spots.front().history.time();
    std::vector<double> row(histories.size());
    for (std::size_t i = 0; i < time.size(); ++i) {
        for (std::size_t c = 0; c < histories.size(); ++c) {
            row[c] = histories[c] != nullptr ? (*histories[c])[i] : levels[c];
        }
        solver::Snapshot now;
        now.time = time[i];
        now.channels = row;
        history.take(now);
    }
    draw_channels(path, drawn, history);
}

}  // namespace tiretherm::post
