// SPDX-License-Identifier: BSD-3-Clause
// A session with its inputs and with numbers that may be moved while it runs: what the C interface and an FMU offer.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/real_time/session_model.hpp"
#include "solver/real_time/step_slopes.hpp"
#include "solver/time_integration/session.hpp"

namespace tiretherm::solver {

/// A direction among the inputs and parameters of a session: what each moves by, in its unit, for a unit of the direction.
struct SessionDirection {
    struct Input {
        const physics::Signal* signal;
        double rate;
    };
    struct Parameter {
        std::size_t index;
        double rate;
    };
    std::vector<Input> inputs;
    std::vector<Parameter> parameters;
};

/// A session that keeps its inputs between steps and the values of its parameters.
class TunableSession {
public:
    explicit TunableSession(SessionModel model);

    [[nodiscard]] const SessionModel& model() const { return model_; }
    [[nodiscard]] const Session& session() const { return session_; }

    /// Of the end of the next step. They stay until they are set again.
    [[nodiscard]] const physics::Inputs& inputs() const { return inputs_; }
    /// Why a value cannot be set, "speed = 900 m s-1 is not between 0 and 150"; empty when it can.
    [[nodiscard]] static std::string refusal(const physics::Signal& signal, double value);
    /// @returns the refusal; empty when it was set
    [[nodiscard]] std::string set_input(const physics::Signal& signal, double value);

    /// @returns in the parameter's unit
    [[nodiscard]] double parameter(std::size_t index) const { return values_[index]; }
    [[nodiscard]] std::string refusal(std::size_t index, double value) const;
    /// To be followed by `apply_parameters`. @param value in the parameter's unit  @returns the refusal; empty when it was set
    [[nodiscard]] std::string set_parameter(std::size_t index, double value);
    /// Lets the session follow the parameters that were set, before the first step from its beginning on. Allocates.
    void apply_parameters();

    /// Begins anew, with the parameters that were set. @param start the inputs at the beginning, of which `time` counts as 0
    void begin(const physics::Inputs& start);
    /// As Session::advance, with the inputs that were set.
    [[nodiscard]] Status advance(double dt) { return session_.advance(dt, inputs_); }

    /// Derivatives of the channels in a direction: of what the last step led to, with the inputs at its end and the parameters over
    /// it, from the same state; before the first step of what the session begins with. Changes nothing. Allocates.
    /// @param slope out, [n_channels] SI for a unit of the direction
    /// @returns not done where a step was taken, but a state was restored or a parameter applied since
    [[nodiscard]] Status find_slopes(const SessionDirection& direction, std::span<double> slope) const;

    /// Inputs, parameters and the state of the session as numbers.
    [[nodiscard]] std::vector<double> state();
    /// Goes on from a state with the same digits. @returns false for what is no state of this model; nothing has changed then
    [[nodiscard]] bool restore(std::span<const double> state);

private:
    [[nodiscard]] Problem moved(const std::vector<double>& values) const;
    [[nodiscard]] double reach(const SessionDirection& direction) const;
    [[nodiscard]] StepNeighbour neighbour(const SessionDirection& direction, const physics::Inputs& inputs,
                                          double shift) const;

    SessionModel model_;
    std::vector<double> base_;    ///< the parameters in the model
    std::vector<double> values_;  ///< the parameters now
    physics::Inputs start_;
    physics::Inputs inputs_;
    Session session_;
};

}  // namespace tiretherm::solver
