// SPDX-License-Identifier: BSD-3-Clause
// Stages of a step, error estimate filtered by A^-1 into kelvin, heat budget of each effect, interpolation by the
// parabola through the stages, steady states.

#include "solver/time_integration/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::solver {

namespace {

/// y += factor x
void add(double factor, std::span<const double> x, std::span<double> y) {
    over_nodes(y.size(), [&](std::size_t n) { y[n] += factor * x[n]; });
}

/// y += dt times the sum of share[j] q[j]
void add_stages(double dt, std::span<const double> share, const std::vector<std::vector<double>>& q,
                std::span<double> y) {
    over_ranges(y.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t j = 0; j < share.size(); ++j) {
            const double factor = dt * share[j];
            for (std::size_t n = begin; n < end; ++n) {
                y[n] += factor * q[j][n];
            }
        }
    });
}

}  // namespace

Stepper::Stepper(const Problem& problem, KeptForcing* kept)
    : problem_(&problem),
      system_(problem),
      tableau_(&tableau(problem.settings.method)),
      forcing_(system_, problem.input_signals, *tableau_, kept),
      newton_(system_) {
    now_.time = now_.step_begin = now_.tried = problem.settings.start;
    const std::size_t n = at(system_.size());
    const std::size_t stages = at(tableau_->stages);
    const std::size_t effects = problem.effects.size();
    const std::vector<double> initial = system_.initial();
    T_.assign(stages + 1, initial);
    now_.last.assign(stages, initial);
    stages_.resize(stages);
    q_.assign(stages, std::vector<double>(n));
    stage_watts_.assign(stages, std::vector<double>(effects));
    now_.end_q.resize(n);
    now_.end_watts.resize(effects);
    now_.end_coefficients.resize(system_.n_coefficients());
    for (std::vector<double>* v : {&now_.left, &known_, &H_, &H_start_, &error_heat_, &error_}) {
        v->resize(n);
    }
    for (std::vector<double>* v : {&now_.watts, &now_.joules, &joules_before_}) {
        v->resize(effects);
    }
    system_.enthalpy(initial, H_start_);
    std::vector<bool> has_taker(n, false);
    for (const mesh::Face& face : problem.mesh.faces) {
        const std::size_t a = at(face.a);
        const std::size_t b = at(face.b);
        if (face.is_coupling || system_.has_capacity(a) == system_.has_capacity(b)) {
            continue;
        }
        const std::size_t surface = system_.has_capacity(a) ? b : a;
        if (!has_taker[surface]) {
            has_taker[surface] = true;
            takers_.emplace_back(surface, surface == a ? b : a);
        }
    }
}

void Stepper::update_heat_budget(int stage) {
    const std::span<const double> q = system_.heat_flow();
    copy_nodes(q, q_[at(stage)]);
    stage_watts_[at(stage)] = system_.terms().watts;
}

/// First guess of a stage: straight on from the last step's end, then along the stages found so far. What would lead near
/// the absolute zero, or below it, is no guess.
void Stepper::predict(int stage, double dt) {
    std::vector<double>& guess = T_[at(stage) + 1];
    const std::vector<double>& now = T_[1];
    if (stage == 1) {
        copy_nodes(now, guess);
        const double width = now_.time - now_.step_begin;
        const double c = tableau_->c[at(tableau_->stages) - 2];
        if (now_.has_history && width > 0.0) {
            const double rate = tableau_->c[1] * dt / ((1.0 - c) * width);
            const std::vector<double>& before = now_.last[at(tableau_->stages) - 2];
            const std::vector<double>& end = now_.last[at(tableau_->stages) - 1];
            over_nodes(guess.size(), [&](std::size_t i) {
                const double onward = guess[i] + rate * (end[i] - before[i]);
                guess[i] = onward > 0.2 * guess[i] ? onward : guess[i];
            });
        }
        return;
    }
    const double rate = tableau_->c[at(stage)] / tableau_->c[1];
    over_nodes(guess.size(), [&](std::size_t i) {
        const double onward = now[i] + rate * (T_[2][i] - now[i]);
        guess[i] = onward > 0.2 * now[i] ? onward : now[i];
    });
}

Stepper::Attempt Stepper::attempt(double t1, bool closed, double harmless) {
    forcing_.open(now_.time, t1);
    return attempt_in_window(t1, closed, harmless);
}

Stepper::Attempt Stepper::attempt(double t1, const physics::Inputs& from, const physics::Inputs& to) {
    forcing_.open(from, to);
    return attempt_in_window(t1, false, 0.0);
}

Stepper::Attempt Stepper::attempt_in_window(double t1, bool closed, double harmless) {
    const double dt = t1 - now_.time;
    now_.tried = t1;

    // The explicit stage. Where the inputs go on as they were, it is the last stage of the step before; otherwise the
    // surface nodes first follow the inputs, which may have jumped.
    copy_nodes(T_[0], T_[1]);
    if (now_.end_is_known && std::ranges::equal(forcing_.stage(0), now_.end_coefficients)) {
        copy_nodes(now_.end_q, q_[0]);
        stage_watts_[0] = now_.end_watts;
        return attempt_stages(dt, closed, harmless);
    }
    system_.make_consistent(T_[1], forcing_.stage(0));
    if (const int bad = system_.first_not_finite(); bad >= 0) {
        return {.status = system_.failure_at(Outcome::not_finite, "the heat balance is not a number", bad, now_.time,
                                             T_[1], forcing_.stage(0)),
                .error = 0.0};
    }
    update_heat_budget(0);
    return attempt_stages(dt, closed, harmless);
}

Stepper::Attempt Stepper::attempt_stages(double dt, bool closed, double harmless) {
    const bool controlled = !problem_->settings.fixed_step;
    const bool early = controlled && newton_.has_factor_for(dt * tableau_->diagonal);
    const double left_out = early ? estimate_left_out(dt) : 0.0;
    if (left_out > 2.0 * problem_->settings.tolerance) {
        return {.status = {}, .error = left_out};
    }
    system_.enthalpy(T_[0], H_);

    for (int i = 1; i < tableau_->stages; ++i) {
        predict(i, dt);
        over_nodes(known_.size(), [&](std::size_t n) { known_[n] = H_[n] + now_.left[n]; });
        add_stages(dt, std::span(tableau_->a[at(i)]).first(at(i)), q_, known_);
        Status status = newton_.solve({.s = dt * tableau_->diagonal,
                                       .known = known_,
                                       .coefficients = forcing_.stage(i),
                                       .time = now_.time + tableau_->c[at(i)] * dt,
                                       .tolerance = newton_share * problem_->settings.tolerance,
                                       .closed = closed && i + 1 == tableau_->stages},
                                      T_[at(i) + 1]);
        if (!status.ok()) {
            return {.status = std::move(status), .error = 0.0};
        }
        update_heat_budget(i);
    }
    if (!controlled) {
        return {.status = {}, .error = 0.0};
    }
    return {.status = {}, .error = std::max(estimate_error(dt, harmless), early ? left_out : estimate_left_out(dt))};
}

double Stepper::largest_filtered() {
    newton_.filter(error_heat_, error_);
    const Largest most = largest_over_nodes(error_.size(), [&](std::size_t n) { return std::abs(error_[n]); });
    now_.worst_node = static_cast<int>(most.place);
    return most.value;
}

/// What the line through a rough log leaves out. Needs no stage: where a factor is at hand, it is the cheapest reason to
/// refuse a step.
double Stepper::estimate_left_out(double dt) {
    if (!forcing_.averaged()) {
        return 0.0;
    }
    system_.evaluate(T_[1], forcing_.unresolved());
    const std::span<const double> q = system_.heat_flow();
    over_nodes(error_heat_.size(), [&](std::size_t n) { error_heat_[n] = dt * (q[n] - q_[0][n]); });
    return largest_filtered();
}

/// Filtered by A^-1, whose rows add up to at most one over the heat capacity: that bounds it without a solve.
double Stepper::estimate_error(double dt, double harmless) {
    clear_nodes(error_heat_);
    add_stages(dt, std::span(tableau_->error).first(at(tableau_->stages)), q_, error_heat_);
    for (std::size_t n = at(problem_->mesh.n_cells); n < error_heat_.size(); ++n) {
        error_heat_[n] = system_.has_capacity(n) ? error_heat_[n] : 0.0;
    }
    const std::span<const double> compliance = newton_.compliance();
    const Largest bound =
        largest_over_nodes(error_heat_.size(), [&](std::size_t n) { return std::abs(error_heat_[n]) * compliance[n]; });
    if (bound.value <= harmless) {
        return bound.value;
    }
    return largest_filtered();
}

Status Stepper::failure_at_largest_error(std::string_view why) {
    return system_.failure_at(Outcome::step_too_small, why, now_.worst_node, now_.time, T_[0], forcing_.stage(0));
}

void Stepper::accept() {
    const double dt = now_.tried - now_.time;
    joules_before_ = now_.joules;
    for (int i = 0; i < tableau_->stages; ++i) {
        for (std::size_t e = 0; e < now_.joules.size(); ++e) {
            const double joules = dt * tableau_->weight(i) * stage_watts_[at(i)][e];
            now_.joules[e] += joules;
            now_.turnover += std::abs(joules);
        }
        copy_nodes(T_[at(i) + 1], now_.last[at(i)]);
    }
    now_.watts = stage_watts_.back();
    copy_nodes(T_.back(), T_[0]);
    copy_nodes(newton_.left(), now_.left);
    for (const auto& [surface, cell] : takers_) {
        now_.left[cell] += now_.left[surface];
        now_.left[surface] = 0.0;
    }
    copy_nodes(q_.back(), now_.end_q);
    now_.end_watts = stage_watts_.back();
    std::ranges::copy(forcing_.stage(tableau_->stages - 1), now_.end_coefficients.begin());
    now_.end_is_known = true;
    find_stored();
    now_.step_begin = now_.time;
    now_.time = now_.tried;
    now_.has_history = true;
    for (int i = 0; i < tableau_->stages; ++i) {
        const double end = i + 1 == tableau_->stages ? now_.time : now_.step_begin + tableau_->c[at(i)] * dt;
        stages_[at(i)] = {.time = end, .temperature = now_.last[at(i)], .watts = stage_watts_[at(i)]};
    }
}

void Stepper::find_stored() {
    system_.enthalpy(T_[0], H_);
    add(-1.0, H_start_, H_);
    now_.stored = system_.of_budget(H_);
}

void Stepper::interpolate(double t, std::span<double> T) const { interpolate(t, now_.last, T); }

void Stepper::interpolate_watts(double t, std::span<double> watts) const { interpolate(t, stage_watts_, watts); }

void Stepper::interpolate(double t, const std::vector<std::vector<double>>& stages, std::span<double> out) const {
    const double x = (t - now_.step_begin) / (now_.time - now_.step_begin);
    clear_nodes(out);
    for (int i = 0; i < tableau_->stages; ++i) {
        double basis = 1.0;
        for (int j = 0; j < tableau_->stages; ++j) {
            if (j != i) {
                basis *= (x - tableau_->c[at(j)]) / (tableau_->c[at(i)] - tableau_->c[at(j)]);
            }
        }
        add(basis, stages[at(i)], out);
    }
}

void Stepper::interpolate_joules(double t, std::span<double> joules) const {
    const double dt = now_.time - now_.step_begin;
    const double x = (t - now_.step_begin) / dt;
    std::copy(joules_before_.begin(), joules_before_.end(), joules.begin());
    for (int i = 0; i < tableau_->stages; ++i) {
        const double weight = dt * tableau_->weight_at(i, x);
        for (std::size_t e = 0; e < joules.size(); ++e) {
            joules[e] += weight * stage_watts_[at(i)][e];
        }
    }
}

void Stepper::find_watts(const physics::Inputs& logged) {
    std::vector<double> coefficients(system_.n_coefficients());
    system_.evaluate_coefficients(logged, coefficients);
    T_[1] = T_[0];
    system_.make_consistent(T_[1], coefficients);
    now_.watts = system_.terms().watts;
}

void Stepper::visit(Archive& archive) {
    archive(now_);
    archive(T_[0]);
    archive(newton_);
}

double Stepper::effective_two_node_conductance() {
    const mesh::Mesh& mesh = problem_->mesh;
    const int surface = mesh.find_region("surface");
    const int bulk = mesh.find_region("bulk");
    if (surface < 0 || bulk < 0) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const std::vector<double>& T = T_[0];
    const double above = mesh.regions[at(bulk)].mean(T) - mesh.regions[at(surface)].mean(T);
    if (std::abs(above) < 1e-3) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    // Heat counts when it leaves for another layer or for the outer surface, not for the inner one.
    enum : char { elsewhere, inside_bulk, inner_surface };
    std::vector<char> place(T.size(), elsewhere);
    for (std::size_t n = at(mesh.n_cells); n < T.size(); ++n) {
        place[n] = inner_surface;
    }
    for (const int node : mesh.regions[at(surface)].mean.nodes) {
        place[at(node)] = elsewhere;
    }
    for (const int node : mesh.regions[at(bulk)].mean.nodes) {
        place[at(node)] = inside_bulk;
    }
    system_.evaluate(T, forcing_.stage(tableau_->stages - 1));
    double leaving = 0.0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const mesh::Face& face = mesh.faces[f];
        const double flux = system_.terms().face_G[f] * (T[at(face.a)] - T[at(face.b)]);
        if (place[at(face.a)] == inside_bulk && place[at(face.b)] == elsewhere) {
            leaving += flux;
        } else if (place[at(face.b)] == inside_bulk && place[at(face.a)] == elsewhere) {
            leaving -= flux;
        }
    }
    return leaving / above;
}

double Stepper::energy_closure() const {
    const double attributed = std::accumulate(now_.joules.begin(), now_.joules.end(), 0.0);
    const double carried = system_.of_budget(now_.left);
    return now_.turnover > 0.0 ? std::abs(now_.stored + carried - attributed) / now_.turnover : 0.0;
}

double Stepper::steepest_rate() {
    forcing_.open(now_.time, now_.time);
    T_[1] = T_[0];
    system_.make_consistent(T_[1], forcing_.stage(0));
    const std::span<const double> q = system_.heat_flow();
    double steepest = 0.0;
    for (std::size_t n = 0; n < q.size(); ++n) {
        if (system_.has_capacity(n)) {
            steepest = std::max(steepest, std::abs(q[n]) / system_.capacity(n, T_[1][n]));
        }
    }
    return steepest;
}

}  // namespace tiretherm::solver
