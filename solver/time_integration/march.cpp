// SPDX-License-Identifier: BSD-3-Clause
// Time loop with the step factor 0.9 (tolerance/error)^(1/(order + 1)) and a dead zone, or by powers of two; steps end on
// the stops of the inputs and on logged samples.

#include "solver/time_integration/march.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/output_sampler.hpp"
#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

namespace {

/// Chooses the size of the next step from the error of the last: an elementary controller with a dead zone, so that
/// the step, and with it the kept factor, changes seldom.
class StepControl {
public:
    StepControl(const Settings& settings, int order) : tolerance_(settings.tolerance), exponent_(1.0 / (order + 1)) {}

    /// Factor on the step after an error of `error` K.
    [[nodiscard]] double factor(double error) const {
        const double bounded = std::clamp(0.9 * allowed(error), 0.2, 4.0);
        return bounded > 0.95 && bounded < 1.25 ? 1.0 : bounded;
    }
    /// The largest power of two that the error allows.
    [[nodiscard]] double power_of_two(double error) const {
        return std::exp2(std::floor(std::log2(std::clamp(allowed(error), 0.25, 4.0))));
    }
    /// The error below which a step of powers of two, or another one, grows by as much as it may. @param growth 1 to 4
    [[nodiscard]] double harmless(double growth, bool by_powers) const {
        const double ratio = by_powers ? 1.0 / growth : 0.9 / (growth > 1.0 ? growth : 0.96);
        return tolerance_ * std::pow(std::min(1.0, ratio), 1.0 / exponent_);
    }
    [[nodiscard]] bool accepts(double error) const { return error <= tolerance_; }

private:
    [[nodiscard]] double allowed(double error) const {
        return error > 0.0 ? std::pow(tolerance_ / error, exponent_) : 5.0;
    }

    double tolerance_;
    double exponent_;
};

/// A log that was too rough for a step stays so for a while, which no power of the step foretells.
constexpr int rough_steps = 8;

/// Tolerances of change in the first step, were the first rate to last. Of powers of two a first step that is refused costs
/// little: the factors of shorter ones are needed anyway, and its own will be.
constexpr double first_change = 10.0;
constexpr double first_change_of_powers = 40.0;

/// A run from its start to its end: chooses the steps, leaves checkpoints, fills the report.
class Run {
public:
    Run(const Problem& problem, const Observer& observer, const Continuation& continuation, KeptForcing* kept)
        : problem_(problem),
          continuation_(continuation),
          stepper_(problem, kept),
          sampler_(problem, observer, stepper_) {
        report_.hottest.temperature = -std::numeric_limits<double>::infinity();
        report_.coldest.temperature = std::numeric_limits<double>::infinity();
    }

    MarchReport go() {
        const Settings& settings = problem_.settings;
        stepper_.find_watts(problem_.input_signals.at(settings.start, JumpSide::after));
        if (settings.steady) {
            report_.status = stepper_.solve_steady(settings.end);
            if (report_.status.ok()) {
                sampler_.watch(report_);
                report_.status = sampler_.show() ? Status{} : stopped();
            }
        } else if (continuation_.from != nullptr) {
            sampler_.watch(report_);
            report_.status = resume(*continuation_.from) ? march() : foreign();
        } else {
            sampler_.watch(report_);
            report_.status = sampler_.show() ? march() : stopped();
        }
        finish();
        return std::move(report_);
    }

private:
    [[nodiscard]] Status stopped() const {
        return {Outcome::stopped,
                fmt::format("stopped at t = {:.6g} s of {:.6g} s", stepper_.time(), problem_.settings.end)};
    }

    [[nodiscard]] Status foreign() const {
        return {Outcome::foreign_checkpoint,
                "the checkpoint belongs to another case: it holds another number of values"};
    }

    /// Everything that the rest of the run depends on, in one order for writing and reading.
    void visit(Archive& archive) {
        archive(stepper_);
        archive(sampler_);
        archive(now_);
        archive(report_.steps);
        archive(report_.rejected);
        for (MarchReport::Extreme* extreme : {&report_.hottest, &report_.coldest}) {
            archive(*extreme);
        }
        for (std::vector<double>* values :
             {&report_.hottest_field, &report_.channel_final, &report_.channel_min, &report_.channel_max}) {
            archive(*values);
        }
    }

    [[nodiscard]] bool resume(const Checkpoint& checkpoint) {
        Archive archive = Archive::reading(checkpoint.numbers);
        visit(archive);
        return archive.complete();
    }

    void leave_checkpoint() {
        const bool wanted = continuation_.every > 0 && report_.steps % continuation_.every == 0 && continuation_.keep;
        if (!wanted || (continuation_.due && !continuation_.due())) {
            return;
        }
        Archive counted = Archive::counting();
        visit(counted);
        Checkpoint checkpoint;  // of a large mesh, a tenth of its memory: for as long as it is written
        checkpoint.numbers.reserve(counted.count());
        Archive archive = Archive::writing(checkpoint.numbers);
        visit(archive);
        continuation_.keep(checkpoint);
    }

    Status march() {
        const Settings& settings = problem_.settings;
        const StepControl control(settings, tableau(settings.method).order);
        const double smallest = 1e-10 * (settings.end - settings.start);
        now_.wanted = settings.fixed_step.value_or(now_.wanted);
        while (stepper_.time() < settings.end - smallest) {
            if (stop_requested()) {  // also between rows that are far apart, and where steps are refused without end
                static_cast<void>(sampler_.show());
                return stopped();
            }
            const double t = stepper_.time();
            const double stop = next_stop(t);
            if (now_.fresh && !settings.fixed_step) {
                const double rate = stepper_.steepest_rate();
                now_.by_powers = stepper_.newton().keeps_factors() && stepper_.newton().is_linear() &&
                                 problem_.input_signals.samples().empty();
                const double change = now_.by_powers ? first_change_of_powers : first_change;
                const double first = rate > 0.0 ? change * settings.tolerance / rate : stop - t;
                now_.wanted = now_.wanted > 0.0 ? std::min(now_.wanted, first) : first;
            }
            now_.fresh = false;
            now_.wanted =
                settings.fixed_step ? now_.wanted : std::min(now_.wanted, settings.largest_step.value_or(now_.wanted));
            // Of a short step after a long time the smallest one is a large part: a refused step would be tried for ever.
            const double slack = std::min(smallest, 0.01 * now_.wanted);
            double t1 = settings.fixed_step ? t + now_.wanted : on_sample(t, t + now_.wanted, slack);
            const double parts = now_.by_powers ? parts_of(stop - t, now_.wanted) : 0.0;
            if (now_.by_powers) {
                t1 = parts > 1.0 ? t + (stop - t) / parts : stop;
            } else if (t1 > stop - slack) {
                t1 = stop;
            } else if (!settings.fixed_step && t1 + now_.wanted > stop) {
                t1 = 0.5 * (t + stop);  // two equal steps rather than a whole one and a sliver
            }
            if (!(t1 > t)) {  // less than the time's last digit
                return stepper_.failure_at_largest_error(
                    fmt::format("the step of {:.1e} s is too short beside the time of {:.6g} s", now_.wanted, t));
            }
            const bool closed = settings.fixed_step || t1 > settings.end - smallest;
            const double most = now_.by_powers ? growth(4.0, t1 - t, parts - 1.0) : now_.hold > 0 ? 1.0 : 4.0;
            Stepper::Attempt attempt = stepper_.attempt(t1, closed, control.harmless(most, now_.by_powers));
            if (!attempt.status.ok()) {
                ++report_.rejected;
                if (settings.fixed_step || t1 - t < 10.0 * smallest || !is_recoverable(attempt.status.outcome)) {
                    if (settings.fixed_step && is_recoverable(attempt.status.outcome)) {
                        attempt.status.message += "; make the fixed step shorter, or leave it out";
                    }
                    return std::move(attempt.status);
                }
                now_.wanted = 0.25 * (t1 - t);
                continue;
            }
            if (!settings.fixed_step) {
                double factor = now_.by_powers ? control.power_of_two(attempt.error) : control.factor(attempt.error);
                if (!control.accepts(attempt.error)) {
                    ++report_.rejected;
                    now_.hold = problem_.input_signals.samples().empty() ? 0 : rough_steps;
                    now_.wanted = std::min(factor, 0.8) * (t1 - t);
                    if (now_.wanted < smallest) {
                        return stepper_.failure_at_largest_error(
                            fmt::format("the step shrank to {:.1e} s without reaching the tolerance of {} K",
                                        now_.wanted, settings.tolerance));
                    }
                    continue;
                }
                // A step cut short by a stop says nothing against the size that was wanted.
                const bool cut_short = parts <= 1.0 && t1 - t < now_.wanted;
                factor = now_.by_powers ? growth(factor, t1 - t, parts - 1.0) : factor;
                now_.wanted = std::max(factor * (t1 - t), cut_short ? now_.wanted : 0.0);
                if (now_.hold > 0) {
                    --now_.hold;
                    now_.wanted = std::min(now_.wanted, t1 - t);
                }
            }
            stepper_.accept();
            sampler_.take_step();
            ++report_.steps;
            sampler_.watch(report_);
            if (!sampler_.advance()) {
                return stopped();
            }
            now_.fresh = jumps_at(stepper_.time());
            leave_checkpoint();
        }
        return {};
    }

    /// Whether a smaller step may help.
    [[nodiscard]] static bool is_recoverable(Outcome outcome) {
        switch (outcome) {
            case Outcome::not_converged:
            case Outcome::not_finite:
            case Outcome::negative_conductance:
            case Outcome::not_positive_definite:
                return true;
            case Outcome::done:
            case Outcome::step_too_small:
            case Outcome::stopped:
            case Outcome::foreign_checkpoint:
                return false;
        }
        return false;
    }

    /// The end of a step over a log: on a sample, so that no piece of a straight line is left over, and 2, 4, 8 ...
    /// samples on, so that steps are often alike and one factor serves them.
    [[nodiscard]] double on_sample(double t, double t1, double round_off) const {
        const std::vector<double>& samples = problem_.input_signals.samples();
        const auto first = std::upper_bound(samples.begin(), samples.end(), t + round_off);
        const auto last = std::upper_bound(first, samples.end(), t1 + round_off);
        const auto count = static_cast<std::size_t>(last - first);
        return count == 0 ? t1 : *(first + static_cast<std::ptrdiff_t>(std::bit_floor(count)) - 1);
    }

    /// Steps of one length to the next stop, each as long as wanted, but for round-off, or less.
    [[nodiscard]] static double parts_of(double way, double wanted) {
        return std::max(1.0, std::ceil(way / wanted - 1e-6));
    }

    /// What a step may grow by so that whole steps still lead to the stop. @param parts steps of the present length to there
    [[nodiscard]] double growth(double allowed, double step, double parts) const {
        const double largest = problem_.settings.largest_step.value_or(std::numeric_limits<double>::infinity());
        double grown = std::max(1.0, allowed);
        while (grown > 1.0 && (std::fmod(parts, grown) != 0.0 || grown * step > largest)) {
            grown *= 0.5;
        }
        return grown;
    }

    [[nodiscard]] double next_stop(double t) const {
        const std::vector<double>& stops = problem_.input_signals.stops();
        const auto next = std::upper_bound(stops.begin(), stops.end(), t);
        return next == stops.end() ? problem_.settings.end : std::min(*next, problem_.settings.end);
    }

    [[nodiscard]] bool jumps_at(double t) const {
        return problem_.input_signals.at(t, JumpSide::before) != problem_.input_signals.at(t, JumpSide::after);
    }

    void finish() {
        const Counters& counters = stepper_.newton().counters();
        report_.simulated = stepper_.time() - problem_.settings.start;
        report_.newton_iterations = counters.newton_iterations;
        report_.linear_iterations = counters.linear_iterations;
        report_.factorisations = counters.factorisations;
        report_.linear_solver = stepper_.newton().linear_solver();
        report_.seconds = {counters.assembly_seconds, counters.factor_seconds, counters.solve_seconds,
                           sampler_.seconds()};
        report_.watts.assign(stepper_.watts().begin(), stepper_.watts().end());
        report_.joules.assign(stepper_.joules().begin(), stepper_.joules().end());
        report_.stored = stepper_.stored();
        find_law_watts();
        report_.warnings = sampler_.range_warnings();
        report_.effective_two_node_conductance = stepper_.effective_two_node_conductance();
        report_.energy_closure = problem_.settings.steady ? steady_closure() : stepper_.energy_closure();
    }

    void find_law_watts() {
        const physics::Inputs inputs = problem_.input_signals.at(stepper_.time(), JumpSide::before);
        for (std::size_t e = 0; e < problem_.effects.size(); ++e) {
            const physics::Effect& effect = *problem_.effects[e].effect;
            const physics::PropertyModifier* modifier = effect.property_modifier();
            const bool modifies_laws = modifier != nullptr && modifier->modify_laws != nullptr;
            report_.law_watts.push_back(modifies_laws || effect.loss_law() != nullptr
                                            ? stepper_.system().share_of_law(e, stepper_.temperature(), inputs)
                                            : std::numeric_limits<double>::quiet_NaN());
        }
    }

    /// In the steady state the watts themselves cancel.
    [[nodiscard]] double steady_closure() const {
        double attributed = 0.0;
        double turned_over = 0.0;
        for (const double watts : report_.watts) {
            attributed += watts;
            turned_over += std::abs(watts);
        }
        return turned_over > 0.0 ? std::abs(attributed) / turned_over : 0.0;
    }

    const Problem& problem_;
    const Continuation& continuation_;
    Stepper stepper_;
    OutputSampler sampler_;
    MarchReport report_;

    struct State {
        double wanted = 0.0;  ///< s, size of the next step
        int hold = 0;         ///< steps to come that do not grow
        bool fresh = true;    ///< at the start and after a jump the step is chosen anew
        bool by_powers =
            false;  ///< a step is 1, 2, 4 times as long as the last, or a half or a quarter: few factors fit
    };
    State now_;
};

MarchReport run_in_team(const Problem& problem, const Observer& observer, const Continuation& continuation,
                        KeptForcing* kept) {
    MarchReport report;
    Team::with(at(problem.mesh.n_nodes), [&] { report = Run(problem, observer, continuation, kept).go(); });
    return report;
}

}  // namespace

MarchReport run(const Problem& problem, const Observer& observer, const Continuation& continuation) {
    return run_in_team(problem, observer, continuation, nullptr);
}

MarchReport run(const Problem& problem, const Observer& observer, KeptForcing& kept) {
    return run_in_team(problem, observer, {}, &kept);
}

}  // namespace tiretherm::solver
