// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of the meshes (two nodes, layers, cylinder, section, block, disc) and the functions that build each of
// them as a graph of cells and faces.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/meridian.hpp"
#include "mesh/mesh.hpp"

namespace tiretherm::mesh {

/// Two lumps, surface and bulk, without internal resistance and joined by one link (thesis (31)).
/// Layers "surface", "bulk"; regions "surface", "bulk"; patch "outside" on the surface lump, "inside" on the bulk lump.
struct TwoNode {
    double area = 0.0;            ///< m2, S_tot = 2 pi R0 W
    double surface_volume = 0.0;  ///< m3
    double bulk_volume = 0.0;     ///< m3
    double bulk_depth = 0.0;      ///< m, dZ
};
[[nodiscard]] Mesh build(const TwoNode& description);

/// One layer through the thickness, from the outside in.
struct Layer {
    std::string name;
    double thickness = 0.0;  ///< m
    int cells = 1;
    double ratio = 1.0;  ///< innermost cell's thickness over the outermost's
};

/// N cells through the thickness of a flat strip. Regions "surface" (outer surface) and "bulk" (all layers but the
/// first, by volume; the only layer when there is one); patches "outside", "inside".
struct Layers {
    double area = 0.0;  ///< m2
    std::vector<Layer> stack;
    int link_below = -1;       ///< layer below which a link is inserted, or -1
    double link_length = 0.0;  ///< m
};
[[nodiscard]] Mesh build(const Layers& description);

/// N cells through the thickness of a hollow cylinder about the tire's axis, such as a thick tread, a drum or a rim: layers
/// with their true radii. Regions and patches as of Layers.
struct Cylinder {
    double inner_radius = 0.0;  ///< m, > 0
    double length = 0.0;        ///< m, along the axis
    std::vector<Layer> stack;   ///< from the outside in
};
[[nodiscard]] Mesh build(const Cylinder& description);

/// A stretch of the meridian with one stack of layers. Zones follow each other from outboard to inboard.
struct Zone {
    std::string name;
    double length = 0.0;  ///< m along the meridian
    int cells = 1;
    double ratio = 1.0;      ///< inboard end's cell over the outboard end's
    std::vector<int> stack;  ///< indices into Section::layers, from the outside in
    bool tread = true;       ///< its outer surface meets the road
};

/// A cross-section: radial columns along the meridian, unrolled for the metric. A column's cells are rings of the
/// column's mean radius, whatever their depth. Zones are aligned at their inner surface: where one is thinner, its outer
/// surface lies deeper, and the step's flank exchanges nothing. Cells of neighbouring columns share a face where their
/// depths overlap. Patches "outside" (tread), "sidewalls", "inside", "beads"; regions "surface" and "bulk" as of Layers,
/// in the zones of the tread.
struct Section {
    Meridian meridian{1.0, {}};
    std::vector<Layer> layers;
    std::vector<Zone> zones;
};
[[nodiscard]] Mesh build(const Section& description);

/// A block under a laser: x along the meridian, y along the circumference, z the depth. With `quarter` the block spans
/// [0, X] x [0, Y], symmetric about x = 0 and y = 0; otherwise it is centred. Patches "top", "bottom" and, where the
/// sides exchange heat, "left", "right" (x), "front", "back" (y; not with one cell across, which is a plane).
struct Block {
    std::vector<Segment> x;  ///< from the centre (quarter) or from -X/2
    std::vector<Segment> y;
    std::vector<Layer> stack;
    bool quarter = true;
    bool side_patches = false;
};
[[nodiscard]] Mesh build(const Block& description);

/// The same about the laser's axis: x is the radius. Patches "top", "bottom", and "rim" where the outer side exchanges.
struct Axisymmetric {
    std::vector<Segment> radius;
    std::vector<Layer> stack;
    bool side_patches = false;
};
[[nodiscard]] Mesh build(const Axisymmetric& description);

}  // namespace tiretherm::mesh
