// SPDX-License-Identifier: BSD-3-Clause
// Coefficients of all effects at the stages of a step. Over logged samples they follow the straight line with the same
// mean and first moment as the series.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/system.hpp"
#include "solver/time_integration/kept_forcing.hpp"
#include "solver/time_integration/tableau.hpp"

namespace tiretherm::solver {

/// The coefficients of all effects over one step, at the times of its stages.
///
/// A step that holds no logged sample inside takes them at the stage times. A step that spans samples takes, for each
/// coefficient, the straight line with the same mean and first moment as the series has over the step (Simpson's rule
/// between samples, exact for products of two straight inputs); its slope is limited so that the line stays within the
/// values of the series. `unresolved` is what such a line leaves out.
class StepForcing {
public:
    /// @param kept what is found of the steps goes there, or comes from there once it is closed, without `unresolved`; null: it is
    ///        found anew
    StepForcing(const System& system, const InputSignals& input_signals, const Tableau& tableau,
                KeptForcing* kept = nullptr);
    StepForcing(const StepForcing&) = delete;
    StepForcing& operator=(const StepForcing&) = delete;

    /// @param t0, t1 s; no stop of the input signals lies between them
    void open(double t0, double t1);
    /// The step that another forcing has opened, where only some effects have other coefficients under the same inputs and laws.
    /// @param opened of a problem whose inputs and laws are the same   @param which these effects, indices into System::effects()
    void open_beside(StepForcing& opened, std::span<const std::size_t> which);
    /// For real time: inputs that go straight from one moment to the next.
    void open(const physics::Inputs& from, const physics::Inputs& to);

    /// @returns [n_coefficients] at stage i of the last opened step
    [[nodiscard]] std::span<const double> stage(int i) const { return stages_[static_cast<std::size_t>(i)]; }
    /// Whether the step spans logged samples.
    [[nodiscard]] bool averaged() const { return averaged_; }
    /// First stage's coefficients plus the largest integral that the line leaves out, divided by the step.
    [[nodiscard]] std::span<const double> unresolved() const { return unresolved_; }

private:
    /// What the inputs are at the times where a step is looked at, and the laws under them.
    struct Moment {
        physics::Inputs inputs;
        physics::Laws laws;
    };
    void find_moments();
    void find_stages(const StepForcing& moments, std::span<const std::size_t> which);
    void average(const StepForcing& moments, std::size_t column);

    const System* system_;
    const InputSignals* logged_;
    std::optional<InputSignals> in_time_;          ///< the inputs without the delays of their logs, where there are any
    const InputSignals* input_signals_ = nullptr;  ///< null before they are asked
    const Tableau* tableau_;
    KeptForcing* kept_;
    std::vector<std::vector<double>> stages_;
    std::optional<physics::Inputs> ended_;  ///< in real time: what the last opened step ends with
    double begin_ = 0.0;                    ///< s, of the last opened step
    double end_ = 0.0;
    bool averaged_ = false;
    std::vector<double> unresolved_;
    std::vector<double> nodes_;    ///< times of samples and midpoints of the step, or of its stages
    std::vector<Moment> moments_;  ///< [nodes]; empty where nothing had to be found of the step
    std::vector<double> places_;   ///< [nodes] from 0 to 1 over the step
    std::vector<double> widths_;   ///< [nodes] of two intervals from a node on, as shares of the step
    std::vector<double> values_;   ///< [nodes][n_coefficients]
};

}  // namespace tiretherm::solver
