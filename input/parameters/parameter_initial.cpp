#include <algorithm>

#include <fmt/format.h>

#include "input/parameters/parameter_kinds.hpp"
#include "input/text/suggestions.hpp"

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

std::optional<FreeParameters> free_initial(TomlTable& parameter, const ProblemBuilder& builder,
                                           const std::vector<std::string>& run_names) {
    const std::size_t before = parameter.errors().count();
    const std::vector<LocatedString> words = parameter.texts("initial");
    const mesh::Mesh& mesh = builder.problem.mesh;
    FreeParameters freed{.numbers = {}, .spec = shift};
    if (builder.problem.settings.steady) {
        parameter.add_error("initial", "a steady state does not follow from where it starts",
                            "remove this [[parameter]]");
        return std::nullopt;
    }
    if (!builder.has_mesh) {
        return std::nullopt;
    }
    std::vector<std::string> known{"temperature"};
    known.insert(known.end(), mesh.layers.begin(), mesh.layers.end());
    const std::vector<std::string> lumped_node_names = names_of(mesh.lumped_nodes);
    known.insert(known.end(), lumped_node_names.begin(), lumped_node_names.end());
    if (words.empty() && parameter.errors().count() == before) {
        parameter.add_error("initial", "initial names nothing", "write initial = \"temperature\", which is all of it");
    }
    for (const LocatedString& word : words) {
        if (std::find(known.begin(), known.end(), word.text) == known.end()) {
            parameter.errors().add(word.place, fmt::format("initial cannot be \"{}\"", word.text),
                                   suggest(word.text, known, "temperatures at the start"));
            return std::nullopt;
        }
        solver::FreeParameter number;
        number.name = "initial " + word.text;
        number.unit = "K";
        number.kind = solver::FreeParameter::Kind::initial;
        number.nodes = nodes_of(mesh, word.text);
        for (std::size_t run = 0; run < run_names.size(); ++run) {
            solver::FreeParameter of_run = number;
            of_run.name += ", run " + run_names[run];
            of_run.run = static_cast<int>(run);
            freed.numbers.push_back(std::move(of_run));
        }
        if (run_names.empty()) {
            freed.numbers.push_back(std::move(number));
        }
    }
    return freed.numbers.empty() ? std::nullopt : std::optional(std::move(freed));
}

}  // namespace tiretherm::input
