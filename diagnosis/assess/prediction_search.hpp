// SPDX-License-Identifier: BSD-3-Clause
// Search of causes by what they predict: for data whose largest part no single cause explains, so that the model has errors
// of its own beside any cause.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/assess/fitted_hypothesis.hpp"
#include "diagnosis/assess/prediction_gain.hpp"

namespace tiretherm::diagnosis {

/// A model fitted to everything, and what it gets wrong of data that were left out.
struct PredictedModel {
    FittedHypothesis hypothesis{};
    HeldOutErrors out{};
    Covariance noise{};  ///< by which it was fitted
    BaseModel base = BaseModel::none;
    std::string mesh{};  ///< of a base on another mesh
};

/// A cause, or several, that predict better than what they were added to.
struct Improvement {
    PredictedModel model;
    PredictionGain gain{};  ///< over the model before
};

/// Causes at sizes that the data gave them.
struct SizedCauses {
    std::vector<std::size_t> candidates;  ///< indices into ScoreTestData::candidates
    std::vector<double> values;           ///< of their numbers
};

/// An addition that was fitted.
struct TriedModel {
    TriedAddition addition;
    SizedCauses model{};  ///< all causes of the model with it
};

/// What a search by prediction found.
struct PredictionSearch {
    PredictedModel base;  ///< the best predicting of the case as it stands, fitted with slow noise, with white
    bool white = false;   ///< white noise predicts better than correlated noise
    std::vector<Improvement> accepted;      ///< one after another, each with all before it
    std::vector<Improvement> alternatives;  ///< that do as well as the first accepted one, as far as these data tell
    PredictionGain gain{};                  ///< of the last accepted over the base
    std::string mesh;                       ///< of the richer model that was accepted; empty: none
    Remarks remarks;                        ///< sizes nobody would believe, channels that get worse
    std::vector<TriedModel> tried;          ///< what was fitted, in this order

    [[nodiscard]] const PredictedModel& best() const { return accepted.empty() ? base : accepted.back().model; }
};

/// A fitted model with what it gets wrong of data that were left out. @param fitted false: its numbers are the case's own
[[nodiscard]] PredictedModel predicted(ScoreTestData& score_data, FittedHypothesis hypothesis, Covariance noise,
                                       bool fitted = true);
/// Noise by which a model is fitted in the search: white, so that every channel counts alike.
[[nodiscard]] Covariance alike(const FittedHypothesis& model, const Observations& observations);

/// What stands against a gain: it must be beyond chance, worth a number, and at the cost of no channel; of no run either, where it is
/// small. @param beyond_doubt share of the mean square that the low end of its interval must be above
[[nodiscard]] AdditionDoubt doubt_of(const PredictionGain& gain, double beyond_doubt = 0.0);
[[nodiscard]] bool is_improvement(const PredictionGain& gain, double beyond_doubt = 0.0);

/// Which of the case as it stands, the fit with correlated noise and the fit with white noise predicts data that were left
/// out best. @param score_data of the base model, with correlated noise
[[nodiscard]] PredictionSearch choose_base(ScoreTestData& score_data);

/// Adds causes, each time the addition that predicts best of those that the linearised model promises most of, and timing of sensors and
/// inputs whatever is promised. An addition is accepted while what it predicts of data that were left out is an improvement, and its
/// sizes are ones that can be. Causes that later ones make superfluous are dropped, or swapped for better ones.
/// @param search as choose_base gives it
void search_by_prediction(ScoreTestData& score_data, PredictionSearch& search);

}  // namespace tiretherm::diagnosis
