// SPDX-License-Identifier: BSD-3-Clause
// Estimates the missing heat by place and time from the residuals, with one adjoint run backwards for each measured
// run; simulated noise gives its standard deviation.

#include <cmath>
#include <random>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "solver/in_parallel.hpp"
#include "solver/sensitivity/adjoint_record.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Windows of a run over which the heat is said.
constexpr int windows = 40;
/// Of noise: the standard deviation is then known to 13 %, on large meshes to 20 %.
constexpr int draws = 30;
constexpr int few_draws = 12;
constexpr int small = 50;  // nodes

/// What the heat at each place and window would raise weighted sums of the readings by, W by W.
/// @param weights [n_rows x n_sums] of the readings  @returns [n_windows * n_places x n_sums]
Eigen::MatrixXd answers(solver::AdjointRecord& record, const Observations& observations, std::size_t run,
                        std::size_t n_channels, const solver::Settings& settings, const std::vector<HeatPlace>& places,
                        const Eigen::MatrixXd& weights) {
    const std::size_t n_readings = observations.times[run].size() * n_channels;
    const auto n_sums = static_cast<std::size_t>(weights.cols());
    std::vector<double> of_reading(n_readings * n_sums);
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        const Observations::Row& what = observations.rows[row];
        for (std::size_t k = 0; what.run == run && k < n_sums; ++k) {
            of_reading[k * n_readings + what.time * n_channels + what.channel] =
                weights(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
        }
    }
    const double length = (settings.end - settings.start) / windows;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(windows * static_cast<Eigen::Index>(places.size()), weights.cols());
    const auto add_step = [&](std::size_t s, std::span<const double> by_heat) {
        const double begin = s == 0 ? settings.start : record.end(s - 1);
        const double end = record.end(s);
        for (int w = std::max(0, static_cast<int>((begin - settings.start) / length) - 1); w < windows; ++w) {
            const double from = settings.start + w * length;
            if (from >= end) {
                break;
            }
            const double share = std::max(0.0, std::min(end, from + length) - std::max(begin, from)) / (end - begin);
            for (std::size_t p = 0; p < places.size() && share > 0.0; ++p) {
                const mesh::Functional& nodes = places[p].nodes;
                for (std::size_t k = 0; k < n_sums; ++k) {
                    sums(static_cast<Eigen::Index>(p) * windows + w, static_cast<Eigen::Index>(k)) +=
                        share * nodes(by_heat.subspan(k * record.n_nodes(), record.n_nodes()));
                }
            }
        }
    };
    // A millionth is seen by no picture.
    record.backward(n_sums, of_reading, add_step, 1e-6);
    return sums;
}

}  // namespace

void estimate_missing_heat(const DiagnosisState& found, Diagnosis& into) {
    const ScoreTestData& score_data = found.score_data;
    const Observations& observations = *score_data.observations;
    if (observations.channels.empty() || score_data.unknowns.places.empty()) {
        return;
    }
    // The first column is what the data leave, the others are noise, both less what the free numbers make up.
    const NuisanceProjector projector(score_data.base.slopes, score_data.base.precision);
    const Eigen::Index n_rows = observations.measured.size();
    const int n_nodes = score_data.experiment->runs.front().problem.mesh.n_nodes;
    const int n_draws = n_nodes > small ? few_draws : draws;
    std::mt19937_64 engine(2011);
    std::normal_distribution<double> normal;
    Eigen::MatrixXd left = Eigen::MatrixXd::NullaryExpr(projector.rows(), n_draws + 1, [&] { return normal(engine); });
    left = projector.project_extended(std::move(left));
    left.col(0) = projector.project(score_data.base.residual, score_data.base.known);
    Eigen::MatrixXd weights = left.topRows(n_rows);
    whiten_transposed(observations.blocks, score_data.noise, weights);

    const Simulator simulator(*score_data.experiment, observations);
    const std::vector<HeatPlace>& places = score_data.unknowns.places;
    std::vector<std::vector<MissingHeat>> of_run(score_data.experiment->runs.size());
    solver::in_parallel(of_run.size(), [&](std::size_t r) {
        const solver::Problem problem = simulator.problem(r, score_data.base.values);
        if (problem.settings.steady || score_data.experiment->runs[r].time.empty()) {
            return;
        }
        solver::AdjointRecord record(problem, observations.times[r], score_data.steps[r]);
        if (!record.status().ok()) {
            return;
        }
        const Eigen::MatrixXd missing =
            answers(record, observations, r, problem.channels.size(), problem.settings, places, weights);
        if (!record.status().ok()) {
            return;
        }
        const Eigen::VectorXd variance = missing.rightCols(n_draws).cwiseAbs2().rowwise().mean();
        const double length = (problem.settings.end - problem.settings.start) / windows;
        for (Eigen::Index k = 0; k < missing.rows(); ++k) {
            if (variance[k] > 0.0) {
                const double from = problem.settings.start + static_cast<double>(k % windows) * length;
                of_run[r].push_back({.run = r,
                                     .place = places[static_cast<std::size_t>(k / windows)].name,
                                     .from = from,
                                     .to = from + length,
                                     .watts = missing(k, 0) / variance[k],
                                     .sigma = missing(k, 0) / std::sqrt(variance[k])});
            }
        }
    });
    for (std::vector<MissingHeat>& one : of_run) {
        into.missing_heat.insert(into.missing_heat.end(), one.begin(), one.end());
    }
}

}  // namespace tiretherm::diagnosis
