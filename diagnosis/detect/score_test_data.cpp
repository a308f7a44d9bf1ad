// SPDX-License-Identifier: BSD-3-Clause
// Fits base model and noise until they agree, takes the signatures of all candidates by slopes or differences, and
// whitens them.

#include "diagnosis/detect/score_test_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "diagnosis/fit/refinement.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr int most_turns = 4;
constexpr double settled_noise = 0.01;
/// A combination of signatures that is this small a part of all of them counts as noise's.
constexpr double least_part = 0.01;
constexpr double chance = 0.002;
/// Two signatures that are this much alike are no pair.
constexpr double alike = 0.995;
/// Windows of a run in which heat of its own is looked for.
constexpr int windows = 16;
/// A perturbed model works out what all its effects do over every sample of the log: on few nodes, where that is what a slope
/// costs, so many candidates are switched on together; on a grid the march is, and all are.
constexpr std::size_t most_together = 12;
constexpr int few_nodes = 50;

Eigen::MatrixXd whitened(const ScoreTestData& score_data, Eigen::MatrixXd columns) {
    whiten(score_data.observations->blocks, score_data.noise, columns);
    return columns;
}

/// Whether a candidate brings a node of its own, such as the rim. Others act on that node where it is there, as heat of the brakes
/// does: beside each other they would not be the causes that they are alone.
bool brings_a_node(const Candidate& candidate) {
    const physics::HeatEffect* heat = candidate.effect->heat_effect();
    return heat != nullptr && heat->extend != nullptr;
}

/// Slopes of some candidates, all in one run, into their columns. @param chosen indices  @returns simulations, not counted yet
long take_slopes(const input::Experiment& still, std::span<const std::size_t> chosen, ScoreTestData& score_data) {
    std::vector<Candidate> linear;
    std::vector<double> absent;
    for (const std::size_t k : chosen) {
        linear.push_back(score_data.candidates[k]);
        absent.push_back(score_data.candidates[k].absent);
    }
    const input::Experiment wide = with(still, linear, absent);
    Simulator all(wide, *score_data.observations);
    all.take_steps(score_data.steps);
    const ModelPrediction& slopes = all.at(all.start());
    for (std::size_t i = 0; i < chosen.size() && slopes.status.ok(); ++i) {
        score_data.signatures.col(static_cast<Eigen::Index>(chosen[i])) =
            slopes.slope.col(static_cast<Eigen::Index>(i));
    }
    return all.simulations();
}

/// The difference that one candidate makes, into its column. @returns simulations, not counted yet
long take_difference(const input::Experiment& still, std::size_t k, const Eigen::VectorXd& simulated,
                     ScoreTestData& score_data) {
    const Candidate& candidate = score_data.candidates[k];
    input::Experiment moved = with(still, {candidate}, {candidate.trial});
    moved.parameters.clear();
    Simulator one(moved, *score_data.observations);
    one.take_steps(score_data.steps);
    if (const ModelPrediction& there = one.at(one.start()); there.status.ok()) {
        score_data.signatures.col(static_cast<Eigen::Index>(k)) =
            (there.simulated - simulated) / (candidate.trial - candidate.absent);
    }
    return one.simulations();
}

/// Signatures of the candidates: slopes together, differences one by one. A candidate whose model fails has none.
void take_signatures(const input::Experiment& still, const Eigen::VectorXd& simulated, ScoreTestData& score_data) {
    std::vector<std::size_t> on_the_mesh;
    std::vector<std::size_t> with_nodes;
    std::vector<std::size_t> alone;
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
        if (const Candidate& candidate = score_data.candidates[k]; candidate.by_slope()) {
            (brings_a_node(candidate) ? with_nodes : on_the_mesh).push_back(k);
        } else {
            alone.push_back(k);
        }
    }
    score_data.signatures.setZero(simulated.size(), static_cast<Eigen::Index>(score_data.candidates.size()));
    const bool is_small = still.runs.front().problem.mesh.n_nodes <= few_nodes;
    std::vector<std::span<const std::size_t>> together;
    for (const std::vector<std::size_t>* chosen : {&on_the_mesh, &with_nodes}) {
        const std::size_t parts = is_small ? (chosen->size() + most_together - 1) / most_together : 1;
        for (std::size_t part = 0; part < parts && !chosen->empty(); ++part) {
            const std::size_t first = part * chosen->size() / parts;
            const std::size_t last = (part + 1) * chosen->size() / parts;
            together.push_back(std::span(*chosen).subspan(first, last - first));
        }
    }
    std::vector<long> simulations(std::max(together.size(), alone.size()));
    in_parallel(together.size(), [&](std::size_t i) { simulations[i] = take_slopes(still, together[i], score_data); });
    score_data.count(std::accumulate(simulations.begin(), simulations.end(), 0L));
    const auto at_once = static_cast<std::size_t>(threads_for(alone.size()));
    for (std::size_t first = 0; first < alone.size(); first += at_once) {
        score_data.say({.doing = Work::signature,
                        .of = name_of(score_data.candidates[alone[first]], *score_data.experiment),
                        .number = first + 1,
                        .count = alone.size()});
        simulations.assign(std::min(at_once, alone.size() - first), 0);
        in_parallel(simulations.size(), [&](std::size_t i) {
            simulations[i] = take_difference(still, alone[first + i], simulated, score_data);
        });
        score_data.count(std::accumulate(simulations.begin(), simulations.end(), 0L));
    }
}

/// Finds noise and base fit that belong together, and all that is tested with them.
void settle(ScoreTestData& score_data) {
    Fit fit(*score_data.experiment, *score_data.observations);
    fit.simulator().take_steps(score_data.steps);
    fit.take_covariance(score_data.noise);
    if (!fit.move_to(score_data.base.values)) {
        score_data.status = fit.now().status;
        return;
    }
    score_data.base = refit(fit);
    for (int turn = 0; turn < most_turns && score_data.base.status.ok(); ++turn) {
        const Covariance before = fit.covariance();
        fit.find_noise(score_data.principal_signatures(score_data.base));
        score_data.noise = fit.covariance();
        score_data.base = refit(fit);
        if (turn > 0 && change(before, score_data.noise) < settled_noise) {
            break;
        }
    }
    score_data.count(fit.simulator().simulations());
    score_data.status = score_data.base.status;
    if (score_data.status.ok()) {
        score_data.take_noise(score_data.noise, score_data.base);
    }
}

Scores scores_against(const Refit& model, const Eigen::MatrixXd& columns) {
    const NuisanceProjector projector(model.slopes, model.precision);
    return score(projector.project(columns), projector.project(model.residual, model.known), columns.colwise().norm());
}

}  // namespace

void ScoreTestData::count(long more) {
    simulations += more;
    if (progress) {
        progress(stage, simulations);
    }
}

void ScoreTestData::say(Activity what) {
    stage = std::move(what);
    stage.ahead = work_ahead(course, stage);
    if (stage.number <= 1) {
        stage_begin = std::chrono::steady_clock::now();
    }
    count(0);
}

double ScoreTestData::rest_of_stage() const {
    if (stage.number < 2) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - stage_begin;
    const double pieces = static_cast<double>(stage.count - stage.number + 1) / static_cast<double>(stage.number - 1);
    return passed.count() * pieces;
}

Scores ScoreTestData::scores_after(const Refit& model) const { return scores_against(model, columns); }

Scores ScoreTestData::unknown_scores_after(const Refit& model) const { return scores_against(model, unknown_columns); }

Eigen::MatrixXd ScoreTestData::principal_signatures(const Refit& model) const {
    // Events are left out: there are many of them, and together they could make up any slow noise.
    Eigen::MatrixXd raw(signatures.rows(), signatures.cols() + unknowns.n_followers);
    raw << signatures, unknowns.columns.leftCols(unknowns.n_followers);
    const Eigen::MatrixXd all = whitened(*this, raw);
    const Eigen::MatrixXd left = NuisanceProjector(model.slopes, model.precision).project(all);
    // Of what the model itself has, as a cause that is switched on in it, round-off is left.
    Eigen::VectorXd inverse = left.colwise().norm();
    for (Eigen::Index k = 0; k < inverse.size(); ++k) {
        inverse[k] = inverse[k] > least_share * all.col(k).norm() ? 1.0 / inverse[k] : 0.0;
    }
    const Eigen::MatrixXd unit = left * inverse.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(Eigen::MatrixXd(unit.transpose() * unit));
    const Eigen::Index n = (parts.eigenvalues().array() > least_part).cast<Eigen::Index>().sum();
    return raw * inverse.asDiagonal() * parts.eigenvectors().rightCols(n);
}

void ScoreTestData::take_noise(Covariance found, Refit refitted) {
    noise = std::move(found);
    base = std::move(refitted);
    columns = whitened(*this, signatures);
    unknown_columns = whitened(*this, unknowns.columns);
    scores = scores_after(base);
    unknown_scores = unknown_scores_after(base);
    threshold = family_threshold(scores.correlation, sign, chance);
    unknown_threshold =
        family_threshold(unknown_scores.correlation, Eigen::VectorXi::Zero(unknown_scores.z.size()), chance);
    pairs.clear();
    for (Eigen::Index b = 0; b < scores.z.size(); ++b) {
        for (Eigen::Index a = 0; a < b; ++a) {
            const bool seen = scores.length[a] > 0.0 && scores.length[b] > 0.0;
            const bool two =
                can_stand_beside(candidates[static_cast<std::size_t>(a)], candidates[static_cast<std::size_t>(b)]);
            if (seen && two && std::abs(scores.correlation(a, b)) < alike) {
                pairs.emplace_back(a, b);
            }
        }
    }
    pair_threshold = diagnosis::pair_threshold(scores.correlation, sign, pairs, chance);
}

ScoreTestData prepare_score_tests(const input::Experiment& experiment, const Observations& observations,
                                  std::vector<Candidate> candidates, Progress progress) {
    ScoreTestData score_data;
    score_data.progress = std::move(progress);
    prepare_score_tests(experiment, observations, std::move(candidates), score_data);
    return score_data;
}

void prepare_score_tests(const input::Experiment& experiment, const Observations& observations,
                         std::vector<Candidate> candidates, ScoreTestData& score_data) {
    score_data.experiment = &experiment;
    score_data.observations = &observations;
    const auto by_slope = std::ranges::count_if(candidates, &Candidate::by_slope);
    score_data.course.runs = std::ssize(experiment.runs);
    score_data.course.recordings = static_cast<long>(observations.n_recordings());
    score_data.course.channels = std::ssize(observations.channels);
    score_data.course.together = by_slope;
    score_data.course.alone = std::ssize(candidates) - by_slope;
    score_data.say({.doing = Work::fitting_case});
    Fit fit(experiment, observations);
    fit.take_stated_noise();
    score_data.noise = fit.covariance();
    if (!fit.move_to(fit.simulator().start())) {
        score_data.status = fit.now().status;
        return;
    }
    score_data.base = refit(fit, 0);  // the case as it stands, in case that the time ends during the fit
    score_data.base = refit(fit);
    fit.simulator().clear_steps();  // steps as the fitted values want them
    if (!score_data.base.status.ok() || !fit.move_to(score_data.base.values)) {
        score_data.status = fit.now().status;
        return;
    }
    score_data.steps = fit.simulator().steps();
    score_data.candidates = std::move(candidates);
    score_data.sign.resize(static_cast<Eigen::Index>(score_data.candidates.size()));
    for (std::size_t k = 0; k < score_data.candidates.size(); ++k) {
        const Candidate& candidate = score_data.candidates[k];
        score_data.sign[static_cast<Eigen::Index>(k)] =
            candidate.absent == candidate.low ? 1 : (candidate.absent == candidate.high ? -1 : 0);
    }
    score_data.say({.doing = Work::signatures, .count = score_data.candidates.size()});
    const input::Experiment still = frozen_at(experiment, fit.simulator(), score_data.base.values);
    take_signatures(still, fit.now().simulated, score_data);
    score_data.say({.doing = Work::unknown_heat});
    std::vector<solver::Problem> problems;
    for (const input::MeasuredRun& run : still.runs) {
        problems.push_back(run.problem);
    }
    score_data.unknowns = candidate_sources_of(experiment, observations, problems, score_data.steps, windows);
    score_data.count(fit.simulator().simulations());
    score_data.say({.doing = Work::noise});
    settle(score_data);
}

void ScoreTestData::take_observations(const Observations& corrected) {
    observations = &corrected;
    settle(*this);
}

}  // namespace tiretherm::diagnosis
