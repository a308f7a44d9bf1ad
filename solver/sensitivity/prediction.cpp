// SPDX-License-Identifier: BSD-3-Clause
// Marches over given steps (otherwise those of the error control) or solves the steady state and carries the tangent
// along; a step that does not converge is halved.

#include "solver/sensitivity/prediction.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"
#include "solver/sensitivity/kept_results.hpp"
#include "solver/sensitivity/tangent.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {

namespace {

/// Halvings of a step that does not converge although it did for a neighbouring problem.
constexpr int most_halvings = 8;

/// Takes the steps of the error control: fills their ends, the heat up to them and what their inputs do.
void find_steps(Problem problem, Prediction& into, KeptForcing& kept) {
    problem.settings.output_interval = 0.0;
    problem.settings.field_interval = 0.0;
    problem.channels.clear();
    for (physics::ActiveEffect& active : problem.effects) {
        active.channels.clear();
    }
    const auto take = [&](const Snapshot& now) {
        if (now.time > problem.settings.start) {
            into.step_ends.push_back(now.time);
            into.joules.insert(into.joules.end(), now.joules.begin(), now.joules.end());
        }
        return !stop_requested();
    };
    into.status = run(problem, take, kept).status;
    kept.close();
}

/// The steps are given: none of them is judged by its error.
Problem judged_by_no_error(Problem problem) {
    problem.settings.fixed_step = 1.0;
    return problem;
}

class Prophet {
public:
    Prophet(const Problem& problem, const PredictionRequest& request, Prediction& into, KeptForcing* kept)
        : problem_(judged_by_no_error(problem)),
          request_(request),
          into_(into),
          stepper_(problem_, kept),
          sensor_outputs_(problem_, stepper_.system()),
          tangent_(problem_, stepper_, request.parameters, request.values, request.tolerance),
          slopes_(request.parameters.size() * problem.channels.size()),
          channels_(problem.channels.size()) {
        stepper_.newton().stop_timing();
    }

    Status steady() {
        const double t = problem_.settings.end;
        if (Status status = stepper_.solve_steady(t); !status.ok()) {
            return status;
        }
        const physics::Inputs inputs = problem_.input_signals.at(t, JumpSide::before);
        sensor_outputs_.begin(t, stepper_.temperature(), stepper_.watts(), inputs);
        if (Status status = tangent_.take_steady(inputs); !status.ok()) {
            return status;
        }
        while (next_ < request_.times.size()) {
            answer(t, t);
        }
        return {};
    }

    Status march(std::span<const double> ends) {
        const double start = problem_.settings.start;
        const physics::Inputs inputs = problem_.input_signals.at(start, JumpSide::after);
        stepper_.find_watts(inputs);
        sensor_outputs_.begin(start, stepper_.temperature(), stepper_.watts(), inputs);
        tangent_.begin(inputs);
        while (next_ < request_.times.size() && request_.times[next_] <= start) {
            answer(start, request_.times[next_]);
        }
        for (const double end : ends) {
            if (stop_requested()) {
                return {Outcome::stopped,
                        fmt::format("stopped at t = {:.6g} s of {:.6g} s", stepper_.time(), problem_.settings.end)};
            }
            if (Status status = step_to(end, 0); !status.ok()) {
                return status;
            }
        }
        while (next_ < request_.times.size()) {  // the last sample may lie a rounding error beyond the end
            answer(stepper_.time(), request_.times[next_]);
        }
        return {};
    }

    void name_kinks() {
        for (std::size_t j = 0; j < tangent_.size(); ++j) {
            if (tangent_.perturbation(j).has_kink()) {
                into_.non_smooth_parameters.push_back(request_.parameters[j].name);
            }
        }
    }

private:
    Status step_to(double end, int halvings) {
        Stepper::Attempt attempt = stepper_.attempt(end, false);
        if (!attempt.status.ok()) {
            if (halvings == most_halvings) {
                return std::move(attempt.status);
            }
            if (Status status = step_to(0.5 * (stepper_.time() + end), halvings + 1); !status.ok()) {
                return status;
            }
            return step_to(end, halvings + 1);
        }
        stepper_.accept();
        inputs_.clear();
        for (const StepMoment& stage : stepper_.stages()) {
            inputs_.push_back(
                problem_.input_signals.at(stage.time, inputs_.empty() ? JumpSide::after : JumpSide::before));
        }
        sensor_outputs_.take_step(stepper_.stages(), inputs_);
        if (Status status = tangent_.take_step(inputs_); !status.ok()) {
            return status;
        }
        while (next_ < request_.times.size() && request_.times[next_] <= end) {
            answer(request_.times[next_], request_.times[next_]);
        }
        return {};
    }

    /// Reads the channels at a moment of the last step as the answer to the next time asked for.
    void answer(double t, double asked) {
        const physics::Inputs logged = problem_.input_signals.at(asked, JumpSide::before);
        sensor_outputs_.at(t, logged, channels_);
        std::ranges::copy(channels_, into_.value.begin() + static_cast<std::ptrdiff_t>(next_ * into_.n_channels));
        tangent_.read(t, logged, slopes_);
        for (std::size_t j = 0; j < tangent_.size(); ++j) {
            for (std::size_t c = 0; c < into_.n_channels; ++c) {
                into_.slope[(j * into_.n_times + next_) * into_.n_channels + c] = slopes_[j * into_.n_channels + c];
            }
        }
        ++next_;
    }

    const Problem problem_;
    const PredictionRequest& request_;
    Prediction& into_;
    Stepper stepper_;
    SensorOutputs sensor_outputs_;
    Tangent tangent_;
    std::vector<double> slopes_;
    std::vector<double> channels_;
    std::vector<physics::Inputs> inputs_;
    std::size_t next_ = 0;
};

Prediction simulate_on_this_thread(const Problem& problem, const PredictionRequest& request) {
    Prediction prediction;
    prediction.n_times = request.times.size();
    prediction.n_channels = problem.channels.size();
    prediction.value.assign(prediction.n_times * prediction.n_channels, std::nan(""));
    prediction.slope.assign(request.parameters.size() * prediction.value.size(), 0.0);
    prediction.step_ends.assign(request.step_ends.begin(), request.step_ends.end());
    KeptForcing kept;
    const bool finds_steps = prediction.step_ends.empty() && !problem.settings.steady;
    if (finds_steps) {
        find_steps(problem, prediction, kept);
        if (!prediction.status.ok()) {
            return prediction;
        }
    }
    Prophet prophet(problem, request, prediction, finds_steps ? &kept : nullptr);
    prediction.status = problem.settings.steady ? prophet.steady() : prophet.march(prediction.step_ends);
    prophet.name_kinks();
    return prediction;
}

Prediction simulate(const Problem& problem, const PredictionRequest& request) {
    Prediction prediction;
    Team::with(at(problem.mesh.n_nodes), [&] { prediction = simulate_on_this_thread(problem, request); });
    return prediction;
}

}  // namespace

Prediction predict(const Problem& problem, const PredictionRequest& request) {
    KeptResults* kept = kept_results();
    if (kept == nullptr || !kept->is_active()) {
        return simulate(problem, request);
    }
    const Digest::Value key = key_of(problem, request);
    if (const std::optional<std::vector<double>> numbers = kept->find(key)) {
        if (std::optional<Prediction> prediction = prediction_of(*numbers, problem, request)) {
            return std::move(*prediction);
        }
    }
    const auto begin = std::chrono::steady_clock::now();
    Prediction prediction = simulate(problem, request);
    if (prediction.status.ok()) {
        kept->add(key, numbers_of(prediction, request),
                  std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return prediction;
}

}  // namespace tiretherm::solver
