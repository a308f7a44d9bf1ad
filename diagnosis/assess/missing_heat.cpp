// SPDX-License-Identifier: BSD-3-Clause
// Estimates the missing heat by place and time from the residuals: all windows of a place together, as random walks, from the
// linearised runs.

#include <algorithm>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/fit/random_walk.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Windows of a run over which the heat is said. Each costs a run of the linear equations.
constexpr std::size_t most_windows = 40;
constexpr std::size_t most_on_large_meshes = 16;
constexpr int small = 50;  // nodes
/// Of all runs together.
constexpr std::size_t most_of_all_runs = 400;

/// The normal equations of the heat in the windows of one run, beside the free numbers of the model.
struct RunWindows {
    std::vector<UnknownTerm> terms;         ///< window by window
    std::vector<Eigen::MatrixXd> of_place;  ///< [n_places] [windows][windows], before the free numbers take their part
    Eigen::MatrixXd explained;              ///< [n][n_terms] by the free numbers
    Eigen::VectorXd right;                  ///< [n_terms]
};

/// @param left [n_rows] the whitened residual less what the free numbers make up
RunWindows windows_of_run(std::size_t run, const ScoreTestData& score_data, const solver::Problem& problem,
                          const NuisanceProjector& projector, const Eigen::VectorXd& left, int windows) {
    const Observations& observations = *score_data.observations;
    const std::vector<HeatPlace>& places = score_data.unknowns.places;
    CandidateSources events = events_of_run(run, observations, problem, score_data.steps[run], places, windows);
    std::vector<NoiseBlock> blocks = observations.blocks;
    std::erase_if(blocks, [&](const NoiseBlock& block) {
        return observations.rows[static_cast<std::size_t>(block.first)].run != run;
    });
    whiten(blocks, score_data.noise, events.columns);
    RunWindows found{.terms = std::move(events.terms),
                     .of_place = {},
                     .explained = projector.explained(events.columns),
                     .right = events.columns.transpose() * left};
    const auto n_places = static_cast<Eigen::Index>(places.size());
    for (Eigen::Index p = 0; p < n_places; ++p) {
        const Eigen::MatrixXd columns = events.columns(Eigen::all, Eigen::seqN(p, windows, n_places));
        found.of_place.emplace_back(columns.transpose() * columns);
    }
    return found;
}

/// The heat at one place in all windows that the data see.
void estimate_place(std::size_t place, std::size_t n_places, const std::string& name,
                    const std::vector<RunWindows>& runs, Diagnosis& into) {
    struct Seen {
        std::size_t run;
        Eigen::Index window;
        Eigen::Index term;
    };
    std::vector<Seen> seen;
    std::vector<Walk> walks;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const auto first = static_cast<Eigen::Index>(seen.size());
        for (Eigen::Index w = 0; !runs[r].terms.empty() && w < runs[r].of_place[place].rows(); ++w) {
            if (runs[r].of_place[place](w, w) > 0.0) {
                seen.push_back({r, w, w * static_cast<Eigen::Index>(n_places) + static_cast<Eigen::Index>(place)});
            }
        }
        if (const auto count = static_cast<Eigen::Index>(seen.size()) - first; count > 0) {
            walks.push_back({first, count, runs[r].terms.front().to - runs[r].terms.front().from});
        }
    }
    const auto m = static_cast<Eigen::Index>(seen.size());
    Eigen::MatrixXd normal(m, m);
    Eigen::VectorXd right(m);
    for (Eigen::Index j = 0; j < m; ++j) {
        const Seen& b = seen[static_cast<std::size_t>(j)];
        right[j] = runs[b.run].right[b.term];
        for (Eigen::Index i = 0; i < m; ++i) {
            const Seen& a = seen[static_cast<std::size_t>(i)];
            const double own = a.run == b.run ? runs[a.run].of_place[place](a.window, b.window) : 0.0;
            normal(i, j) = own - runs[a.run].explained.col(a.term).dot(runs[b.run].explained.col(b.term));
        }
    }
    const WalkEstimate heat = estimate_walks(normal, right, walks);
    for (Eigen::Index k = 0; k < m; ++k) {
        const Seen& at = seen[static_cast<std::size_t>(k)];
        const UnknownTerm& term = runs[at.run].terms[static_cast<std::size_t>(at.term)];
        into.missing_heat.push_back({.run = at.run,
                                     .place = name,
                                     .from = term.from,
                                     .to = term.to,
                                     .watts = heat.value[k],
                                     .deviation = heat.deviation[k]});
    }
}

}  // namespace

void estimate_missing_heat(const DiagnosisState& found, Diagnosis& into) {
    const ScoreTestData& score_data = found.score_data;
    const Observations& observations = *score_data.observations;
    const std::vector<HeatPlace>& places = score_data.unknowns.places;
    const std::vector<input::MeasuredRun>& measured = score_data.experiment->runs;
    if (observations.channels.empty() || places.empty()) {
        return;
    }
    const NuisanceProjector projector(score_data.base.slopes, score_data.base.precision);
    const Eigen::VectorXd left =
        projector.project(score_data.base.residual, score_data.base.known).head(observations.measured.size());
    const Simulator simulator(*score_data.experiment, observations);
    const bool is_small = measured.front().problem.mesh.n_nodes <= small;
    const auto windows = static_cast<int>(
        std::clamp(most_of_all_runs / measured.size(), std::size_t{1}, is_small ? most_windows : most_on_large_meshes));
    std::vector<RunWindows> runs(measured.size());
    in_parallel(runs.size(), [&](std::size_t r) {
        const solver::Problem problem = simulator.problem(r, score_data.base.values);
        if (!problem.settings.steady && !measured[r].time.empty()) {
            runs[r] = windows_of_run(r, score_data, problem, projector, left, windows);
        }
    });
    for (std::size_t p = 0; p < places.size(); ++p) {
        estimate_place(p, places.size(), places[p].name, runs, into);
    }
    std::ranges::stable_sort(into.missing_heat, {}, &MissingHeat::run);
}

}  // namespace tiretherm::diagnosis
