// SPDX-License-Identifier: BSD-3-Clause
// Initial temperatures as free parameters: shifts of those of a case or of each run.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "input/parameters/parameter_kind.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

/// The word of [initial] that means these nodes.
std::string initial_word(const mesh::Mesh& mesh, const std::vector<int>& nodes) {
    if (static_cast<int>(nodes.size()) == mesh.n_nodes) {
        return "temperature";
    }
    const int layer = mesh.layer[static_cast<std::size_t>(nodes.front())];
    if (layer >= 0) {
        return mesh.layers[static_cast<std::size_t>(layer)];
    }
    return std::ranges::find(mesh.lumped_nodes, nodes.front(), &mesh::LumpedNode::node)->name;
}

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

std::optional<FreeParameters> find_initial(const ParameterPath& path, const CaseAsRead& in, const Knots& /*knots*/) {
    const LocatedString& word = path.keys.back();
    if (in.problem.settings.steady) {
        return in.errors.add(word.place, "a steady state does not follow from where it starts",
                             "remove this [[parameter]]");
    }
    if (in.problem.mesh.n_nodes == 0) {
        return std::nullopt;
    }
    const mesh::Mesh& mesh = in.problem.mesh;
    std::vector<std::string> known{"temperature"};
    known.insert(known.end(), mesh.layers.begin(), mesh.layers.end());
    std::ranges::copy(names_of(mesh.lumped_nodes), std::back_inserter(known));
    if (path.keys.size() > 2 || std::ranges::find(known, word.text) == known.end()) {
        return in.errors.add(word.place, fmt::format("initial cannot be \"{}\"", word.text),
                             suggest(word.text, known, "temperatures at the start"));
    }
    solver::FreeParameter number;
    number.name = "initial " + word.text;
    number.unit = "K";
    number.kind = solver::FreeParameter::Kind::initial;
    number.nodes = nodes_of(mesh, word.text);
    FreeParameters freed{.numbers = {}, .spec = shift};
    // Each run has a start of its own, whatever the other runs began with.
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

ParameterPath path_of_initial(const solver::Problem& problem, const solver::FreeParameter& number) {
    return ParameterPath::of({"initial", initial_word(problem.mesh, number.nodes)});
}

std::vector<ParameterPath> paths_of_initial(TomlTable& table, std::string_view subject, const TomlValue& /*document*/) {
    const std::size_t before = table.errors().count();
    std::vector<ParameterPath> paths;
    for (LocatedString& word : table.texts("initial")) {
        paths.push_back({.keys = {{"initial", table.place(subject)}, std::move(word)}});
    }
    if (paths.empty() && table.errors().count() == before) {
        table.add_error("initial", "initial names nothing", "write initial = \"temperature\", which is all of it");
    }
    return paths;
}

/// Of all runs; those of a run are in its table.
void write_initial(TomlValue& over, const Overlay& overlay, const TomlValue& /*original*/) {
    const bool everywhere = std::ranges::any_of(overlay.parameters, [](const solver::FreeParameter& number) {
        return is_initial(number) && number.runs.empty();
    });
    if (everywhere) {
        TomlValue initial = initial_value(*overlay.fitted);
        initial.in_braces = false;
        over.set("initial", std::move(initial));
    }
}

}  // namespace

bool is_initial(const solver::FreeParameter& parameter) {
    return parameter.kind == solver::FreeParameter::Kind::initial;
}

TomlValue initial_value(const solver::Problem& problem) {
    const mesh::Mesh& mesh = problem.mesh;
    TomlValue table = toml_text::table_value();
    for (std::size_t layer = 0; layer < mesh.layers.size(); ++layer) {
        const auto node = std::ranges::find(mesh.layer, static_cast<int>(layer)) - mesh.layer.begin();
        table.set(mesh.layers[layer], toml_text::temperature_value(problem.initial[static_cast<std::size_t>(node)]));
    }
    for (const mesh::LumpedNode& lumped_node : mesh.lumped_nodes) {
        table.set(lumped_node.name,
                  toml_text::temperature_value(problem.initial[static_cast<std::size_t>(lumped_node.node)]));
    }
    return table;
}

ParameterKind initial_kind() {
    return {.subjects = {"initial"},
            .takes = [](const ParameterPath& path) { return path.keys.front().text == "initial"; },
            .has = is_initial,
            .paths_of_table = paths_of_initial,
            .find = find_initial,
            .path_of = path_of_initial,
            .write = write_initial};
}

}  // namespace tiretherm::input
