#pragma once

#include <memory>
#include <span>
#include <vector>

#include "solver/prediction.hpp"
#include "solver/readings.hpp"
#include "solver/stepper.hpp"

namespace tiretherm::solver {

/// A run kept step by step, that can be gone through forwards, with small heat added to it, and backwards, from weights
/// on its readings to the heat that would answer them: the tangent and the adjoint of the discrete equations. For heat h
/// and weights w, (forward(h), w) = (h, backward(w)) to round-off.
class Tape {
public:
    /// @param times s, ascending: when the channels are read
    /// @param step_ends s, of the steps to take; as of a prediction at the same times
    Tape(const Problem& problem, std::span<const double> times, std::span<const double> step_ends);

    [[nodiscard]] const Status& status() const { return status_; }
    [[nodiscard]] std::size_t n_steps() const { return steps_.size(); }
    [[nodiscard]] std::size_t n_nodes() const { return n_; }
    /// Ends of the steps. @returns s
    [[nodiscard]] double end(std::size_t step) const { return steps_[step].stages.back().time; }

    /// How the channels answer to heat that is constant over each step.
    /// @param heat [n_steps][n_nodes] W  @returns [n_times][n_channels] SI, of what follows no temperature 0
    [[nodiscard]] std::vector<double> forward(std::span<const double> heat);
    /// Slope of the weighted sum of readings with the heat of every step and node.
    /// @param weights [n_times][n_channels]  @returns [n_steps][n_nodes] per W held over the step
    [[nodiscard]] std::vector<double> backward(std::span<const double> weights);

private:
    struct Step {
        std::vector<std::vector<double>> T;            ///< [stages][n_nodes] K
        std::vector<std::vector<double>> intensities;  ///< [stages]
        std::vector<Stage> stages;                     ///< times, and spans on T
        std::vector<Readings::Form> carry;             ///< [n_channels] what a lagging sensor gives at the end
        double dt = 0.0;
    };
    /// One reading: a linear form of one step.
    struct Reading {
        std::size_t step = 0;
        std::size_t channel = 0;
        std::size_t place = 0;  ///< time * n_channels + channel
        Readings::Form form;    ///< the slope of what is shown included
    };
    /// The linearised stage equations of one step, ready to be solved either way.
    struct Operator {
        Matrix A;
        std::vector<Matrix> J;                      ///< [stages] C - s dq/dT
        std::vector<std::vector<double>> slopes;    ///< what the matrices' outer products point to
        std::vector<std::vector<double>> capacity;  ///< [stages][n_nodes] J/K
        double s = 0.0;
    };
    void record(const Stepper& stepper, std::span<const physics::Inputs> inputs, const Readings& readings);
    void linearise(const Step& step);
    void solve(const Matrix& J, std::span<const double> b, std::span<double> x);
    void settle_surfaces(std::span<double> S, std::span<const double> heat);
    void settle_surfaces_back(std::span<double> adjoint, std::span<double> heat);

    const Problem problem_;
    Status status_;
    std::size_t n_ = 0;
    Stepper stepper_;
    std::unique_ptr<Factor> factor_;
    Krylov krylov_;
    std::vector<Step> steps_;
    std::vector<Reading> readings_;           ///< ascending in their steps
    std::vector<std::size_t> first_reading_;  ///< [n_steps + 1]
    std::vector<mesh::Functional> places_;    ///< [n_channels]
    std::size_t n_readings_ = 0;              ///< n_times * n_channels
    Operator now_;
    std::vector<double> left_;
    double factored_s_ = 0.0;
};

}  // namespace tiretherm::solver
