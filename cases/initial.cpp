#include <algorithm>

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
    if (initial.mistakes().count() > before) {
        return;
    }
    for (const int layer : mesh.layer) {
        draft.problem.initial.push_back(of_layer[static_cast<std::size_t>(layer)]);
    }
}

}  // namespace tiretherm::cases
