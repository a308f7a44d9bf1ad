// SPDX-License-Identifier: BSD-3-Clause
// Discriminating experiments: simulates the manoeuvres that are possible and computes by how many standard deviations each would
// separate the likeliest explanations.

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/assess/tried_additions.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

/// s between readings of a run that is yet to be made.
constexpr double interval = 5.0;
/// Explanations that are told apart at once.
constexpr std::size_t most_explanations = 3;
/// A cause that is not seen is taken as large as it may be: so many standard deviations above what the data ask for.
constexpr double not_excluded = 2.0;
/// Of the load, at most what a lateral force can be.
constexpr double grip = 0.9;
/// Inputs that a manoeuvre does not have unless it says so; all others stay as the first run begins.
constexpr std::array<std::string_view, 6> absent_unless_given{"slip_angle",    "slip_ratio",         "slip_speed",
                                                              "lateral_force", "longitudinal_force", "laser_power"};

template <typename Take>
void at_every_sample(const input::Experiment& experiment, const Take& take) {
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const double t : run.time) {
            take(run.problem.input_signals.at(t, solver::JumpSide::after));
        }
    }
}

/// Side force over slip angle of the logs, N/rad.
double cornering_slope(const input::Experiment& experiment) {
    double product = 0.0;
    double square = 0.0;
    at_every_sample(experiment, [&](const physics::Inputs& u) {
        product += u.lateral_force * u.slip_angle;
        square += u.slip_angle * u.slip_angle;
    });
    return square > 0.0 ? product / square : 0.0;
}

double largest_of(const input::Experiment& experiment, const physics::Signal& signal) {
    double most = 0.0;
    at_every_sample(experiment, [&](const physics::Inputs& u) { most = std::max(most, std::abs(u.*signal.member)); });
    return most;
}

/// What a manoeuvre puts in, under the surroundings in which the first run begins.
solver::InputSignals inputs_of(const input::Experiment& experiment, const input::Manoeuvre& manoeuvre) {
    const solver::Problem& problem = experiment.runs.front().problem;
    const physics::Inputs first = problem.input_signals.at(problem.settings.start, solver::JumpSide::after);
    const physics::Signal& slip = *physics::find_signal("slip_angle");
    solver::InputSignals inputs;
    for (const physics::Signal& signal : physics::signals()) {
        if (!problem.input_signals.gives(signal)) {
            continue;
        }
        const auto series = std::ranges::find(manoeuvre.inputs.series(), &signal, &solver::Series::signal);
        if (series != manoeuvre.inputs.series().end()) {
            inputs.add(*series);
        } else if (manoeuvre.inputs.gives(signal)) {
            inputs.add(signal, manoeuvre.inputs.constants().*signal.member);
        } else {
            const bool is_absent = std::ranges::find(absent_unless_given, signal.name) != absent_unless_given.end();
            inputs.add(signal, is_absent ? 0.0 : first.*signal.member);
        }
        if (std::ranges::find(manoeuvre.of_largest, signal.name) != manoeuvre.of_largest.end()) {
            inputs.move(signal, largest_of(experiment, signal), 0.0);
        }
    }
    // A slip angle makes the lateral force that it has made in the logs.
    const physics::Signal& force = *physics::find_signal("lateral_force");
    const auto angle = std::ranges::find(manoeuvre.inputs.series(), &slip, &solver::Series::signal);
    if (angle != manoeuvre.inputs.series().end() && inputs.gives(force) && !manoeuvre.inputs.gives(force)) {
        const double slope = cornering_slope(experiment);
        std::vector<double> made;
        for (const double t : angle->time) {
            const double most = grip * inputs.at(t, solver::JumpSide::after).vertical_load;
            made.push_back(std::clamp(slope * angle->at(t, solver::JumpSide::after), -most, most));
        }
        inputs.replace(solver::Series{.signal = &force, .time = angle->time, .value = std::move(made)});
    }
    inputs.start_at(manoeuvre.start);
    return inputs;
}

/// The experiment with nothing but this manoeuvre as a run; sensors as in the first one.
input::Experiment planned_run_of(const input::Experiment& experiment, const input::Manoeuvre& manoeuvre) {
    input::Experiment planned = experiment;
    planned.runs.resize(1);
    input::MeasuredRun& run = planned.runs.front();
    run.problem.input_signals = inputs_of(experiment, manoeuvre);
    run.problem.input_model = nullptr;  // loads and slips are those of the manoeuvre
    run.problem.settings.start = manoeuvre.start;
    run.problem.settings.end = manoeuvre.end;
    run.time.clear();
    for (double t = manoeuvre.start; t <= manoeuvre.end; t += interval) {
        run.time.push_back(t);
    }
    run.numbers.clear();
    for (input::MeasuredSeries& one : run.series) {
        one.value.assign(run.time.size(), 0.0);
    }
    // How this run starts is as unknown as how the first one did.
    for (solver::FreeParameter& number : planned.parameters) {
        if (!number.belongs_to(0)) {
            number.runs.clear();
            number.nodes.clear();
            number.kind = solver::FreeParameter::Kind::initial;
        }
    }
    return planned;
}

/// What two hypotheses differ by, squared, in standard deviations: nothing free of either can bring them together.
/// @param a, b signatures at the sizes that the data gave
double separation(const Eigen::MatrixXd& slopes, const Eigen::VectorXd& precision, const Eigen::VectorXd& a,
                  const Eigen::VectorXd& b) {
    Eigen::MatrixXd free(slopes.rows(), slopes.cols() + 1);
    free << slopes, b;
    Eigen::VectorXd known(precision.size() + 1);
    known << precision, 0.0;
    return NuisanceProjector(free, known).project(Eigen::MatrixXd(a)).squaredNorm();
}

/// Signature of an explanation in whole: what it makes of the fitted base model.
struct Shape {
    Eigen::VectorXd old;   ///< whitened, of the data there are
    Eigen::VectorXd more;  ///< whitened, of the manoeuvre
};

/// The experiment with causes at their sizes, all else as in the base fit.
input::Experiment with_causes(const ScoreTestData& score_data, const input::Experiment& planned,
                              const SizedCauses& one) {
    std::vector<Candidate> on;
    for (const std::size_t k : one.candidates) {
        on.push_back(score_data.candidates[k]);
    }
    input::Experiment model = with(planned, on, one.values);
    model.parameters.clear();
    return model;
}

/// What each explanation makes of the data that there are, by the score test's columns.
std::vector<Shape> shapes_of(const ScoreTestData& score_data, const std::vector<SizedCauses>& explanations) {
    std::vector<Shape> shapes(explanations.size());
    for (std::size_t s = 0; s < shapes.size(); ++s) {
        shapes[s].old = Eigen::VectorXd::Zero(score_data.observations->measured.size());
        for (std::size_t i = 0; i < explanations[s].candidates.size(); ++i) {
            const std::size_t k = explanations[s].candidates[i];
            shapes[s].old += (explanations[s].values[i] - score_data.candidates[k].absent) *
                             score_data.columns.col(static_cast<Eigen::Index>(k));
        }
    }
    return shapes;
}

/// The least of what any two hypotheses differ by. @param shape of the s-th of them
template <typename ShapeOf>
double apart(const ScoreTestData& score_data, std::size_t n_shapes, const Eigen::MatrixXd& slopes,
             const ShapeOf& shape) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < n_shapes; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
            least = std::min({least, separation(slopes, score_data.base.precision, shape(j), shape(k)),
                              separation(slopes, score_data.base.precision, shape(k), shape(j))});
        }
    }
    return std::sqrt(std::max(0.0, least));
}

/// The noise of a planned run: its blocks know channels by their order of appearance there.
Covariance noise_of(const Observations& seen, const ScoreTestData& score_data) {
    Covariance noise;
    for (const std::size_t channel : seen.channels) {
        const auto& channels = score_data.observations->channels;
        const auto known = std::ranges::find(channels, channel) - channels.begin();
        noise.channels.push_back(score_data.noise.channels[static_cast<std::size_t>(known)]);
    }
    return noise;
}

/// By how many standard deviations the explanations would differ with a manoeuvre in addition; nothing where a simulation fails.
std::optional<double> apart_with(const input::Manoeuvre& manoeuvre, const ScoreTestData& score_data,
                                 const std::vector<SizedCauses>& explanations, std::vector<Shape>& shapes,
                                 long& simulations) {
    const input::Experiment& experiment = *score_data.experiment;
    input::Experiment planned = planned_run_of(experiment, manoeuvre);
    // Numbers of all runs at their fitted values, the start as the first run's.
    const Observations seen = observe(planned);
    Simulator base(planned, seen);
    Eigen::VectorXd values = base.start();
    const Eigen::Index n = score_data.base.values.size();
    for (Eigen::Index j = 0; j < n; ++j) {
        const solver::FreeParameter& number = experiment.parameters[static_cast<std::size_t>(j)];
        values[j] = number.belongs_to(0) ? score_data.base.values[j] : 0.0;  // which moves nothing
    }
    const ModelPrediction& plain = base.at(values);
    simulations += base.simulations();
    if (!plain.status.ok()) {
        return std::nullopt;
    }
    const Covariance noise = noise_of(seen, score_data);
    Eigen::MatrixXd slopes = plain.slope * score_data.base.scale.asDiagonal();
    whiten(seen.blocks, noise, slopes);
    planned.runs.front().problem = base.problem(0, values);
    for (std::size_t s = 0; s < shapes.size(); ++s) {
        const input::Experiment model = with_causes(score_data, planned, explanations[s]);
        Simulator other(model, seen);
        other.take_steps(base.steps());
        const ModelPrediction& there = other.at(other.start());
        simulations += 1;
        if (!there.status.ok()) {
            return std::nullopt;
        }
        Eigen::MatrixXd difference = there.simulated - plain.simulated;
        whiten(seen.blocks, noise, difference);
        shapes[s].more = difference.col(0);
    }
    // The new run starts for itself: its own start is a further number, which the first run's stands in for.
    Eigen::MatrixXd together(score_data.base.slopes.rows() + slopes.rows(), n);
    together << score_data.base.slopes, slopes;
    return apart(score_data, shapes.size(), together, [&](std::size_t s) {
        Eigen::VectorXd joined(together.rows());
        joined << shapes[s].old, shapes[s].more;
        return joined;
    });
}

SizedCauses sized(const FittedHypothesis& one) {
    SizedCauses causes{.candidates = one.candidates, .values = {}};
    for (std::size_t i = 0; i < one.candidates.size(); ++i) {
        causes.values.push_back(one.fit.values[one.number_of(i)]);
    }
    return causes;
}

/// A cause that is not seen, as large as these data allow on the side that they ask for.
SizedCauses largest_allowed(const ScoreTestData& score_data, std::size_t k) {
    const Candidate& candidate = score_data.candidates[k];
    const auto i = static_cast<Eigen::Index>(k);
    const double z = score_data.scores.z[i];
    const auto [low, high] = plausible_bounds(candidate);
    const double size = (z + std::copysign(not_excluded, z)) / score_data.scores.length[i];
    return {.candidates = {k}, .values = {std::clamp(candidate.absent + size, low, high)}};
}

/// What an experiment should tell apart: the members of the set. Of fewer than two, that and what was tried beside it, those first that
/// removed most; then the causes with the largest scores.
std::vector<SizedCauses> explanations_of(const DiagnosisState& found) {
    const ScoreTestData& score_data = found.score_data;
    std::vector<SizedCauses> all;
    for (std::size_t s = 0; s < std::min(most_explanations, found.set.size()); ++s) {
        all.push_back(sized(*found.set[s]));
    }
    const auto cause_of = [&](std::size_t k) { return score_data.candidates[k].cause; };
    const auto add = [&](const SizedCauses& one) {
        const auto is_known = [&](const SizedCauses& other) {
            return std::ranges::equal(one.candidates, other.candidates, {}, cause_of, cause_of);
        };
        if (all.size() < 2 && std::ranges::none_of(all, is_known)) {
            all.push_back(one);
        }
    };
    for (const TriedModel& trial : ranked(found.tried)) {
        if (trial.addition.removed > 0.0) {
            add(trial.model);
        }
    }
    for (const std::size_t k : by_score(score_data, most_explanations)) {
        add(largest_allowed(score_data, k));
    }
    return all;
}

/// "sensor_lag of surface_temperature (tau 1.4) with inner_gas (liner 9)"
std::string name_of_causes(const ScoreTestData& score_data, const SizedCauses& one) {
    std::string name;
    for (std::size_t i = 0; i < one.candidates.size(); ++i) {
        const Candidate& candidate = score_data.candidates[one.candidates[i]];
        name += fmt::format("{}{} ({} {:.2g})", name.empty() ? "" : " with ",
                            name_of(candidate, *score_data.experiment), candidate.number().key, one.values[i]);
    }
    return name;
}

}  // namespace

void plan_next(const DiagnosisState& found, Diagnosis& into) {
    const ScoreTestData& score_data = found.score_data;
    const std::vector<SizedCauses> explanations = explanations_of(found);
    if (explanations.size() < 2 || score_data.observations->channels.empty()) {
        return;
    }
    std::vector<Shape> shapes = shapes_of(score_data, explanations);
    const double now = apart(score_data, shapes.size(), score_data.base.slopes,
                             [&](std::size_t s) -> const Eigen::VectorXd& { return shapes[s].old; });
    for (const input::Manoeuvre& manoeuvre : score_data.experiment->possible) {
        if (const std::optional<double> then =
                apart_with(manoeuvre, score_data, explanations, shapes, into.simulations)) {
            into.next.push_back({.name = manoeuvre.name, .now = now, .then = *then});
        }
    }
    std::ranges::stable_sort(into.next, std::greater{}, &NextExperiment::then);
    if (!into.next.empty()) {
        std::ranges::transform(explanations, std::back_inserter(into.told_apart),
                               [&](const SizedCauses& one) { return name_of_causes(score_data, one); });
    }
}

}  // namespace tiretherm::diagnosis
