// SPDX-License-Identifier: BSD-3-Clause
// Copies the section's cells into equal sectors and joins each cell to the one in the next sector by a face along the
// arc; the first sector has its middle at angle 0.

#include "mesh/ring.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "mesh/column_probe.hpp"
#include "mesh/index.hpp"

namespace tiretherm::mesh {

namespace {

/// How the nodes of a ring are numbered: cells sector after sector, then surface nodes sector by sector, then lumped.
struct Numbering {
    int sectors = 1;
    int cells = 0;  ///< of one sector
    int lumped = 0;
    int surfaces = 0;  ///< of one sector

    explicit Numbering(const Mesh& ring)
        : sectors(ring.sectors),
          cells(ring.n_cells / ring.sectors),
          lumped(static_cast<int>(ring.lumped_nodes.size())),
          surfaces((ring.n_nodes - lumped - ring.n_cells) / ring.sectors) {}

    [[nodiscard]] int total() const { return sectors * (cells + surfaces); }
    [[nodiscard]] int section_nodes() const { return cells + surfaces + lumped; }
    /// A node of the section in a sector.
    [[nodiscard]] int node(int of_section, int sector) const {
        if (of_section < cells) {
            return sector * cells + of_section;
        }
        return of_section < cells + surfaces ? sectors * cells + sector * surfaces + of_section - cells
                                             : total() + of_section - cells - surfaces;
    }
    /// The node of the section of which a node is a copy.
    [[nodiscard]] int of_section(int node) const {
        if (node < sectors * cells) {
            return node % cells;
        }
        return node < total() ? cells + (node - sectors * cells) % surfaces : node - total() + cells + surfaces;
    }
    [[nodiscard]] int sector(int node) const {
        if (node < sectors * cells) {
            return node / cells;
        }
        return node < total() ? (node - sectors * cells) / surfaces : -1;
    }
};

constexpr double turn = 2.0 * std::numbers::pi;

class RingBuilder {
public:
    RingBuilder(const Mesh& section, int sectors) : section_(section) {
        ring_.kind = "ring";
        ring_.sectors = sectors;
        ring_.n_cells = sectors * section.n_cells;
        ring_.n_nodes = sectors * section.n_nodes;
        ring_.layers = section.layers;
        ring_.zones = section.zones;
        ring_.links = section.links;
    }

    Mesh build() {
        const Numbering number(ring_);
        const double share = 1.0 / ring_.sectors;
        add_nodes(number, share);
        ring_.faces.reserve(at(ring_.sectors) * (section_.faces.size() + at(section_.n_cells)));
        for (int s = 0; s < ring_.sectors; ++s) {
            for (Face face : section_.faces) {
                face.a = number.node(face.a, s);
                face.b = number.node(face.b, s);
                face.area *= share;
                ring_.faces.push_back(face);
            }
        }
        add_faces_around(number);
        add_patches(number, share);
        ring_.columns = section_.columns;
        for (Column& column : ring_.columns) {
            column.outer = number.node(column.outer, 0);
            column.inner = number.node(column.inner, 0);
        }
        for (const Region& region : section_.regions) {
            ring_.regions.push_back({.name = region.name, .mean = around(ring_, in_first(number, region.mean))});
        }
        draw();
        return std::move(ring_);
    }

private:
    [[nodiscard]] double radius(int node) const {
        return section_.columns[at(static_cast<int>(column_at(section_, section_.centre[at(node)][0])))].radius;
    }
    [[nodiscard]] double angle(int sector) const { return turn * sector / ring_.sectors; }

    void add_nodes(const Numbering& number, double share) {
        ring_.volume.resize(at(ring_.n_nodes));
        ring_.centre.resize(at(ring_.n_nodes));
        ring_.layer.resize(at(ring_.n_nodes));
        ring_.zone.resize(at(ring_.n_nodes));
        for (int node = 0; node < ring_.n_nodes; ++node) {
            const std::size_t from = at(number.of_section(node));
            ring_.volume[at(node)] = section_.volume[from] * share;
            ring_.centre[at(node)] = section_.centre[from];
            ring_.centre[at(node)][1] = angle(number.sector(node)) * radius(static_cast<int>(from));
            ring_.layer[at(node)] = section_.layer[from];
            ring_.zone[at(node)] = section_.zone[from];
        }
    }

    void add_faces_around(const Numbering& number) {
        for (const Column& column : section_.columns) {
            const double arc = turn * column.radius / ring_.sectors;
            for (int cell = column.first_cell; cell < column.first_cell + column.cells(); ++cell) {
                const double area = section_.volume[at(cell)] / (turn * column.radius);
                for (int s = 0; s < ring_.sectors; ++s) {
                    ring_.faces.push_back({.a = number.node(cell, s),
                                           .b = number.node(cell, (s + 1) % ring_.sectors),
                                           .area = area,
                                           .half_a = 0.5 * arc,
                                           .half_b = 0.5 * arc,
                                           .axis = Axis::circumference});
                }
            }
        }
    }

    void add_patches(const Numbering& number, double share) {
        for (const Patch& patch : section_.patches) {
            Patch& all = ring_.patches.emplace_back(Patch{.name = patch.name, .faces = {}});
            all.faces.reserve(at(ring_.sectors) * patch.faces.size());
            for (int s = 0; s < ring_.sectors; ++s) {
                for (PatchFace face : patch.faces) {
                    const double r = radius(face.node);
                    face.node = number.node(face.node, s);
                    face.cell = number.node(face.cell, s);
                    face.area *= share;
                    face.centre[1] = angle(s) * r;
                    const double half = 0.5 * turn * r * share;
                    face.extent[2] = face.centre[1] - half;
                    face.extent[3] = face.centre[1] + half;
                    all.faces.push_back(face);
                }
            }
        }
    }

    [[nodiscard]] static Functional in_first(const Numbering& number, Functional reading) {
        for (int& node : reading.nodes) {
            node = number.node(node, 0);
        }
        return reading;
    }

    /// The section's plane turned about the tire's axis, x; angle 0 is at the top, z.
    void draw() {
        const Drawing& flat = section_.drawing;
        const auto n = std::ssize(flat.points);
        ring_.drawing.shape = CellShape::hexahedron;
        ring_.drawing.points.reserve(at(ring_.sectors) * flat.points.size());
        ring_.drawing.places.reserve(at(ring_.sectors) * flat.points.size());
        ring_.drawing.corners.reserve(at(ring_.sectors) * 2 * flat.corners.size());
        for (int border = 0; border < ring_.sectors; ++border) {
            const double where = turn * (border - 0.5) / ring_.sectors;
            for (std::size_t i = 0; i < flat.points.size(); ++i) {
                const double r = flat.points[i][2];
                ring_.drawing.points.push_back({flat.points[i][0], r * std::sin(where), r * std::cos(where)});
                Point place = flat.places[i];
                place[1] = where * section_.columns[at(static_cast<int>(column_at(section_, place[0])))].radius;
                ring_.drawing.places.push_back(place);
            }
        }
        for (int s = 0; s < ring_.sectors; ++s) {
            const auto front = static_cast<int>(n) * s;
            const auto back = static_cast<int>(n) * ((s + 1) % ring_.sectors);
            for (std::size_t c = 0; c < flat.corners.size(); c += 4) {
                for (const int offset : {back, front}) {
                    for (std::size_t i = 0; i < 4; ++i) {
                        ring_.drawing.corners.push_back(flat.corners[c + i] + offset);
                    }
                }
            }
        }
    }

    const Mesh& section_;
    Mesh ring_;
};

}  // namespace

Mesh ring(const Mesh& section, int sectors) {
    assert(!section.columns.empty() && section.lumped_nodes.empty() && section.sectors == 1);
    return RingBuilder(section, sectors).build();
}

int sector_of(const Mesh& ring, int node) { return Numbering(ring).sector(node); }

Functional around(const Mesh& ring, const Functional& reading) {
    const Numbering number(ring);
    Functional merged;  // of the section's nodes
    for (std::size_t i = 0; i < reading.nodes.size(); ++i) {
        merged.nodes.push_back(number.of_section(reading.nodes[i]));
    }
    std::vector<double> weight(at(number.section_nodes()));
    for (std::size_t i = 0; i < merged.nodes.size(); ++i) {
        weight[at(merged.nodes[i])] += reading.weights[i];
    }
    std::ranges::sort(merged.nodes);
    merged.nodes.erase(std::unique(merged.nodes.begin(), merged.nodes.end()), merged.nodes.end());
    Functional mean;
    for (const int node : merged.nodes) {
        const int copies = number.sector(number.node(node, 0)) < 0 ? 1 : ring.sectors;
        for (int s = 0; s < copies; ++s) {
            mean.nodes.push_back(number.node(node, s));
            mean.weights.push_back(weight[at(node)] / copies);
        }
    }
    return mean;
}

Column in_sector(const Mesh& ring, Column column, int sector) {
    const Numbering number(ring);
    const auto moved = [&](int node) { return number.node(number.of_section(node), sector); };
    column.first_cell = moved(column.first_cell);
    column.outer = moved(column.outer);
    column.inner = moved(column.inner);
    return column;
}

Functional at_angle(const Mesh& ring, const Functional& in_first_sector, double angle) {
    const Numbering number(ring);
    const double position = angle / turn * ring.sectors;
    const double below = std::floor(position);
    const auto sector = [&](double s) {
        const auto whole = static_cast<int>(std::fmod(s, ring.sectors));
        return whole < 0 ? whole + ring.sectors : whole;
    };
    Functional moved;
    for (std::size_t i = 0; i < in_first_sector.nodes.size(); ++i) {
        const int node = number.of_section(in_first_sector.nodes[i]);
        const double weight = in_first_sector.weights[i];
        moved.add(number.node(node, sector(below)), weight * (1.0 - (position - below)));
        if (position > below) {
            moved.add(number.node(node, sector(below + 1.0)), weight * (position - below));
        }
    }
    return moved;
}

Mesh drawn_section(const Mesh& ring) {
    const Numbering number(ring);
    Mesh section;
    section.kind = "section";
    section.n_cells = number.cells;
    section.n_nodes = number.section_nodes();
    section.layers = ring.layers;
    section.zones = ring.zones;
    for (int node = 0; node < section.n_nodes; ++node) {
        const std::size_t from = at(number.node(node, 0));
        section.volume.push_back(ring.volume[from] * ring.sectors);
        section.centre.push_back(ring.centre[from]);
        section.layer.push_back(ring.layer[from]);
        section.zone.push_back(ring.zone[from]);
    }
    section.columns = ring.columns;
    for (Column& column : section.columns) {
        column.outer = number.of_section(column.outer);
        column.inner = number.of_section(column.inner);
    }
    // What is drawn of a ring before its first sector is the section, turned back by half a sector.
    section.drawing.shape = CellShape::quadrilateral;
    for (std::size_t i = 0; i < ring.drawing.points.size() / at(ring.sectors); ++i) {
        const auto [x, y, z] = ring.drawing.points[i];
        section.drawing.points.push_back({x, 0.0, std::hypot(y, z)});
        section.drawing.places.push_back({ring.drawing.places[i][0], 0.0, ring.drawing.places[i][2]});
    }
    for (std::size_t corner = 0; corner < at(8 * number.cells); ++corner) {
        if (corner % 8 >= 4) {
            section.drawing.corners.push_back(ring.drawing.corners[corner]);
        }
    }
    return section;
}

std::vector<double> around(const Mesh& ring, std::span<const double> temperature) {
    const Numbering number(ring);
    std::vector<double> mean(at(number.section_nodes()));
    for (int node = 0; node < ring.n_nodes; ++node) {
        const double share = number.sector(node) < 0 ? 1.0 : 1.0 / ring.sectors;
        mean[at(number.of_section(node))] += share * temperature[at(node)];
    }
    return mean;
}

}  // namespace tiretherm::mesh
