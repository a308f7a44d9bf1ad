// SPDX-License-Identifier: BSD-3-Clause
// All that Rao's score tests of a fitted model need: noise, residuals, whitened signatures of the candidate effects and
// unknown sources, and thresholds.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/detect/candidate_sources.hpp"
#include "diagnosis/detect/candidates.hpp"
#include "diagnosis/detect/scores.hpp"
#include "diagnosis/detect/work_ahead.hpp"
#include "diagnosis/fit/refit.hpp"
#include "diagnosis/remarks/stage.hpp"

namespace tiretherm::diagnosis {

/// Score tests of a fitted model against measured data: the noise, and the signature of every effect that may be
/// missing.
struct ScoreTestData {
    solver::Status status;
    const input::Experiment* experiment = nullptr;
    const Observations* observations = nullptr;
    Refit base;
    Covariance noise;
    std::vector<std::vector<double>> steps;  ///< [n_runs] s, ends of the steps that every run takes

    std::vector<Candidate> candidates;
    Eigen::VectorXi sign;        ///< [n_candidates] to which side of absent they may go; 0: either
    Eigen::MatrixXd signatures;  ///< [n_rows][n_candidates] SI per unit of the candidate's number
    Eigen::MatrixXd columns;     ///< the same, whitened
    CandidateSources unknowns;
    Eigen::MatrixXd unknown_columns;  ///< [n_rows][n_terms] whitened

    Scores scores;  ///< of the candidates against the base model
    Scores unknown_scores;
    double threshold = 0.0;  ///< that the largest score of a sound model exceeds by chance twice in a thousand times
    double unknown_threshold = 0.0;
    /// Indices of candidates that two causes can be distinguished by, and the gain that the best of these pairs has by
    /// chance as rarely. Two causes that hide each other are seen by this alone.
    std::vector<Pair> pairs;
    double pair_threshold = 0.0;
    long simulations = 0;
    Progress progress{};
    Activity stage{};
    Course course{};
    std::chrono::steady_clock::time_point stage_begin{};  ///< of its first piece

    void count(long more);
    /// Says what is being done from now on.
    void say(Activity what);
    /// How long the rest of the stage takes, if its pieces take alike. @returns s; NaN before the first piece is done
    [[nodiscard]] double rest_of_stage() const;
    /// Scores of the candidates and of the unknown sources against another model.
    [[nodiscard]] Scores scores_after(const Refit& model) const;
    [[nodiscard]] Scores unknown_scores_after(const Refit& model) const;
    /// Combinations of all signatures that stand for nearly all of what they span beside a model's free numbers.
    /// @returns [n_rows][as many as it takes] SI
    [[nodiscard]] Eigen::MatrixXd principal_signatures(const Refit& model) const;
    /// Repeats all score tests with another noise. @param refitted the base model fitted with it
    void take_noise(Covariance found, Refit refitted);
    /// The same for other measured values. The signatures stay: a correction of the data does not change them.
    /// @param corrected lives longer
    void take_observations(const Observations& corrected);
};

/// Fits the base model with the noise that is most likely whatever is missing, and takes every signature.
/// @param experiment, observations live longer  @param candidates causes that may be missing
[[nodiscard]] ScoreTestData prepare_score_tests(const input::Experiment& experiment, const Observations& observations,
                                                std::vector<Candidate> candidates, Progress progress = {});
/// The same into what the caller has, which keeps what there is when the work is stopped: first the base model as it stands,
/// then as it is fitted.
void prepare_score_tests(const input::Experiment& experiment, const Observations& observations,
                         std::vector<Candidate> candidates, ScoreTestData& score_data);

}  // namespace tiretherm::diagnosis
