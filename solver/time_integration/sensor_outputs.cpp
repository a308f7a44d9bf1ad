// SPDX-License-Identifier: BSD-3-Clause
// Follows each channel by the parabola through the stages of a step, solves tau dm/dt = v - m along it in closed form,
// and looks up delays in the kept past.

#include "solver/time_integration/sensor_outputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/probe.hpp"

namespace tiretherm::solver {

namespace {

/// Half the step of a difference quotient with temperature: readings are smooth over kelvins. K
constexpr double difference = 0.01;

/// The parabola through three points, or the line through two; times u since the begin.
struct Parabola {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
};

Parabola through(std::span<const double> u, std::span<const double> v) {
    const std::size_t last = u.size() - 1;
    const double chord = (v[last] - v[0]) / (u[last] - u[0]);
    // In a step as short as the rounding of its times the stages fall together.
    if (u.size() == 2 || !(u[0] < u[1] && u[1] < u[last])) {
        return {.a = v[0], .b = chord, .c = 0.0};
    }
    const double first = (v[1] - v[0]) / (u[1] - u[0]);
    const double c = (chord - first) / (u[last] - u[1]);
    return {.a = v[0], .b = first - c * (u[1] - u[0]), .c = c};
}

}  // namespace

SensorOutputs::SensorOutputs(const Problem& problem, const System& system)
    : problem_(&problem),
      system_(&system),
      chains_(problem.channels.size()),
      coefficients_(system.n_coefficients()),
      flow_(static_cast<std::size_t>(system.size())),
      means_(problem.mesh.regions.size()) {
    const std::span<const physics::ActiveEffect> effects = system.effects();
    const int surface = problem.mesh.find_region("surface");
    if (problem.handling.grip && surface >= 0) {
        chains_.emplace_back().where = problem.mesh.regions[static_cast<std::size_t>(surface)].mean;
    }
    for (std::size_t c = 0; c < problem.channels.size(); ++c) {
        Chain& chain = chains_[c];
        const Channel& channel = problem.channels[c];
        chain.where = channel.where;
        double depth_offset = 0.0;
        for (const physics::ActiveEffect& active : effects) {
            const physics::SensorModel* model = active.effect->sensor_model();
            const auto found = std::find(active.channels.begin(), active.channels.end(), static_cast<int>(c));
            if (model == nullptr || found == active.channels.end()) {
                continue;
            }
            const auto position = static_cast<std::size_t>(found - active.channels.begin());
            depth_offset += model->depth_offset != nullptr ? model->depth_offset(active, position) : 0.0;
            chain.delay += model->delay != nullptr ? model->delay(active, position) : 0.0;
            chain.rate += model->clock_rate != nullptr ? model->clock_rate(active, position) : 0.0;
            chain.lag += model->lag != nullptr ? model->lag(active, position) : 0.0;
            if (model->read != nullptr) {
                (model->before_lag ? chain.before : chain.after).push_back({&active, position, model->read});
            }
        }
        if (depth_offset != 0.0 && channel.point) {
            mesh::Point point = *channel.point;
            point[2] = std::max(0.0, point[2] + depth_offset);
            chain.where = mesh::contains(problem.mesh, point) ? mesh::at_point(problem.mesh, point) : chain.where;
        }
    }
}

bool SensorOutputs::is_linear_and_as(const SensorOutputs& other) const {
    for (std::size_t c = 0; c < problem_->channels.size(); ++c) {
        const QuantityDescription& quantity = description_of(problem_->channels[c].quantity);
        const Chain& ours = chains_[c];
        const Chain& theirs = other.chains_[c];
        if (quantity.follow != nullptr || quantity.evaluate != nullptr || !ours.before.empty() || !ours.after.empty() ||
            ours.lag != theirs.lag || ours.delay != theirs.delay || ours.rate != theirs.rate ||
            ours.where.nodes != theirs.where.nodes || ours.where.weights != theirs.where.weights) {
            return false;
        }
    }
    return true;
}

/// What is followed along a step: the temperature at the channel's place, or what its quantity names instead.
double SensorOutputs::followed_quantity(std::size_t channel, std::span<const double> T,
                                        std::span<const double> watts) const {
    const bool is_channel = channel < problem_->channels.size();
    const auto follow = is_channel ? description_of(problem_->channels[channel].quantity).follow : nullptr;
    const mesh::Functional& where = chains_[channel].where;
    return follow == nullptr ? where(T)
                             : follow({.system = *system_,
                                       .where = where,
                                       .temperature = T,
                                       .watts = watts,
                                       .flow = flow_,
                                       .means = means_});
}

/// What the channel reads, from what is followed and from the inputs of the moment.
double SensorOutputs::quantity(std::size_t channel, double t, double followed, const physics::Inputs& logged) const {
    const QuantityDescription& quantity = description_of(problem_->channels[channel].quantity);
    if (quantity.evaluate == nullptr) {
        return followed;
    }
    return quantity.evaluate(
        {.problem = *problem_,
         .system = *system_,
         .quantity = quantity.quantity,
         .followed = followed,
         .inputs = system_->transformed(logged),
         .logged = logged,
         .gas_start = gas_start_,
         .coefficients = coefficients_,
         .surface = chains_.size() > problem_->channels.size() ? delayed(chains_.back(), t) : 0.0});
}

void SensorOutputs::begin(double t, std::span<const double> T, std::span<const double> watts,
                          const physics::Inputs& inputs) {
    // The cold pressure is that at the start of the case, also where T is a steady state.
    const int gas = problem_->mesh.find_lumped_node("gas");
    gas_start_ = gas < 0 ? inputs.air_temperature : system_->initial()[static_cast<std::size_t>(gas)];
    for (std::size_t c = 0; c < chains_.size(); ++c) {
        Chain& chain = chains_[c];
        double value = followed_quantity(c, T, watts);
        for (const AppliedModel& model : chain.before) {
            value = model.read(*model.active, model.position, value, inputs);
        }
        chain.past.assign(1, {.begin = t, .end = t, .a = value, .b = 0.0, .c = 0.0, .lagged = value});
    }
}

/// What a channel does over a step. @param lagged what a lagging sensor gave at its begin
SensorOutputs::Piece SensorOutputs::piece_over(std::size_t channel, std::span<const StepMoment> stages,
                                               std::span<const physics::Inputs> inputs, double lagged) const {
    const std::size_t n = stages.size();
    std::array<double, 3> u{};
    std::array<double, 3> v{};
    const double begin = stages.front().time;
    for (std::size_t i = 0; i < n; ++i) {
        const StepMoment& stage = stages[i];
        u[i] = stage.time - begin;
        v[i] = followed_quantity(channel, stage.temperature, stage.watts);
        for (const AppliedModel& model : chains_[channel].before) {
            v[i] = model.read(*model.active, model.position, v[i], inputs[i]);
        }
    }
    const Parabola p = through({u.data(), n}, {v.data(), n});
    return {.begin = begin, .end = stages.back().time, .a = p.a, .b = p.b, .c = p.c, .lagged = lagged};
}

void SensorOutputs::take_step(std::span<const StepMoment> stages, std::span<const physics::Inputs> inputs) {
    const double begin = stages.front().time;
    const double end = stages.back().time;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
        Chain& chain = chains_[c];
        const Piece piece = piece_over(c, stages, inputs, followed(chain, chain.past.back(), begin));
        // Only as much of the past is kept as the delay looks back.
        const double oldest = std::min(begin, chain.moment(begin));
        std::erase_if(chain.past, [&](const Piece& candidate) { return candidate.end < oldest; });
        if (chain.moment(begin) >= begin && chain.moment(end) >= end) {
            chain.past.clear();
        }
        chain.past.push_back(piece);
    }
}

void SensorOutputs::retake_step(const SensorOutputs& as, std::span<const StepMoment> stages,
                                std::span<const physics::Inputs> inputs) {
    gas_start_ = as.gas_start_;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
        std::vector<Piece>& past = chains_[c].past;
        past = as.chains_[c].past;
        past.back() = piece_over(c, stages, inputs, past.back().lagged);
    }
}

/// Solves lag dm/dt = v - m along a piece, v a parabola.
double SensorOutputs::followed(const Chain& chain, const Piece& piece, double t) {
    if (chain.lag <= 0.0) {
        return piece.value(t);
    }
    const auto particular = [&](double when) {
        return piece.value(when) - chain.lag * piece.slope(when) + 2.0 * chain.lag * chain.lag * piece.c;
    };
    const double decay = std::exp(-(t - piece.begin) / chain.lag);
    return particular(t) + (piece.lagged - particular(piece.begin)) * decay;
}

double SensorOutputs::ahead(const Chain& chain, const Piece& piece, double t) {
    const double value = followed(chain, piece, piece.end);
    const double slope = chain.lag > 0.0 ? (piece.value(piece.end) - value) / chain.lag : piece.slope(piece.end);
    return value + (t - piece.end) * slope;
}

/// Lag and delay commute: a delayed reading is the lagged one of an earlier time.
double SensorOutputs::delayed(const Chain& chain, double t) {
    const double when = chain.moment(t);
    const Piece& now = chain.past.back();
    if (when > now.end) {  // a clock that runs ahead
        return ahead(chain, now, when);
    }
    const auto piece = std::find_if(chain.past.rbegin(), chain.past.rend(),
                                    [&](const Piece& candidate) { return when >= candidate.begin; });
    return piece == chain.past.rend() ? chain.past.front().lagged : followed(chain, *piece, when);
}

void SensorOutputs::at(double t, const physics::Inputs& logged, std::span<double> out) const {
    for (std::size_t c = 0; c < problem_->channels.size(); ++c) {
        out[c] = shown(c, t, delayed(chains_[c], t), logged);
    }
}

double SensorOutputs::shown(std::size_t channel, double t, double followed, const physics::Inputs& logged) const {
    double value = quantity(channel, t, followed, logged);
    for (const AppliedModel& model : chains_[channel].after) {
        value = model.read(*model.active, model.position, value, logged);
    }
    return value;
}

double SensorOutputs::slope(std::size_t channel, double t, const physics::Inputs& logged) const {
    const double followed = delayed(chains_[channel], t);
    return (shown(channel, t, followed + difference, logged) - shown(channel, t, followed - difference, logged)) /
           (2.0 * difference);
}

SensorOutputs::Form SensorOutputs::form(std::size_t channel, std::span<const StepMoment> stages,
                                        std::span<const physics::Inputs> inputs, double t) const {
    const Chain& chain = chains_[channel];
    if (description_of(problem_->channels[channel].quantity).follow != nullptr || chain.where.nodes.empty()) {
        return {};
    }
    const std::size_t n = stages.size();
    const double begin = stages.front().time;
    const double end = stages.back().time;
    std::array<double, 3> u{};
    for (std::size_t i = 0; i < n; ++i) {
        u[i] = stages[i].time - begin;
    }
    const auto response = [&](const std::array<double, 3>& v, double lagged) {
        const Parabola p = through({u.data(), n}, {v.data(), n});
        const Piece piece{.begin = begin, .end = end, .a = p.a, .b = p.b, .c = p.c, .lagged = lagged};
        return t > end ? ahead(chain, piece, t) : followed(chain, piece, t);
    };
    Form form{.lagged = response({}, 1.0)};
    for (std::size_t i = 0; i < n; ++i) {
        std::array<double, 3> unit{};
        unit[i] = 1.0;
        double above = chain.where(stages[i].temperature) + difference;
        double below = above - 2.0 * difference;
        for (const AppliedModel& model : chain.before) {
            above = model.read(*model.active, model.position, above, inputs[i]);
            below = model.read(*model.active, model.position, below, inputs[i]);
        }
        form.stage[i] = response(unit, 0.0) * (above - below) / (2.0 * difference);
    }
    return form;
}

void SensorOutputs::visit(Archive& archive) {
    archive(gas_start_);
    for (Chain& chain : chains_) {
        archive.grown(chain.past);
        chain.past.resize(std::max<std::size_t>(chain.past.size(), 1));  // of a damaged archive
    }
}

}  // namespace tiretherm::solver
