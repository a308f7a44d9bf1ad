// SPDX-License-Identifier: BSD-3-Clause
// Prepares the interpolation weights of every corner point once and applies them to a field.

#include "post/page/drawn_field.hpp"

#include "mesh/probe.hpp"

namespace tiretherm::post {

DrawnField::DrawnField(const mesh::Mesh& mesh) {
    const bool folded = !mesh.drawing.places.empty();
    if (!mesh.grid && !folded) {
        return;
    }
    first_.push_back(0);
    for (std::size_t i = 0; i < mesh.drawing.points.size(); ++i) {
        const auto [x, y, z] = mesh.drawing.points[i];
        const mesh::Functional one = mesh::at_point(mesh, folded ? mesh.drawing.places[i] : mesh::Point{x, y, -z});
        nodes_.insert(nodes_.end(), one.nodes.begin(), one.nodes.end());
        weights_.insert(weights_.end(), one.weights.begin(), one.weights.end());
        first_.push_back(nodes_.size());
    }
}

std::vector<double> DrawnField::at_points(std::span<const double> temperature) const {
    std::vector<double> values;
    for (std::size_t point = 0; point + 1 < first_.size(); ++point) {
        double sum = 0.0;
        for (std::size_t i = first_[point]; i < first_[point + 1]; ++i) {
            sum += weights_[i] * temperature[static_cast<std::size_t>(nodes_[i])];
        }
        values.push_back(sum);
    }
    return values;
}

}  // namespace tiretherm::post
