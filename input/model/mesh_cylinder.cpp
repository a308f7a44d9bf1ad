// SPDX-License-Identifier: BSD-3-Clause
// [mesh] kind = "cylinder": layers with their true radii. With a tire its radius and its outer area are the standard ones.
#include <numbers>

#include <fmt/format.h>

#include "input/model/problem_builder.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

bool read_cylinder(TomlTable& mesh, ProblemBuilder& builder) {
    const Need need = builder.has_tire ? Need::optional : Need::required;
    const std::optional<double> inner_radius = mesh.quantity("inner_radius", quantity_specs::length, need);
    const std::optional<double> length = mesh.quantity("length", quantity_specs::length, need);
    mesh::Cylinder cylinder;
    cylinder.stack = read_stack(mesh, builder);
    if (cylinder.stack.empty() || (!builder.has_tire && (!inner_radius || !length))) {
        return false;
    }
    double thickness = 0.0;
    for (const mesh::Layer& layer : cylinder.stack) {
        thickness += layer.thickness;
    }
    const physics::Tire& tire = builder.problem.tire;
    cylinder.inner_radius = inner_radius.value_or(tire.unloaded_radius - thickness);
    if (!(cylinder.inner_radius > 0.0)) {
        mesh.add_error("layer",
                       fmt::format("the layers are {:.6g} mm thick, and the tire's radius is {:.6g} mm",
                                   thickness * 1e3, tire.unloaded_radius * 1e3),
                       "take thinner layers");
        return false;
    }
    cylinder.length =
        length.value_or(tire.outer_area() / (2.0 * std::numbers::pi * (cylinder.inner_radius + thickness)));
    builder.problem.mesh = build(cylinder);
    return true;
}

}  // namespace tiretherm::input
