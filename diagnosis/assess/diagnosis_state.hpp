// SPDX-License-Identifier: BSD-3-Clause
// Working state of a diagnosis, shared by its steps: score tests, fitted hypotheses, the set of hypotheses that remain,
// and the verdict.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/assess/fitted_hypothesis.hpp"
#include "diagnosis/assess/prediction_search.hpp"
#include "diagnosis/assess/run_changes.hpp"
#include "input/parameters/mesh_change.hpp"

namespace tiretherm::diagnosis {

/// What is left this many times above a sensor's data sheet holds more than noise.
inline constexpr double swollen = 1.5;

/// What is left counts for as large as the noise up to this ratio: what parameters take of a tenth of all samples.
inline constexpr double as_large = 1.1;

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
    std::optional<PredictionSearch> search;    ///< where the model has errors of its own
    input::MeshChange change{};                ///< that makes the mesh
    std::string mesh{};                        ///< richer than the experiment's, that was taken; empty: none
    std::vector<std::string> other_meshes{};   ///< that predict better, too
    std::vector<TriedModel> tried{};           ///< by the searches by prediction on the mesh that was taken
    std::vector<RicherMesh> richer_meshes{};   ///< that were tried
    std::vector<RunChange> run_changes{};      ///< that all models have, each with a number of its runs
    std::optional<Refit> without_changes{};    ///< the base fit without them
    const input::Experiment* unchanged = nullptr;   ///< the experiment without them
    std::list<input::Experiment> changed_models{};  ///< with them: the experiment, then other meshes
    std::vector<Eigen::VectorXd> of_folds{};        ///< [n_folds][n] numbers of the best hypothesis without each fold

    /// The hypothesis that the model is extended with; null where there is none.
    [[nodiscard]] const FittedHypothesis* best() const;
};

/// Looks for hypotheses and decides between them: nothing, one cause, two causes, an unknown source.
void search_hypotheses(DiagnosisState& state);

/// Whether the residuals hold more than the sensors' noise whatever the candidates explain: noise far above the data sheet's,
/// or without one as slow as is allowed.
[[nodiscard]] bool has_model_error(const ScoreTestData& score_data);

/// Whether the model has errors beside any cause: that were looked for by prediction, or are left, or show in the noise.
[[nodiscard]] bool is_doubted(const DiagnosisState& state);

/// Whether a channel's noise is plainly larger than the data sheet says: the fitted base leaves no more than the noise that is
/// estimated beside all that any candidate could explain, and that is of short correlation.
[[nodiscard]] bool is_plainly_noise(const ScoreTestData& score_data, std::size_t c);

/// The channels whose noise is plainly above the data sheet; nothing where there is none.
[[nodiscard]] std::optional<Remark> noise_above_sheet(const ScoreTestData& score_data);

/// Searches causes by what they predict, on richer meshes as well, and takes what is found as the verdict.
void search_beside_model_error(DiagnosisState& state, const std::vector<RicherModel>& richer);

/// False where heat that no effect is was found by its likelihood, and data that were left out are predicted no better with it.
[[nodiscard]] bool unknown_source_predicts(DiagnosisState& state);
/// Where a search by prediction found no cause: takes heat that no effect is, if data that were left out are predicted better
/// with it than with the best base.
void accept_unknown_source(DiagnosisState& state);
/// Where something is left beside what was found by its likelihood: takes what a search by prediction finds, if that predicts
/// better; otherwise what was found stays, as the largest part of what is missing.
void search_for_more(DiagnosisState& state, const std::vector<RicherModel>& richer);

/// Takes the causes that a search by prediction has accepted so far as the verdict.
void take_what_was_found(DiagnosisState& state);
/// Candidates with the largest scores, one of each cause. @returns indices into ScoreTestData::candidates
[[nodiscard]] std::vector<std::size_t> by_score(const ScoreTestData& score_data, std::size_t most);

/// Measures the gain run by run: each run in turn takes no part in sizing and fitting, and is then predicted from the
/// others, with how it started from itself. A verdict that the prediction does not bear out becomes `partial`.
void measure_gain(DiagnosisState& state, Diagnosis& into);

/// A comparison of predictions as the gain of an answer.
void take_gain(const PredictionGain& gain, Gain& into);
/// Whether a gain is large enough to confirm what is beyond chance: odds of 100 and more, the greater part of each sensor's error, and at
/// no cost.
[[nodiscard]] bool is_confirmed(const PredictionGain& gain, const Gain& taken);

/// What is left of each channel beyond its noise, and the free numbers with the intervals that this leaves them.
void describe_model_error(const DiagnosisState& state, Diagnosis& into);

/// Simulates the manoeuvres that are possible and says by how many standard deviations each would separate the likeliest explanations:
/// those of the set; of fewer than two also what was tried, or the largest that the data allow.
void plan_next(const DiagnosisState& state, Diagnosis& into);

/// The missing heat that the residuals of the base model imply, beside its free numbers: the heat at a place in all windows of all
/// runs, together, from what each watt would do to the readings.
void estimate_missing_heat(const DiagnosisState& state, Diagnosis& into);

/// Writes what was found into a diagnosis.
void report(const DiagnosisState& state, Diagnosis& into);

}  // namespace tiretherm::diagnosis
