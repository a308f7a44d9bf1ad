// SPDX-License-Identifier: BSD-3-Clause
// Partial derivatives with respect to one parameter at a given state, dq/dp, dH/dp and those of the initial state and
// the outputs: the right-hand sides of the tangent.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "solver/sensitivity/free_parameter.hpp"
#include "solver/system.hpp"
#include "solver/time_integration/sensor_outputs.hpp"
#include "solver/time_integration/step_forcing.hpp"

namespace tiretherm::solver {

/// What a small move of one parameter changes at a given state: the heat flow, the enthalpy, the initial state, the
/// outputs. By differences of the right-hand side alone, between two neighbouring problems; no run is repeated.
class ParameterPerturbation {
public:
    /// @param value that the base problem has
    ParameterPerturbation(const Problem& base, const FreeParameter& parameter, double value);

    /// @returns d(initial state)/dp [n_nodes] K per unit
    [[nodiscard]] std::vector<double> start() const;
    /// Whether the heat flow or the enthalpy follows the parameter at a given state.
    [[nodiscard]] bool moves_flow() const { return !moved_effects_.empty() || moves_coefficients_; }
    [[nodiscard]] bool moves_enthalpy() const { return moves_enthalpy_; }

    /// Finds the coefficients over a step. @param t0, t1 s  @param base forcing of the base problem, with this step opened
    void open(double t0, double t1, StepForcing& base);
    /// Whether this step begins with what the last one ended with.
    [[nodiscard]] bool goes_on() const;
    /// d(heat flow)/dp at a stage of the step. @param base coefficients of the base problem at this stage
    /// @param means of the regions at T  @param out [n_nodes] W per unit
    void flow(int stage, std::span<const double> T, std::span<const double> means, std::span<const double> base,
              std::span<double> out);
    /// Effects that follow it without inputs and as good as straight, as conduction follows a conductivity; empty
    /// where that does not hold. Their terms in the base problem then serve as the lower side for all such parameters.
    [[nodiscard]] std::span<const std::size_t> straight() const {
        return is_straight_ ? std::span<const std::size_t>(moved_effects_) : std::span<const std::size_t>{};
    }
    /// d(heat flow)/dp of a straight parameter. @param base_flow of its effects in the base problem, [n_nodes] W
    void flow_above(std::span<const double> T, std::span<const double> means, std::span<const double> base,
                    std::span<const double> base_flow, std::span<double> out);
    /// d(enthalpy)/dp. @param out [n_nodes] J per unit
    void enthalpy(std::span<const double> T, std::span<double> out) const;

    /// Whether the heat flow's slope to one side was another than to the other, at some stage so far.
    [[nodiscard]] bool has_kink() const { return has_slope_jump_; }

    void begin_sensor_outputs(double t, std::span<const double> T, std::span<const double> S,
                              std::span<const double> watts, const physics::Inputs& inputs);
    /// @param stages of the base run  @param S its sensitivities at the stages, each [n_nodes] K per unit
    /// @param coefficients of the base run at the stages
    void take_step(std::span<const StepMoment> stages, std::span<const std::span<const double>> S,
                   std::span<const std::span<const double>> coefficients, std::span<const physics::Inputs> inputs);
    /// d(channels)/dp at a moment of the last step. @param out [n_channels]
    void read(double t, const physics::Inputs& logged, std::span<double> out);

private:
    /// One of the two neighbours.
    struct Side {
        Side(const Problem& base, const FreeParameter& parameter, double value, double to);
        Problem problem;
        System system;
        StepForcing forcing;
        SensorOutputs sensor_outputs;
        double shift;                            ///< of the parameter, in its unit
        std::vector<double> ended;               ///< coefficients at the end of the last step
        std::vector<double> q;                   ///< [n_nodes]
        std::vector<double> read;                ///< [n_channels]
        std::vector<std::vector<double>> T;      ///< [stages][n_nodes]
        std::vector<std::vector<double>> watts;  ///< [stages][n_effects]
    };
    const Problem* base_;
    std::unique_ptr<Side> plus_;
    std::unique_ptr<Side> minus_;
    double width_ = 1.0;  ///< plus_->shift - minus_->shift
    bool moves_enthalpy_ = false;
    bool is_straight_ = false;
    bool is_delay_ = false;
    bool follows_own_inputs_ = false;  ///< the inputs follow the parameter
    bool moves_coefficients_ = false;
    bool follows_watts_ = false;              ///< a channel reads the heat of effects
    bool channels_are_linear_ = false;        ///< in the temperatures, and do not follow the parameter else
    std::vector<std::size_t> moved_effects_;  ///< heat effects whose parameters or places differ
    /// Effects whose coefficients follow the parameter, while inputs and laws do not; empty where these do.
    std::vector<std::size_t> driven_;
    std::vector<std::size_t> contributing_;  ///< those that differ at a stage
    bool has_slope_jump_ = false;
};

}  // namespace tiretherm::solver
