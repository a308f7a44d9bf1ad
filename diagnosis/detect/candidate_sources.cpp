// SPDX-License-Identifier: BSD-3-Clause
// Responses of the channels to every candidate heat source, from a forward run of the linearised equations with all
// sources side by side.

#include "diagnosis/detect/candidate_sources.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "mesh/parallel.hpp"
#include "physics/user_effect_place.hpp"
#include "solver/sensitivity/adjoint_record.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Integral of a signal, linear between its points and held beyond them, from its first point on.
class Integral {
public:
    Integral(const std::vector<double>& time, const std::vector<double>& value) : time_(time), value_(value) {
        sum_.push_back(0.0);
        for (std::size_t i = 1; i < time.size(); ++i) {
            sum_.push_back(sum_.back() + 0.5 * (value[i] + value[i - 1]) * (time[i] - time[i - 1]));
        }
    }
    [[nodiscard]] double mean(double from, double to) const { return (up_to(to) - up_to(from)) / (to - from); }

private:
    [[nodiscard]] double up_to(double t) const {
        if (t <= time_.front()) {
            return (t - time_.front()) * value_.front();
        }
        if (t >= time_.back()) {
            return sum_.back() + (t - time_.back()) * value_.back();
        }
        const auto i = static_cast<std::size_t>(std::ranges::upper_bound(time_, t) - time_.begin());
        const double share = (t - time_[i - 1]) / (time_[i] - time_[i - 1]);
        const double here = value_[i - 1] + share * (value_[i] - value_[i - 1]);
        return sum_[i - 1] + 0.5 * (value_[i - 1] + here) * (t - time_[i - 1]);
    }
    const std::vector<double>& time_;
    const std::vector<double>& value_;
    std::vector<double> sum_;
};

double value_at(const SourceSignal& source_signal, std::size_t run, double t) {
    const std::vector<double>& time = source_signal.time[run];
    const std::vector<double>& value = source_signal.value[run];
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time, t) - time.begin());
    if (after == 0 || after == time.size()) {
        return after == 0 ? value.front() : value.back();
    }
    const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
    return value[after - 1] + share * (value[after] - value[after - 1]);
}

/// The part of a step that lies within a window.
double overlap(double from, double to, double begin, double end) {
    return std::max(0.0, std::min(to, end) - std::max(from, begin)) / (to - from);
}

void name_events(std::size_t run, const solver::Settings& settings, int windows, CandidateSources& sources) {
    const double length = (settings.end - settings.start) / std::max(1, windows);
    for (int i = 0; i < windows; ++i) {
        for (std::size_t p = 0; p < sources.places.size(); ++p) {
            sources.terms.push_back({.place = p,
                                     .event = true,
                                     .run = run,
                                     .from = settings.start + i * length,
                                     .to = settings.start + (i + 1) * length});
        }
    }
}

void name_terms(const input::Experiment& experiment, const Observations& observations, int windows,
                CandidateSources& sources) {
    for (std::size_t c = 0; c < sources.signals.size(); ++c) {
        for (std::size_t p = 0; p < sources.places.size(); ++p) {
            sources.terms.push_back({.place = p, .signal = c});
        }
        for (const std::size_t channel : observations.channels) {
            if (sources.signals[c].follows != "1") {  // an offset is in the catalogue
                sources.terms.push_back({.place = channel, .signal = c, .sensor = true});
            }
        }
    }
    sources.n_followers = static_cast<Eigen::Index>(sources.terms.size());
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        if (!experiment.runs[r].time.empty()) {
            name_events(r, experiment.runs[r].problem.settings, windows, sources);
        }
    }
}

/// Fills the rows of one run.
void fill_run(std::size_t r, const Observations& observations, const solver::Problem& problem,
              const std::vector<double>& ends, CandidateSources& sources) {
    const std::size_t n_channels = problem.channels.size();
    std::vector<Eigen::Index> rows;
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        if (observations.rows[row].run == r) {
            rows.push_back(static_cast<Eigen::Index>(row));
        }
    }
    solver::AdjointRecord record(problem, observations.times[r], ends);
    if (!record.status().ok()) {
        return;
    }
    std::vector<std::size_t> heats;  // the terms that this run sees as heat
    std::vector<Integral> integrals;
    for (const SourceSignal& source_signal : sources.signals) {
        integrals.emplace_back(source_signal.time[r], source_signal.value[r]);
    }
    for (std::size_t k = 0; k < sources.terms.size(); ++k) {
        const UnknownTerm& term = sources.terms[k];
        if (!term.sensor && (!term.event || term.run == r)) {
            heats.push_back(k);
        }
        if (!term.sensor) {
            continue;
        }
        const SourceSignal& source_signal = sources.signals[term.signal];
        for (const Eigen::Index row : rows) {
            const Observations::Row& what = observations.rows[static_cast<std::size_t>(row)];
            if (what.channel == term.place) {
                sources.columns(row, static_cast<Eigen::Index>(k)) =
                    value_at(source_signal, r, observations.times[r][what.time]) / source_signal.largest;
            }
        }
    }
    const auto heat_of_step = [&](std::size_t s, std::span<double> heat) {
        const double begin = s == 0 ? problem.settings.start : record.end(s - 1);
        const double end = record.end(s);
        for (std::size_t h = 0; h < heats.size(); ++h) {
            const UnknownTerm& term = sources.terms[heats[h]];
            const double watts = term.event
                                     ? overlap(begin, end, term.from, term.to)
                                     : integrals[term.signal].mean(begin, end) / sources.signals[term.signal].largest;
            const mesh::Functional& nodes = sources.places[term.place].nodes;
            for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
                heat[h * record.n_nodes() + static_cast<std::size_t>(nodes.nodes[i])] = watts * nodes.weights[i];
            }
        }
    };
    // A millionth of what a source does is seen by no score.
    const std::vector<double> read = record.forward(heats.size(), heat_of_step, 1e-6);
    if (!record.status().ok()) {
        return;
    }
    const std::size_t n_readings = observations.times[r].size() * n_channels;
    for (std::size_t h = 0; h < heats.size(); ++h) {
        auto column = sources.columns.col(static_cast<Eigen::Index>(heats[h]));
        for (const Eigen::Index row : rows) {
            const Observations::Row& what = observations.rows[static_cast<std::size_t>(row)];
            column[row] = read[h * n_readings + what.time * n_channels + what.channel];
        }
    }
}

}  // namespace

std::vector<HeatPlace> heat_places(const solver::Problem& problem, bool all) {
    std::vector<HeatPlace> places;
    const mesh::Mesh& mesh = problem.mesh;
    for (const std::string& name : physics::names_of_places(mesh)) {
        const bool is_part = mesh.zones.empty() ? mesh.find_layer(name) >= 0 : mesh.find_zone(name) >= 0;
        if (!all && !is_part && mesh.find_region(name) < 0 && mesh.find_patch(name) < 0) {
            continue;
        }
        const std::vector<int> nodes = physics::nodes_of_place(mesh, name);
        const std::vector<double> shares = physics::shares_of_nodes(mesh, problem.materials, nodes);
        const bool known = std::ranges::any_of(
            places, [&](const HeatPlace& other) { return std::ranges::is_permutation(other.nodes.nodes, nodes); });
        if (!shares.empty() && !known) {
            places.push_back({.name = name, .nodes = {.nodes = nodes, .weights = shares}});
            places.back().nodes.normalise();
        }
    }
    return places;
}

CandidateSources candidate_sources_of(const input::Experiment& experiment, const Observations& observations,
                                      const std::vector<solver::Problem>& problems,
                                      const std::vector<std::vector<double>>& steps, int windows) {
    constexpr int small = 50;
    const bool is_small = problems.front().mesh.n_nodes <= small;
    CandidateSources sources;
    sources.places = heat_places(problems.front(), is_small);
    sources.signals = source_signals_of(experiment, is_small);
    name_terms(experiment, observations, is_small ? windows : 0, sources);
    sources.columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(observations.rows.size()),
                                            static_cast<Eigen::Index>(sources.terms.size()));
    in_parallel(problems.size(), [&](std::size_t r) { fill_run(r, observations, problems[r], steps[r], sources); });
    return sources;
}

CandidateSources events_of_run(std::size_t run, const Observations& observations, const solver::Problem& problem,
                               const std::vector<double>& steps, std::vector<HeatPlace> places, int windows) {
    CandidateSources sources;
    sources.places = std::move(places);
    name_events(run, problem.settings, windows, sources);
    sources.columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(observations.rows.size()),
                                            static_cast<Eigen::Index>(sources.terms.size()));
    fill_run(run, observations, problem, steps, sources);
    return sources;
}

}  // namespace tiretherm::diagnosis
