// SPDX-License-Identifier: BSD-3-Clause
// Discrete tangent and adjoint of a run for heat added at each step and node: (forward(h), w) = (h, backward(w)) for
// heat h and weights w on the outputs.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "solver/linear/block_solver.hpp"
#include "solver/sensitivity/prediction.hpp"
#include "solver/sensitivity/surfaces.hpp"
#include "solver/time_integration/sensor_outputs.hpp"
#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

/// A run kept step by step, that can be gone through forwards, with small heat added to it, and backwards, from weights
/// on its outputs to the heat that would answer them: the tangent and the adjoint of the discrete equations, for several
/// sweeps at once. For heat h and weights w, (forward(h), w) = (h, backward(w)) to the tolerance.
/// All that takes time throws Interrupted when the user has asked for an end.
class AdjointRecord {
public:
    /// @param times s, ascending: when the channels are read
    /// @param step_ends s, of the steps to take; as of a prediction at the same times
    AdjointRecord(const Problem& problem, std::span<const double> times, std::span<const double> step_ends);

    [[nodiscard]] const Status& status() const { return status_; }
    [[nodiscard]] std::size_t n_steps() const { return steps_.size(); }
    [[nodiscard]] std::size_t n_nodes() const { return n_; }
    /// Ends of the steps. @returns s
    [[nodiscard]] double end(std::size_t step) const { return steps_[step].stages.back().time; }

    /// Gives the heat of one step, [n_heats][n_nodes] W, in place of that of the step before.
    using Heats = std::function<void(std::size_t step, std::span<double> heat)>;
    /// How the channels answer to several histories of heat, each constant over each step. Those that begin last stand
    /// last: what has not begun is not solved. Many of them are shared out over threads.
    /// @param tolerance of the linear solutions, beside the largest entry
    /// @returns [n_heats][n_times][n_channels] SI, of what follows no temperature 0
    [[nodiscard]] std::vector<double> forward(std::size_t n_heats, const Heats& heats, double tolerance = round_off);
    /// Is given what one step's heat does, [n_sums][n_nodes] per W held over the step; the last step comes first.
    using Slopes = std::function<void(std::size_t step, std::span<const double> slopes)>;
    /// Slopes of weighted sums of outputs with the heat of every step and node.
    /// @param weights [n_sums][n_times][n_channels]  @param tolerance as above
    void backward(std::size_t n_sums, std::span<const double> weights, const Slopes& slopes,
                  double tolerance = round_off);

private:
    static constexpr double round_off = 1e-13;
    struct Step {
        std::vector<std::vector<double>> T;             ///< [stages][n_nodes] K
        std::vector<std::vector<double>> coefficients;  ///< [stages]
        std::vector<StepMoment> stages;                 ///< times, and spans on T
        std::vector<SensorOutputs::Form> carry;         ///< [n_channels] what a lagging sensor gives at the end
        double dt = 0.0;
    };
    /// One sampled output: a linear form of one step.
    struct OutputSample {
        std::size_t step = 0;
        std::size_t channel = 0;
        std::size_t place = 0;     ///< time * n_channels + channel
        SensorOutputs::Form form;  ///< the slope of what is shown included
    };
    /// The linearised stage equations of one step, ready to be solved either way.
    struct Operator {
        Matrix A;
        std::vector<Matrix> J;                      ///< [stages] C - s dq/dT
        std::vector<std::vector<double>> slopes;    ///< what the matrices' outer products point to
        std::vector<std::vector<double>> capacity;  ///< [stages][n_nodes] J/K
        double s = 0.0;
    };
    class ForwardSweep;
    class BackwardSweep;
    void add_step(const Stepper& stepper, std::span<const physics::Inputs> inputs, const SensorOutputs& sensor_outputs);
    void linearise(const Step& step);
    /// Tolerance of the explicit stage's surfaces, beside that of the linear solutions.
    [[nodiscard]] static double of_surfaces(double tolerance) { return std::max(1e-15, 1e-3 * tolerance); }
    void note(Status status);
    [[nodiscard]] Status solve(BlockSolver& solver, Factor& factor, const Matrix& J, std::span<const double> B,
                               std::span<double> X, double tolerance, std::size_t step) const;
    void settle_back(std::span<double> adjoint, std::span<double> heat, double tolerance, std::span<double> w,
                     std::span<double> product);

    const Problem problem_;
    Status status_;
    std::size_t n_ = 0;
    Stepper stepper_;
    std::unique_ptr<Factor> factor_;
    SurfaceSettling settling_;
    std::vector<Step> steps_;
    std::vector<OutputSample> samples_;      ///< ascending in their steps
    std::vector<std::size_t> first_sample_;  ///< [n_steps + 1]
    std::vector<mesh::Functional> places_;   ///< [n_channels]
    std::size_t n_samples_ = 0;              ///< n_times * n_channels
    Operator now_;
};

}  // namespace tiretherm::solver
