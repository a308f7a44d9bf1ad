// SPDX-License-Identifier: BSD-3-Clause
// Semi-discrete heat balance dH/dt = q(T, t): enthalpy H(T) and heat flow q of every node, with its matrices.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "physics/terms.hpp"
#include "solver/linear/matrix.hpp"
#include "solver/problem.hpp"
#include "solver/status.hpp"

namespace tiretherm::solver {

/// The semi-discrete problem dH/dt = q(T, t): enthalpy H [J] and heat flow q [W] of every node. Surface nodes have no
/// capacity, so that their row says q = 0. Everything it needs is allocated once.
class System {
public:
    explicit System(const Problem& problem);

    [[nodiscard]] int size() const { return problem_->mesh.n_nodes; }
    [[nodiscard]] const Problem& problem() const { return *problem_; }
    [[nodiscard]] const Pattern& pattern() const { return pattern_; }
    [[nodiscard]] std::size_t n_coefficients() const { return n_coefficients_; }
    [[nodiscard]] bool has_capacity(std::size_t node) const { return mass_[node] > 0.0 || lump_[node] > 0.0; }
    /// Heat capacity of a node at a temperature. @returns J/K
    [[nodiscard]] double capacity(std::size_t node, double T) const {
        const double constant = constant_capacity_[node];
        return constant > 0.0 ? constant : varying_capacity(node, T);
    }
    /// What the layers are made of, as the effects on properties left it.
    [[nodiscard]] const physics::MaterialModel& material_model() const { return material_model_; }
    /// The effects that are on, each in its place.
    [[nodiscard]] std::span<const physics::ActiveEffect> effects() const { return effects_; }
    /// The initial state, with the effects on it. @returns [n_nodes] K
    [[nodiscard]] std::vector<double> initial() const;

    /// The logged inputs after the input corrections.
    [[nodiscard]] physics::Inputs transformed(physics::Inputs inputs) const;
    /// Coefficients of all effects, one after the other, for the logged inputs of a moment. @param out [n_coefficients]
    void evaluate_coefficients(const physics::Inputs& logged, std::span<double> out) const;
    /// Those of some effects alone, into their places. @param which indices into effects()
    /// @param inputs after the input corrections  @param laws that hold under them
    void evaluate_coefficients(std::span<const std::size_t> which, const physics::Inputs& inputs,
                               const physics::Laws& laws, std::span<double> out) const;
    /// What the effects make of the laws at a moment. @param inputs after the input corrections  @param left_out an effect
    /// whose law is left out
    [[nodiscard]] physics::Laws laws(const physics::Inputs& inputs, std::optional<std::size_t> left_out = {}) const;

    /// Lets every effect add its terms at T [n_nodes] K with these coefficients.
    void evaluate(std::span<const double> T, std::span<const double> coefficients);
    /// The terms of the last evaluation.
    [[nodiscard]] const physics::Terms& terms() const { return terms_; }
    /// Heat of all effects at T under the inputs, less what it would be without the law of one effect. @returns W
    [[nodiscard]] double share_of_law(std::size_t effect, std::span<const double> T, const physics::Inputs& logged);
    /// Heat flow into each node on account of some effects alone; the terms of the last evaluation stay.
    /// @param which indices into effects()  @param means of the regions at T  @param q out, [n_nodes] W
    void find_flow_of(std::span<const std::size_t> which, std::span<const double> T, std::span<const double> means,
                      std::span<const double> coefficients, std::span<double> q) const;
    /// Mean temperature of every region at T [n_nodes] K. @param means out, [n_regions] K
    void find_means(std::span<const double> T, std::span<double> means) const;
    /// Mean temperature of every region at the last evaluation. @returns [n_regions] K
    [[nodiscard]] std::span<const double> means() const { return means_; }
    /// The effects that have coefficients. @returns indices into effects()
    [[nodiscard]] std::span<const std::size_t> with_coefficients() const { return with_coefficients_; }
    /// Where an effect's coefficients begin among those of all.
    [[nodiscard]] std::size_t first_coefficient(std::size_t effect) const { return first_coefficient_[effect]; }
    /// An effect's coefficients among those of all.
    [[nodiscard]] std::span<const double> coefficients_of(std::size_t effect, std::span<const double> all) const {
        return all.subspan(first_coefficient_[effect],
                           static_cast<std::size_t>(effects_[effect].effect->n_coefficients()));
    }
    /// Heat flow into each node at the last evaluation. @returns [n_nodes] W
    [[nodiscard]] std::span<const double> heat_flow() const { return flow_; }

    /// H(T) of each node, zero at 0 K. @param H out, [n_nodes] J
    void enthalpy(std::span<const double> T, std::span<double> H) const;

    /// The sum over all nodes but those that are the memory of a law. @param heat [n_nodes] J  @returns J
    [[nodiscard]] double of_budget(std::span<const double> heat) const;

    /// At the last evaluation: A = C + s K, symmetric positive definite, and J = C - s dq/dT. @param s s, > 0
    /// With `steady`, C is left out.
    void matrices(double s, bool steady, Matrix& A, Matrix& J) const;
    /// A alone.
    void symmetric_matrix(double s, bool steady, Matrix& A) const;

    /// Relaxes the surface nodes to q = 0 with the cells held: they follow a jump of the inputs at once. The system has
    /// been evaluated at the result.
    void make_consistent(std::span<double> T, std::span<const double> coefficients);

    /// A failure at a node in a sentence: why, when, where, and the largest heat source there.
    [[nodiscard]] Status failure_at(Outcome outcome, std::string_view why, int node, double time,
                                    std::span<const double> T, std::span<const double> coefficients);
    /// First node whose heat flow at the last evaluation is not finite, or -1.
    [[nodiscard]] int first_not_finite() const;

private:
    void settle_effects();
    void find_surfaces();
    void find_flow(const physics::Terms& terms, std::span<const double> T, std::span<double> q) const;
    void find_symmetric_part(double s, bool steady, Matrix& A) const;
    bool add_slopes_of_faces(double s, Matrix& J) const;
    void find_stiffness_of_surfaces();
    [[nodiscard]] double varying_capacity(std::size_t node, double T) const;
    [[nodiscard]] physics::Terms& terms_to_work_in() const;
    [[nodiscard]] physics::EvaluationState evaluation_state(std::size_t effect, std::span<const double> T,
                                                            std::span<const double> means,
                                                            std::span<const double> coefficients) const;
    /// An effect whose law is left out, to find what the law does; empty in every run.
    using LeftOut = std::optional<std::size_t>;
    void evaluate_coefficients(const physics::Inputs& logged, std::span<double> out, LeftOut left_out) const;
    void evaluate(std::span<const double> T, std::span<const double> coefficients, LeftOut left_out);
    void find_loss_factors(std::span<const double> T, std::span<const double> means,
                           std::span<const double> coefficients, LeftOut left_out) const;
    [[nodiscard]] double total_heat(std::span<const double> T, const physics::Inputs& logged, LeftOut left_out);
    [[nodiscard]] std::string largest_heat_source(int node, std::span<const double> T,
                                                  std::span<const double> coefficients);

    const Problem* problem_;
    Pattern pattern_;
    std::size_t n_coefficients_ = 0;
    std::vector<std::size_t> first_coefficient_;  ///< [n_effects]
    std::vector<std::size_t> with_coefficients_;  ///< effects that have any
    std::vector<std::size_t> with_loss_law_;
    physics::Terms terms_;
    mutable std::optional<physics::Terms> here_;  ///< to work in: derivatives by difference, some effects alone
    std::optional<physics::Terms> there_;
    std::vector<double> means_;
    std::vector<double> shifted_means_;
    std::vector<double> shifted_;
    std::vector<double> flow_;
    physics::MaterialModel material_model_;
    std::vector<physics::ActiveEffect> effects_;
    /// A node without capacity, and what its own balance is like while the cells are held.
    struct Surface {
        std::size_t node = 0;
        double stiffness = 0.0;  ///< W/K
        double too_cold = 0.0;   ///< K, bounds of where it comes to rest
        double too_hot = 0.0;
    };
    std::vector<Surface> surfaces_;
    /// A face at such a node.
    struct SurfaceFace {
        std::size_t face;
        std::size_t surface;  ///< index into surfaces_
        bool is_a;            ///< whether the node is the face's node a
    };
    std::vector<SurfaceFace> surface_faces_;
    std::vector<int> face_of_;                   ///< [n_nonzeros] face that joins row and column; -1 on the diagonal
    std::vector<std::size_t> second_faces_;      ///< between nodes that another face joins, too
    std::vector<double> mass_;                   ///< [n_nodes] kg, density * volume; 0 for surfaces and lumped nodes
    std::vector<double> lump_;                   ///< [n_nodes] J/K of a lumped node
    std::vector<std::size_t> memory_;            ///< nodes that are states of a law
    std::vector<double> constant_capacity_;      ///< [n_nodes] J/K where it does not follow the temperature, else 0
    std::vector<std::size_t> varying_capacity_;  ///< nodes whose heat capacity does
    mutable std::vector<physics::LossFactor> loss_factors_;
};

/// A place in words: "cell 12 of layer tread, 3.2 mm deep".
[[nodiscard]] std::string describe_node(const mesh::Mesh& mesh, int node);

}  // namespace tiretherm::solver
