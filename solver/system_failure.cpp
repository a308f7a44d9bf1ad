// SPDX-License-Identifier: BSD-3-Clause
// A failure in words: where it is, and what heats the place most.
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"
#include "physics/celsius.hpp"
#include "solver/system.hpp"

namespace tiretherm::solver {

Status System::failure_at(Outcome outcome, std::string_view why, int node, double time, std::span<const double> T,
                          std::span<const double> coefficients) {
    const double shown = celsius(T[at(node)]);
    const std::string degrees = std::abs(shown) < 1e5 ? fmt::format("{:.2f}", shown) : fmt::format("{:.3g}", shown);
    return {outcome,
            fmt::format("{} at t = {:.6g} s, in {} ({} degC); largest heat source there: {}", why, time,
                        describe_node(problem_->mesh, node), degrees, largest_heat_source(node, T, coefficients))};
}

int System::first_not_finite() const {
    // Zero times a number is zero; times what is none, it is not.
    const auto zeros = [this](std::size_t begin, std::size_t end) {
        const auto add_zero = [this](double sum, std::size_t i) { return sum + 0.0 * flow_[i]; };
        return fold_side_by_side(begin, end, 0.0, add_zero, std::plus<>());
    };
    if (sum_over_ranges(flow_.size(), zeros) == 0.0) {
        return -1;
    }
    const auto bad = std::ranges::find_if_not(flow_, [](double q) { return std::isfinite(q); });
    return bad == flow_.end() ? -1 : static_cast<int>(bad - flow_.begin());
}

std::string System::largest_heat_source(int node, std::span<const double> T, std::span<const double> coefficients) {
    find_means(T, means_);
    find_loss_factors(T, means_, coefficients, std::nullopt);
    physics::Terms& terms = terms_to_work_in();
    double largest = -1.0;
    std::string name = "none";
    for (std::size_t e = 0; e < effects_.size(); ++e) {
        const physics::HeatEffect* heat = effects_[e].effect->heat_effect();
        if (heat == nullptr) {
            continue;
        }
        terms.begin(T);
        heat->add_terms(evaluation_state(e, T, means_, coefficients), terms);
        double watts = std::abs(terms.node_q[at(node)]);
        for (std::size_t f = 0; f < problem_->mesh.faces.size(); ++f) {
            const mesh::Face& face = problem_->mesh.faces[f];
            if (face.a == node || face.b == node) {
                watts += std::abs(terms.face_G[f] * (T[at(face.b)] - T[at(face.a)]));
            }
        }
        if (!(watts <= largest)) {  // true also for NaN, which is largest of all
            largest = watts;
            name = effects_[e].title();
            if (std::isnan(watts)) {
                break;
            }
        }
    }
    return name;
}

std::string describe_node(const mesh::Mesh& mesh, int node) {
    for (const mesh::LumpedNode& lumped_node : mesh.lumped_nodes) {
        if (lumped_node.node == node) {
            return fmt::format("the {} node", lumped_node.name);
        }
    }
    const auto& [x, y, z] = mesh.centre[at(node)];
    const std::string layer = mesh.layers[at(mesh.layer[at(node)])];
    if (mesh.is_lumped()) {
        return fmt::format("the {} node", layer);
    }
    const std::string what = node < mesh.n_cells ? fmt::format("cell {}", node) : "the surface";
    if (mesh.is_section()) {
        return fmt::format("{} of layer {} in the {}, {:.1f} mm along the meridian{}, {:.2f} mm deep", what, layer,
                           mesh.zones[at(mesh.zone[at(node)])], 1e3 * x,
                           mesh.is_ring() ? fmt::format(", {:.1f} mm around", 1e3 * y) : "", 1e3 * z);
    }
    if (mesh.stack) {
        return fmt::format("{} of layer {}, {:.2f} mm deep", what, layer, 1e3 * z);
    }
    return fmt::format("{} of layer {}, x {:.2f} mm, y {:.2f} mm, {:.2f} mm deep", what, layer, 1e3 * x, 1e3 * y,
                       1e3 * z);
}

}  // namespace tiretherm::solver
