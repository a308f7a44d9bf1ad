// SPDX-License-Identifier: BSD-3-Clause
// Evaluates value, mean, maximum, minimum or time to a share of the change, with straight lines between rows.

#include "input/validation/trace.hpp"

#include <algorithm>

#include "physics/bracket.hpp"

namespace tiretherm::input {

void Trace::take(const solver::Snapshot& snapshot) {
    width_ = snapshot.channels.size();
    time_.push_back(snapshot.time);
    value_.insert(value_.end(), snapshot.channels.begin(), snapshot.channels.end());
}

void Trace::correct(std::size_t channel, double factor, double about, double offset) {
    for (std::size_t row = 0; row < rows(); ++row) {
        double& value = value_[row * width_ + channel];
        value = about + factor * (value - about) + offset;
    }
}

double Trace::at(std::size_t channel, double t) const {
    return physics::bracket(time_, t).between([&](std::size_t row) { return value_[row * width_ + channel]; });
}

std::vector<double> Trace::corners(double from, double to) const {
    std::vector<double> times{from};
    std::copy_if(time_.begin(), time_.end(), std::back_inserter(times), [&](double t) { return t > from && t < to; });
    times.push_back(to);
    return times;
}

double Trace::read(std::size_t channel, const Window& window) const {
    const double first = at(channel, window.from);
    const double last = at(channel, window.to);
    if (window.take == Window::Take::at || window.to <= window.from) {
        return window.take == Window::Take::time_to ? 0.0 : last;
    }
    const double aim = first + window.share * (last - first);
    double area = 0.0;
    double high = first;
    double low = first;
    double t_before = window.from;
    double before = first;
    for (const double t : corners(window.from, window.to)) {
        const double now = at(channel, t);
        if (window.take == Window::Take::time_to && (last - first) * (now - aim) >= 0.0) {
            const double part = now == before ? 0.0 : (aim - before) / (now - before);
            return t_before + part * (t - t_before) - window.from;
        }
        area += 0.5 * (before + now) * (t - t_before);
        high = std::max(high, now);
        low = std::min(low, now);
        t_before = t;
        before = now;
    }
    switch (window.take) {
        case Window::Take::mean:
            return area / (window.to - window.from);
        case Window::Take::max:
            return high;
        case Window::Take::min:
            return low;
        case Window::Take::at:
        case Window::Take::time_to:
            break;
    }
    return window.take == Window::Take::time_to ? window.to - window.from : last;
}

}  // namespace tiretherm::input
