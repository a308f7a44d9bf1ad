// SPDX-License-Identifier: BSD-3-Clause
// Keys of [mesh] and its layers: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"
#include "mesh/builders.hpp"
#include "physics/contact/travelling.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> mesh_tables() {
    return {
        {"mesh", TableForm::table,
         "Where the temperatures are. `two_node`: surface and bulk of the crown band, joined by a link; layers and regions `surface`, `bulk`; patches `outside`, `inside`. `layers`: one column through the thickness; patches `outside`, `inside`. `section`: the cross-section of a tire; zones `outside_sidewall`, `outside_shoulder`, `crown`, `inside_shoulder`, `inside_sidewall`, where outside is outboard; zones are aligned at their inner surface; patches `outside` (the tread), `sidewalls`, `inside`, `beads`. `cylinder`: layers about an axis, a tread or a hose as a hollow cylinder; patches `outside`, `inside`. `block`: a specimen; patches `top`, `bottom`, with side patches `right`, `back` and, without symmetry, `left`, `front`; the results of a quarter are those of the quarter. `axisymmetric`: a disc; patches `top`, `bottom`, `rim`. Regions of all kinds but `two_node`: `surface` is the outer surface, `bulk` all layers but the first. How many cells there may be says `[limits]`.", {
            choice("kind", {"two_node", "layers", "cylinder", "section", "block", "axisymmetric"}, "The kind of the mesh.").required(),
            quantity("surface_mass_share", {.unit = "1", .low = 1e-6, .high = 0.999999}, "Share of the crown's mass in the surface node.").required().kinds("two_node"),
            quantity("bulk_depth", thickness, "Length of the link between the two nodes.").required().kinds("two_node"),
            text("material", "Name of the `[[material]]` of both nodes.").required().kinds("two_node"),
            law("link_conductivity", conductivity, "Law of temperature of the link. Default for `two_node`: that of the material; for `layers`: required with `link_below`.").sometimes().kinds("layers two_node"),
            quantity("area", area, "Area of the column. Default: outer area of the tire; required without a tire.").sometimes().kinds("layers"),
            quantity("inner_radius", length, "Radius of the inner surface. Default: the tire's unloaded radius less the layers; required without a tire.").sometimes().kinds("cylinder"),
            quantity("length", length, "Length along the axis. Default: so that the outer area is that of the tire; required without a tire.").sometimes().kinds("cylinder"),
            text("link_below", "Name of the layer below which a link stands in place of contact. Default: none.").kinds("layers"),
            quantity("link_length", thickness, "Length of that link; required with `link_below`.").sometimes().kinds("layers"),
            tables("layer", "The layers, from the outside in.").required().kinds("axisymmetric block cylinder layers section"),
            count("crown_cells", 1, 10000, "Cells along the meridian in the crown.").required().kinds("section"),
            count("shoulder_cells", 0, 10000, "Cells along the meridian in each shoulder; 0: no shoulders.").required().kinds("section"),
            count("sidewall_cells", 0, 10000, "Cells along the meridian in each sidewall; 0: no sidewalls.").required().kinds("section"),
            quantity("tread_width", length, "Default: the tire's width.").kinds("section"),
            quantity("shoulder_width", length, "Default: a fifth of the tread's width.").kinds("section"),
            quantity("sidewall_length", length, "Default: so that the profile ends at the rim.").kinds("section"),
            quantity("crown_radius", length, "Radius of curvature of the crown across the tire. Default: 1 m.").kinds("section"),
            quantity("shoulder_ratio", {.unit = "1", .low = 0.001, .high = 1000.0}, "Width of the cell at the sidewall over that at the crown. Default: 1.").kinds("section"),
            quantity("sidewall_ratio", {.unit = "1", .low = 0.001, .high = 1000.0}, "Width of the cell at the bead over that at the shoulder. Default: 1.").kinds("section"),
            count("sectors", 1, physics::most_sectors, "Number of equal parts around the circumference; above 1 the mesh is a ring in the rubber's frame. Default: 1.").kinds("section"),
            tables("x", "Cells along x, as segments.").required().kinds("block"),
            tables("y", "Cells along y, as segments.").required().kinds("block"),
            tables("radius", "Cells along the radius, as segments.").required().kinds("axisymmetric"),
            flag("quarter", "Symmetric about x = 0 and y = 0: from there to X and Y; otherwise from -X to X. Default: true.").kinds("block").into<&mesh::Block::quarter>(),
            flag("side_patches", "Whether the sides are patches that effects may act on. Default: false.").kinds("axisymmetric block").into<&mesh::Block::side_patches>().into<&mesh::Axisymmetric::side_patches>(),
        }},
        {"mesh.layer", TableForm::list,
         "One layer, from the outside in.", {
            name("name", "Name of the layer, for sensors, effects and initial temperatures.").required().into<&mesh::Layer::name>(),
            quantity("thickness", thickness, "Thickness of the layer.").required().into<&mesh::Layer::thickness>(),
            count("cells", 1, 1000000, "Number of cells through the layer.").required().into<&mesh::Layer::cells>(),
            quantity("ratio", {.unit = "1", .low = 1e-5, .high = 1e5}, "Thickness of the innermost cell over the outermost. Default: 1.").into<&mesh::Layer::ratio>(),
            text("material", "Name of its `[[material]]`.").required(),
            texts("zones", "For a section: some of `crown`, `shoulders`, `sidewalls`. Default: all."),
        }},
        {"mesh.x", TableForm::list,
         "A segment of the cells along an axis: `x = [{ to = \"30 mm\", cells = 8 }]`; `y` and `radius` are the same.", {
            quantity("to", coordinate, "Where the segment ends; ascending.").required().into<&mesh::Segment::to>(),
            count("cells", 1, 1000000, "Number of cells.").required().into<&mesh::Segment::cells>(),
            quantity("ratio", {.unit = "1", .low = 1e-5, .high = 1e5}, "Width of the last cell over the first. Default: 1.").into<&mesh::Segment::ratio>(),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
