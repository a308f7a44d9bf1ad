// SPDX-License-Identifier: BSD-3-Clause
// A hypothesis of a diagnosis: the model with one or more missing effects, or an unknown heat source, switched on and
// fitted to the data.
#pragma once

#include <vector>

#include "diagnosis/detect/score_test_data.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::diagnosis {

/// One or more causes taken as true: the model with them, fitted in full, and what it leaves.
struct FittedHypothesis {
    std::vector<std::size_t> candidates;  ///< indices into ScoreTestData::candidates, one of each cause
    input::Experiment model;              ///< with the causes switched on, their numbers free after its own
    Refit fit;
    double gain = 0.0;                   ///< log likelihood ratio over the base model
    double largest_score = 0.0;          ///< that is left among the candidates
    double largest_unknown_score = 0.0;  ///< and among the unknown sources
    bool rest_is_insignificant = false;  ///< neither of the two is significant
    bool sound = false;                  ///< the fit ended, with every number on the side that physics allows
    /// Sound, no cause at the bound of what is plausible, and none that would hardly be missed: it may be in a verdict.
    bool admissible = false;
    bool plausible = true;  ///< every size is one that an engineer would believe: otherwise it is never alone in a set

    long simulations = 0;     ///< that its fit took
    Eigen::Index n_held = 0;  ///< numbers that causes hold on trial, free after all others

    /// Index of a cause's number among the fitted ones. @param i index into `candidates`
    [[nodiscard]] Eigen::Index number_of(std::size_t i) const;
};

/// The same, its simulations counted. Fits do not count their own, as several may be made at a time.
[[nodiscard]] FittedHypothesis counted(ScoreTestData& score_data, FittedHypothesis one);

/// Where the numbers of causes start, from where they are absent. A lag and a delay of one sensor have the same signature there: only their
/// sum is known, and an estimate may take a long lag and a clock that is early. Each takes half of the sum.
/// @param amplitudes [n_candidates] by the linearised model  @returns [n_candidates]
[[nodiscard]] std::vector<double> with_timing_shared(const ScoreTestData& score_data,
                                                     const std::vector<std::size_t>& candidates,
                                                     std::vector<double> amplitudes);
/// Causes switched on, their numbers free, not fitted yet.
[[nodiscard]] FittedHypothesis unfitted(const ScoreTestData& score_data, const std::vector<std::size_t>& candidates);
/// Switches causes on and fits. @param amplitudes where their numbers start
[[nodiscard]] FittedHypothesis fit_hypothesis(const ScoreTestData& score_data,
                                              const std::vector<std::size_t>& candidates,
                                              const std::vector<double>& amplitudes);

/// Every cause alone that the linearised model does not rule out, fitted: the most likely first.
[[nodiscard]] std::vector<FittedHypothesis> fit_single_causes(ScoreTestData& score_data);
/// Pairs of causes, likewise. @param least_gain pairs with a smaller predicted gain are left out
[[nodiscard]] std::vector<FittedHypothesis> fit_cause_pairs(ScoreTestData& score_data, double least_gain);

/// Heat that no effect of the catalogue is, as a source of the user's own at a place, following a signal or over a window
/// of one run; fitted in full. Its number, W, comes after the experiment's. Sensors have no such model: not sound.
[[nodiscard]] FittedHypothesis fit_unknown_source(const ScoreTestData& score_data, std::size_t term, double watts);
/// What is switched on for it in a run.
[[nodiscard]] solver::UserEffect user_effect(const ScoreTestData& score_data, std::size_t term, std::size_t run);

/// The noise beside the best hypothesis instead of beside the base model, where a large cause makes the linearisation
/// at the base model inaccurate.
/// @returns whether anything changed
bool settle_noise(ScoreTestData& score_data, const FittedHypothesis& best);

}  // namespace tiretherm::diagnosis
