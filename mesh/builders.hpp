#pragma once

#include <array>
#include <string>
#include <vector>

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
