// SPDX-License-Identifier: BSD-3-Clause
// Sensitivities S = dT/dp carried along with a run: (C - s dq/dT) S = d(known)/dp - dH/dp + s dq/dp at every stage of a
// step.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "solver/linear/block_solver.hpp"
#include "solver/sensitivity/parameter_perturbation.hpp"
#include "solver/sensitivity/surfaces.hpp"
#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

/// Derivatives of a run with parameters of its problem, carried along with it: the tangent of the discrete equations,
/// whose steps are held. With q(T, p) the heat flow and H(T, p) the enthalpy, a stage H(T_i) - s q(T_i) = known gives
///
///     (C - s dq/dT) S_i = d(known)/dp - dH/dp + s dq/dp        S_i = dT_i/dp
///
/// for all parameters together, the unsymmetric matrix by iteration on the kept factor of its symmetric part.
class Tangent {
public:
    /// @param stepper of the base run, which lives longer  @param values that the base problem has
    /// @param tolerance of the linear solutions, relative to the largest sensitivity
    Tangent(const Problem& problem, Stepper& stepper, std::span<const FreeParameter> parameters,
            std::span<const double> values, double tolerance);

    /// At the start, before any step. @param inputs logged
    void begin(const physics::Inputs& inputs);
    /// After the stepper has accepted a step. @param inputs logged ones at its stages
    [[nodiscard]] Status take_step(std::span<const physics::Inputs> inputs);
    /// After the stepper has found a steady state. @param inputs logged
    [[nodiscard]] Status take_steady(const physics::Inputs& inputs);

    /// d(channels)/dp at a moment of the last step. @param out [n_parameters][n_channels] SI per unit
    void read(double t, const physics::Inputs& logged, std::span<double> out);
    /// dT/dp at the end of the last step. @returns [n_nodes] K per unit
    [[nodiscard]] std::span<const double> temperature(std::size_t number) const { return column(S_.back(), number); }
    [[nodiscard]] const ParameterPerturbation& perturbation(std::size_t number) const {
        return *perturbations_[number];
    }
    [[nodiscard]] std::size_t size() const { return perturbations_.size(); }
    [[nodiscard]] long sweeps() const { return sweeps_; }

private:
    using Block = std::vector<double>;  ///< [n_parameters][n_nodes]
    [[nodiscard]] std::span<const double> column(const Block& block, std::size_t j) const {
        return std::span(block).subspan(j * n_, n_);
    }
    [[nodiscard]] std::span<double> column(Block& block, std::size_t j) const {
        return std::span(block).subspan(j * n_, n_);
    }
    void find_flow_slopes(int stage, std::span<const double> T);
    void find_capacities(std::span<const double> T);
    [[nodiscard]] Status start_step(double s);
    [[nodiscard]] Status solve_stage(int stage, double dt);

    const Problem* problem_;
    Stepper* stepper_;
    System* system_;
    std::size_t n_;
    double tolerance_;
    std::vector<std::unique_ptr<ParameterPerturbation>> perturbations_;
    BlockSolver solver_;
    SurfaceSettling settling_;
    Matrix A_;
    Matrix J_;
    std::vector<Block> S_;   ///< [stages] dT/dp
    std::vector<Block> dq_;  ///< [stages] d(heat flow)/dp in whole, W per unit
    Block before_;           ///< S of the last step's stage before its end
    Block enthalpy_begin_;   ///< dH/dp in whole at the begin of the step, J per unit
    Block enthalpy_end_;     ///< the same at its end
    Block known_;            ///< right-hand side of a stage, J per unit
    Block partial_;          ///< dq/dp or dH/dp at a given temperature
    Block product_;
    std::vector<double> capacity_;   ///< [n_nodes] J/K at a stage
    std::vector<double> base_flow_;  ///< [n_nodes] W, of straight effects in the base problem
    std::vector<double> ended_;      ///< coefficients at the end of the last step
    double last_width_ = 0.0;
    long sweeps_ = 0;
};

}  // namespace tiretherm::solver
