// SPDX-License-Identifier: BSD-3-Clause
// Difference quotients between two neighbouring problems, normally one on each side of the value; different one-sided
// slopes reveal a switch or a clamp.

#include "solver/sensitivity/parameter_perturbation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/index.hpp"

namespace tiretherm::solver {

namespace {

/// Slopes to either side that differ by more than this share belong to a switch or a clamp.
constexpr double slope_jump = 0.01;

Problem moved(Problem problem, const FreeParameter& parameter, double from, double to) {
    move(problem, parameter, from, to);
    return problem;
}

bool same_places(const physics::ActiveEffect& a, const physics::ActiveEffect& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.scope == y.scope && x.index == y.index && x.parameter == y.parameter && x.value == y.value;
    };
    return a.parameters == b.parameters && std::ranges::equal(a.overrides, b.overrides, same) && a.nodes == b.nodes &&
           a.weights == b.weights && a.groups == b.groups && a.skew == b.skew && a.crown == b.crown;
}

bool same_conductivity(const physics::MaterialModel& a, const physics::MaterialModel& b) {
    return a.link_laws == b.link_laws && std::ranges::equal(a.materials, b.materials, [](const auto& x, const auto& y) {
               return x.conductivity == y.conductivity;
           });
}

bool same_capacity(const System& a, const System& b) {
    const auto& x = a.material_model().materials;
    const auto& y = b.material_model().materials;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i].density != y[i].density || !(x[i].heat_capacity == y[i].heat_capacity)) {
            return false;
        }
    }
    for (std::size_t n = 0; n < static_cast<std::size_t>(a.size()); ++n) {
        if (a.capacity(n, 300.0) != b.capacity(n, 300.0)) {
            return false;
        }
    }
    return true;
}

}  // namespace

ParameterPerturbation::Side::Side(const Problem& base, const FreeParameter& parameter, double value, double to)
    : problem(moved(base, parameter, value, to)),
      system(problem),
      forcing(system, problem.input_signals, tableau(problem.settings.method)),
      sensor_outputs(problem, system),
      shift(to - value),
      q(static_cast<std::size_t>(system.size())),
      read(problem.channels.size()) {
    const auto stages = static_cast<std::size_t>(tableau(problem.settings.method).stages);
    T.assign(stages, std::vector<double>(q.size()));
    watts.assign(stages, std::vector<double>(problem.effects.size()));
}

ParameterPerturbation::ParameterPerturbation(const Problem& base, const FreeParameter& parameter, double value)
    : base_(&base) {
    using Kind = FreeParameter::Kind;
    const bool is_conductivity = parameter.kind == Kind::conductivity || parameter.kind == Kind::link_conductivity;
    // What follows a conductivity is bent only where two materials meet: a small step to one side is as good.
    const double step = (is_conductivity ? 1e-2 : 1.0) * typical_step(parameter, value);
    // At a bound the parameter moves to one side only: beyond it there may be nothing (a lag below zero).
    const double high = value + step > parameter.high ? value : value + step;
    is_straight_ = is_conductivity && high > value;
    const double low = is_straight_ || value - step < parameter.low ? value : value - step;
    plus_ = std::make_unique<Side>(base, parameter, value, high);
    minus_ = std::make_unique<Side>(base, parameter, value, low);
    width_ = high - low;

    const std::span<const physics::ActiveEffect> ours = plus_->system.effects();
    const std::span<const physics::ActiveEffect> theirs = minus_->system.effects();
    // Properties reach the heat by effects without inputs (conduction), by places, by laws of the tire.
    const bool moves_conductivity = !same_conductivity(plus_->system.material_model(), minus_->system.material_model());
    const bool moves_tire = !(plus_->system.material_model().tire == minus_->system.material_model().tire);
    moves_enthalpy_ = !same_capacity(plus_->system, minus_->system);
    const physics::InputCorrection* moves_inputs =
        parameter.kind == Kind::effect ? base.effects[parameter.effect].effect->input_correction() : nullptr;
    const bool is_input_number = parameter.kind == Kind::input && base.input_model != nullptr;
    is_delay_ = moves_inputs != nullptr && moves_inputs->delay != nullptr;
    follows_own_inputs_ = is_input_number;
    moves_coefficients_ = is_input_number;
    const auto depends_on_inputs = [](const physics::Effect& effect) {
        const physics::InputCorrection* correction = effect.input_correction();
        const physics::PropertyModifier* modifier = effect.property_modifier();
        return effect.n_coefficients() > 0 ||
               (correction != nullptr && (correction->transform != nullptr || correction->delay != nullptr)) ||
               (modifier != nullptr && modifier->modify_laws != nullptr);
    };
    bool scales_loss = false;
    bool moves_all = moves_tire || is_input_number;
    for (std::size_t e = 0; e < ours.size(); ++e) {
        const physics::Effect& effect = *ours[e].effect;
        const bool moved_one = !same_places(ours[e], theirs[e]);
        const bool conducts = moves_conductivity && effect.n_coefficients() == 0;
        if (effect.heat_effect() != nullptr && (moved_one || conducts)) {
            moved_effects_.push_back(e);
        }
        scales_loss = scales_loss || (moved_one && effect.loss_law() != nullptr);
        moves_coefficients_ = moves_coefficients_ || moves_tire || (moved_one && depends_on_inputs(effect));
        moves_all = moves_all || (moved_one && depends_on_inputs(effect) && effect.n_coefficients() == 0);
    }
    for (const std::size_t e : plus_->system.with_coefficients()) {
        // Sliding in a contact looks at what the road takes.
        const bool looks = ours[e].road >= 0 && !same_places(ours[at(ours[e].road)], theirs[at(ours[e].road)]);
        if (!moves_all && (looks || !same_places(ours[e], theirs[e]))) {
            driven_.push_back(e);
        }
    }
    for (std::size_t e = 0; scales_loss && e < ours.size(); ++e) {
        const physics::HeatEffect* heat = ours[e].effect->heat_effect();
        if (heat != nullptr && heat->by_deformation && std::ranges::find(moved_effects_, e) == moved_effects_.end()) {
            moved_effects_.push_back(e);
        }
    }
    for (const Channel& channel : base.channels) {
        follows_watts_ = follows_watts_ || description_of(channel.quantity).follows_watts;
    }
    channels_are_linear_ = plus_->sensor_outputs.is_linear_and_as(minus_->sensor_outputs);
}

std::vector<double> ParameterPerturbation::start() const {
    std::vector<double> slope = plus_->system.initial();
    const std::vector<double> below = minus_->system.initial();
    for (std::size_t n = 0; n < slope.size(); ++n) {
        slope[n] = (slope[n] - below[n]) / width_;
    }
    return slope;
}

void ParameterPerturbation::open(double t0, double t1, StepForcing& base) {
    if (moves_coefficients_) {
        for (Side* side : {plus_.get(), minus_.get()}) {
            const std::span<const double> ended = side->forcing.stage(tableau(base_->settings.method).stages - 1);
            side->ended.assign(ended.begin(), ended.end());
            if (driven_.empty()) {
                side->forcing.open(t0, t1);
            } else {
                side->forcing.open_beside(base, driven_);
            }
        }
    }
}

bool ParameterPerturbation::goes_on() const {
    return !moves_coefficients_ || (std::ranges::equal(plus_->forcing.stage(0), plus_->ended) &&
                                    std::ranges::equal(minus_->forcing.stage(0), minus_->ended));
}

void ParameterPerturbation::flow(int stage, std::span<const double> T, std::span<const double> means,
                                 std::span<const double> base, std::span<double> out) {
    const std::span<const double> above = moves_coefficients_ ? plus_->forcing.stage(stage) : base;
    const std::span<const double> below = moves_coefficients_ ? minus_->forcing.stage(stage) : base;
    contributing_ = moved_effects_;
    if (moves_coefficients_) {
        const System& system = plus_->system;
        for (const std::size_t e :
             driven_.empty() ? system.with_coefficients() : std::span<const std::size_t>(driven_)) {
            const std::span<const double> ours = system.coefficients_of(e, above);
            const std::span<const double> theirs = system.coefficients_of(e, below);
            if (!std::ranges::equal(ours, theirs) && std::ranges::find(contributing_, e) == contributing_.end()) {
                contributing_.push_back(e);
            }
            const std::span<const double> between = system.coefficients_of(e, base);
            for (std::size_t i = 0; i < ours.size(); ++i) {
                const double up = plus_->shift > 0.0 ? (ours[i] - between[i]) / plus_->shift : 0.0;
                const double down = minus_->shift < 0.0 ? (between[i] - theirs[i]) / -minus_->shift : up;
                const double round_off = 1e-12 * std::abs(between[i]) / width_;
                // A log bends at each of its samples: what follows a delay has another slope to either side there. So has
                // one sample of thousands at which a wheel lifts, whatever a number of the car is.
                has_slope_jump_ =
                    has_slope_jump_ ||
                    (!is_delay_ && !follows_own_inputs_ &&
                     std::abs(up - down) > slope_jump * std::max(std::abs(up), std::abs(down)) + round_off);
            }
        }
    }
    if (contributing_.empty()) {
        std::fill(out.begin(), out.end(), 0.0);
        return;
    }
    plus_->system.find_flow_of(contributing_, T, means, above, plus_->q);
    minus_->system.find_flow_of(contributing_, T, means, below, minus_->q);
    for (std::size_t n = 0; n < out.size(); ++n) {
        out[n] = (plus_->q[n] - minus_->q[n]) / width_;
    }
}

void ParameterPerturbation::flow_above(std::span<const double> T, std::span<const double> means,
                                       std::span<const double> base, std::span<const double> base_flow,
                                       std::span<double> out) {
    plus_->system.find_flow_of(moved_effects_, T, means, base, plus_->q);
    for (std::size_t n = 0; n < out.size(); ++n) {
        out[n] = (plus_->q[n] - base_flow[n]) / width_;
    }
}

void ParameterPerturbation::enthalpy(std::span<const double> T, std::span<double> out) const {
    if (!moves_enthalpy_) {
        std::fill(out.begin(), out.end(), 0.0);
        return;
    }
    plus_->system.enthalpy(T, plus_->q);
    minus_->system.enthalpy(T, minus_->q);
    for (std::size_t n = 0; n < out.size(); ++n) {
        out[n] = (plus_->q[n] - minus_->q[n]) / width_;
    }
}

void ParameterPerturbation::begin_sensor_outputs(double t, std::span<const double> T, std::span<const double> S,
                                                 std::span<const double> watts, const physics::Inputs& inputs) {
    if (channels_are_linear_) {
        plus_->sensor_outputs.begin(t, S, watts, inputs);
        return;
    }
    for (Side* side : {plus_.get(), minus_.get()}) {
        for (std::size_t n = 0; n < T.size(); ++n) {
            side->T[0][n] = T[n] + side->shift * S[n];
        }
        std::ranges::copy(watts, side->watts[0].begin());
        const physics::Inputs its = follows_own_inputs_ ? side->problem.input_signals.at(t, JumpSide::after) : inputs;
        if (follows_watts_) {
            std::vector<double> coefficients(side->system.n_coefficients());
            side->system.evaluate_coefficients(its, coefficients);
            side->system.evaluate(side->T[0], coefficients);
            side->watts[0] = side->system.terms().watts;
        }
        side->sensor_outputs.begin(t, side->T[0], side->watts[0], its);
    }
}

void ParameterPerturbation::take_step(std::span<const StepMoment> stages, std::span<const std::span<const double>> S,
                                      std::span<const std::span<const double>> coefficients,
                                      std::span<const physics::Inputs> inputs) {
    std::vector<StepMoment> seen(stages.begin(), stages.end());
    if (channels_are_linear_) {
        for (std::size_t i = 0; i < stages.size(); ++i) {
            seen[i].temperature = S[i];
        }
        plus_->sensor_outputs.take_step(seen, inputs);
        return;
    }
    std::vector<physics::Inputs> its(inputs.begin(), inputs.end());
    for (Side* side : {plus_.get(), minus_.get()}) {
        for (std::size_t i = 0; i < stages.size(); ++i) {
            if (follows_own_inputs_) {
                its[i] = side->problem.input_signals.at(stages[i].time, i == 0 ? JumpSide::after : JumpSide::before);
            }
            for (std::size_t n = 0; n < side->T[i].size(); ++n) {
                side->T[i][n] = stages[i].temperature[n] + side->shift * S[i][n];
            }
            seen[i].temperature = side->T[i];
            if (follows_watts_) {
                side->system.evaluate(side->T[i],
                                      moves_coefficients_ ? side->forcing.stage(static_cast<int>(i)) : coefficients[i]);
                side->watts[i] = side->system.terms().watts;
                seen[i].watts = side->watts[i];
            }
        }
        side->sensor_outputs.take_step(seen, its);
    }
}

void ParameterPerturbation::read(double t, const physics::Inputs& logged, std::span<double> out) {
    if (channels_are_linear_) {
        plus_->sensor_outputs.at(t, logged, out);
        return;
    }
    for (Side* side : {plus_.get(), minus_.get()}) {
        const physics::Inputs its = follows_own_inputs_ ? side->problem.input_signals.at(t, JumpSide::before) : logged;
        side->sensor_outputs.at(t, its, side->read);
    }
    for (std::size_t c = 0; c < out.size(); ++c) {
        out[c] = (plus_->read[c] - minus_->read[c]) / width_;
    }
}

}  // namespace tiretherm::solver
