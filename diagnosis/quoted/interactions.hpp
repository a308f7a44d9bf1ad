// SPDX-License-Identifier: BSD-3-Clause
// What two additions change together beyond what each changes alone: heat that one path takes the other cannot take again.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "diagnosis/quoted/trials.hpp"

namespace tiretherm::diagnosis::quoted {

/// Pairs of additions, each simulated once, at the reference values of both, when it is first asked for; at other values it is
/// taken in proportion to how far either is from absent.
class Interactions {
public:
    /// All of these outlive it.
    Interactions(const std::vector<Addition>& additions, const Numbers& numbers, Trials& trials);

    /// Simulates the pairs of a set that are not known yet.
    /// @param set indices of additions
    void know(const std::vector<std::size_t>& set);
    /// @returns [rows]; empty: nothing, or not known
    [[nodiscard]] const std::vector<double>& of(std::size_t one, std::size_t other) const;

private:
    [[nodiscard]] Applied at_reference(std::size_t addition) const;
    [[nodiscard]] const std::vector<double>& alone(std::size_t addition);

    const std::vector<Addition>& additions_;
    const Numbers& numbers_;
    Trials& trials_;
    std::map<std::size_t, std::vector<double>> alone_;  ///< at the reference value
    std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> pairs_;
};

}  // namespace tiretherm::diagnosis::quoted
