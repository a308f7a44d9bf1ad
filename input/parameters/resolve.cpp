// SPDX-License-Identifier: BSD-3-Clause
// Which reader resolves a path, and paths of initial temperatures.
#include "input/parameters/resolve.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/effects/user_effects.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

/// A shift of temperatures; bounds are for the user to give.
constexpr QuantitySpec shift{.unit = "K", .scale = Scale::difference, .low = -1000.0, .high = 1000.0};

/// Nodes that a word names: all of them, those of a layer with its surfaces, or one such as the gas.
std::vector<int> nodes_of(const mesh::Mesh& mesh, const std::string& word) {
    std::vector<int> nodes;
    const int layer = mesh.find_layer(word);
    const int lumped_node = layer < 0 ? mesh.find_lumped_node(word) : -1;
    for (int node = 0; node < mesh.n_nodes; ++node) {
        const bool in_layer = layer >= 0 && mesh.layer[static_cast<std::size_t>(node)] == layer;
        if (word == "temperature" || in_layer || node == lumped_node) {
            nodes.push_back(node);
        }
    }
    return nodes;
}

}  // namespace

std::optional<FreeParameters> resolve_initial(const ParameterPath& path, const CaseAsRead& in) {
    const LocatedString& word = path.keys.back();
    if (in.problem.settings.steady) {
        in.errors.add(word.place, "a steady state does not follow from where it starts", "remove this [[parameter]]");
        return std::nullopt;
    }
    if (in.problem.mesh.n_nodes == 0) {
        return std::nullopt;
    }
    const mesh::Mesh& mesh = in.problem.mesh;
    std::vector<std::string> known{"temperature"};
    known.insert(known.end(), mesh.layers.begin(), mesh.layers.end());
    std::ranges::copy(names_of(mesh.lumped_nodes), std::back_inserter(known));
    if (path.keys.size() > 2 || std::ranges::find(known, word.text) == known.end()) {
        in.errors.add(word.place, fmt::format("initial cannot be \"{}\"", word.text),
                      suggest(word.text, known, "temperatures at the start"));
        return std::nullopt;
    }
    solver::FreeParameter number;
    number.name = "initial " + word.text;
    number.unit = "K";
    number.kind = solver::FreeParameter::Kind::initial;
    number.nodes = nodes_of(mesh, word.text);
    FreeParameters freed{.numbers = {}, .spec = shift};
    for (std::size_t run = 0; run < in.run_names.size(); ++run) {
        freed.numbers.push_back(number);
        freed.numbers.back().name += ", run " + in.run_names[run];
        freed.numbers.back().runs = {run};
    }
    if (in.run_names.empty()) {
        freed.numbers.push_back(std::move(number));
    }
    return freed;
}

std::optional<FreeParameters> resolve(const ParameterPath& path, const CaseAsRead& in, const Knots& knots) {
    const std::string& first = path.keys.front().text;
    if (first == "effects") {
        return resolve_effect(path, in);
    }
    if (first == user_heat_source.list || first == user_heat_transfer.list) {
        return resolve_user_effect(path, in);
    }
    if (first == "camera") {
        return resolve_camera(path, in);
    }
    if (first == "vehicle") {
        return resolve_vehicle(path, in);
    }
    if (first == "initial") {
        return resolve_initial(path, in);
    }
    if (first == "mesh" && path.is_law()) {
        return resolve_link(path, in, knots);
    }
    if (first == "material" && (path.is_law() || path.keys.back().text.empty())) {
        return resolve_material(path, in, knots);
    }
    in.errors.add(path.keys.front().place, fmt::format("{} is not a number that a fit can free", path.text()),
                  "name a number of [effects], [[source]], [[exchange]], [[camera]], [vehicle] or [initial], "
                  "material.NAME.conductivity, material.NAME.heat_capacity or mesh.link_conductivity");
    return std::nullopt;
}

}  // namespace tiretherm::input
