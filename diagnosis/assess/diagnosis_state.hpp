// SPDX-License-Identifier: BSD-3-Clause
// Working state of a diagnosis, shared by its steps: score tests, fitted hypotheses, the set of hypotheses that remain,
// and the verdict.
#pragma once

#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/assess/fitted_hypothesis.hpp"

namespace tiretherm::diagnosis {

/// The strongest of the unknown sources.
struct MostSignificantTerm {
    std::size_t term = 0;
    double z = 0.0;

    [[nodiscard]] double gain() const { return 0.5 * z * z; }
};
[[nodiscard]] MostSignificantTerm most_significant_term(const Scores& scores);

/// State of a diagnosis: score tests, fitted hypotheses, verdict.
struct DiagnosisState {
    ScoreTestData score_data;
    std::vector<FittedHypothesis> singles;  ///< causes alone, the most likely first
    std::vector<FittedHypothesis> pairs;
    MostSignificantTerm unknown;
    FittedHypothesis unknown_fit;
    Verdict verdict = Verdict::cannot_tell;
    std::vector<const FittedHypothesis*> set;  ///< hypotheses that stand, the most likely first; point into the lists
    bool unknown_stands = false;               ///< the unknown source explains the data about as well as the set
    bool something_left = false;               ///< beside the best hypothesis

    /// The hypothesis that the model is extended with; null where there is none.
    [[nodiscard]] const FittedHypothesis* best() const;
};

/// Looks for hypotheses and decides between them: nothing, one cause, two causes, an unknown source.
void search_hypotheses(DiagnosisState& state);

/// Measures the gain run by run: each run in turn takes no part in choosing, sizing and fitting, and is then predicted from
/// the others, with how it started from itself. To first order about the two fitted models.
void measure_gain(const DiagnosisState& state, Diagnosis& into);

/// Simulates manoeuvres of a menu and says by how many standard deviations each would separate the likeliest
/// hypotheses.
void plan_next(const DiagnosisState& state, Diagnosis& into);

/// The missing heat that the residuals of the base model imply, by the adjoint of the discrete run: one run backwards
/// says for every place and moment how the likelihood would rise with heat there. What noise makes of it is drawn.
void estimate_missing_heat(const DiagnosisState& state, Diagnosis& into);

/// Writes what was found into a diagnosis.
void report(const DiagnosisState& state, Diagnosis& into);

}  // namespace tiretherm::diagnosis
