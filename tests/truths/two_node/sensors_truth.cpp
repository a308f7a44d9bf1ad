// SPDX-License-Identifier: BSD-3-Clause
// Exact response of a first-order lag to cubics, then offset and gain; emissivity by Stefan and Boltzmann's law.

#include "two_node/sensors_truth.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace hidden_effects {

namespace {

constexpr double reference_of_gain = 298.15;  // K

double dot(const std::vector<double>& weights, const std::vector<double>& T) {
    return std::inner_product(weights.begin(), weights.end(), T.begin(), 0.0);
}

/// What a camera of wrong emissivity makes of a temperature, with T_air at rest.
Sensors::Course seen(double emissivity, double T_air, const Sensors::Course& of) {
    if (emissivity == 1.0) {
        return of;
    }
    const double fourth = emissivity * std::pow(of.value, 4) + (1.0 - emissivity) * std::pow(T_air, 4);
    const double value = std::pow(fourth, 0.25);
    return {value, emissivity * std::pow(of.value / value, 3) * of.rate};
}

/// tau y' = p - y over a step, p the cubic through its ends: y = p - tau p' + tau^2 p'' - tau^3 p''' + C exp(-t/tau).
double lagged(double before, double tau, double dt, const Sensors::Course& begin, const Sensors::Course& end) {
    const double chord = (end.value - begin.value) / dt;
    const double c = (3.0 * chord - 2.0 * begin.rate - end.rate) / dt;
    const double d = (begin.rate + end.rate - 2.0 * chord) / (dt * dt);
    const auto particular = [&](double t) {
        const double p = begin.value + t * (begin.rate + t * (c + t * d));
        const double first = begin.rate + t * (2.0 * c + 3.0 * d * t);
        const double second = 2.0 * c + 6.0 * d * t;
        return p - tau * (first - tau * (second - tau * 6.0 * d));
    };
    return particular(dt) + (before - particular(0.0)) * std::exp(-dt / tau);
}

}  // namespace

Sensors::Sensors(std::vector<std::vector<double>> places, std::vector<Reading> readings)
    : places_(std::move(places)), readings_(std::move(readings)), state_(places_.size()) {
    for (const Reading& reading : readings_) {
        lags_ = lags_ || reading.tau > 0.0;
    }
}

std::vector<Sensors::Course> Sensors::now(const std::vector<double>& T, const std::vector<double>& rate,
                                          double T_air) const {
    std::vector<Course> out;
    for (std::size_t c = 0; c < places_.size(); ++c) {
        const Course at{dot(places_[c], T), rate.empty() ? 0.0 : dot(places_[c], rate)};
        out.push_back(seen(readings_[c].emissivity, T_air, at));
    }
    return out;
}

void Sensors::start(const std::vector<Course>& at) {
    for (std::size_t c = 0; c < state_.size(); ++c) {
        state_[c] = at[c].value;
    }
}

void Sensors::follow(double dt, const std::vector<Course>& from, const std::vector<Course>& to) {
    for (std::size_t c = 0; c < state_.size(); ++c) {
        const double tau = readings_[c].tau;
        state_[c] = tau > 0.0 ? lagged(state_[c], tau, dt, from[c], to[c]) : to[c].value;
    }
}

double Sensors::shown(std::size_t c) const {
    const double shifted = state_[c] + readings_[c].kelvin;
    return shifted + readings_[c].excess * (shifted - reference_of_gain);
}

}  // namespace hidden_effects
