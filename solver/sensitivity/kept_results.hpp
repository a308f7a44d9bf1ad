// SPDX-License-Identifier: BSD-3-Clause
// Results of simulations that an interrupted call has kept, found by the hash of what was asked.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solver/digest.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::solver {

/// Keeps results of simulations and gives them back, to the last bit. Several threads ask at a time.
class KeptResults {
public:
    KeptResults() = default;
    KeptResults(const KeptResults&) = delete;
    KeptResults& operator=(const KeptResults&) = delete;
    virtual ~KeptResults() = default;

    /// Whether there is anything to find or to be kept now; otherwise nobody need ask.
    [[nodiscard]] virtual bool is_active() = 0;
    [[nodiscard]] virtual std::optional<std::vector<double>> find(const Digest::Value& key) = 0;
    /// @param seconds that it took   Never throws: what cannot be kept is computed again.
    virtual void add(const Digest::Value& key, std::span<const double> result, double seconds) noexcept = 0;
};

/// Lets all predictions of the process look there first, as long as it lives. One at a time.
class UseOfKeptResults {
public:
    explicit UseOfKeptResults(KeptResults& results);
    ~UseOfKeptResults();
    UseOfKeptResults(const UseOfKeptResults&) = delete;
    UseOfKeptResults& operator=(const UseOfKeptResults&) = delete;
};

/// Those in use, or null.
[[nodiscard]] KeptResults* kept_results();

/// Hash of a problem, with all that it has, and of what is asked of it. @param request of the problem
[[nodiscard]] Digest::Value key_of(const Problem& problem, const PredictionRequest& request);

/// A prediction that came to its end as numbers.
[[nodiscard]] std::vector<double> numbers_of(const Prediction& prediction, const PredictionRequest& request);
/// The prediction that these numbers are; nothing where they do not fit what was asked.
[[nodiscard]] std::optional<Prediction> prediction_of(std::span<const double> numbers, const Problem& problem,
                                                      const PredictionRequest& request);

}  // namespace tiretherm::solver
