#include "solver/march.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "solver/stepper.hpp"

namespace tiretherm::solver {

namespace {

/// Chooses the size of the next step from the error of the last: an elementary controller with a dead zone, so that
/// the step, and with it the kept factor, changes seldom.
class StepControl {
public:
    StepControl(const Settings& settings, int order) : tolerance_(settings.tolerance), exponent_(1.0 / (order + 1)) {}

    /// Factor on the step after an error of `error` K.
    [[nodiscard]] double factor(double error) const {
        const double wanted = error > 0.0 ? 0.9 * std::pow(tolerance_ / error, exponent_) : 4.0;
        const double bounded = std::clamp(wanted, 0.2, 4.0);
        return bounded > 0.95 && bounded < 1.25 ? 1.0 : bounded;
    }
    [[nodiscard]] bool accepts(double error) const { return error <= tolerance_; }

private:
    double tolerance_;
    double exponent_;
};

/// Everything of a run that is not the stepping itself: outputs, extremes, the report.
class Run {
public:
    Run(const Problem& problem, const Observer& observer, const Continuation& continuation)
        : problem_(problem),
          observer_(observer),
          continuation_(continuation),
          stepper_(problem),
          field_(problem.initial) {
        channels_.resize(problem.channels.size());
        joules_.resize(problem.effects.size());
        report_.hottest.temperature = -std::numeric_limits<double>::infinity();
        report_.coldest.temperature = std::numeric_limits<double>::infinity();
    }

    Report go() {
        const Settings& settings = problem_.settings;
        if (settings.steady) {
            report_.status = stepper_.solve_steady(settings.end);
            if (report_.status.ok()) {
                watch();
                emit(settings.end, stepper_.temperature(), stepper_.joules(), stepper_.stored(), true);
            }
        } else if (continuation_.from != nullptr) {
            watch();
            report_.status = resume(*continuation_.from) ? march() : foreign();
        } else {
            watch();
            // The first row shows the state before the drive acts.
            report_.status = emit_at_start() ? march() : stopped();
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
        stepper_.visit(archive);
        for (double* number : {&wanted_, &next_output_, &next_field_}) {
            archive(*number);
        }
        archive.whole(fresh_);
        archive.whole(outputs_);
        archive.whole(report_.steps);
        archive.whole(report_.rejected);
        for (Report::Extreme* extreme : {&report_.hottest, &report_.coldest}) {
            archive(extreme->temperature);
            archive(extreme->time);
            archive.whole(extreme->node);
        }
        for (std::vector<double>* values : {&report_.channel_final, &report_.channel_min, &report_.channel_max}) {
            archive(*values);
        }
    }

    [[nodiscard]] bool resume(const Checkpoint& checkpoint) {
        Archive archive = Archive::reading(checkpoint.numbers);
        visit(archive);
        return archive.complete();
    }

    void leave_checkpoint() {
        if (continuation_.every <= 0 || report_.steps % continuation_.every != 0 || !continuation_.keep) {
            return;
        }
        checkpoint_.numbers.clear();
        Archive archive = Archive::writing(checkpoint_.numbers);
        visit(archive);
        continuation_.keep(checkpoint_);
    }

    Status march() {
        const Settings& settings = problem_.settings;
        const StepControl control(settings, tableau(settings.method).order);
        const double smallest = 1e-12 * std::max(1.0, std::abs(settings.end));
        wanted_ = settings.fixed_step.value_or(wanted_);
        while (stepper_.time() < settings.end - smallest) {
            const double t = stepper_.time();
            const double stop = next_stop(t);
            if (fresh_ && !settings.fixed_step) {
                // Ten tolerances of change, were the present rate to last.
                const double rate = stepper_.steepest_rate();
                const double first = rate > 0.0 ? 10.0 * settings.tolerance / rate : stop - t;
                wanted_ = wanted_ > 0.0 ? std::min(wanted_, first) : first;
            }
            fresh_ = false;
            double t1 = t + wanted_;
            if (t1 > stop - smallest) {
                t1 = stop;
            } else if (!settings.fixed_step && t1 + wanted_ > stop) {
                t1 = 0.5 * (t + stop);  // two equal steps rather than a whole one and a sliver
            }
            Stepper::Attempt attempt = stepper_.attempt(t1);
            if (!attempt.status.ok()) {
                ++report_.rejected;
                if (settings.fixed_step || t1 - t < 1e3 * smallest || !mendable(attempt.status.outcome)) {
                    return std::move(attempt.status);
                }
                wanted_ = 0.25 * (t1 - t);
                continue;
            }
            if (!settings.fixed_step) {
                const double factor = control.factor(attempt.error);
                if (!control.accepts(attempt.error)) {
                    ++report_.rejected;
                    wanted_ = std::min(factor, 0.8) * (t1 - t);
                    if (wanted_ < smallest) {
                        return {
                            Outcome::step_too_small,
                            fmt::format(
                                "the step shrank to {:.1e} s at t = {:.6g} s without reaching the tolerance of {} K",
                                wanted_, t, settings.tolerance)};
                    }
                    continue;
                }
                // A step cut short by a stop says nothing against the size that was wanted.
                wanted_ = std::max(factor * (t1 - t), t1 - t < wanted_ ? wanted_ : 0.0);
            }
            stepper_.accept();
            ++report_.steps;
            watch();
            if (!emit_until(stepper_.time())) {
                return stopped();
            }
            fresh_ = jumps_at(stepper_.time());
            leave_checkpoint();
        }
        return {};
    }

    /// Whether a smaller step may help.
    [[nodiscard]] static bool mendable(Outcome outcome) {
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

    [[nodiscard]] double next_stop(double t) const {
        const std::vector<double>& stops = problem_.drive.stops();
        const auto next = std::upper_bound(stops.begin(), stops.end(), t);
        return next == stops.end() ? problem_.settings.end : std::min(*next, problem_.settings.end);
    }

    [[nodiscard]] bool jumps_at(double t) const {
        return problem_.drive.at(t, Limit::before) != problem_.drive.at(t, Limit::after);
    }

    /// Looks at the state for the extremes.
    void watch() {
        const std::span<const double> T = stepper_.temperature();
        for (std::size_t n = 0; n < T.size(); ++n) {
            if (T[n] > report_.hottest.temperature) {
                report_.hottest = {T[n], stepper_.time(), static_cast<int>(n)};
            }
            if (T[n] < report_.coldest.temperature) {
                report_.coldest = {T[n], stepper_.time(), static_cast<int>(n)};
            }
        }
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            channels_[c] = problem_.channels[c].where(T);
        }
        if (report_.channel_final.empty()) {
            report_.channel_min = report_.channel_max = channels_;
        }
        report_.channel_final = channels_;
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            report_.channel_min[c] = std::min(report_.channel_min[c], channels_[c]);
            report_.channel_max[c] = std::max(report_.channel_max[c], channels_[c]);
        }
    }

    bool emit(double t, std::span<const double> T, std::span<const double> joules, double stored, bool field) {
        const auto begin = std::chrono::steady_clock::now();
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            channels_[c] = problem_.channels[c].where(T);
        }
        const bool go_on = observer_ == nullptr || observer_({.time = t,
                                                              .temperature = T,
                                                              .channels = channels_,
                                                              .watts = stepper_.watts(),
                                                              .joules = joules,
                                                              .stored = stored,
                                                              .field = field});
        output_seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return go_on;
    }

    bool emit_at_start() {
        const Settings& settings = problem_.settings;
        next_output_ = settings.start + settings.output_interval;
        next_field_ = settings.start + settings.field_interval;
        return emit(settings.start, stepper_.temperature(), joules_, 0.0, true);
    }

    /// Reports every output time up to t, interpolated inside the step, and the end of the run itself.
    bool emit_until(double t) {
        const Settings& settings = problem_.settings;
        const double slack = 1e-9 * std::max(settings.output_interval, 1e-3);
        const bool at_end = t >= settings.end;
        if (settings.output_interval <= 0.0) {
            return emit(t, stepper_.temperature(), stepper_.joules(), stepper_.stored(), field_due(t) || at_end);
        }
        while (next_output_ < t - slack) {
            const double share = (next_output_ - stepper_.step_begin()) / (t - stepper_.step_begin());
            stepper_.interpolate(next_output_, field_);
            for (std::size_t e = 0; e < joules_.size(); ++e) {
                joules_[e] = stepper_.joules_before()[e] + share * (stepper_.joules()[e] - stepper_.joules_before()[e]);
            }
            const double stored = stepper_.stored_before() + share * (stepper_.stored() - stepper_.stored_before());
            if (!emit(next_output_, field_, joules_, stored, field_due(next_output_))) {
                return false;
            }
            next_output_ = output_time(++outputs_);
        }
        if (at_end || next_output_ <= t + slack) {
            if (next_output_ <= t + slack) {
                next_output_ = output_time(++outputs_);
            }
            return emit(t, stepper_.temperature(), stepper_.joules(), stepper_.stored(), field_due(t) || at_end);
        }
        return true;
    }

    /// Multiplied out, not summed up, so that late output times do not drift.
    [[nodiscard]] double output_time(long index) const {
        return problem_.settings.start + static_cast<double>(index + 1) * problem_.settings.output_interval;
    }

    bool field_due(double t) {
        const double interval = problem_.settings.field_interval;
        if (interval <= 0.0 || t < next_field_ - 1e-9 * interval) {
            return false;
        }
        next_field_ =
            problem_.settings.start + interval * (std::floor((t - problem_.settings.start) / interval + 1e-9) + 1.0);
        return true;
    }

    void finish() {
        const Counters& counters = stepper_.newton().counters();
        report_.simulated = stepper_.time() - problem_.settings.start;
        report_.newton_iterations = counters.newton_iterations;
        report_.linear_iterations = counters.linear_iterations;
        report_.factorisations = counters.factorisations;
        report_.linear_solver = stepper_.newton().linear_solver();
        report_.seconds = {counters.assembly_seconds, counters.factor_seconds, counters.solve_seconds, output_seconds_};
        report_.watts.assign(stepper_.watts().begin(), stepper_.watts().end());
        report_.joules.assign(stepper_.joules().begin(), stepper_.joules().end());
        report_.stored = stepper_.stored();
        report_.effective_link = stepper_.effective_link();
        report_.energy_closure = problem_.settings.steady ? steady_closure() : stepper_.energy_closure();
    }

    /// In the steady state the watts themselves cancel.
    [[nodiscard]] double steady_closure() const {
        double booked = 0.0;
        double turned_over = 0.0;
        for (const double watts : report_.watts) {
            booked += watts;
            turned_over += std::abs(watts);
        }
        return turned_over > 0.0 ? std::abs(booked) / turned_over : 0.0;
    }

    const Problem& problem_;
    const Observer& observer_;
    const Continuation& continuation_;
    Stepper stepper_;
    Report report_;
    Checkpoint checkpoint_;
    double wanted_ = 0.0;  ///< s, size of the next step
    bool fresh_ = true;    ///< at the start and after a jump the step is chosen anew
    std::vector<double> channels_;
    std::vector<double> field_;
    std::vector<double> joules_;
    double next_output_ = 0.0;
    double next_field_ = 0.0;
    long outputs_ = 0;
    double output_seconds_ = 0.0;
};

}  // namespace

Report run(const Problem& problem, const Observer& observer, const Continuation& continuation) {
    return Run(problem, observer, continuation).go();
}

std::vector<std::string> defects(const Problem& problem) {
    std::vector<std::string> found = mesh::defects(problem.mesh);
    const auto expect = [&](bool holds, std::string_view sentence) {
        if (!holds) {
            found.emplace_back(sentence);
        }
    };
    const auto n = static_cast<std::size_t>(problem.mesh.n_nodes);
    expect(problem.materials.size() == problem.mesh.layers.size(), "every layer of the mesh needs a material");
    expect(problem.link_laws.size() == problem.mesh.links.size(), "every link of the mesh needs a conductivity");
    expect(problem.initial.size() == n, "every node needs an initial temperature");
    expect(problem.settings.steady || problem.settings.end > problem.settings.start,
           "the run must end after it starts");
    expect(problem.settings.tolerance > 0.0, "the tolerance of a step must be positive");
    expect(!problem.settings.fixed_step || *problem.settings.fixed_step > 0.0, "a fixed step must be positive");
    for (const double T : problem.initial) {
        if (!(T > 0.0) || !std::isfinite(T)) {
            found.push_back(fmt::format("an initial temperature is {} K", T));
            break;
        }
    }
    return found;
}

}  // namespace tiretherm::solver
