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
      logged_(&input_signals),
      tableau_(&tableau),
      kept_(kept),
      stages_(static_cast<std::size_t>(tableau.stages), std::vector<double>(system.n_coefficients())),
      unresolved_(system.n_coefficients()) {}

void StepForcing::open(double t0, double t1) {
    ended_.reset();
    begin_ = t0;
    end_ = t1;
    moments_.clear();
    const std::vector<double>& samples = logged_->samples();
    const auto after = std::upper_bound(samples.begin(), samples.end(), t0);
    averaged_ = after != samples.end() && *after < t1;
    if (averaged_ && kept_ != nullptr && kept_->is_closed() && kept_->take(t0, t1, stages_)) {
        return;
    }
    find_moments();
    find_stages(*this, system_->with_coefficients());
    if (averaged_ && kept_ != nullptr && !kept_->is_closed()) {
        kept_->keep(t0, t1, stages_);
    }
}

void StepForcing::open_beside(StepForcing& opened, std::span<const std::size_t> which) {
    if (opened.moments_.empty()) {
        opened.find_moments();
    }
    averaged_ = opened.averaged_;
    stages_ = opened.stages_;
    find_stages(opened, which);
}

/// Inputs and laws at the samples within the step and half way between them, or at its stages.
void StepForcing::find_moments() {
    if (input_signals_ == nullptr) {
        in_time_ = in_time(*system_, *logged_);
        input_signals_ = in_time_ ? &*in_time_ : logged_;
    }
    nodes_.clear();
    if (averaged_) {
        const std::vector<double>& samples = logged_->samples();
        nodes_.push_back(begin_);
        const auto first = std::upper_bound(samples.begin(), samples.end(), begin_);
        const auto last = std::lower_bound(first, samples.end(), end_);
        const auto add = [&](double end) {
            nodes_.push_back(0.5 * (nodes_.back() + end));
            nodes_.push_back(end);
        };
        std::for_each(first, last, add);
        add(end_);
    } else {
        for (int i = 0; i + 1 < tableau_->stages; ++i) {
            nodes_.push_back(begin_ + tableau_->c[static_cast<std::size_t>(i)] * (end_ - begin_));
        }
        nodes_.push_back(end_);
    }
    moments_.clear();
    for (const double t : nodes_) {
        const JumpSide side = moments_.empty() ? JumpSide::after : JumpSide::before;
        Moment& now = moments_.emplace_back();
        now.inputs = system_->transformed(input_signals_->at(t, side));
        now.laws = system_->laws(now.inputs);
    }
    const double width = end_ - begin_;
    places_.resize(nodes_.size());
    widths_.resize(nodes_.size());
    for (std::size_t k = 0; averaged_ && k < nodes_.size(); ++k) {
        places_[k] = (nodes_[k] - begin_) / width;
        widths_[k] = k + 2 < nodes_.size() ? (nodes_[k + 2] - nodes_[k]) / width : 0.0;
    }
}

/// @param moments what has found them  @param which effects, of which the coefficients are found
void StepForcing::find_stages(const StepForcing& moments, std::span<const std::size_t> which) {
    const std::size_t n = system_->n_coefficients();
    values_.resize(averaged_ ? moments.nodes_.size() * n : 0);
    for (std::size_t k = 0; k < moments.moments_.size(); ++k) {
        const Moment& now = moments.moments_[k];
        const std::span<double> out = averaged_ ? std::span(values_).subspan(k * n, n) : std::span(stages_[k]);
        system_->evaluate_coefficients(which, now.inputs, now.laws, out);
    }
    for (std::size_t i = 0; averaged_ && i < which.size(); ++i) {
        const std::size_t first = system_->first_coefficient(which[i]);
        const auto own = static_cast<std::size_t>(system_->effects()[which[i]].effect->n_coefficients());
        for (std::size_t column = first; column < first + own; ++column) {
            average(moments, column);
        }
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

void StepForcing::average(const StepForcing& moments, std::size_t column) {
    const std::size_t n = system_->n_coefficients();
    const std::vector<double>& places = moments.places_;
    const auto value = [&](std::size_t k) { return values_[k * n + column]; };
    double mean = 0.0;
    double moment = 0.0;  // of x - 1/2, with x from 0 to 1 over the step
    double low = value(0);
    double high = value(0);
    for (std::size_t k = 0; k + 2 < places.size(); k += 2) {
        const double dx = moments.widths_[k];
        const auto arm = [&](std::size_t j) { return places[j] - 0.5; };
        mean += dx / 6.0 * (value(k) + 4.0 * value(k + 1) + value(k + 2));
        moment += dx / 6.0 * (arm(k) * value(k) + 4.0 * arm(k + 1) * value(k + 1) + arm(k + 2) * value(k + 2));
        low = std::min({low, value(k + 1), value(k + 2)});
        high = std::max({high, value(k + 1), value(k + 2)});
    }
    // mean + slope (x - 1/2) has the moment slope / 12.
    const double side = 2.0 * std::min(high - mean, mean - low);
    const double slope = std::clamp(12.0 * moment, -std::max(side, 0.0), std::max(side, 0.0));
    for (std::size_t i = 0; i < stages_.size(); ++i) {
        stages_[i][column] = mean + slope * (tableau_->c[i] - 0.5);
    }
    double integral = 0.0;
    double largest = 0.0;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        const double x0 = places[k];
        const double x1 = places[k + 1];
        const double left0 = value(k) - mean - slope * (x0 - 0.5);
        const double left1 = value(k + 1) - mean - slope * (x1 - 0.5);
        integral += 0.5 * (left0 + left1) * (x1 - x0);
        largest = std::max(largest, std::abs(integral));
    }
    unresolved_[column] = stages_[0][column] + largest;
}

}  // namespace tiretherm::solver
