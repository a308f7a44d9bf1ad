// SPDX-License-Identifier: BSD-3-Clause
// Integrates the piecewise linear field over each face or cell, along the meridian and then along the contact or in
// depth, and reports points outside the mesh.

#include "physics/field_transfer/field_transfer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "physics/field_transfer/field_line.hpp"

namespace tiretherm::physics {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Cells through the thickness at one stretch of the meridian.
struct Strip {
    double from = -infinite;
    double to = infinite;
    int first_cell = 0;
    std::vector<double> edge{};  ///< m, depths

    [[nodiscard]] double width() const { return to - from; }
};

std::vector<Strip> strips_of(const mesh::Mesh& mesh) {
    std::vector<Strip> strips;
    for (const mesh::Column& column : mesh.columns) {
        strips.push_back({column.from, column.to, column.first_cell, column.edge});
    }
    if (strips.empty() && mesh.grid && mesh.grid->size(0) == 1 && mesh.grid->size(1) == 1) {
        strips.push_back({.edge = mesh.grid->edge[2]});
    }
    return strips;
}

/// The stretch of the meridian that belongs to a face; without end on a mesh of one face.
Strip strip_of(const mesh::Mesh& mesh, const mesh::PatchFace& face) {
    return mesh.is_section() ? Strip{.from = face.extent[0], .to = face.extent[1]} : Strip{};
}

/// How much of a strip each row covers, as a share of it; of a strip without end as a share of what the rows cover.
struct Cover {
    std::vector<double> share;
    double width = 0.0;  ///< m, of the strip; 0 where it has no end and there is one row
};

Cover cover_of(const FieldLine& line, const Strip& strip) {
    const bool endless = std::isinf(strip.from);
    if (endless && line.size() == 1) {
        return {.share = {1.0}};
    }
    Cover cover{.share = line.integrals(strip.from, strip.to)};
    cover.width = endless ? std::accumulate(cover.share.begin(), cover.share.end(), 0.0) : strip.width();
    for (double& share : cover.share) {
        share /= cover.width;
    }
    return cover;
}

/// Collects what every node has of every point, and makes shares of it.
class Collector {
public:
    Collector(std::size_t points, std::vector<int> nodes) : has_(points) { transfer_.nodes = std::move(nodes); }

    void add(std::size_t point, std::size_t node, double measure) {
        if (measure > 0.0) {
            has_[point][node] += measure;
        }
    }
    FieldTransfer shares(const std::vector<double>& given) {
        transfer_.measure.assign(has_.size(), 0.0);
        for (std::size_t p = 0; p < has_.size(); ++p) {
            assert(!has_[p].empty());
            for (const auto& [node, measure] : has_[p]) {
                transfer_.measure[p] += measure;
            }
            for (const auto& [node, measure] : has_[p]) {
                transfer_.shares.push_back({p, node, measure / transfer_.measure[p]});
            }
        }
        if (!given.empty()) {
            transfer_.measure = given;
        }
        return std::move(transfer_);
    }

private:
    std::vector<std::map<std::size_t, double>> has_;
    FieldTransfer transfer_;
};

/// The strip at a place of the meridian, at a border the thicker one; the end when there is none.
std::vector<Strip>::const_iterator thickest_at(const std::vector<Strip>& strips, double y) {
    auto found = strips.end();
    for (auto strip = strips.begin(); strip != strips.end(); ++strip) {
        const bool here = y >= strip->from - same_place && y <= strip->to + same_place;
        const bool thicker = found == strips.end() || strip->edge.empty() || strip->edge.back() > found->edge.back();
        found = here && thicker ? strip : found;
    }
    return found;
}

}  // namespace

Spacings spacings(const FieldPoints& points) {
    const std::vector<FieldRow> rows = rows_of(points.size(), points.across, points.along);
    const auto alone = [&](const FieldRow& row) { return places_of(row, points.along).at.size() < 2; };
    return {.rows = rows.size(), .alone = std::ranges::any_of(rows, alone)};
}

std::vector<double> FieldTransfer::watts(std::span<const double> density) const {
    std::vector<double> found(nodes.size());
    for (const Share& share : shares) {
        found[share.node] += density[share.point] * measure[share.point] * share.share;
    }
    return found;
}

double FieldTransfer::total(std::span<const double> density) const {
    return std::inner_product(density.begin(), density.end(), measure.begin(), 0.0);
}

FieldTransfer onto_faces(const mesh::Mesh& mesh, std::span<const int> patches, const FieldPoints& points) {
    std::vector<const mesh::PatchFace*> faces;
    std::vector<int> nodes;
    for (const int patch : patches) {
        for (const mesh::PatchFace& face : mesh.patches[at(patch)].faces) {
            faces.push_back(&face);
            nodes.push_back(face.node);
        }
    }
    Collector collector(points.size(), std::move(nodes));
    const std::vector<FieldRow> rows = rows_of(points.size(), points.across, points.along);
    const FieldLine line(values_of(rows));
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (!points.cell.empty()) {
            for (std::size_t p = 0; p < points.size(); ++p) {
                const auto sharing = static_cast<double>(std::ranges::count(points.cell, points.cell[p]));
                collector.add(p, f, points.cell[p] == faces[f]->cell ? faces[f]->area / sharing : 0.0);
            }
            continue;
        }
        const Strip strip = strip_of(mesh, *faces[f]);
        const Cover cover = cover_of(line, strip);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const Places places = places_of(rows[r], points.along);
            // Points of the contact stand for its own area, a mean around the tire for that of the whole face.
            const bool lengths = places.at.size() > 1;
            const std::vector<double> length =
                lengths ? FieldLine(places.at).integrals(-infinite, infinite) : std::vector<double>{1.0};
            const double base = lengths && cover.width > 0.0 ? cover.width : faces[f]->area;
            for (std::size_t i = 0; i < rows[r].points.size(); ++i) {
                const std::size_t place = places.of[i];
                collector.add(rows[r].points[i], f, base * cover.share[r] * length[place] / places.together[place]);
            }
        }
    }
    return collector.shares(points.measure);
}

FieldTransfer onto_cells(const mesh::Mesh& mesh, const FieldPoints& points) {
    std::vector<int> nodes(at(mesh.n_cells));
    std::iota(nodes.begin(), nodes.end(), 0);
    Collector collector(points.size(), std::move(nodes));
    if (!points.cell.empty()) {
        for (std::size_t p = 0; p < points.size(); ++p) {
            const auto sharing = static_cast<double>(std::ranges::count(points.cell, points.cell[p]));
            collector.add(p, at(points.cell[p]), mesh.volume[at(points.cell[p])] / sharing);
        }
        return collector.shares(points.measure);
    }
    const std::vector<FieldRow> rows = rows_of(points.size(), points.across, points.depth);
    const FieldLine line(values_of(rows));
    for (const Strip& strip : strips_of(mesh)) {
        const Cover cover = cover_of(line, strip);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            if (cover.share[r] <= 0.0) {
                continue;
            }
            const Places places = places_of(rows[r], points.depth);
            const FieldLine through(places.at);
            for (std::size_t k = 0; k + 1 < strip.edge.size(); ++k) {
                const double thickness = strip.edge[k + 1] - strip.edge[k];
                const std::vector<double> deep = through.integrals(strip.edge[k], strip.edge[k + 1]);
                const std::size_t cell = at(strip.first_cell) + k;
                for (std::size_t i = 0; i < rows[r].points.size(); ++i) {
                    const std::size_t place = places.of[i];
                    collector.add(
                        rows[r].points[i], cell,
                        mesh.volume[cell] * cover.share[r] * deep[place] / thickness / places.together[place]);
                }
            }
        }
    }
    return collector.shares(points.measure);
}

std::vector<Stray> strays(const mesh::Mesh& mesh, std::span<const int> patches, const FieldPoints& points) {
    std::vector<Strip> strips;
    std::vector<int> cells;
    if (patches.empty()) {
        strips = strips_of(mesh);
        cells.resize(at(mesh.n_cells));
        std::iota(cells.begin(), cells.end(), 0);
    }
    for (const int patch : patches) {
        for (const mesh::PatchFace& face : mesh.patches[at(patch)].faces) {
            strips.push_back(strip_of(mesh, face));
            cells.push_back(face.cell);
        }
    }
    std::vector<Stray> found;
    const char* what = patches.empty() ? "tire" : "tread";
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!points.cell.empty()) {
            if (std::ranges::find(cells, points.cell[p]) == cells.end()) {
                found.push_back(
                    {p, fmt::format("cell {} is {}", points.cell[p],
                                    patches.empty() ? fmt::format("none of the mesh's, 0 to {}", mesh.n_cells - 1)
                                                    : "not at the outer surface of the tread")});
            }
            continue;
        }
        const double y = points.across[p];
        const auto strip = thickest_at(strips, y);
        if (strip == strips.end()) {
            double low = infinite;
            double high = -infinite;
            for (const Strip& s : strips) {
                low = std::min(low, s.from);
                high = std::max(high, s.to);
            }
            found.push_back({p, fmt::format("y is {:.4g} mm, beyond the {}, which reaches from {:.4g} to {:.4g} mm",
                                            1e3 * y, what, 1e3 * low, 1e3 * high)});
        } else if (patches.empty() && !points.depth.empty() && points.depth[p] > strip->edge.back() + same_place) {
            found.push_back({p, fmt::format("depth is {:.4g} mm at y = {:.4g} mm, where the tire is {:.4g} mm thick",
                                            1e3 * points.depth[p], 1e3 * y, 1e3 * strip->edge.back())});
        }
    }
    return found;
}

}  // namespace tiretherm::physics
