// SPDX-License-Identifier: BSD-3-Clause
// Simpson's rule between logged samples gives mean and first moment of each coefficient; the slope is limited, and the
// largest integral left out is kept for the error estimate.

#include "solver/time_integration/step_forcing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tiretherm::solver {

namespace {

/// The inputs as they were, of logs that effects say are late; nothing where none is.
std::optional<InputSignals> in_time(const System& system, const InputSignals& logged) {
    std::optional<InputSignals> moved;
    for (const physics::ActiveEffect& active : system.effects()) {
        const physics::InputCorrection* correction = active.effect->input_correction();
        for (const physics::Signal& signal : physics::signals()) {
            const double delay =
                correction != nullptr && correction->delay != nullptr ? correction->delay(active, signal) : 0.0;
            if (delay != 0.0) {
                moved = moved ? std::move(moved) : logged;
                moved->advance(signal, delay);
            }
        }
    }
    return moved;
}

}  // namespace

StepForcing::StepForcing(const System& system, const InputSignals& input_signals, const Tableau& tableau,
                         KeptForcing* kept)
    : system_(&system),
      in_time_(in_time(system, input_signals)),
      input_signals_(in_time_ ? &*in_time_ : &input_signals),
      tableau_(&tableau),
      kept_(kept),
      stages_(static_cast<std::size_t>(tableau.stages), std::vector<double>(system.n_coefficients())),
      unresolved_(system.n_coefficients()) {
    nodes_.reserve(2 * input_signals.samples().size() + 3);
    values_.reserve(input_signals.samples().empty() ? 0 : 64 * system.n_coefficients());
}

void StepForcing::sample(double t, JumpSide side, std::span<double> out) const {
    system_->evaluate_coefficients(input_signals_->at(t, side), out);
}

void StepForcing::open(double t0, double t1) {
    ended_.reset();
    const std::vector<double>& samples = input_signals_->samples();
    const auto first = std::upper_bound(samples.begin(), samples.end(), t0) - samples.begin();
    const auto last = std::lower_bound(samples.begin(), samples.end(), t1) - samples.begin();
    averaged_ = last > first;
    if (averaged_) {
        if (kept_ != nullptr && kept_->is_closed() && kept_->take(t0, t1, stages_)) {
            return;
        }
        average(t0, t1, first, last);
        if (kept_ != nullptr && !kept_->is_closed()) {
            kept_->keep(t0, t1, stages_);
        }
        return;
    }
    for (int i = 0; i < tableau_->stages; ++i) {
        const double c = tableau_->c[static_cast<std::size_t>(i)];
        sample(i + 1 == tableau_->stages ? t1 : t0 + c * (t1 - t0), i == 0 ? JumpSide::after : JumpSide::before,
               stages_[static_cast<std::size_t>(i)]);
    }
}

void StepForcing::open(const physics::Inputs& from, const physics::Inputs& to) {
    averaged_ = false;
    const bool goes_on = ended_ && *ended_ == from;
    if (goes_on) {
        std::ranges::copy(stages_.back(), stages_.front().begin());
    }
    ended_ = to;
    for (std::size_t i = goes_on ? 1 : 0; i < stages_.size(); ++i) {
        const bool last = i + 1 == stages_.size();
        system_->evaluate_coefficients(last ? to : physics::between(from, to, tableau_->c[i]), stages_[i]);
    }
}

void StepForcing::average(double t0, double t1, std::ptrdiff_t first, std::ptrdiff_t last) {
    const std::vector<double>& samples = input_signals_->samples();
    nodes_.clear();
    nodes_.push_back(t0);
    for (std::ptrdiff_t i = first; i <= last; ++i) {
        const double next = i < last ? samples[static_cast<std::size_t>(i)] : t1;
        nodes_.push_back(0.5 * (nodes_.back() + next));
        nodes_.push_back(next);
    }
    const std::size_t n = system_->n_coefficients();
    values_.resize(nodes_.size() * n);
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        sample(nodes_[k], k == 0 ? JumpSide::after : JumpSide::before, std::span(values_).subspan(k * n, n));
    }
    const double width = t1 - t0;
    places_.resize(nodes_.size());
    widths_.resize(nodes_.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        places_[k] = (nodes_[k] - t0) / width;
        widths_[k] = k + 2 < nodes_.size() ? (nodes_[k + 2] - nodes_[k]) / width : 0.0;
    }
    for (std::size_t m = 0; m < n; ++m) {
        const auto value = [&](std::size_t k) { return values_[k * n + m]; };
        double mean = 0.0;
        double moment = 0.0;  // of x - 1/2, with x from 0 to 1 over the step
        double low = value(0);
        double high = value(0);
        for (std::size_t k = 0; k + 2 < nodes_.size(); k += 2) {
            const double dx = widths_[k];
            const auto arm = [&](std::size_t j) { return places_[j] - 0.5; };
            mean += dx / 6.0 * (value(k) + 4.0 * value(k + 1) + value(k + 2));
            moment += dx / 6.0 * (arm(k) * value(k) + 4.0 * arm(k + 1) * value(k + 1) + arm(k + 2) * value(k + 2));
            low = std::min({low, value(k + 1), value(k + 2)});
            high = std::max({high, value(k + 1), value(k + 2)});
        }
        // mean + slope (x - 1/2) has the moment slope / 12.
        const double side = 2.0 * std::min(high - mean, mean - low);
        const double slope = std::clamp(12.0 * moment, -std::max(side, 0.0), std::max(side, 0.0));
        for (std::size_t i = 0; i < stages_.size(); ++i) {
            stages_[i][m] = mean + slope * (tableau_->c[i] - 0.5);
        }
        double integral = 0.0;
        double largest = 0.0;
        for (std::size_t k = 0; k + 1 < nodes_.size(); ++k) {
            const double x0 = places_[k];
            const double x1 = places_[k + 1];
            const double left0 = value(k) - mean - slope * (x0 - 0.5);
            const double left1 = value(k + 1) - mean - slope * (x1 - 0.5);
            integral += 0.5 * (left0 + left1) * (x1 - x0);
            largest = std::max(largest, std::abs(integral));
        }
        unresolved_[m] = stages_[0][m] + largest;
    }
}

}  // namespace tiretherm::solver
