// SPDX-License-Identifier: BSD-3-Clause
// Floating forward selection of sets.

#include "diagnosis/quoted/set_search.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

/// Costs of sets, each asked for once.
class Sets {
public:
    explicit Sets(const SetSearch& search) : search_(search) {}

    double cost(AdditionSet set) {
        std::ranges::sort(set);
        const auto [found, is_new] = costs_.try_emplace(set, 0.0);
        if (is_new) {
            if (search_.prepare) {
                search_.prepare(set);
            }
            found->second = search_.cost(set);
        }
        return found->second;
    }
    [[nodiscard]] bool may_join(const AdditionSet& set, std::size_t addition) const {
        return std::ranges::none_of(
            set, [&](std::size_t one) { return one == addition || search_.are_one_cause(one, addition); });
    }
    /// The best of a set with one of the pool in addition; nothing where none may join.
    std::optional<AdditionSet> joined(const AdditionSet& set) {
        std::optional<AdditionSet> best;
        for (const std::size_t addition : search_.pool) {
            if (solver::stop_requested() || !may_join(set, addition)) {
                continue;
            }
            AdditionSet trial = set;
            trial.push_back(addition);
            if (!best || cost(trial) < cost(*best)) {
                best = std::move(trial);
            }
        }
        return best;
    }
    static AdditionSet without(AdditionSet set, std::size_t place) {
        set.erase(set.begin() + static_cast<std::ptrdiff_t>(place));
        return set;
    }

private:
    const SetSearch& search_;
    std::map<AdditionSet, double> costs_;
};

}  // namespace

std::vector<AdditionSet> best_sets(const SetSearch& search) {
    Sets sets(search);
    std::vector<AdditionSet> best{{}};
    while (best.size() <= search.most && !(search.is_enough && search.is_enough(best.back()))) {
        std::optional<AdditionSet> next = sets.joined(best.back());
        if (!next) {
            break;
        }
        // Each exchanged for another while that is better.
        for (bool moved = search.looks_back; moved;) {
            moved = false;
            for (std::size_t place = 0; place < next->size() && next->size() > 1; ++place) {
                const std::optional<AdditionSet> other = sets.joined(Sets::without(*next, place));
                if (other && sets.cost(*other) < sets.cost(*next)) {
                    next = other;
                    moved = true;
                }
            }
        }
        // Two may help of which neither does alone.
        if (next->size() > 2 && sets.cost(*next) >= (1.0 - search.least_gain) * sets.cost(best.back())) {
            break;
        }
        // What is left when one is dropped may be better than what was known of that size.
        for (std::size_t place = 0; search.looks_back && place < next->size(); ++place) {
            AdditionSet fewer = Sets::without(*next, place);
            if (sets.cost(fewer) < sets.cost(best.back())) {
                best.back() = std::move(fewer);
            }
        }
        if (search.is_enough && search.is_enough(best.back())) {
            break;
        }
        best.push_back(std::move(*next));
    }
    return best;
}

}  // namespace tiretherm::diagnosis::quoted
