// SPDX-License-Identifier: BSD-3-Clause
// Quadrilaterals of the drawn section with their temperatures, borders and names.
#include "post/page/field_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "mesh/ring.hpp"
#include "physics/celsius.hpp"
#include "post/page/charts.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

namespace {

constexpr double per_metre = 1e3;  ///< mm

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

/// Whether a mesh extends along x as well as through the thickness.
bool has_plane(const mesh::Mesh& mesh) { return mesh.grid && mesh.grid->size(0) > 1; }

/// The columns of a plane that are drawn: of a mirrored specimen both halves.
struct PlaneColumns {
    const mesh::Grid& grid;
    int kept;  ///< of the mesh, from its inner end on

    [[nodiscard]] bool mirrored() const { return grid.mirror[0]; }
    [[nodiscard]] int count() const { return mirrored() ? 2 * kept : kept; }
    [[nodiscard]] int of_mesh(int column) const {
        return !mirrored() ? column : column < kept ? kept - 1 - column : column - kept;
    }
    /// Both sides of a column, the left one first. m
    [[nodiscard]] std::array<double, 2> sides(int column) const {
        const auto i = static_cast<std::size_t>(of_mesh(column));
        const bool left = mirrored() && column < kept;
        return left ? std::array{-grid.edge[0][i + 1], -grid.edge[0][i]}
                    : std::array{grid.edge[0][i], grid.edge[0][i + 1]};
    }
};

/// The row of cells in the middle along y: at the plane of symmetry, the axis, or y = 0.
int middle_row(const mesh::Grid& grid) {
    const std::vector<double>& edge = grid.edge[1];
    const double y = grid.mirror[1] ? edge.front() : 0.5 * (edge.front() + edge.back());
    const auto above = std::ranges::upper_bound(edge, y) - edge.begin();
    return std::clamp(static_cast<int>(above) - 1, 0, grid.size(1) - 1);
}

/// How many columns from the axis outwards say something: a specimen is made wide so that its rim does not matter. The rest
/// differs at each depth from the outer end by less than 5 % of the range. Nothing is cut for less than a third, and never so
/// much that less than the depth is left on either side.
/// @param shown with values of the mesh's columns, depth after depth
int columns_worth_drawing(const mesh::Grid& grid, const std::vector<Moment>& shown) {
    const int all = grid.size(0);
    if (!grid.mirror[0]) {
        return all;
    }
    const auto width = static_cast<std::size_t>(all);
    int kept = 0;
    for (const Moment& moment : shown) {
        const auto [low, high] = std::ranges::minmax(moment.celsius);
        for (std::size_t i = 0; i < moment.celsius.size(); ++i) {
            const float at_end = moment.celsius[i / width * width + width - 1];
            if (std::abs(moment.celsius[i] - at_end) >= 0.05F * (high - low) && high > low) {
                kept = std::max(kept, static_cast<int>(i % width) + 2);
            }
        }
    }
    const std::vector<double>& x = grid.edge[0];
    const double deep = grid.edge[2].back() - grid.edge[2].front();
    kept = kept == 0 ? all : std::max(kept, static_cast<int>(std::ranges::lower_bound(x, deep) - x.begin()));
    return kept >= all || x[static_cast<std::size_t>(kept)] > 2.0 / 3.0 * x.back() ? all : kept;
}

/// Lines and names of the layers of a plane.
Value layers_of_plane(const mesh::Mesh& mesh, const Range& across) {
    const mesh::Grid& grid = *mesh.grid;
    const auto layer = [&](int row) { return mesh.layer[static_cast<std::size_t>(grid.cell(0, 0, row))]; };
    Value::List borders;
    Value::List places;
    double top = grid.edge[2].front();
    for (int k = 0; k < grid.size(2); ++k) {
        const bool is_last = k + 1 == grid.size(2);
        if (!is_last && layer(k) == layer(k + 1)) {
            continue;
        }
        const double bottom = grid.edge[2][static_cast<std::size_t>(k) + 1];
        places.emplace_back(Value{{"name", in_words(mesh.layers[static_cast<std::size_t>(layer(k))])},
                                  {"x", across.low},
                                  {"y", mm(0.5 * (top + bottom))}});
        if (!is_last) {
            borders.emplace_back(Value::List{across.low, mm(bottom), across.high, mm(bottom)});
        }
        top = bottom;
    }
    return {{"borders", std::move(borders)}, {"names", Value::List{}}, {"layer_places", std::move(places)}};
}

/// The cells of a plane, row by row from the surface on.
Value outline_of_plane(const mesh::Mesh& mesh, const PlaneColumns& columns) {
    const mesh::Grid& grid = *mesh.grid;
    Value::List polygons;
    Value::List layers;
    Range across;
    for (int k = 0; k < grid.size(2); ++k) {
        const double z0 = grid.edge[2][static_cast<std::size_t>(k)];
        const double z1 = grid.edge[2][static_cast<std::size_t>(k) + 1];
        for (int column = 0; column < columns.count(); ++column) {
            const auto [x0, x1] = columns.sides(column);
            add_polygon(polygons, std::array{x0, z0, x1, z0, x1, z1, x0, z1});
            layers.emplace_back(mesh.layer[static_cast<std::size_t>(grid.cell(columns.of_mesh(column), 0, k))]);
            across.include(per_metre * x0);
            across.include(per_metre * x1);
        }
    }
    const Range depth{.low = per_metre * grid.edge[2].front(), .high = per_metre * grid.edge[2].back()};
    const double whole = per_metre * grid.edge[0].back();
    const bool is_cut = columns.kept < grid.size(0);
    const std::string name = is_cut ? fmt::format("across, shown to {:.3g} of {:.3g}", across.high, whole) : "across";
    Value data{
        {"x", axis(name, across, 0.0, false)}, {"y", axis("depth", depth, 0.0, true)}, {"corners", 4},
        {"columns", columns.count()},          {"polygons", std::move(polygons)},      {"layers", std::move(layers)},
        {"layer_names", mesh.layers}};
    data.set(layers_of_plane(mesh, across));
    return data;
}

/// The cells of a folded section, each with arcs for its inner and outer side.
Value outline_of_section(const FoldedSection& section, const mesh::Mesh& mesh) {
    Value::List polygons;
    Value::List layers;
    Range across;
    Range along;
    constexpr int pieces = FoldedSection::pieces;
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        std::array<double, 4 * (pieces + 1)> polygon{};  // the inner side, and the outer side back
        for (int i = 0; i < 2 * (pieces + 1); ++i) {
            const bool inner = i <= pieces;
            const double u = static_cast<double>(inner ? i : 2 * pieces + 1 - i) / pieces;
            const FoldedSection::Place place = section.in_cell(cell, u, inner ? 0.0 : 1.0);
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
            {"corners", 2 * (pieces + 1)},
            {"polygons", std::move(polygons)},
            {"layers", std::move(layers)},
            {"layer_names", mesh.layers},
            {"borders", borders_of(section)},
            {"names", names_of(section, mesh)},
            {"layer_places", layer_places_of(section, mesh)}};
}

}  // namespace

FieldFrames::FieldFrames(const solver::Problem& problem)
    : problem_(problem),
      folded_(problem.mesh.is_section() && !problem.mesh.drawing.places.empty()),
      section_(folded_ && problem.mesh.is_ring() ? mesh::drawn_section(problem.mesh) : mesh::Mesh{}),
      drawn_(problem.mesh.is_ring() ? section_ : problem.mesh),
      finder_(problem.mesh, solver::nodes_of_layers(problem.mesh)) {
    if (folded_) {
        section_shape_.emplace(drawn_mesh());
    }
    if (folded_ && problem.mesh.is_ring()) {
        tread_.emplace(problem);
    }
}

Moment FieldFrames::of_plane(double time, std::span<const double> temperature) const {
    const mesh::Grid& grid = *problem_.mesh.grid;
    const int row = middle_row(grid);
    Moment moment{.time = time, .celsius = {}, .mark = {}};
    for (int k = 0; k < grid.size(2); ++k) {
        for (int i = 0; i < grid.size(0); ++i) {
            const double kelvin = temperature[static_cast<std::size_t>(grid.cell(i, row, k))];
            moment.celsius.push_back(static_cast<float>(celsius(kelvin)));
        }
    }
    const auto cell = static_cast<std::size_t>(std::ranges::max_element(moment.celsius) - moment.celsius.begin());
    const auto middle = [&](std::size_t side, std::size_t i) {
        return mm(0.5 * (grid.edge[side][i] + grid.edge[side][i + 1]));
    };
    const auto width = static_cast<std::size_t>(grid.size(0));
    moment.mark = {middle(0, cell % width), middle(2, cell / width), celsius(finder_.find(temperature).temperature)};
    return moment;
}

Moment FieldFrames::of_section(double time, std::span<const double> temperature) const {
    const bool is_ring = problem_.mesh.is_ring();
    const std::vector<double> mean = is_ring ? mesh::around(problem_.mesh, temperature) : std::vector<double>{};
    const std::span<const double> kelvin = is_ring ? std::span<const double>(mean) : temperature;
    const std::vector<double> at_corners = drawn_.at_points(kelvin);
    Moment moment{.time = time, .celsius = {}, .mark = {}};
    for (int cell = 0; cell < drawn_mesh().n_cells; ++cell) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            sum += at_corners[section_shape_->corner(cell, i)];
        }
        moment.celsius.push_back(static_cast<float>(celsius(0.25 * sum)));
    }
    const solver::HotSpotFinder::Found hottest = section_shape_->hottest(kelvin);
    const FoldedSection::Place at =
        section_shape_->place(hottest.point[0], hottest.point[2]).value_or(FoldedSection::Place{});
    moment.mark = {mm(at[0]), mm(at[1]), celsius(hottest.temperature)};
    return moment;
}

bool FieldFrames::is_drawn() const { return folded_ || has_plane(problem_.mesh); }

void FieldFrames::take(const solver::Snapshot& snapshot) {
    if (!snapshot.field || !is_drawn()) {
        return;
    }
    moments_.take(moment_of(snapshot.time, snapshot.temperature));
    if (tread_) {
        tread_->take(snapshot.time, snapshot.temperature);
    }
}

void FieldFrames::take_hottest(double time, std::span<const double> temperature) {
    if (!empty()) {
        moments_.show_first(moment_of(time, temperature));
    }
}

Value::List FieldFrames::spots(const diagnosis::HotSpots& hot_spots, const std::vector<Moment>& shown) const {
    Value::List list;
    for (const diagnosis::HotSpot& spot : hot_spots.spots) {
        const std::vector<double>& time = spot.history.time();
        Value::List places;
        for (const Moment& moment : shown) {
            auto row = static_cast<std::size_t>(std::ranges::lower_bound(time, moment.time) - time.begin());
            if (row >= time.size()) {
                places.emplace_back();
                continue;
            }
            // The hottest step may lie between two rows.
            row -= row > 0 && moment.time - time[row - 1] < time[row] - moment.time ? 1 : 0;
            const solver::HotSpotFinder::Found& found = spot.history.found(row);
            const auto at = section_shape_->place(found.point[0], found.point[2]);
            places.push_back(at ? Value(Value::List{mm((*at)[0]), mm((*at)[1]), rounded(celsius(found.temperature), 7)})
                                : Value());
        }
        const solver::Critical& critical = spot.history.critical();
        list.emplace_back(Value{{"name", critical.name},
                                {"critical", rounded(celsius(critical.temperature), 7)},
                                {"at", std::move(places)}});
    }
    return list;
}

Value FieldFrames::chart(const diagnosis::HotSpots* hot_spots) const {
    std::vector<Moment> shown = moments_.shown();
    Value data{{"kind", "field"}};
    if (folded_) {
        data.set(moments_.data(shown));
        if (hot_spots != nullptr) {
            data.set("spots", spots(*hot_spots, shown));
        }
        data.set(outline_of_section(*section_shape_, drawn_mesh()));
        return data;
    }
    const mesh::Grid& grid = *problem_.mesh.grid;
    const PlaneColumns columns{.grid = grid, .kept = columns_worth_drawing(grid, shown)};
    for (Moment& moment : shown) {
        std::vector<float> drawn;
        for (int k = 0; k < grid.size(2); ++k) {
            for (int column = 0; column < columns.count(); ++column) {
                drawn.push_back(moment.celsius[static_cast<std::size_t>(k * grid.size(0) + columns.of_mesh(column))]);
            }
        }
        moment.celsius = std::move(drawn);
    }
    data.set(moments_.data(shown));
    data.set(outline_of_plane(problem_.mesh, columns));
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
        problem_.mesh.is_ring() ? " Mean around the tire." : "",
        folded_ ? "" : " The colour of a cell is its mean; the circle stands in the hottest cell. Lines are isotherms.",
        layers);
}

}  // namespace tiretherm::post
