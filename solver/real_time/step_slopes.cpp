// SPDX-License-Identifier: BSD-3-Clause
// Stage by stage, with systems of its own, so that nothing of the session moves; then the sensors look at both neighbours.

#include "solver/real_time/step_slopes.hpp"

#include <vector>

#include "mesh/index.hpp"
#include "solver/linear/block_solver.hpp"
#include "solver/sensitivity/surfaces.hpp"
#include "solver/time_integration/sensor_outputs.hpp"
#include "solver/time_integration/step_forcing.hpp"
#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

namespace {

/// Of the linear solutions, beside the largest sensitivity: a hundred times below what the differences leave open.
constexpr double tolerance = 1e-11;

/// A problem over the step, at temperatures that are given.
class Side {
public:
    Side(const Problem& problem, const LastStep& step, const physics::Inputs& to)
        : problem_(&problem),
          step_(&step),
          to_(to),
          system_(problem),
          forcing_(system_, problem.input_signals, step.stepper->method()) {
        forcing_.open(step.inputs.front(), to);
    }

    [[nodiscard]] System& system() { return system_; }
    void evaluate(int stage, std::span<const double> T) { system_.evaluate(T, forcing_.stage(stage)); }

    /// What the channels show at the end of the step. @param S [stages][n_nodes]  @param shift of the temperatures, along S
    [[nodiscard]] std::vector<double> channels(const std::vector<std::vector<double>>& S, double shift) {
        const std::span<const StepMoment> stages = step_->stepper->stages();
        std::vector<StepMoment> moments(stages.begin(), stages.end());
        std::vector<std::vector<double>> temperatures;
        std::vector<std::vector<double>> watts;
        std::vector<physics::Inputs> inputs;
        for (std::size_t i = 0; i < stages.size(); ++i) {
            std::vector<double>& T = temperatures.emplace_back(S[i]);
            for (std::size_t n = 0; n < T.size(); ++n) {
                T[n] = stages[i].temperature[n] + shift * S[i][n];
            }
            evaluate(static_cast<int>(i), T);
            watts.push_back(system_.terms().watts);
            inputs.push_back(physics::between(step_->inputs.front(), to_, step_->stepper->method().c[i]));
        }
        inputs.back() = to_;
        for (std::size_t i = 0; i < moments.size(); ++i) {
            moments[i].temperature = temperatures[i];
            moments[i].watts = watts[i];
        }
        SensorOutputs outputs(*problem_, system_);
        outputs.retake_step(*step_->sensor_outputs, moments, inputs);
        std::vector<double> shown(problem_->channels.size());
        outputs.at(moments.back().time, to_, shown);
        return shown;
    }

private:
    const Problem* problem_;
    const LastStep* step_;
    physics::Inputs to_;
    System system_;
    StepForcing forcing_;
};

/// The stages of the step, one after the other.
class StepTangent {
public:
    StepTangent(const LastStep& step, Side& above, Side& below, double width)
        : stepper_(step.stepper),
          base_(*step.problem, step, step.inputs.back()),
          above_(&above),
          below_(&below),
          width_(width),
          solver_(base_.system().size()),
          settling_(base_.system()) {
        const std::size_t n = at(base_.system().size());
        const std::size_t stages = at(stepper_->method().stages);
        S_.assign(stages, std::vector<double>(n));
        dq_ = S_;
        for (std::vector<double>* v : {&dq_dx_, &dH_dx_, &begin_, &known_, &right_, &high_, &low_}) {
            v->resize(n);
        }
    }

    [[nodiscard]] Status solve() {
        for (int stage = 0; stage < stepper_->method().stages; ++stage) {
            find_partial_derivatives(stage);
            if (Status status = stage == 0 ? begin() : solve_stage(stage); !status.ok()) {
                return status;
            }
        }
        return {};
    }
    /// dT/dx at the stages, [stages][n_nodes].
    [[nodiscard]] const std::vector<std::vector<double>>& temperatures() const { return S_; }

private:
    /// dq/dx and dH/dx at the temperatures of a stage, and its matrices.
    void find_partial_derivatives(int stage) {
        T_ = stepper_->stages()[at(stage)].temperature;
        base_.evaluate(stage, T_);
        base_.system().matrices(s(), false, A_, J_);
        above_->evaluate(stage, T_);
        below_->evaluate(stage, T_);
        take_difference(above_->system().heat_flow(), below_->system().heat_flow(), dq_dx_);
        above_->system().enthalpy(T_, high_);
        below_->system().enthalpy(T_, low_);
        take_difference(high_, low_, dH_dx_);
    }
    void take_difference(std::span<const double> high, std::span<const double> low, std::vector<double>& slope) const {
        for (std::size_t n = 0; n < slope.size(); ++n) {
            slope[n] = (high[n] - low[n]) / width_;
        }
    }
    [[nodiscard]] double s() const { return stepper_->width() * stepper_->method().diagonal; }
    [[nodiscard]] double stored(int stage, std::size_t n) {
        System& system = base_.system();
        return system.has_capacity(n) ? system.capacity(n, T_[n]) * S_[at(stage)][n] : 0.0;
    }

    /// The explicit stage: cells hold, surfaces without capacity follow at once.
    [[nodiscard]] Status begin() {
        if (Status status = settling_.settle(J_, dq_dx_, s(), tolerance, S_[0]); !status.ok()) {
            return status;
        }
        J_.multiply(S_[0], right_);
        for (std::size_t n = 0; n < begin_.size(); ++n) {
            begin_[n] = dH_dx_[n] + stored(0, n);
            dq_[0][n] = (stored(0, n) - right_[n]) / s() + dq_dx_[n];  // s dq/dT S = C S - J S
        }
        return {};
    }

    [[nodiscard]] Status solve_stage(int stage) {
        known_ = begin_;
        for (int j = 0; j < stage; ++j) {
            const double weight = stepper_->width() * stepper_->method().a[at(stage)][at(j)];
            for (std::size_t n = 0; n < known_.size(); ++n) {
                known_[n] += weight * dq_[at(j)][n];
            }
        }
        for (std::size_t n = 0; n < known_.size(); ++n) {
            right_[n] = known_[n] + s() * dq_dx_[n] - dH_dx_[n];
        }
        S_[at(stage)] = S_[at(stage) - 1];
        if (!solver_.solve(J_, stepper_->newton().factor(), right_, S_[at(stage)], tolerance).converged) {
            return {Outcome::not_converged, "the derivative of the step did not converge"};
        }
        for (std::size_t n = 0; n < known_.size(); ++n) {
            dq_[at(stage)][n] = (stored(stage, n) + dH_dx_[n] - known_[n]) / s();
        }
        return {};
    }

    Stepper* stepper_;
    Side base_;
    Side* above_;
    Side* below_;
    double width_;
    BlockSolver solver_;
    SurfaceSettling settling_;
    Matrix A_;
    Matrix J_;
    std::span<const double> T_;            ///< [n_nodes] K, of the stage
    std::vector<std::vector<double>> S_;   ///< [stages][n_nodes] dT/dx
    std::vector<std::vector<double>> dq_;  ///< [stages][n_nodes] d(heat flow)/dx in whole
    std::vector<double> dq_dx_;            ///< [n_nodes] where the temperatures are held
    std::vector<double> dH_dx_;
    std::vector<double> begin_;  ///< dH/dx in whole at the begin
    std::vector<double> known_;
    std::vector<double> right_;
    std::vector<double> high_;
    std::vector<double> low_;
};

}  // namespace

Status find_step_slopes(const LastStep& step, const StepNeighbour& above, const StepNeighbour& below,
                        std::span<double> slope) {
    const double width = above.shift - below.shift;
    Side high(above.problem, step, above.to);
    Side low(below.problem, step, below.to);
    StepTangent tangent(step, high, low, width);
    if (Status status = tangent.solve(); !status.ok()) {
        return status;
    }
    const std::vector<double> shown_above = high.channels(tangent.temperatures(), above.shift);
    const std::vector<double> shown_below = low.channels(tangent.temperatures(), below.shift);
    for (std::size_t c = 0; c < slope.size(); ++c) {
        slope[c] = (shown_above[c] - shown_below[c]) / width;
    }
    return {};
}

}  // namespace tiretherm::solver
