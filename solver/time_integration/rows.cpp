#include "solver/time_integration/rows.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace tiretherm::solver {

Rows::Rows(const Problem& problem, const Observer& observer, const Stepper& stepper)
    : problem_(&problem),
      observer_(&observer),
      stepper_(&stepper),
      readings_(problem, stepper.system()),
      channels_(problem.channels.size()),
      field_(problem.initial),
      joules_(problem.effects.size()),
      coldest_(problem.effects.size(), std::numeric_limits<double>::infinity()),
      hottest_(problem.effects.size(), -std::numeric_limits<double>::infinity()),
      next_output_(output_time(1)),
      next_field_(problem.settings.start + problem.settings.field_interval) {}

void Rows::begin_readings() {
    const double t = stepper_->time();
    readings_.begin(t, stepper_->temperature(), stepper_->watts(), problem_->drive.at(t, Limit::after));
}

void Rows::read(double t) { readings_.at(t, problem_->drive.at(t, Limit::before), channels_); }

void Rows::take_step() {
    inputs_.clear();
    for (const Stage& stage : stepper_->stages()) {
        inputs_.push_back(problem_->drive.at(stage.time, inputs_.empty() ? Limit::after : Limit::before));
    }
    readings_.take_step(stepper_->stages(), inputs_);
}

void Rows::watch(Report& report) {
    const std::span<const double> T = stepper_->temperature();
    for (std::size_t n = 0; n < T.size(); ++n) {
        if (T[n] > report.hottest.temperature) {
            report.hottest = {T[n], stepper_->time(), static_cast<int>(n)};
        }
        if (T[n] < report.coldest.temperature) {
            report.coldest = {T[n], stepper_->time(), static_cast<int>(n)};
        }
    }
    for (std::size_t e = 0; e < problem_->effects.size(); ++e) {
        const physics::ActiveEffect& active = problem_->effects[e];
        if (active.effect->caution == nullptr) {
            continue;
        }
        for (const int patch : active.patches) {
            for (const mesh::PatchFace& face : problem_->mesh.patches[static_cast<std::size_t>(patch)].faces) {
                coldest_[e] = std::min(coldest_[e], T[static_cast<std::size_t>(face.node)]);
                hottest_[e] = std::max(hottest_[e], T[static_cast<std::size_t>(face.node)]);
            }
        }
    }
    if (report.channel_final.empty()) {
        begin_readings();
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

std::vector<std::string> Rows::cautions() const {
    std::vector<std::string> sentences;
    for (std::size_t e = 0; e < problem_->effects.size(); ++e) {
        const physics::ActiveEffect& active = problem_->effects[e];
        if (active.effect->caution != nullptr) {
            if (std::string sentence = active.effect->caution(active, coldest_[e], hottest_[e]); !sentence.empty()) {
                sentences.push_back(std::move(sentence));
            }
        }
    }
    return sentences;
}

bool Rows::emit(double t, std::span<const double> T, std::span<const double> joules, double stored, bool field) {
    const auto begin = std::chrono::steady_clock::now();
    read(t);
    const bool go_on = *observer_ == nullptr || (*observer_)({.time = t,
                                                              .temperature = T,
                                                              .channels = channels_,
                                                              .watts = stepper_->watts(),
                                                              .joules = joules,
                                                              .stored = stored,
                                                              .field = field});
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return go_on;
}

bool Rows::emit_state(bool field) {
    return emit(stepper_->time(), stepper_->temperature(), stepper_->joules(), stepper_->stored(), field);
}

bool Rows::show() { return emit_state(true); }

bool Rows::emit_inside_step(double t) {
    stepper_->interpolate(t, field_);
    stepper_->interpolate_joules(t, joules_);
    const double stored = std::accumulate(joules_.begin(), joules_.end(), 0.0);
    return emit(t, field_, joules_, stored, field_due(t));
}

bool Rows::advance() {
    const Settings& settings = problem_->settings;
    const double t = stepper_->time();
    const bool at_end = t >= settings.end;
    if (settings.output_interval <= 0.0) {
        return emit_state(field_due(t) || at_end);
    }
    const double slack = 1e-9 * settings.output_interval;
    while (next_output_ < t - slack) {
        if (!emit_inside_step(next_output_)) {
            return false;
        }
        next_output_ = output_time(++outputs_);
    }
    const bool due = next_output_ <= t + slack;
    if (due) {
        next_output_ = output_time(++outputs_);
    }
    return !(due || at_end) || emit_state(field_due(t) || at_end);
}

/// Multiplied out, not summed up, so that late output times do not drift.
double Rows::output_time(long index) const {
    return problem_->settings.start + static_cast<double>(index) * problem_->settings.output_interval;
}

bool Rows::field_due(double t) {
    const Settings& settings = problem_->settings;
    const double interval = settings.field_interval;
    if (interval <= 0.0 || t < next_field_ - 1e-9 * interval) {
        return false;
    }
    next_field_ = settings.start + interval * (std::floor((t - settings.start) / interval + 1e-9) + 1.0);
    return true;
}

void Rows::visit(Archive& archive) {
    archive(next_output_);
    archive(next_field_);
    archive.whole(outputs_);
    readings_.visit(archive);
    archive(coldest_);
    archive(hottest_);
}

}  // namespace tiretherm::solver
