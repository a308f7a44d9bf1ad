// SPDX-License-Identifier: BSD-3-Clause
// Search over sets of additions: adds the best, drops what later ones make superfluous, and exchanges, size by size.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "diagnosis/quoted/held_out.hpp"

namespace tiretherm::diagnosis::quoted {

/// What is searched.
struct SetSearch {
    AdditionSet pool;                                             ///< additions that may be in a set
    std::size_t most = 0;                                         ///< additions in a set
    std::function<bool(std::size_t, std::size_t)> are_one_cause;  ///< which of them do not go together
    std::function<void(const AdditionSet&)> prepare{};            ///< called before a set's cost is asked for
    std::function<double(const AdditionSet&)> cost;               ///< what is to be least
    std::function<bool(const AdditionSet&)> is_enough{};          ///< no more are added to such a set; empty: never
    double least_gain = 0.0;  ///< share of the cost by which a larger set must be better
    bool looks_back = true;   ///< drops and exchanges, or only adds
};

/// The best sets of 0, 1, 2 ... additions (floating search: Pudil, Novovicova & Kittler, Pattern Recognition Letters 15, 1994,
/// 1119). It ends where one more is worth nothing, but not before two.
/// @returns [sizes], the empty set first
[[nodiscard]] std::vector<AdditionSet> best_sets(const SetSearch& search);

}  // namespace tiretherm::diagnosis::quoted
