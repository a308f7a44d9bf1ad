#include "solver/input_signals.hpp"

#include <algorithm>
#include <iterator>

namespace tiretherm::solver {

double Series::at(double t, JumpSide side) const {
    const auto next = side == JumpSide::after ? std::upper_bound(time.begin(), time.end(), t)
                                              : std::lower_bound(time.begin(), time.end(), t);
    if (next == time.begin()) {
        return value.front();
    }
    if (next == time.end()) {
        return value.back();
    }
    const auto i = static_cast<std::size_t>(next - time.begin());
    if (time[i] == t) {  // to the last digit the same from both sides
        return value[i];
    }
    const double width = time[i] - time[i - 1];
    return width > 0.0 ? value[i - 1] + (value[i] - value[i - 1]) * (t - time[i - 1]) / width : value[i];
}

void InputSignals::add(const physics::Signal& signal, double constant) {
    constants_.*signal.member = constant;
    given_.push_back(&signal);
}

void InputSignals::add(Series series) {
    given_.push_back(series.signal);
    std::vector<double> stops;
    std::vector<double> samples;
    for (std::size_t i = 0; i < series.time.size(); ++i) {
        const bool jump = i > 0 && series.time[i] == series.time[i - 1];
        (series.logged && !jump ? samples : stops).push_back(series.time[i]);
    }
    const auto merge = [](std::vector<double>& all, const std::vector<double>& more) {
        std::vector<double> merged;
        std::set_union(all.begin(), all.end(), more.begin(), more.end(), std::back_inserter(merged));
        merged.erase(std::unique(merged.begin(), merged.end()), merged.end());
        all = std::move(merged);
    };
    merge(stops_, stops);
    merge(samples_, samples);
    series_.push_back(std::move(series));
}

bool InputSignals::gives(const physics::Signal& signal) const {
    return std::find(given_.begin(), given_.end(), &signal) != given_.end();
}

physics::Inputs InputSignals::at(double t, JumpSide side) const {
    physics::Inputs inputs = constants_;
    inputs.time = t - start_;
    for (const Series& s : series_) {
        inputs.*(s.signal->member) = s.at(t, side);
    }
    return inputs;
}

}  // namespace tiretherm::solver
