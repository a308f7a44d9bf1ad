// SPDX-License-Identifier: BSD-3-Clause
// Quadrilaterals of the drawn section, their temperatures in 65536 steps of one common scale, borders and names.
#include "post/page/field_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "mesh/ring.hpp"
#include "post/page/charts.hpp"
#include "post/pictures/section_plane.hpp"
#include "post/report/base64.hpp"
#include "post/report/number_text.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr std::size_t values_on_a_page = 500'000;  ///< 1.3 MB as text
constexpr double per_metre = 1e3;                  ///< mm
constexpr double steps = 65535.0;

double mm(double metres) { return rounded(per_metre * metres, 5); }

/// Numbers of a polygon, corner after corner.
template <std::size_t N>
void add_polygon(Value::List& polygons, const std::array<double, N>& at) {
    for (const double value : at) {
        polygons.emplace_back(mm(value));
    }
}

struct Range {
    double low = 1e300;
    double high = -1e300;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

Value axis(std::string_view name, const Range& range, double margin, bool down) {
    return {{"name", name},
            {"unit", "mm"},
            {"min", rounded(range.low - margin, 5)},
            {"max", rounded(range.high + margin, 5)},
            {"down", down}};
}

/// Lines where layers meet and where zones meet. mm
Value::List borders_of(const FoldedSection& section) {
    Value::List borders;
    for (const FoldedSection::Border& border : section.borders()) {
        Value::List line;
        for (const FoldedSection::Place& place : border.line) {
            line.emplace_back(mm(place[0]));
            line.emplace_back(mm(place[1]));
        }
        borders.emplace_back(std::move(line));
    }
    return borders;
}

/// The name of each zone beside its middle column, inside the cavity.
Value::List names_of(const FoldedSection& section, const mesh::Mesh& mesh) {
    Value::List names;
    for (std::size_t zone = 0; zone < mesh.zones.size(); ++zone) {
        const std::optional<FoldedSection::Place> below = section.below_zone(zone);
        if (!below) {
            continue;
        }
        const FoldedSection::Place& at = *below;
        constexpr double beside = 4.0;  // mm
        names.emplace_back(Value{{"name", in_words(mesh.zones[zone])},
                                 {"x", mm(at[0]) + (at[0] < -0.05 ? beside : -beside)},
                                 {"y", mm(at[1]) - beside},
                                 {"align", at[0] < -0.05 ? "left" : "right"}});
    }
    return names;
}

/// A point in the middle of each layer of the crown, side by side, and the cavity below it, where the names have room. mm
Value::List layer_places_of(const FoldedSection& section, const mesh::Mesh& mesh) {
    std::size_t middle = 0;  // column at the tire's plane
    for (std::size_t i = 0; i < mesh.columns.size(); ++i) {
        const auto off = [&](std::size_t c) { return std::abs(mesh.columns[c].from + mesh.columns[c].to); };
        middle = off(i) < off(middle) ? i : middle;
    }
    const mesh::Column& column = mesh.columns[middle];
    Value::List places;
    int first = 0;
    for (int k = 0; k < column.cells(); ++k) {
        const auto layer = [&](int row) { return mesh.layer[static_cast<std::size_t>(column.first_cell + row)]; };
        if (k + 1 < column.cells() && layer(k) == layer(k + 1)) {
            continue;
        }
        const double depth =
            0.5 * (column.edge[static_cast<std::size_t>(first)] + column.edge[static_cast<std::size_t>(k) + 1]);
        first = k + 1;
        // Side by side: 4 mm from one to the next.
        const double along = 0.5 * (column.from + column.to) + 4e-3 * static_cast<double>(places.size());
        if (const auto at = section.place(along, depth)) {
            places.emplace_back(Value{{"name", in_words(mesh.layers[static_cast<std::size_t>(layer(k))])},
                                      {"x", mm((*at)[0])},
                                      {"y", mm((*at)[1])}});
        }
    }
    return places;
}

}  // namespace

FieldFrames::FieldFrames(const solver::Problem& problem)
    : problem_(problem),
      folded_(!problem.mesh.columns.empty() && !problem.mesh.drawing.places.empty()),
      section_(folded_ && problem.mesh.sectors > 1 ? mesh::drawn_section(problem.mesh) : mesh::Mesh{}),
      drawn_(problem.mesh.sectors > 1 ? section_ : problem.mesh),
      finder_(problem.mesh, solver::nodes_of_layers(problem.mesh)) {
    if (folded_) {
        section_shape_.emplace(drawn_mesh());
    }
}

FieldFrames::Frame FieldFrames::frame_of(double time, std::span<const double> temperature) const {
    Frame frame;
    frame.time = time;
    if (!folded_) {
        const SectionPlane plane = section_plane(problem_, temperature, Shading::cells);
        const std::size_t width = plane.x.size() - 1;
        for (const double kelvin : plane.kelvin) {
            frame.celsius.push_back(static_cast<float>(solver::celsius(kelvin)));
        }
        const auto cell = static_cast<std::size_t>(std::ranges::max_element(plane.kelvin) - plane.kelvin.begin());
        const std::size_t column = cell % width;
        const std::size_t row = cell / width;
        frame.hottest = solver::celsius(finder_.find(temperature).temperature);
        frame.at = {mm(0.5 * (plane.x[column] + plane.x[column + 1])),
                    mm(0.5 * (plane.depth[row] + plane.depth[row + 1]))};
        return frame;
    }
    const bool is_ring = problem_.mesh.sectors > 1;
    const mesh::Mesh& mesh = is_ring ? section_ : problem_.mesh;
    const std::vector<double> mean = is_ring ? mesh::around(problem_.mesh, temperature) : std::vector<double>{};
    const std::vector<double> kelvin = drawn_.at_points(is_ring ? std::span<const double>(mean) : temperature);
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            sum += kelvin[section_shape_->corner(cell, i)];
        }
        frame.celsius.push_back(static_cast<float>(solver::celsius(0.25 * sum)));
    }
    const solver::HotSpotFinder::Found hottest =
        section_shape_->hottest(is_ring ? std::span<const double>(mean) : temperature);
    frame.hottest = solver::celsius(hottest.temperature);
    if (const auto at = section_shape_->place(hottest.point[0], hottest.point[2])) {
        frame.at = {mm((*at)[0]), mm((*at)[1])};
    }
    return frame;
}

bool FieldFrames::is_drawn() const { return has_section(problem_.mesh) || folded_; }

void FieldFrames::take(const solver::Snapshot& snapshot) {
    if (!snapshot.field || !is_drawn()) {
        return;
    }
    last_ = frame_of(snapshot.time, snapshot.temperature);
    if (seen_ % stride_ == 0) {
        frames_.push_back(last_);
        thin();
    }
    ++seen_;
}

void FieldFrames::take_hottest(double time, std::span<const double> temperature) {
    if (is_drawn() && seen_ > 0) {
        hottest_ = frame_of(time, temperature);
    }
}

void FieldFrames::thin() {
    const std::size_t most = std::clamp<std::size_t>(values_on_a_page / frames_.front().celsius.size(), 2, 120);
    if (frames_.size() <= most) {
        return;
    }
    std::vector<Frame> kept;
    for (std::size_t i = 0; i < frames_.size(); i += 2) {
        kept.push_back(std::move(frames_[i]));
    }
    frames_ = std::move(kept);
    stride_ *= 2;
}

Value FieldFrames::outline() const {
    Value::List polygons;
    Value::List layers;
    Range across;
    Range along;
    if (folded_) {
        const mesh::Mesh& mesh = drawn_mesh();
        for (int cell = 0; cell < mesh.n_cells; ++cell) {
            constexpr int pieces = FoldedSection::pieces;
            std::array<double, 4 * (pieces + 1)> polygon{};  // the inner side, and the outer side back
            for (int i = 0; i < 2 * (pieces + 1); ++i) {
                const bool inner = i <= pieces;
                const double u = static_cast<double>(inner ? i : 2 * pieces + 1 - i) / pieces;
                const FoldedSection::Place place = section_shape_->in_cell(cell, u, inner ? 0.0 : 1.0);
                polygon[2 * static_cast<std::size_t>(i)] = place[0];
                polygon[2 * static_cast<std::size_t>(i) + 1] = place[1];
                across.include(per_metre * place[0]);
                along.include(per_metre * place[1]);
            }
            add_polygon(polygons, polygon);
            layers.emplace_back(mesh.layer[static_cast<std::size_t>(cell)]);
        }
        return {{"x", axis("across, outboard to inboard", across, 6.0, false)},
                {"y", axis("radius", along, 6.0, false)},
                {"corners", 2 * (FoldedSection::pieces + 1)},
                {"polygons", std::move(polygons)},
                {"layers", std::move(layers)},
                {"layer_names", mesh.layers},
                {"borders", borders_of(*section_shape_)},
                {"names", names_of(*section_shape_, mesh)},
                {"layer_places", layer_places_of(*section_shape_, mesh)}};
    }
    const mesh::Grid& grid = *problem_.mesh.grid;
    const bool mirrored = grid.mirror[0];
    for (int side = 0; side < (mirrored ? 2 : 1); ++side) {
        for (int k = 0; k < grid.size(2); ++k) {
            for (int i = 0; i < grid.size(0); ++i) {
                const double sign = side == 0 ? 1.0 : -1.0;
                const double x0 = sign * grid.edge[0][static_cast<std::size_t>(i)];
                const double x1 = sign * grid.edge[0][static_cast<std::size_t>(i) + 1];
                const double z0 = grid.edge[2][static_cast<std::size_t>(k)];
                const double z1 = grid.edge[2][static_cast<std::size_t>(k) + 1];
                add_polygon(polygons, std::array{x0, z0, x1, z0, x1, z1, x0, z1});
                layers.emplace_back(problem_.mesh.layer[static_cast<std::size_t>(grid.cell(i, 0, k))]);
                across.include(per_metre * x0);
                across.include(per_metre * x1);
                along.include(per_metre * z0);
                along.include(per_metre * z1);
            }
        }
    }
    Value::List borders;
    Value::List layer_places;
    int first = 0;  // row of the layer at hand
    for (int k = 0; k < grid.size(2); ++k) {
        const auto index = [&](int row) { return problem_.mesh.layer[static_cast<std::size_t>(grid.cell(0, 0, row))]; };
        if (k + 1 == grid.size(2) || index(k) != index(k + 1)) {
            const double top = grid.edge[2][static_cast<std::size_t>(first)];
            const double bottom = grid.edge[2][static_cast<std::size_t>(k) + 1];
            layer_places.emplace_back(
                Value{{"name", in_words(problem_.mesh.layers[static_cast<std::size_t>(index(k))])},
                      {"x", across.low},
                      {"y", mm(0.5 * (top + bottom))}});
            first = k + 1;
        }
    }
    for (int k = 0; k + 1 < grid.size(2); ++k) {
        const auto layer = [&](int row) { return problem_.mesh.layer[static_cast<std::size_t>(grid.cell(0, 0, row))]; };
        if (layer(k) != layer(k + 1)) {
            const double z = mm(grid.edge[2][static_cast<std::size_t>(k) + 1]);
            borders.emplace_back(Value::List{across.low, z, across.high, z});
        }
    }
    return {{"x", axis("across", across, 0.0, false)},
            {"y", axis("depth", along, 0.0, true)},
            {"corners", 4},
            {"polygons", std::move(polygons)},
            {"layers", std::move(layers)},
            {"layer_names", problem_.mesh.layers},
            {"borders", std::move(borders)},
            {"names", Value::List{}},
            {"layer_places", std::move(layer_places)}};
}

Value::List FieldFrames::spots(const diagnosis::HotSpots& hot_spots, const std::vector<const Frame*>& shown) const {
    Value::List list;
    for (const diagnosis::HotSpot& spot : hot_spots.spots) {
        const std::vector<double>& time = spot.history.time();
        Value::List places;
        for (const Frame* frame : shown) {
            auto row = static_cast<std::size_t>(std::ranges::lower_bound(time, frame->time) - time.begin());
            if (row >= time.size()) {
                places.emplace_back();
                continue;
            }
            // The hottest step may lie between two rows.
            row -= row > 0 && frame->time - time[row - 1] < time[row] - frame->time ? 1 : 0;
            const solver::HotSpotFinder::Found& found = spot.history.found(row);
            const auto at = section_shape_->place(found.point[0], found.point[2]);
            places.push_back(
                at ? Value(Value::List{mm((*at)[0]), mm((*at)[1]), rounded(solver::celsius(found.temperature), 7)})
                   : Value());
        }
        const solver::Critical& critical = spot.history.critical();
        list.emplace_back(Value{{"name", critical.name},
                                {"critical", rounded(solver::celsius(critical.temperature), 7)},
                                {"at", std::move(places)}});
    }
    return list;
}

Value FieldFrames::chart(const diagnosis::HotSpots* hot_spots) const {
    std::vector<const Frame*> shown;
    for (const Frame& frame : frames_) {
        shown.push_back(&frame);
    }
    const Frame& hottest_frame = hottest_ ? *hottest_ : last_;
    for (const Frame* extra : {&hottest_frame, &last_}) {
        if (std::ranges::none_of(shown, [&](const Frame* frame) { return frame->time == extra->time; })) {
            shown.push_back(extra);
        }
    }
    std::ranges::sort(shown, {}, &Frame::time);
    Range range;
    for (const Frame* frame : shown) {
        range.include(frame->hottest);
        for (const float celsius : frame->celsius) {
            range.include(static_cast<double>(celsius));
        }
    }
    const TimeUnit unit = time_unit(shown.back()->time - shown.front()->time);
    const bool mirrored = !folded_ && problem_.mesh.grid->mirror[0];
    std::vector<unsigned char> bytes;
    Value::List times;
    Value::List marks;
    std::size_t hottest = 0;
    for (std::size_t f = 0; f < shown.size(); ++f) {
        const Frame& frame = *shown[f];
        for (int side = 0; side < (mirrored ? 2 : 1); ++side) {
            for (const float celsius : frame.celsius) {
                const double share =
                    (static_cast<double>(celsius) - range.low) / std::max(range.high - range.low, 1e-9);
                const auto step = static_cast<std::uint16_t>(std::lround(steps * share));
                bytes.push_back(static_cast<unsigned char>(step & 0xFFU));
                bytes.push_back(static_cast<unsigned char>(step >> 8U));
            }
        }
        times.emplace_back(rounded(frame.time / unit.seconds));
        marks.emplace_back(Value::List{frame.at[0], frame.at[1], rounded(frame.hottest, 7)});
        hottest = frame.time == hottest_frame.time ? f : hottest;
    }
    Value data{{"kind", "field"},
               {"times", times},
               {"time_unit", unit.name},
               {"low", rounded(range.low, 7)},
               {"high", rounded(range.high, 7)},
               {"hottest", hottest},
               {"marks", marks},
               {"values", base64(bytes)}};
    if (folded_ && hot_spots != nullptr) {
        data.set("spots", spots(*hot_spots, shown));
    }
    data.set(outline());
    return data;
}

std::string FieldFrames::caption(const diagnosis::HotSpots* hot_spots) const {
    std::string layers;
    for (const std::string& layer : problem_.mesh.layers) {
        layers += (layers.empty() ? "" : ", ") + in_words(layer);
    }
    return fmt::format(
        "One colour scale for all moments; the circle is the hottest place of the moment that is shown.{}{}{} Layers "
        "from the outside in: {}.",
        folded_ && hot_spots != nullptr ? " The diamonds are the hot spots of the parts with a critical temperature."
                                        : "",
        problem_.mesh.sectors > 1 ? " Mean around the tire." : "",
        folded_ ? "" : " The colour of a cell is its mean; the circle stands in the hottest cell.", layers);
}

}  // namespace tiretherm::post
