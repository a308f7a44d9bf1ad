#include <algorithm>
#include <map>

#include "cases/draft.hpp"
#include "cases/wanted.hpp"

namespace tiretherm::cases {

void read_initial(Section& root, Draft& draft) {
    Section initial = root.section("initial", Need::required);
    const std::size_t before = initial.mistakes().count();
    if (!draft.has_mesh) {
        for (const Entry& layer : initial.table().entries) {
            initial.quantity(layer.key, wanted::temperature);
        }
        return;
    }
    const mesh::Mesh& mesh = draft.problem.mesh;
    const bool by_layer = std::any_of(mesh.layers.begin(), mesh.layers.end(),
                                      [&](const std::string& layer) { return initial.has(layer); });
    const std::optional<double> everywhere =
        initial.quantity("temperature", wanted::temperature, by_layer ? Need::optional : Need::required);
    std::vector<double> of_layer;
    for (const std::string& layer : mesh.layers) {
        const bool needed = by_layer && !initial.has("temperature");
        const auto own = initial.quantity(layer, wanted::temperature, needed ? Need::required : Need::optional);
        of_layer.push_back(own.value_or(everywhere.value_or(0.0)));
    }
    // Gas and rim start with the air around them, or as the rest where there is no air.
    const bool has_air = draft.given.contains("air_temperature");
    const double air = draft.problem.drive.at(-1e300, solver::Limit::after).air_temperature;
    std::map<int, double> of_node;
    for (const mesh::Appended& appended : mesh.appended) {
        of_node[appended.node] = initial.quantity(appended.name, wanted::temperature)
                                     .value_or(has_air ? air : everywhere.value_or(of_layer.front()));
    }
    if (initial.mistakes().count() > before) {
        return;
    }
    for (int node = 0; node < mesh.n_nodes; ++node) {
        const int layer = mesh.layer[static_cast<std::size_t>(node)];
        draft.problem.initial.push_back(layer < 0 ? of_node.at(node) : of_layer[static_cast<std::size_t>(layer)]);
    }
}

}  // namespace tiretherm::cases
