// SPDX-License-Identifier: BSD-3-Clause
// Parabolas through three nodes about the hottest one, in depth and along the meridian, on one side of jumps of
// material or thickness.

#include "solver/hot_spot_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "mesh/index.hpp"
#include "mesh/ring.hpp"

namespace tiretherm::solver {

namespace {

/// Two mirrored shoulders are equally hot but for round-off: the first one is reported, always. K
constexpr double as_hot = 1e-7;

/// Beside a jump the field bends much more than it does further on: a parabola across both overshoots. Between two nodes it
/// bends at most this many times as much as behind the second of them. In a smooth field the two are nearly equal.
constexpr double most_bend = 2.0;

/// Three points with the parabola through them.
struct Three {
    std::array<double, 3> x{};
    std::array<double, 3> f{};

    [[nodiscard]] double slope(std::size_t i) const { return (f[i + 1] - f[i]) / (x[i + 1] - x[i]); }
    [[nodiscard]] double bend() const { return (slope(1) - slope(0)) / (x[2] - x[0]); }
};

/// The highest place between two limits, and its weights there.
struct Peak {
    double at = 0.0;
    std::array<double, 3> weight{};
};

/// Of the straight line from the first point to the second with `times` the bend of the parabola, which it is with 1.
Peak peak(const Three& three, double times, double low, double high) {
    const std::array<double, 3>& x = three.x;
    const double slope = three.slope(0);
    const double bend = times * three.bend();
    const auto value = [&](double z) { return (z - x[0]) * (slope + (z - x[1]) * bend); };
    Peak found;
    if (bend < 0.0) {
        found.at = std::clamp(0.5 * (x[0] + x[1] - slope / bend), low, high);
    } else {
        found.at = value(low) > value(high) ? low : high;
    }
    const double along = (found.at - x[0]) / (x[1] - x[0]);
    const double across = times * (found.at - x[0]) * (found.at - x[1]);
    found.weight = {1.0 - along + across / ((x[0] - x[1]) * (x[0] - x[2])),
                    along + across / ((x[1] - x[0]) * (x[1] - x[2])), across / ((x[2] - x[0]) * (x[2] - x[1]))};
    return found;
}

/// Three neighbours in a row about one of them, on its own side of whatever interrupts the row.
/// @param joined whether i and i + 1 belong together  @returns the first of them; n where there are not three
template <typename Joined>
std::size_t three_about(std::size_t i, std::size_t n, const Joined& joined) {
    const auto whole = [&](std::size_t first) { return first + 2 < n && joined(first) && joined(first + 1); };
    for (const std::size_t back : {1U, 0U, 2U}) {
        if (i >= back && whole(i - back)) {
            return i - back;
        }
    }
    return n;
}

}  // namespace

HotSpotFinder::HotSpotFinder(const mesh::Mesh& mesh, std::vector<int> nodes)
    : mesh_(&mesh), nodes_(std::move(nodes)), line_positions_(at(mesh.n_nodes)) {
    for (std::size_t i = 0; i < columns(); ++i) {
        const mesh::Column column = mesh::in_sector(mesh, column_of(i), static_cast<int>(i / mesh.columns.size()));
        Line line{.node = {column.outer}, .edge = column_of(i).edge, .first_cell = 1};
        for (int k = 0; k < column.cells(); ++k) {
            line.node.push_back(column.first_cell + k);
        }
        line.node.push_back(column.inner);
        add_line(std::move(line));
    }
    if (mesh.grid) {
        const mesh::Grid& grid = *mesh.grid;
        const auto has = [&](mesh::Side side) { return !grid.surface[static_cast<std::size_t>(side)].empty(); };
        for (int j = 0; j < grid.size(1); ++j) {
            for (int i = 0; i < grid.size(0); ++i) {
                Line line{.edge = grid.edge[2]};
                if (has(mesh::Side::z_min)) {
                    line.node.push_back(grid.surface_node(mesh::Side::z_min, i, j, 0));
                    line.first_cell = 1;
                }
                for (int k = 0; k < grid.size(2); ++k) {
                    line.node.push_back(grid.cell(i, j, k));
                }
                if (has(mesh::Side::z_max)) {
                    line.node.push_back(grid.surface_node(mesh::Side::z_max, i, j, 0));
                }
                add_line(std::move(line));
            }
        }
    }
    goes_on_.assign(lines_.size(), false);
    for (std::size_t i = 0; i + 1 < columns(); ++i) {
        const auto layer_of = [&](int node) { return mesh.layer[at(node)]; };
        const bool ends_sector = (i + 1) % mesh.columns.size() == 0;
        goes_on_[i] = !ends_sector && std::ranges::equal(lines_[i].edge, lines_[i + 1].edge, [](double a, double b) {
            return std::abs(a - b) < 1e-9;
        }) && std::ranges::equal(lines_[i].node, lines_[i + 1].node, {}, layer_of, layer_of);
    }
}

void HotSpotFinder::add_line(Line line) {
    for (std::size_t i = 0; i < line.node.size(); ++i) {
        line_positions_[at(line.node[i])] = {.line = static_cast<int>(lines_.size()), .index = i};
    }
    lines_.push_back(std::move(line));
}

int HotSpotFinder::hottest_node(std::span<const double> T) const {
    int hottest = nodes_.front();
    for (const int node : nodes_) {
        hottest = T[at(node)] > T[at(hottest)] + as_hot ? node : hottest;
    }
    return hottest;
}

/// Between three neighbours from `first` on, where the parabola through them is highest between two limits. Towards a
/// neighbour behind which the field goes on, it bends no more than `most_bend` allows.
/// @param joined whether i and i + 1 of n belong together
template <typename Joined, typename Place, typename Value>
HotSpotFinder::Interpolant HotSpotFinder::at_peak(std::size_t first, std::size_t n, const Joined& joined,
                                                  const Place& place, const Value& value, double low, double high) {
    const auto about = [&](const std::array<std::size_t, 3>& index) {
        return Three{.x = {place(index[0]), place(index[1]), place(index[2])},
                     .f = {value(index[0]), value(index[1]), value(index[2])}};
    };
    const auto put = [](const std::array<std::size_t, 3>& index, const Peak& found) {
        return Interpolant{.at = found.at, .index = index, .weight = found.weight, .count = 3};
    };
    const std::array<std::size_t, 3> index{first, first + 1, first + 2};
    const Three three = about(index);
    const Peak found = peak(three, 1.0, low, high);
    const double middle = three.x[1];
    if (found.at > middle && first + 3 < n && joined(first + 2)) {
        const std::array<std::size_t, 3> behind{first + 1, first + 2, first + 3};
        if (const Three other = about(behind); most_bend * other.bend() > three.bend()) {
            return put(behind, peak(other, other.bend() < 0.0 ? most_bend : 0.0, middle, high));
        }
    } else if (found.at < middle && first > 0 && joined(first - 1)) {
        const std::array<std::size_t, 3> behind{first + 1, first, first - 1};
        if (const Three other = about(behind); most_bend * other.bend() > three.bend()) {
            return put(behind, peak(other, other.bend() < 0.0 ? most_bend : 0.0, low, middle));
        }
    }
    return put(index, found);
}

/// A surface is a place of its own: nothing lies beyond it.
HotSpotFinder::Interpolant HotSpotFinder::in_depth(const LinePosition& position, std::span<const double> T) const {
    const Line& line = lines_[at(position.line)];
    const std::size_t n = line.node.size();
    Interpolant here{.at = line.depth(position.index), .index = {position.index, position.index, position.index}};
    const std::size_t cell = position.index - line.first_cell;
    if (position.index < line.first_cell || cell + 1 >= line.edge.size()) {
        return here;
    }
    const auto joined = [&](std::size_t i) {
        return mesh_->layer[at(line.node[i])] == mesh_->layer[at(line.node[i + 1])];
    };
    std::size_t first = three_about(position.index, n, joined);
    if (first == n) {
        first = three_about(position.index, n, [](std::size_t) { return true; });
    }
    if (first == n) {
        return here;
    }
    return at_peak(
        first, n, joined, [&](std::size_t i) { return line.depth(i); },
        [&](std::size_t i) { return T[at(line.node[i])]; }, line.edge[cell], line.edge[cell + 1]);
}

double HotSpotFinder::at_depth(std::size_t line, const Interpolant& depth, std::span<const double> T) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < depth.count; ++i) {
        sum += depth.weight[i] * T[at(lines_[line].node[depth.index[i]])];
    }
    return sum;
}

HotSpotFinder::Interpolant HotSpotFinder::along(std::size_t line, const Interpolant& depth,
                                                std::span<const double> T) const {
    Interpolant here{.index = {line, line, line}};
    if (line >= columns()) {
        return here;
    }
    const mesh::Column& column = column_of(line);
    here.at = column.middle();
    const std::size_t n = lines_.size();
    const auto joined = [&](std::size_t i) { return goes_on_[i]; };
    const std::size_t first = three_about(line, n, joined);
    if (first == n) {
        return here;
    }
    // Where the thickness jumps the field turns into the neighbour: the parabola is not carried on towards it.
    const bool ends_before = line == first;
    const bool ends_behind = line == first + 2;
    return at_peak(
        first, n, joined, [&](std::size_t i) { return column_of(i).middle(); },
        [&](std::size_t i) { return at_depth(i, depth, T); }, ends_before ? column.middle() : column.from,
        ends_behind ? column.middle() : column.to);
}

HotSpotFinder::Found HotSpotFinder::find(std::span<const double> temperature) const {
    Found found{.temperature = std::numeric_limits<double>::quiet_NaN()};
    if (nodes_.empty()) {
        return found;
    }
    found.node = hottest_node(temperature);
    found.temperature = temperature[at(found.node)];
    found.point = mesh_->centre[at(found.node)];
    const LinePosition& position = line_positions_[at(found.node)];
    if (position.line < 0) {
        return found;
    }
    const Interpolant depth = in_depth(position, temperature);
    const Interpolant beside = along(at(position.line), depth, temperature);
    found.temperature = 0.0;
    for (std::size_t i = 0; i < beside.count; ++i) {
        found.temperature += beside.weight[i] * at_depth(beside.index[i], depth, temperature);
    }
    found.point[2] = depth.at;
    if (at(position.line) < columns()) {
        found.point[0] = beside.at;
    }
    return found;
}

mesh::Functional HotSpotFinder::functional(std::span<const double> temperature) const {
    mesh::Functional place;
    if (nodes_.empty()) {
        return place;
    }
    const int node = hottest_node(temperature);
    const LinePosition& position = line_positions_[at(node)];
    if (position.line < 0) {
        place.add(node, 1.0);
        return place;
    }
    const Interpolant depth = in_depth(position, temperature);
    const Interpolant beside = along(at(position.line), depth, temperature);
    for (std::size_t i = 0; i < beside.count; ++i) {
        for (std::size_t k = 0; k < depth.count; ++k) {
            place.add(lines_[beside.index[i]].node[depth.index[k]], beside.weight[i] * depth.weight[k]);
        }
    }
    return place;
}

std::vector<int> all_nodes(const mesh::Mesh& mesh) {
    std::vector<int> nodes(at(mesh.n_nodes));
    std::iota(nodes.begin(), nodes.end(), 0);
    return nodes;
}

std::vector<int> nodes_of_layers(const mesh::Mesh& mesh) {
    std::vector<int> nodes = all_nodes(mesh);
    std::erase_if(nodes, [&](int node) { return mesh.layer[at(node)] < 0; });
    return nodes;
}

}  // namespace tiretherm::solver
