#include "diagnosis/detect/evidence.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

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

Eigen::MatrixXd whitened(const Evidence& evidence, Eigen::MatrixXd columns) {
    whiten(evidence.observations->blocks, evidence.noise, columns);
    return columns;
}

/// The experiment as it stands at some values, with nothing free.
input::Experiment frozen(const Evidence& evidence, const Simulator& simulator, const Eigen::VectorXd& values) {
    input::Experiment still = *evidence.experiment;
    for (std::size_t r = 0; r < still.runs.size(); ++r) {
        still.runs[r].problem = simulator.problem(r, values);
    }
    still.parameters.clear();
    return still;
}

/// Signatures of the candidates: slopes of all in one run, differences one by one. A candidate whose model fails has
/// none.
void take_signatures(const input::Experiment& still, const Eigen::VectorXd& simulated, Evidence& evidence) {
    std::vector<Candidate> straight;
    std::vector<double> absent;
    for (const Candidate& candidate : evidence.candidates) {
        if (candidate.by_slope()) {
            straight.push_back(candidate);
            absent.push_back(candidate.absent);
        }
    }
    evidence.signatures.setZero(simulated.size(), static_cast<Eigen::Index>(evidence.candidates.size()));
    const input::Experiment wide = with(still, straight, absent);
    Simulator all(wide, *evidence.observations);
    all.take_steps(evidence.steps);
    const ModelPrediction& slopes = all.at(all.start());
    evidence.count(all.simulations());
    Eigen::Index taken = 0;
    for (std::size_t k = 0; k < evidence.candidates.size(); ++k) {
        const Candidate& candidate = evidence.candidates[k];
        auto column = evidence.signatures.col(static_cast<Eigen::Index>(k));
        if (candidate.by_slope()) {
            if (slopes.status.ok()) {
                column = slopes.slope.col(taken++);
            }
            continue;
        }
        input::Experiment moved = with(still, {candidate}, {candidate.trial});
        moved.parameters.clear();
        Simulator one(moved, *evidence.observations);
        one.take_steps(evidence.steps);
        if (const ModelPrediction& there = one.at(one.start()); there.status.ok()) {
            column = (there.simulated - simulated) / (candidate.trial - candidate.absent);
        }
        evidence.count(one.simulations());
    }
}

/// Finds noise and base fit that belong together, and all that is judged by them.
void settle(Evidence& evidence) {
    Fit fit(*evidence.experiment, *evidence.observations);
    fit.simulator().take_steps(evidence.steps);
    fit.take_covariance(evidence.noise);
    if (!fit.move_to(evidence.base.values)) {
        evidence.status = fit.now().status;
        return;
    }
    evidence.base = refit(fit);
    for (int turn = 0; turn < most_turns && evidence.base.status.ok(); ++turn) {
        const Covariance before = fit.covariance();
        fit.find_noise(evidence.essence(evidence.base));
        evidence.noise = fit.covariance();
        evidence.base = refit(fit);
        if (turn > 0 && change(before, evidence.noise) < settled_noise) {
            break;
        }
    }
    evidence.count(fit.simulator().simulations());
    evidence.status = evidence.base.status;
    if (evidence.status.ok()) {
        evidence.take_noise(evidence.noise, evidence.base);
    }
}

Scores scored(const Refit& model, const Eigen::MatrixXd& columns) {
    const Remainder remainder(model.slopes, model.precision);
    return score(remainder.of(columns), remainder.of(model.residual, model.known), columns.colwise().norm());
}

}  // namespace

void Evidence::count(long more) {
    simulations += more;
    if (progress) {
        progress(simulations);
    }
}

Scores Evidence::scores_after(const Refit& model) const { return scored(model, columns); }

Scores Evidence::unknown_scores_after(const Refit& model) const { return scored(model, unknown_columns); }

Eigen::MatrixXd Evidence::essence(const Refit& model) const {
    // Events are left out: there are many of them, and together they could make up any slow noise.
    Eigen::MatrixXd raw(signatures.rows(), signatures.cols() + unknowns.n_followers);
    raw << signatures, unknowns.columns.leftCols(unknowns.n_followers);
    const Eigen::MatrixXd all = whitened(*this, raw);
    const Eigen::MatrixXd left = Remainder(model.slopes, model.precision).of(all);
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

void Evidence::take_noise(Covariance found, Refit refitted) {
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
                candidates[static_cast<std::size_t>(a)].cause != candidates[static_cast<std::size_t>(b)].cause;
            if (seen && two && std::abs(scores.correlation(a, b)) < alike) {
                pairs.emplace_back(a, b);
            }
        }
    }
    pair_threshold = diagnosis::pair_threshold(scores.correlation, sign, pairs, chance);
}

Evidence gather_evidence(const input::Experiment& experiment, const Observations& observations,
                         std::vector<Candidate> candidates, std::function<void(long)> progress) {
    Evidence evidence;
    evidence.progress = std::move(progress);
    evidence.experiment = &experiment;
    evidence.observations = &observations;
    Fit fit(experiment, observations);
    fit.take_stated_noise();
    if (!fit.move_to(fit.simulator().start())) {
        evidence.status = fit.now().status;
        return evidence;
    }
    evidence.base = refit(fit);
    fit.simulator().forget_steps();  // steps as the fitted values want them
    if (!evidence.base.status.ok() || !fit.move_to(evidence.base.values)) {
        evidence.status = fit.now().status;
        return evidence;
    }
    evidence.steps = fit.simulator().steps();
    evidence.noise = fit.covariance();
    evidence.candidates = std::move(candidates);
    evidence.sign.resize(static_cast<Eigen::Index>(evidence.candidates.size()));
    for (std::size_t k = 0; k < evidence.candidates.size(); ++k) {
        const Candidate& candidate = evidence.candidates[k];
        evidence.sign[static_cast<Eigen::Index>(k)] =
            candidate.absent == candidate.low ? 1 : (candidate.absent == candidate.high ? -1 : 0);
    }
    const input::Experiment still = frozen(evidence, fit.simulator(), evidence.base.values);
    take_signatures(still, fit.now().simulated, evidence);
    std::vector<solver::Problem> problems;
    for (const input::MeasuredRun& run : still.runs) {
        problems.push_back(run.problem);
    }
    evidence.unknowns = dictionary_of(experiment, observations, problems, evidence.steps, windows);
    evidence.count(fit.simulator().simulations());
    settle(evidence);
    return evidence;
}

void Evidence::take_observations(const Observations& corrected) {
    observations = &corrected;
    settle(*this);
}

}  // namespace tiretherm::diagnosis
