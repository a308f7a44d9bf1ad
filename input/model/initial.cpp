// SPDX-License-Identifier: BSD-3-Clause
// Reads [initial]: start temperatures of the layers and of lumped nodes such as gas and rim, as values or as
// "air_temperature".

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "input/model/problem_builder.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

/// The air around the tire when the run starts; nothing where no air is given.
std::optional<double> first_air(const ProblemBuilder& builder) {
    const solver::Problem& problem = builder.problem;
    return builder.given.contains("air_temperature")
               ? std::optional(
                     problem.input_signals.at(problem.settings.start, solver::JumpSide::after).air_temperature)
               : std::nullopt;
}

/// A temperature, or that of the air by the name of the input.
std::optional<double> read_start(TomlTable& initial, std::string_view key, const ProblemBuilder& builder,
                                 Need need = Need::optional) {
    const TomlValue* node = initial.value(key);
    if (node == nullptr || node->kind != TomlValue::Kind::text || node->text != "air_temperature") {
        return initial.quantity(key, quantity_specs::temperature, need);
    }
    const std::optional<double> air = first_air(builder);
    if (!air) {
        initial.add_error(key, fmt::format("{} is set to \"air_temperature\", but no air temperature is given", key),
                          "add air_temperature to [drive], or write a temperature");
    }
    return air;
}

}  // namespace

void read_initial(TomlTable& root, ProblemBuilder& builder) {
    TomlTable initial = root.subtable("initial", Need::required);
    const std::size_t before = initial.errors().count();
    if (!builder.has_mesh) {
        for (const Entry& layer : initial.content().entries) {
            read_start(initial, layer.key, builder);
        }
        return;
    }
    const mesh::Mesh& mesh = builder.problem.mesh;
    const bool by_layer = std::any_of(mesh.layers.begin(), mesh.layers.end(),
                                      [&](const std::string& layer) { return initial.has(layer); });
    const std::optional<double> everywhere =
        read_start(initial, "temperature", builder, by_layer ? Need::optional : Need::required);
    std::vector<double> of_layer;
    for (const std::string& layer : mesh.layers) {
        const bool needed = by_layer && !initial.has("temperature");
        const auto own = read_start(initial, layer, builder, needed ? Need::required : Need::optional);
        of_layer.push_back(own.value_or(everywhere.value_or(0.0)));
    }
    // Gas and rim start with the air around them, or as the rest where there is no air.
    const double around = first_air(builder).value_or(everywhere.value_or(of_layer.front()));
    std::map<int, double> of_node;
    for (const mesh::LumpedNode& lumped_node : mesh.lumped_nodes) {
        of_node[lumped_node.node] = read_start(initial, lumped_node.name, builder).value_or(around);
    }
    if (initial.errors().count() > before) {
        return;
    }
    for (int node = 0; node < mesh.n_nodes; ++node) {
        const int layer = mesh.layer[static_cast<std::size_t>(node)];
        builder.problem.initial.push_back(layer < 0 ? of_node.at(node) : of_layer[static_cast<std::size_t>(layer)]);
    }
}

}  // namespace tiretherm::input
