// SPDX-License-Identifier: BSD-3-Clause
// Lets every effect act in turn: properties, places, input corrections, laws, coefficients, terms; then sums the heat
// flow of each node.

#include "solver/system.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::solver {

namespace {

/// Step of the difference quotient for effects without derivatives: far above round-off, far below any law's scale. K
constexpr double difference_step = 1e-4;

}  // namespace

System::System(const Problem& problem)
    : problem_(&problem),
      pattern_(pattern_of(problem.mesh)),
      terms_(problem.mesh, problem.effects.size()),
      means_(problem.mesh.regions.size()),
      shifted_means_(problem.mesh.regions.size()),
      flow_(at(problem.mesh.n_nodes)),
      material_model_{.materials = problem.materials, .link_laws = problem.link_laws, .tire = problem.tire},
      effects_(problem.effects),
      lump_(at(problem.mesh.n_nodes)) {
    face_of_.resize(pattern_.nonzeros(), -1);
    for (std::size_t f = 0; f < problem.mesh.faces.size(); ++f) {
        if (int& face = face_of_[at(pattern_.ab[f])]; face < 0) {
            face = face_of_[at(pattern_.ba[f])] = static_cast<int>(f);
        } else {
            second_faces_.push_back(f);
        }
    }
    settle_effects();
    for (const physics::ActiveEffect& active : effects_) {
        first_coefficient_.push_back(n_coefficients_);
        n_coefficients_ += at(active.effect->n_coefficients());
        const physics::HeatEffect* heat = active.effect->heat_effect();
        if (heat != nullptr && heat->evaluate_coefficients != nullptr) {
            with_coefficients_.push_back(first_coefficient_.size() - 1);
        }
        if (heat != nullptr && !heat->gives_derivatives && !there_) {
            there_.emplace(problem.mesh, problem.effects.size());
            here_.emplace(problem.mesh, problem.effects.size());
            shifted_.resize(at(problem.mesh.n_nodes));
        }
        for (std::size_t i = 0; i < active.lumped_nodes.size(); ++i) {
            lump_[at(active.lumped_nodes[i])] += active.effect->heat_effect()->capacity(active, i);
            if (active.effect->heat_effect()->is_memory) {
                memory_.push_back(at(active.lumped_nodes[i]));
            }
        }
    }
    for (int node = 0; node < problem.mesh.n_nodes; ++node) {
        const int layer = problem.mesh.layer[at(node)];
        mass_.push_back(layer < 0 ? 0.0 : problem.mesh.volume[at(node)] * material_model_.materials[at(layer)].density);
        const double mass = mass_.back();
        constant_capacity_.push_back(mass > 0.0 ? 0.0 : lump_[at(node)]);
        if (mass > 0.0) {
            const physics::Curve& c = material_model_.materials[at(layer)].heat_capacity;
            if (c.is_constant()) {
                constant_capacity_.back() = mass * c.value(0.0);
            } else {
                varying_capacity_.push_back(at(node));
            }
        }
    }
    find_surfaces();
}

void System::find_surfaces() {
    if (problem_->mesh.n_cells + std::ssize(problem_->mesh.lumped_nodes) == problem_->mesh.n_nodes) {
        return;
    }
    constexpr std::size_t none = -1;
    std::vector surface(mass_.size(), none);
    for (std::size_t i = at(problem_->mesh.n_cells); i < mass_.size(); ++i) {
        if (!has_capacity(i)) {
            surface[i] = surfaces_.size();
            surfaces_.push_back({.node = i});
        }
    }
    for (std::size_t f = 0; f < problem_->mesh.faces.size(); ++f) {
        const mesh::Face& face = problem_->mesh.faces[f];
        for (const int node : {face.a, face.b}) {
            if (const std::size_t k = surface[at(node)]; k != none) {
                surface_faces_.push_back({.face = f, .surface = k, .is_a = node == face.a});
            }
        }
    }
}

/// Properties first, then places: a share by mass must see the mass that counts.
void System::settle_effects() {
    for (const physics::ActiveEffect& active : effects_) {
        const physics::PropertyModifier* modifier = active.effect->property_modifier();
        if (modifier != nullptr && modifier->modify_properties != nullptr) {
            modifier->modify_properties(active, problem_->mesh, material_model_);
        }
    }
    for (physics::ActiveEffect& active : effects_) {
        active.effect->place({.mesh = problem_->mesh, .material_model = material_model_, .effects = effects_}, active);
    }
    for (std::size_t e = 0; e < effects_.size(); ++e) {
        if (effects_[e].effect->loss_law() != nullptr) {
            with_loss_law_.push_back(e);
        }
    }
    loss_factors_.reserve(with_loss_law_.size());
}

std::vector<double> System::initial() const {
    std::vector<double> T = problem_->initial;
    for (const physics::ActiveEffect& active : effects_) {
        const physics::InputCorrection* correction = active.effect->input_correction();
        if (correction != nullptr && correction->start != nullptr) {
            correction->start(active, problem_->mesh, T);
        }
    }
    return T;
}

double System::varying_capacity(std::size_t node, double T) const {
    return mass_[node] > 0.0
               ? mass_[node] * material_model_.materials[at(problem_->mesh.layer[node])].heat_capacity.value(T)
               : 0.0;
}

physics::Inputs System::transformed(physics::Inputs inputs) const {
    for (const physics::ActiveEffect& active : effects_) {
        const physics::InputCorrection* correction = active.effect->input_correction();
        if (correction != nullptr && correction->transform != nullptr) {
            correction->transform(active, inputs);
        }
    }
    return inputs;
}

physics::Laws System::laws(const physics::Inputs& inputs, std::optional<std::size_t> left_out) const {
    physics::Laws laws;
    for (std::size_t e = 0; e < effects_.size(); ++e) {
        const physics::ActiveEffect& active = effects_[e];
        const physics::PropertyModifier* modifier = active.effect->property_modifier();
        if (modifier != nullptr && modifier->modify_laws != nullptr && e != left_out) {
            modifier->modify_laws(active, material_model_.tire, inputs, laws);
        }
    }
    return laws;
}

void System::evaluate_coefficients(const physics::Inputs& logged, std::span<double> out) const {
    evaluate_coefficients(logged, out, std::nullopt);
}

void System::evaluate_coefficients(const physics::Inputs& logged, std::span<double> out, LeftOut left_out) const {
    const physics::Inputs inputs = transformed(logged);
    evaluate_coefficients(with_coefficients_, inputs, laws(inputs, left_out), out);
}

void System::evaluate_coefficients(std::span<const std::size_t> which, const physics::Inputs& inputs,
                                   const physics::Laws& laws, std::span<double> out) const {
    const physics::OperatingPoint point{
        .tire = material_model_.tire, .inputs = inputs, .laws = laws, .effects = effects_};
    for (const std::size_t e : which) {
        const physics::ActiveEffect& active = effects_[e];
        const physics::HeatEffect& heat = *active.effect->heat_effect();
        heat.evaluate_coefficients(active, point, out.subspan(first_coefficient_[e], at(heat.n_coefficients)));
    }
}

void System::find_means(std::span<const double> T, std::span<double> means) const {
    for (std::size_t r = 0; r < means.size(); ++r) {
        means[r] = problem_->mesh.regions[r].mean(T);
    }
}

physics::EvaluationState System::evaluation_state(std::size_t e, std::span<const double> T,
                                                  std::span<const double> means,
                                                  std::span<const double> coefficients) const {
    const physics::ActiveEffect& active = effects_[e];
    const std::size_t n = at(active.effect->n_coefficients());
    return {.mesh = problem_->mesh,
            .material_model = material_model_,
            .temperature = T,
            .region_mean = means,
            .active = active,
            .coefficients = n > 0 && !coefficients.empty() ? coefficients.subspan(first_coefficient_[e], n)
                                                           : std::span<const double>(),
            .loss_factors = loss_factors_};
}

/// None without coefficients, which some effects alone need.
void System::find_loss_factors(std::span<const double> T, std::span<const double> means,
                               std::span<const double> coefficients, LeftOut left_out) const {
    loss_factors_.clear();
    if (coefficients.empty()) {
        return;
    }
    for (const std::size_t e : with_loss_law_) {
        if (e != left_out) {
            loss_factors_.push_back(effects_[e].effect->loss_law()(evaluation_state(e, T, means, coefficients)));
        }
    }
}

void System::evaluate(std::span<const double> T, std::span<const double> coefficients) {
    evaluate(T, coefficients, std::nullopt);
}

void System::evaluate(std::span<const double> T, std::span<const double> coefficients, LeftOut left_out) {
    terms_.begin(T);
    find_means(T, means_);
    find_loss_factors(T, means_, coefficients, left_out);
    for (std::size_t e = 0; e < effects_.size(); ++e) {
        const physics::HeatEffect* heat = effects_[e].effect->heat_effect();
        if (heat == nullptr) {
            continue;
        }
        terms_.attribute_to(e);
        if (heat->gives_derivatives) {
            heat->add_terms(evaluation_state(e, T, means_, coefficients), terms_);
            terms_.watts[e] = heat->is_memory ? 0.0 : terms_.watts[e];
            continue;
        }
        over_nodes(T.size(), [&](std::size_t i) { shifted_[i] = T[i] + difference_step; });
        find_means(shifted_, shifted_means_);
        here_->begin(T);
        there_->begin(shifted_);
        here_->attribute_to(e);
        there_->attribute_to(e);
        heat->add_terms(evaluation_state(e, T, means_, coefficients), *here_);
        heat->add_terms(evaluation_state(e, shifted_, shifted_means_, coefficients), *there_);
        terms_.add_difference(*here_, *there_, difference_step);
    }
    find_flow(terms_, T, flow_);
}

/// What the terms make of the temperatures: heat and exchanges of each node, and what its faces let through.
void System::find_flow(const physics::Terms& terms, std::span<const double> T, std::span<double> q) const {
    if (!terms.faces_used) {
        copy_nodes(terms.node_q, q);
        return;
    }
    if (ranges_of(q.size()) == 1) {  // a face at a time, where no thread shares the nodes
        std::ranges::copy(terms.node_q, q.begin());
        const double* G = terms.face_G.data();
        for (const mesh::Face& face : problem_->mesh.faces) {
            const double flux = *G++ * (T[at(face.b)] - T[at(face.a)]);
            q[at(face.a)] += flux;
            q[at(face.b)] -= flux;
        }
        return;
    }
    over_nodes(q.size(), [&](std::size_t i) {
        double flux = 0.0;
        for (std::size_t e = at(pattern_.start[i]); e < at(pattern_.start[i + 1]); ++e) {
            if (const int f = face_of_[e]; f >= 0) {
                flux += terms.face_G[at(f)] * (T[at(pattern_.column[e])] - T[i]);
            }
        }
        q[i] = terms.node_q[i] + flux;
    });
    for (const std::size_t f : second_faces_) {
        const mesh::Face& face = problem_->mesh.faces[f];
        const double flux = terms.face_G[f] * (T[at(face.b)] - T[at(face.a)]);
        q[at(face.a)] += flux;
        q[at(face.b)] -= flux;
    }
}

/// Made when it is first asked for: most runs never do.
physics::Terms& System::terms_to_work_in() const {
    return here_ ? *here_ : here_.emplace(problem_->mesh, effects_.size());
}

void System::find_flow_of(std::span<const std::size_t> which, std::span<const double> T, std::span<const double> means,
                          std::span<const double> coefficients, std::span<double> q) const {
    physics::Terms& terms = terms_to_work_in();
    terms.begin(T);
    find_loss_factors(T, means, coefficients, std::nullopt);
    for (const std::size_t e : which) {
        terms.attribute_to(e);
        effects_[e].effect->heat_effect()->add_terms(evaluation_state(e, T, means, coefficients), terms);
    }
    find_flow(terms, T, q);
}

double System::total_heat(std::span<const double> T, const physics::Inputs& logged, LeftOut left_out) {
    std::vector<double> coefficients(n_coefficients_);
    evaluate_coefficients(logged, coefficients, left_out);
    evaluate(T, coefficients, left_out);
    return std::accumulate(terms_.watts.begin(), terms_.watts.end(), 0.0);
}

double System::share_of_law(std::size_t effect, std::span<const double> T, const physics::Inputs& logged) {
    const double with = total_heat(T, logged, std::nullopt);
    const double without = total_heat(T, logged, effect);
    return with - without;
}

void System::enthalpy(std::span<const double> T, std::span<double> H) const {
    over_nodes(T.size(), [&](std::size_t i) { H[i] = constant_capacity_[i] * T[i]; });
    over_nodes(varying_capacity_.size(), [&](std::size_t k) {
        const std::size_t i = varying_capacity_[k];
        H[i] = mass_[i] * material_model_.materials[at(problem_->mesh.layer[i])].heat_capacity.integral(T[i]);
    });
}

double System::of_budget(std::span<const double> heat) const {
    double sum = sum_of(heat);
    for (const std::size_t node : memory_) {
        sum -= heat[node];
    }
    return sum;
}

}  // namespace tiretherm::solver
