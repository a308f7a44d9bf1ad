// SPDX-License-Identifier: BSD-3-Clause
// Appends the coefficients of each step to one list, and copies them from there.

#include "solver/time_integration/kept_forcing.hpp"

#include <algorithm>

namespace tiretherm::solver {

namespace {

constexpr std::size_t most_values = 4'000'000;

}  // namespace

void KeptForcing::keep(double begin, double end, const Stages& stages) {
    if (!steps_.empty() && steps_.back().begin == begin) {
        values_.resize(steps_.back().first);
        steps_.pop_back();
    }
    if (values_.size() + stages.size() * stages.front().size() > most_values) {
        return;
    }
    steps_.push_back({.begin = begin, .end = end, .first = values_.size()});
    for (const std::vector<double>& stage : stages) {
        values_.insert(values_.end(), stage.begin(), stage.end());
    }
}

bool KeptForcing::take(double begin, double end, Stages& stages) {
    while (next_ < steps_.size() && steps_[next_].begin < begin) {
        ++next_;
    }
    if (next_ == steps_.size() || steps_[next_].begin != begin || steps_[next_].end != end) {
        return false;
    }
    const std::size_t last = next_ + 1 < steps_.size() ? steps_[next_ + 1].first : values_.size();
    auto from = values_.begin() + static_cast<std::ptrdiff_t>(steps_[next_].first);
    if (last - steps_[next_].first != stages.size() * stages.front().size()) {
        return false;
    }
    for (std::vector<double>& stage : stages) {
        std::copy_n(from, stage.size(), stage.begin());
        from += std::ssize(stage);
    }
    return true;
}

}  // namespace tiretherm::solver
