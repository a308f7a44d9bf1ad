// SPDX-License-Identifier: BSD-3-Clause
// Discriminating experiments: simulates manoeuvres of a menu and computes by how many standard deviations each would
// separate the likeliest hypotheses.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "solver/in_parallel.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double minute = 60.0;
constexpr double kmh = 1.0 / 3.6;
constexpr double degree = std::numbers::pi / 180.0;
/// s between readings of a run that is yet to be made.
constexpr double interval = 5.0;
/// How long inputs take from one value to the next, s.
constexpr double ramp = 5.0;

/// What is held from a moment on. What is NaN stays as before.
struct Hold {
    double minutes = 0.0;
    double speed = 0.0;  ///< m/s
    double load = 0.0;   ///< N
    double slip = 0.0;   ///< rad
    double camber = 0.0;
    double laser = 0.0;  ///< share of the largest power so far
};

struct Manoeuvre {
    std::string name;
    std::string_view needs;  ///< an input that must be given
    std::vector<Hold> holds;
};

std::vector<Manoeuvre> menu() {
    const double v = 100.0 * kmh;
    const double fast = 150.0 * kmh;
    const double load = 4500.0;
    return {
        {"speed steps of 50, 100 and 150 km/h at 4500 N, 10 min each",
         "speed",
         {{10, 50 * kmh, load}, {10, v, load}, {10, fast, load}}},
        {"load steps of 2000, 4500 and 7000 N at 100 km/h, 10 min each",
         "vertical_load",
         {{10, v, 2000}, {10, v, load}, {10, v, 7000}}},
        {"slip angles of 2 degrees to either side at 80 km/h, 2 min on and 4 min off, 30 min",
         "slip_angle",
         {{4, 80 * kmh, load},
          {2, 80 * kmh, load, 2 * degree},
          {4, 80 * kmh, load},
          {2, 80 * kmh, load, -2 * degree},
          {4, 80 * kmh, load},
          {2, 80 * kmh, load, 2 * degree},
          {12, 80 * kmh, load}}},
        {"15 min at 150 km/h and 6000 N, then 25 min coasting at 50 km/h and 200 N",
         "speed",
         {{15, fast, 6000}, {25, 50 * kmh, 200}}},
        {"15 min at 150 km/h and 6000 N, then 45 min standing", "speed", {{15, fast, 6000}, {45, 0, 200}}},
        {"two hours at 100 km/h and 4500 N", "speed", {{120, v, load}}},
        {"camber of 3 degrees to either side at 100 km/h, 15 min each",
         "camber",
         {{15, v, load, 0, 3 * degree}, {15, v, load, 0, -3 * degree}}},
        {"laser at a third, two thirds and all of its power, 10 min each",
         "laser_power",
         {{10, 0, 0, 0, 0, 1.0 / 3}, {10, 0, 0, 0, 0, 2.0 / 3}, {10, 0, 0, 0, 0, 1}}},
        {"laser at all of its power for 10 min, then 20 min off", "laser_power", {{10, 0, 0, 0, 0, 1}, {20}}},
    };
}

/// Side force over slip angle of the logs, N/rad.
double cornering_slope(const input::Experiment& experiment) {
    double product = 0.0;
    double square = 0.0;
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const double t : run.time) {
            const physics::Inputs u = run.problem.input_signals.at(t, solver::JumpSide::after);
            product += u.lateral_force * u.slip_angle;
            square += u.slip_angle * u.slip_angle;
        }
    }
    return square > 0.0 ? product / square : 0.0;
}

double largest_power(const input::Experiment& experiment) {
    double most = 0.0;
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const double t : run.time) {
            most = std::max(most, run.problem.input_signals.at(t, solver::JumpSide::after).laser_power);
        }
    }
    return most;
}

/// The experiment with nothing but this manoeuvre as a run, under the surroundings of the first run; sensors as there.
input::Experiment planned_run_of(const input::Experiment& experiment, const Manoeuvre& manoeuvre) {
    input::Experiment planned = experiment;
    planned.runs.resize(1);
    input::MeasuredRun& run = planned.runs.front();
    const physics::Inputs first = run.problem.input_signals.at(run.problem.settings.start, solver::JumpSide::after);
    const double slope = cornering_slope(experiment);
    const double power = largest_power(experiment);
    solver::InputSignals input_signals;
    const auto series = [&](const physics::Signal& signal, auto value) {
        std::vector<double> time;
        std::vector<double> held;
        double t = 0.0;
        for (const Hold& hold : manoeuvre.holds) {
            time.insert(time.end(), {t == 0.0 ? 0.0 : t + ramp, t + minute * hold.minutes});
            held.insert(held.end(), {value(hold), value(hold)});
            t += minute * hold.minutes;
        }
        input_signals.add(solver::Series{.signal = &signal, .time = std::move(time), .value = std::move(held)});
    };
    for (const physics::Signal& signal : physics::signals()) {
        if (!experiment.runs.front().problem.input_signals.gives(signal)) {
            continue;
        }
        if (signal.name == "speed") {
            series(signal, [](const Hold& hold) { return hold.speed; });
        } else if (signal.name == "vertical_load") {
            series(signal, [](const Hold& hold) { return hold.load; });
        } else if (signal.name == "slip_angle") {
            series(signal, [](const Hold& hold) { return hold.slip; });
        } else if (signal.name == "lateral_force") {
            series(signal,
                   [&](const Hold& hold) { return std::clamp(slope * hold.slip, -0.9 * hold.load, 0.9 * hold.load); });
        } else if (signal.name == "camber") {
            series(signal, [](const Hold& hold) { return hold.camber; });
        } else if (signal.name == "laser_power") {
            series(signal, [&](const Hold& hold) { return power * hold.laser; });
        } else {
            input_signals.add(signal, first.*signal.member);
        }
    }
    input_signals.start_at(0.0);
    double length = 0.0;
    for (const Hold& hold : manoeuvre.holds) {
        length += minute * hold.minutes;
    }
    run.problem.input_signals = std::move(input_signals);
    run.problem.input_model = nullptr;  // loads and slips are those of the manoeuvre
    run.problem.settings.start = 0.0;
    run.problem.settings.end = length;
    run.time.clear();
    for (double t = 0.0; t <= length; t += interval) {
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

/// Signature of a hypothesis in whole: what it makes of the fitted base model.
struct Shape {
    Eigen::VectorXd old;   ///< whitened, of the data there are
    Eigen::VectorXd more;  ///< whitened, of the manoeuvre
};

/// Problems of the planned run with a hypothesis' causes at their fitted numbers, all else as in the base fit.
input::Experiment with_causes(const DiagnosisState& found, const input::Experiment& planned,
                              const FittedHypothesis& one) {
    std::vector<Candidate> on;
    std::vector<double> values;
    for (std::size_t i = 0; i < one.candidates.size(); ++i) {
        on.push_back(found.score_data.candidates[one.candidates[i]]);
        values.push_back(one.fit.values[one.number_of(i)]);
    }
    input::Experiment model = with(planned, on, values);
    model.parameters.clear();
    return model;
}

/// What each hypothesis makes of the data that there are, by the score test's columns.
std::vector<Shape> shapes_of(const DiagnosisState& found, std::size_t n_shapes) {
    const ScoreTestData& score_data = found.score_data;
    std::vector<Shape> shapes(n_shapes);
    for (std::size_t s = 0; s < n_shapes; ++s) {
        shapes[s].old = Eigen::VectorXd::Zero(score_data.observations->measured.size());
        const FittedHypothesis& one = *found.set[s];
        for (std::size_t i = 0; i < one.candidates.size(); ++i) {
            const std::size_t k = one.candidates[i];
            shapes[s].old += (one.fit.values[one.number_of(i)] - score_data.candidates[k].absent) *
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

/// By how many standard deviations the hypotheses would differ with a manoeuvre in addition; nothing where a simulation fails.
std::optional<double> apart_with(const Manoeuvre& manoeuvre, const DiagnosisState& found, std::vector<Shape>& shapes,
                                 long& simulations) {
    const ScoreTestData& score_data = found.score_data;
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
        const input::Experiment model = with_causes(found, planned, *found.set[s]);
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

}  // namespace

void plan_next(const DiagnosisState& found, Diagnosis& into) {
    const ScoreTestData& score_data = found.score_data;
    if (found.set.size() < 2 || score_data.observations->channels.empty()) {
        return;
    }
    const std::size_t n_shapes = std::min<std::size_t>(3, found.set.size());
    std::vector<Shape> shapes = shapes_of(found, n_shapes);
    const double now = apart(score_data, n_shapes, score_data.base.slopes,
                             [&](std::size_t s) -> const Eigen::VectorXd& { return shapes[s].old; });
    const solver::InputSignals& given = score_data.experiment->runs.front().problem.input_signals;
    for (const Manoeuvre& manoeuvre : menu()) {
        if (!given.gives(*physics::find_signal(manoeuvre.needs))) {
            continue;
        }
        if (const std::optional<double> then = apart_with(manoeuvre, found, shapes, into.simulations)) {
            into.next.push_back({.name = manoeuvre.name, .now = now, .then = *then});
        }
    }
    std::ranges::stable_sort(into.next, std::greater{}, &NextExperiment::then);
}

}  // namespace tiretherm::diagnosis
