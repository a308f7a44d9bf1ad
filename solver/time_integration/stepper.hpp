// SPDX-License-Identifier: BSD-3-Clause
// Advances dH/dt = q(T, t) by one step of TR-BDF2 or backward Euler, with an estimate of the local error and the heat
// budget of every effect.
#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/time_integration/checkpoint.hpp"
#include "solver/time_integration/newton.hpp"
#include "solver/time_integration/step_forcing.hpp"

namespace tiretherm::solver {

/// The state at a moment inside a step.
struct StepMoment {
    double time = 0.0;                    ///< s
    std::span<const double> temperature;  ///< [n_nodes] K
    std::span<const double> watts;        ///< [n_effects] W
};

/// Steps a system through time. Holds the state, the ledger and every buffer; a step allocates nothing but what the
/// linear algebra libraries need when a new factor is made.
class Stepper {
public:
    /// @param kept as StepForcing takes it: closed, the steps must be given
    explicit Stepper(const Problem& problem, KeptForcing* kept = nullptr);

    /// Where an attempted step would lead.
    struct Attempt {
        Status status;
        double error = 0.0;  ///< K, estimate of the local error, the input's unresolved part included
    };

    /// Tries a step from time() to t1 over which no stop of the inputs lies. The state changes only by `accept`.
    /// @param closed whether the heat budget closes to round-off at t1; what it leaves open is else carried into the next
    /// @param harmless K, an error below which a bound of it says enough and costs no solve
    [[nodiscard]] Attempt attempt(double t1, bool closed, double harmless = 0.0);
    /// The same, not closed, with inputs that go straight from `from` to `to`, whatever the problem's input signals say.
    [[nodiscard]] Attempt attempt(double t1, const physics::Inputs& from, const physics::Inputs& to);
    void accept();
    /// A failure at the place of the largest error of the last attempt.
    [[nodiscard]] Status failure_at_largest_error(std::string_view why);

    /// Finds the watts at the present state under the inputs just after `time()`, which a run reports before its first
    /// step; the surfaces that follow the inputs at once are not moved for it.
    void find_watts(const physics::Inputs& logged);

    /// Solves q(T) = 0 for the inputs at a time, from the present state as a guess.
    [[nodiscard]] Status solve_steady(double t);

    /// Largest rate of change at the present state under the inputs just after `time()`. @returns K/s
    [[nodiscard]] double steepest_rate();

    /// What the laws gave at the end of the last step no longer holds: another problem goes on from there.
    void forget_end() { now_.end_is_known = false; }

    /// Writes or reads the state. The next step starts with a new factor either way, so that both ways go on alike.
    void visit(Archive& archive);

    /// Heat that leaves the bulk by conduction over the difference of the two regions' mean temperatures: what the link
    /// of a two-node model would have to be to carry it. NaN without these regions or without a difference. @returns W/K
    [[nodiscard]] double effective_two_node_conductance();

    [[nodiscard]] double time() const { return now_.time; }
    [[nodiscard]] std::span<const double> temperature() const { return T_.front(); }
    /// State inside the last accepted step, by the parabola through its stages. @param t s, within that step
    void interpolate(double t, std::span<double> T) const;
    /// Watts of each effect there, by the same parabola. @param watts out, [n_effects] W
    void interpolate_watts(double t, std::span<double> watts) const;
    /// Heat attributed to each effect until a moment inside the last accepted step. @param joules out, [n_effects] J
    void interpolate_joules(double t, std::span<double> joules) const;
    [[nodiscard]] std::span<const double> watts() const { return now_.watts; }    ///< [n_effects] W at the state
    [[nodiscard]] std::span<const double> joules() const { return now_.joules; }  ///< [n_effects] J since the start
    [[nodiscard]] double stored() const { return now_.stored; }                   ///< J since the start
    /// |stored + carried - sum of joules| over the heat turned over (sum of |watts| dt) since the start, with what the last
    /// step left open of its balance for the next to carry; 0 before the first step.
    [[nodiscard]] double energy_closure() const;
    /// The stages of the last accepted step, its begin and its end among them; one after a steady solve.
    [[nodiscard]] std::span<const StepMoment> stages() const { return stages_; }
    /// Intensities of all effects at a stage of the last attempted step. @returns [n_coefficients]
    [[nodiscard]] std::span<const double> coefficients(int i) const { return forcing_.stage(i); }
    /// Of the last attempted step.
    [[nodiscard]] StepForcing& forcing() { return forcing_; }
    [[nodiscard]] const Tableau& method() const { return *tableau_; }
    /// Length of the last accepted step. @returns s
    [[nodiscard]] double width() const { return now_.time - now_.step_begin; }
    [[nodiscard]] double begin() const { return now_.step_begin; }  ///< s, of the last accepted step
    [[nodiscard]] const Newton& newton() const { return newton_; }
    [[nodiscard]] Newton& newton() { return newton_; }
    [[nodiscard]] System& system() { return system_; }
    [[nodiscard]] const System& system() const { return system_; }

private:
    /// Newton's tolerance beside the tolerance of a step: small enough that the error estimate does not see it.
    static constexpr double newton_share = 0.05;

    [[nodiscard]] bool come_near_steady(const Newton::Stage& steady);
    [[nodiscard]] Attempt attempt_in_window(double t1, bool closed, double harmless);
    [[nodiscard]] Attempt attempt_stages(double dt, bool closed, double harmless);
    void update_heat_budget(int stage);
    void find_stored();
    /// The parabola through what was at the stages of the last accepted step. @param stages [stages][n]
    void interpolate(double t, const std::vector<std::vector<double>>& stages, std::span<double> out) const;
    void predict(int stage, double dt);
    [[nodiscard]] double largest_filtered();
    [[nodiscard]] double estimate_left_out(double dt);
    [[nodiscard]] double estimate_error(double dt, double harmless);

    const Problem* problem_;
    System system_;
    const Tableau* tableau_;
    StepForcing forcing_;
    Newton newton_;
    /// All that the next step depends on, beside the temperatures and what Newton's method keeps.
    struct State {
        double time = 0.0;
        double step_begin = 0.0;
        double tried = 0.0;
        double stored = 0.0;
        double turnover = 0.0;
        bool has_history = false;
        int worst_node = 0;
        bool end_is_known = false;             ///< the terms at the end of the last accepted step:
        std::vector<double> end_q;             ///< [n] W
        std::vector<double> end_watts;         ///< [n_effects] W
        std::vector<double> end_coefficients;  ///< under these
        std::vector<double> left;  ///< [n] J that the last accepted stage left of its balance: the next step carries it
        std::vector<std::vector<double>> last;  ///< [stages][n] stages of the last accepted step
        std::vector<double> watts;              ///< [n_effects] W at its end
        std::vector<double> joules;             ///< [n_effects] J since the start
    };
    State now_;
    std::vector<std::vector<double>> T_;            ///< [stages + 1][n]: the state, then the stages of the attempt
    std::vector<std::vector<double>> q_;            ///< [stages][n] W
    std::vector<std::vector<double>> stage_watts_;  ///< [stages][n_effects] W
    std::vector<StepMoment> stages_;                ///< of the last accepted step
    /// Surfaces without capacity, each with the cell that takes what it leaves: in a step a thousand times as short it would be
    /// a thousand times as many kelvin there.
    std::vector<std::pair<std::size_t, std::size_t>> takers_;
    std::vector<double> known_;
    std::vector<double> H_;
    std::vector<double> H_start_;
    std::vector<double> error_heat_;
    std::vector<double> error_;
    std::vector<double> joules_before_;
};

}  // namespace tiretherm::solver
