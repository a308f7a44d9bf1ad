// SPDX-License-Identifier: BSD-3-Clause
// Interpolates temperatures and heat at output times inside a step, reads the channels there, and keeps extremes and
// the temperatures for range warnings.

#include "solver/time_integration/output_sampler.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace tiretherm::solver {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

OutputSampler::OutputSampler(const Problem& problem, const Observer& observer, const Stepper& stepper)
    : problem_(&problem),
      observer_(&observer),
      stepper_(&stepper),
      hot_spot_finder_(problem.mesh, all_nodes(problem.mesh)),
      sensor_outputs_(problem, stepper.system()),
      channels_(problem.channels.size()),
      field_(problem.initial),
      watts_(problem.effects.size()),
      joules_(problem.effects.size()),
      now_{.next_output = output_time(1),
           .next_field = problem.settings.start + problem.settings.field_interval,
           .coldest = std::vector<double>(problem.effects.size(), infinity),
           .hottest = std::vector<double>(problem.effects.size(), -infinity),
           .layer_extremes =
               std::vector<LayerExtremes>(problem.mesh.layers.size(), {.coldest = infinity, .hottest = -infinity})} {}

void OutputSampler::begin_sensor_outputs() {
    const double t = stepper_->time();
    sensor_outputs_.begin(t, stepper_->temperature(), stepper_->watts(),
                          problem_->input_signals.at(t, JumpSide::after));
}

void OutputSampler::read(double t) {
    sensor_outputs_.at(t, problem_->input_signals.at(t, JumpSide::before), channels_);
}

void OutputSampler::take_step() {
    inputs_.clear();
    for (const StepMoment& stage : stepper_->stages()) {
        inputs_.push_back(problem_->input_signals.at(stage.time, inputs_.empty() ? JumpSide::after : JumpSide::before));
    }
    sensor_outputs_.take_step(stepper_->stages(), inputs_);
}

void OutputSampler::watch(MarchReport& report) {
    const std::span<const double> T = stepper_->temperature();
    const HotSpotFinder::Found hottest = hot_spot_finder_.find(T);
    if (hottest.temperature > report.hottest.temperature + creeping_rise) {
        report.hottest = {hottest.temperature, stepper_->time(), hottest.node};
        report.hottest_field.assign(T.begin(), T.end());
    }
    for (std::size_t n = 0; n < T.size(); ++n) {
        if (T[n] < report.coldest.temperature) {
            report.coldest = {T[n], stepper_->time(), static_cast<int>(n)};
        }
        if (const int layer = problem_->mesh.layer[n]; layer >= 0) {
            LayerExtremes& of_layer = now_.layer_extremes[static_cast<std::size_t>(layer)];
            of_layer.coldest = std::min(of_layer.coldest, T[n]);
            of_layer.hottest = std::max(of_layer.hottest, T[n]);
        }
    }
    for (std::size_t e = 0; e < problem_->effects.size(); ++e) {
        const physics::ActiveEffect& active = problem_->effects[e];
        const physics::HeatEffect* heat = active.effect->heat_effect();
        if (heat == nullptr || heat->range_warning == nullptr) {
            continue;
        }
        for (const int patch : active.patches) {
            for (const mesh::PatchFace& face : problem_->mesh.patches[static_cast<std::size_t>(patch)].faces) {
                now_.coldest[e] = std::min(now_.coldest[e], T[static_cast<std::size_t>(face.node)]);
                now_.hottest[e] = std::max(now_.hottest[e], T[static_cast<std::size_t>(face.node)]);
            }
        }
        for (const LayerExtremes& of_layer : now_.layer_extremes) {
            if (active.patches.empty()) {
                now_.coldest[e] = std::min(now_.coldest[e], of_layer.coldest);
                now_.hottest[e] = std::max(now_.hottest[e], of_layer.hottest);
            }
        }
    }
    if (report.channel_final.empty()) {
        begin_sensor_outputs();
    }
    read(stepper_->time());
    if (report.channel_final.empty()) {
        report.channel_min = report.channel_max = channels_;
    }
    report.channel_final = channels_;
    for (std::size_t c = 0; c < channels_.size(); ++c) {
        report.channel_min[c] = std::min(report.channel_min[c], channels_[c]);
        report.channel_max[c] = std::max(report.channel_max[c], channels_[c]);
    }
}

std::vector<RangeWarning> OutputSampler::range_warnings() const {
    std::vector<RangeWarning> warnings;
    for (std::size_t e = 0; e < problem_->effects.size(); ++e) {
        const physics::ActiveEffect& active = problem_->effects[e];
        const physics::HeatEffect* heat = active.effect->heat_effect();
        if (heat != nullptr && heat->range_warning != nullptr) {
            if (std::string law = heat->range_warning(active, now_.coldest[e], now_.hottest[e]); !law.empty()) {
                warnings.push_back({.law = std::move(law), .coldest = now_.coldest[e], .hottest = now_.hottest[e]});
            }
        }
    }
    std::ranges::move(law_range_warnings(problem_->mesh, stepper_->system().material_model(), now_.layer_extremes),
                      std::back_inserter(warnings));
    return warnings;
}

bool OutputSampler::emit(double t, std::span<const double> T, std::span<const double> watts,
                         std::span<const double> joules, double stored, bool field) {
    const auto begin = std::chrono::steady_clock::now();
    read(t);
    const bool go_on = *observer_ == nullptr || (*observer_)({.time = t,
                                                              .temperature = T,
                                                              .channels = channels_,
                                                              .watts = watts,
                                                              .joules = joules,
                                                              .stored = stored,
                                                              .field = field});
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return go_on;
}

bool OutputSampler::emit_state(bool field) {
    return emit(stepper_->time(), stepper_->temperature(), stepper_->watts(), stepper_->joules(), stepper_->stored(),
                field);
}

bool OutputSampler::show() { return emit_state(true); }

bool OutputSampler::emit_inside_step(double t) {
    stepper_->interpolate(t, field_);
    stepper_->interpolate_watts(t, watts_);
    stepper_->interpolate_joules(t, joules_);
    const double stored = std::accumulate(joules_.begin(), joules_.end(), 0.0);
    return emit(t, field_, watts_, joules_, stored, field_due(t));
}

bool OutputSampler::advance() {
    const Settings& settings = problem_->settings;
    const double t = stepper_->time();
    const bool at_end = t >= settings.end;
    if (settings.output_interval <= 0.0) {
        return emit_state(field_due(t) || at_end);
    }
    const double slack = 1e-9 * settings.output_interval;
    while (now_.next_output < t - slack) {
        if (!emit_inside_step(now_.next_output)) {
            return false;
        }
        now_.next_output = output_time(++now_.outputs);
    }
    const bool due = now_.next_output <= t + slack;
    if (due) {
        now_.next_output = output_time(++now_.outputs);
    }
    return !(due || at_end) || emit_state(field_due(t) || at_end);
}

/// Multiplied out, not summed up, so that late output times do not drift.
double OutputSampler::output_time(long index) const {
    return problem_->settings.start + static_cast<double>(index) * problem_->settings.output_interval;
}

bool OutputSampler::field_due(double t) {
    const Settings& settings = problem_->settings;
    const double interval = settings.field_interval;
    if (interval <= 0.0 || t < now_.next_field - 1e-9 * interval) {
        return false;
    }
    now_.next_field = settings.start + interval * (std::floor((t - settings.start) / interval + 1e-9) + 1.0);
    return true;
}

void OutputSampler::visit(Archive& archive) {
    archive(now_);
    archive(sensor_outputs_);
}

}  // namespace tiretherm::solver
