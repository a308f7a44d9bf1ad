// SPDX-License-Identifier: BSD-3-Clause
// Simulates pairs of additions and keeps what they change beyond the sum of both.

#include "diagnosis/quoted/interactions.hpp"

#include <algorithm>

#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

/// Instruments change what is read and no heat, and two inputs of one experiment are taken to add up.
bool can_interact(const Addition& one, const Addition& other) {
    const auto is_heat = [](const Addition& addition) {
        return addition.kind == AdditionKind::effect || addition.kind == AdditionKind::number;
    };
    const auto is_real = [](const Addition& addition) { return addition.kind != AdditionKind::instrument; };
    return is_real(one) && is_real(other) && (is_heat(one) || is_heat(other));
}

}  // namespace

Interactions::Interactions(const std::vector<Addition>& additions, const Numbers& numbers, Trials& trials)
    : additions_(additions), numbers_(numbers), trials_(trials) {}

Applied Interactions::at_reference(std::size_t addition) const {
    return {.addition = &additions_[addition], .value = additions_[addition].reference()};
}

const std::vector<double>& Interactions::alone(std::size_t addition) {
    const auto [found, is_new] = alone_.try_emplace(addition);
    if (is_new) {
        found->second = trials_.together({at_reference(addition)}, numbers_);
    }
    return found->second;
}

void Interactions::know(const std::vector<std::size_t>& set) {
    for (std::size_t i = 0; i < set.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (solver::stop_requested() || !can_interact(additions_[set[i]], additions_[set[j]])) {
                continue;
            }
            const auto [found, is_new] = pairs_.try_emplace(std::minmax(set[i], set[j]));
            if (!is_new) {
                continue;
            }
            const std::vector<double>& one = alone(set[i]);
            const std::vector<double>& other = alone(set[j]);
            std::vector<double> both = trials_.together({at_reference(set[i]), at_reference(set[j])}, numbers_);
            for (std::size_t r = 0; r < both.size() && !one.empty() && !other.empty(); ++r) {
                both[r] -= one[r] + other[r];
            }
            found->second = one.empty() || other.empty() ? std::vector<double>{} : std::move(both);
        }
    }
}

const std::vector<double>& Interactions::of(std::size_t one, std::size_t other) const {
    static const std::vector<double> nothing;
    const auto found = pairs_.find(std::minmax(one, other));
    return found == pairs_.end() ? nothing : found->second;
}

}  // namespace tiretherm::diagnosis::quoted
