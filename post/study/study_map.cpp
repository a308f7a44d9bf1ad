// SPDX-License-Identifier: BSD-3-Clause
// The hottest temperature over the first two sides of a study's grid, a map for each value of the others.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "diagnosis/study/study_statistics.hpp"
#include "physics/celsius.hpp"
#include "post/page/cell_chart.hpp"
#include "post/page/charts.hpp"
#include "post/study/study_axis.hpp"
#include "post/study/study_chart.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr std::size_t most_maps = 6;

/// A side of the map, and the ends of its cells in the order of the places.
struct MapSide {
    CellAxis axis;
    std::vector<double> ends;
};

MapSide map_side(const StudyAxis& axis) {
    MapSide side{.axis = {.name = axis.name, .unit = axis_unit(axis.unit)}, .ends = {}};
    if (axis.is_number) {
        std::vector<double> sorted = axis.at;
        std::ranges::sort(sorted);
        side.ends = borders_between(sorted);
        side.axis.low = side.ends.front();
        side.axis.high = side.ends.back();
        return side;
    }
    side.axis.words = axis.labels_in_order();
    for (std::size_t i = 0; i <= side.axis.words.size(); ++i) {
        side.ends.push_back(static_cast<double>(i));
    }
    return side;
}

/// @param corner point of the grid at which both sides have their first values
std::vector<MapCell> cells_at(const StudyRecord& study, std::size_t side_x, std::size_t side_y, std::size_t corner,
                              const std::vector<double>& across, const std::vector<double>& up) {
    const std::vector<std::size_t> columns = study_axis(study, side_x).order();
    const std::vector<std::size_t> rows = study_axis(study, side_y).order();
    std::vector<MapCell> cells;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        for (std::size_t j = 0; j < rows.size(); ++j) {
            const std::vector<double> hottest =
                hottest_at(study, corner + columns[i] * stride(study, side_x) + rows[j] * stride(study, side_y));
            if (!hottest.empty()) {
                const double median = quantile(hottest, 0.5);
                cells.push_back({.x_from = across[i],
                                 .x_to = across[i + 1],
                                 .y_from = up[j],
                                 .y_to = up[j + 1],
                                 .value = median,
                                 .is_marked = study.critical && median > celsius(*study.critical)});
            }
        }
    }
    return cells;
}

/// "drive.camber = 2 deg, ..." of the sides that the map does not have
std::string held(const StudyRecord& study, std::size_t side_x, std::size_t side_y, std::size_t corner) {
    std::string text;
    for (const std::size_t side : wide_sides(study)) {
        if (side != side_x && side != side_y) {
            text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", study.columns[side].key,
                                study.columns[side].texts[corner * study.samples]);
        }
    }
    return text;
}

}  // namespace

void add_study_maps(ReportSection& section, const StudyRecord& study) {
    const std::vector<std::size_t> wide = wide_sides(study);
    std::vector<std::size_t> corners{0};
    for (std::size_t k = 2; k < wide.size(); ++k) {
        std::vector<std::size_t> next;
        for (const std::size_t corner : corners) {
            for (std::size_t i = 0; i < study.sides[wide[k]]; ++i) {
                next.push_back(corner + i * stride(study, wide[k]));
            }
        }
        corners = std::move(next);
    }
    const bool more = corners.size() > most_maps;
    corners.resize(more ? 1 : corners.size());
    const MapSide across = map_side(study_axis(study, wide[0]));
    const MapSide up = map_side(study_axis(study, wide[1]));
    std::vector<std::vector<MapCell>> maps;
    double low = std::numeric_limits<double>::infinity();  // one scale for all maps
    double high = -low;
    for (const std::size_t corner : corners) {
        maps.push_back(cells_at(study, wide[0], wide[1], corner, across.ends, up.ends));
        for (const MapCell& cell : maps.back()) {
            low = std::min(low, cell.value);
            high = std::max(high, cell.value);
        }
    }
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::string others = held(study, wide[0], wide[1], corners[i]);
        std::string caption = study.is_sampled ? fmt::format("A cell is the median of {} samples", study.samples)
                                               : std::string("A cell is a run");
        caption += "; where there is none, the run failed.";
        if (study.critical) {
            caption += fmt::format(" Framed: above the critical {:.6g} °C.", celsius(*study.critical));
        }
        if (more) {
            caption += " Other values of what else is varied are not drawn.";
        }
        section.chart("Map of the hottest temperature" + (others.empty() ? "" : ", " + others), caption,
                      cell_chart(across.axis, up.axis,
                                 {.name = "hottest temperature",
                                  .unit = "°C",
                                  .low = low,
                                  .high = high,
                                  .marked = "above the critical temperature"},
                                 maps[i]));
    }
}

}  // namespace tiretherm::post
