// SPDX-License-Identifier: BSD-3-Clause
// Real-time interface: the caller gives a step and the inputs at its end and reads temperatures. Bounded work, no lock,
// no file. Its state can be kept and taken up again.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/problem.hpp"
#include "solver/status.hpp"

namespace tiretherm::solver {

class Archive;
class SensorOutputs;
class Stepper;

/// What the last step of a session was made of, until the session takes another one.
struct LastStep {
    const Problem* problem;
    Stepper* stepper;
    const SensorOutputs* sensor_outputs;
    std::span<const physics::Inputs> inputs;  ///< at its stages
};

/// A problem advanced in real time: the caller gives a step and the inputs at its end, and reads the temperatures.
/// Between two calls the inputs go in a straight line. A step is one step of the problem's method without error
/// control: bounded work, no lock, no file, and after the first steps no allocation. The numbers are those of a batch
/// run with the same steps and inputs.
///
/// Not safe to call from two threads at once; independent sessions are independent.
class Session {
public:
    /// @param problem copied; its input signals and times are not used  @param start the inputs at the beginning
    Session(Problem problem, const physics::Inputs& start);
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    /// @param dt s, > 0  @param inputs at the end of the step
    /// @errors as `run`; the state is then left as it was before the call
    [[nodiscard]] Status advance(double dt, const physics::Inputs& inputs);

    /// The state as numbers, from which this session, or another of the same problem, goes on with the same digits.
    [[nodiscard]] std::vector<double> state();
    /// Takes a state up again. @returns false for what is no state of this problem; nothing has changed then
    [[nodiscard]] bool restore(std::span<const double> state);
    /// Goes on from the present temperatures with other numbers in the problem, such as a film or a conductivity. May allocate.
    /// @param problem of the same mesh, effects and channels; its initial temperatures are not used
    void exchange(Problem problem);

    /// Nothing before the first step, and after a state or another problem was taken up.
    [[nodiscard]] std::optional<LastStep> last_step() const;

    [[nodiscard]] double time() const;                          ///< s since the beginning
    [[nodiscard]] std::span<const double> temperature() const;  ///< [n_nodes] K
    [[nodiscard]] double channel(std::size_t index) const;      ///< SI
    [[nodiscard]] std::span<const double> watts() const;        ///< [n_effects] W
    [[nodiscard]] double energy_closure() const;                ///< as in Report

private:
    void visit(Archive& archive);

    std::unique_ptr<Problem> problem_;
    std::unique_ptr<Stepper> stepper_;
    std::unique_ptr<SensorOutputs> sensor_outputs_;
    physics::Inputs inputs_;
    std::vector<physics::Inputs> stage_inputs_;
    std::vector<double> channels_;
    bool has_last_step_ = false;
};

}  // namespace tiretherm::solver
