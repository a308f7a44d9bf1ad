#include "solver/tape.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::solver {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Of the linear solutions: what is left of the largest entry.
constexpr double tolerance = 1e-13;

Problem with_given_steps(Problem problem) {
    problem.settings.fixed_step = 1.0;
    return problem;
}

}  // namespace

Tape::Tape(const Problem& problem, std::span<const double> times, std::span<const double> step_ends)
    : problem_(with_given_steps(problem)),
      n_(at(problem.mesh.n_nodes)),
      stepper_(problem_),
      factor_(make_factor(stepper_.system().pattern(), problem.settings.linear_solver)),
      krylov_(problem.mesh.n_nodes),
      n_readings_(times.size() * problem.channels.size()),
      left_(n_) {
    Readings readings(problem_, stepper_.system());
    const double start = problem_.settings.start;
    const physics::Inputs first = problem_.drive.at(start, Limit::after);
    stepper_.find_watts(first);
    readings.begin(start, stepper_.temperature(), stepper_.watts(), first);
    const std::size_t channels = problem_.channels.size();
    for (std::size_t c = 0; c < channels; ++c) {
        places_.push_back(readings.place(c));
    }
    std::vector<physics::Inputs> inputs;
    std::vector<std::vector<Reading>> of_step;
    std::size_t next = 0;
    while (next < times.size() && times[next] <= start) {
        ++next;  // the initial state follows no heat
    }
    for (const double end : step_ends) {
        Stepper::Attempt attempt = stepper_.attempt(end);
        if (!attempt.status.ok()) {
            status_ = std::move(attempt.status);
            return;
        }
        stepper_.accept();
        inputs.clear();
        for (const Stage& stage : stepper_.stages()) {
            inputs.push_back(problem_.drive.at(stage.time, inputs.empty() ? Limit::after : Limit::before));
        }
        readings.take_step(stepper_.stages(), inputs);
        record(stepper_, inputs, readings);
        of_step.emplace_back();
        for (; next < times.size() && times[next] <= end; ++next) {
            const physics::Inputs logged = problem_.drive.at(times[next], Limit::before);
            for (std::size_t c = 0; c < channels; ++c) {
                // A delayed clock shows a moment that may lie in an earlier step.
                const double when = times[next] - readings.delay(c);
                std::size_t step = steps_.size() - 1;
                while (step > 0 && when < steps_[step].stages.front().time) {
                    --step;
                }
                if (when < steps_[step].stages.front().time) {
                    continue;
                }
                Reading reading{.step = step, .channel = c, .place = next * channels + c, .form = {}};
                // The inputs matter to readings before a lag alone, which look at the air.
                std::vector<physics::Inputs> then;
                for (const Stage& stage : steps_[step].stages) {
                    then.push_back(problem_.drive.at(stage.time, then.empty() ? Limit::after : Limit::before));
                }
                reading.form = readings.form(c, steps_[step].stages, then, when);
                const double slope = readings.slope(c, times[next], logged);
                for (double& weight : reading.form.stage) {
                    weight *= slope;
                }
                reading.form.lagged *= slope;
                of_step[step].push_back(reading);
            }
        }
    }
    for (const std::vector<Reading>& some : of_step) {
        first_reading_.push_back(readings_.size());
        readings_.insert(readings_.end(), some.begin(), some.end());
    }
    first_reading_.push_back(readings_.size());
}

void Tape::record(const Stepper& stepper, std::span<const physics::Inputs> inputs, const Readings& readings) {
    Step step;
    step.dt = stepper.width();
    for (std::size_t i = 0; i < stepper.stages().size(); ++i) {
        const Stage& stage = stepper.stages()[i];
        const std::span<const double> intensities = stepper.intensities(static_cast<int>(i));
        step.T.emplace_back(stage.temperature.begin(), stage.temperature.end());
        step.intensities.emplace_back(intensities.begin(), intensities.end());
        step.stages.push_back({.time = stage.time, .temperature = {}, .watts = {}});
    }
    steps_.push_back(std::move(step));
    Step& kept = steps_.back();
    for (std::size_t i = 0; i < kept.stages.size(); ++i) {
        kept.stages[i].temperature = kept.T[i];
    }
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
        kept.carry.push_back(readings.form(c, kept.stages, inputs, kept.stages.back().time));
    }
}

void Tape::linearise(const Step& step) {
    System& system = stepper_.system();
    const std::size_t stages = step.T.size();
    now_.s = step.dt * stepper_.method().diagonal;
    now_.J.resize(stages);
    now_.slopes.resize(stages);
    now_.capacity.assign(stages, std::vector<double>(n_));
    for (std::size_t i = 0; i < stages; ++i) {
        system.evaluate(step.T[i], step.intensities[i]);
        system.matrices(now_.s, false, now_.A, now_.J[i]);
        // The outer products point into the terms, which the next stage overwrites.
        now_.slopes[i] = system.terms().region_slope;
        for (Matrix::Outer& outer : now_.J[i].outer) {
            const auto offset = outer.row.data() - system.terms().region_slope.data();
            outer.row = std::span(now_.slopes[i]).subspan(static_cast<std::size_t>(offset), n_);
        }
        for (std::size_t k = 0; k < n_; ++k) {
            now_.capacity[i][k] = system.has_capacity(k) ? system.capacity(k, step.T[i][k]) : 0.0;
        }
    }
    if (std::abs(now_.s - factored_s_) > 0.01 * now_.s) {
        if (const std::string wrong = factor_->factorise(now_.A); !wrong.empty()) {
            status_ = {Outcome::not_positive_definite, wrong};
        }
        factored_s_ = now_.s;
    }
}

void Tape::solve(const Matrix& J, std::span<const double> b, std::span<double> x) {
    const Krylov::Result result = krylov_.solve(J, *factor_, b, x, left_, 0.0, tolerance);
    if (result.solves > 12) {
        factored_s_ = 0.0;  // a fresh factor for the next step
    }
}

/// Surfaces without capacity: J_ss S_s = s heat - J_sc S_c, by the diagonal of J_ss, which has little beside it.
void Tape::settle_surfaces(std::span<double> S, std::span<const double> heat) {
    const Matrix& J = now_.J.front();
    const System& system = stepper_.system();
    std::vector<double> product(n_);
    for (int iteration = 0; iteration < 60; ++iteration) {
        J.multiply(S, product);
        double change = 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < n_; ++i) {
            if (!system.has_capacity(i)) {
                const double by = (now_.s * heat[i] - product[i]) / J.value[at(J.pattern->diagonal[i])];
                S[i] += by;
                change = std::max(change, std::abs(by));
                largest = std::max(largest, std::abs(S[i]));
            }
        }
        if (change <= 1e-15 * largest) {
            return;
        }
    }
}

/// The same backwards: w_s = J_ss^-T adjoint_s goes to the heat and, through J_sc, to the cells.
void Tape::settle_surfaces_back(std::span<double> adjoint, std::span<double> heat) {
    const Matrix& J = now_.J.front();
    const System& system = stepper_.system();
    std::vector<double> w(n_);
    std::vector<double> product(n_);
    for (int iteration = 0; iteration < 60; ++iteration) {
        J.multiply_transposed(w, product);
        double change = 0.0;
        double largest = 0.0;
        for (std::size_t i = 0; i < n_; ++i) {
            if (!system.has_capacity(i)) {
                const double by = (adjoint[i] - product[i]) / J.value[at(J.pattern->diagonal[i])];
                w[i] += by;
                change = std::max(change, std::abs(by));
                largest = std::max(largest, std::abs(w[i]));
            }
        }
        if (change <= 1e-15 * largest) {
            break;
        }
    }
    J.multiply_transposed(w, product);
    for (std::size_t i = 0; i < n_; ++i) {
        if (system.has_capacity(i)) {
            adjoint[i] -= product[i];
        } else {
            heat[i] += now_.s * w[i];
            adjoint[i] = 0.0;
        }
    }
}

std::vector<double> Tape::forward(std::span<const double> heat) {
    const Tableau& method = stepper_.method();
    const System& system = stepper_.system();
    const std::size_t stages = at(method.stages);
    std::vector<double> answer(n_readings_);
    std::vector<std::vector<double>> S(stages, std::vector<double>(n_));
    std::vector<std::vector<double>> dq(stages, std::vector<double>(n_));
    std::vector<double> known(n_);
    std::vector<double> right(n_);
    std::vector<double> lagged(places_.size());
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const Step& step = steps_[k];
        linearise(step);
        const std::span<const double> f = heat.subspan(k * n_, n_);
        S[0] = S[stages - 1];
        settle_surfaces(S[0], f);
        now_.J[0].multiply(S[0], right);
        for (std::size_t i = 0; i < n_; ++i) {
            dq[0][i] = system.has_capacity(i) ? (now_.capacity[0][i] * S[0][i] - right[i]) / now_.s + f[i] : 0.0;
        }
        for (std::size_t stage = 1; stage < stages; ++stage) {
            for (std::size_t i = 0; i < n_; ++i) {
                double sum = 0.0;
                for (std::size_t j = 0; j < stage; ++j) {
                    sum += method.a[stage][j] * dq[j][i];
                }
                known[i] = now_.capacity[0][i] * S[0][i] + step.dt * sum;
                right[i] = known[i] + now_.s * f[i];
            }
            solve(now_.J[stage], right, S[stage]);
            for (std::size_t i = 0; i < n_; ++i) {
                dq[stage][i] = (now_.capacity[stage][i] * S[stage][i] - known[i]) / now_.s;
            }
        }
        for (std::size_t r = first_reading_[k]; r < first_reading_[k + 1]; ++r) {
            const Reading& reading = readings_[r];
            double value = reading.form.lagged * lagged[reading.channel];
            for (std::size_t i = 0; i < stages; ++i) {
                value += reading.form.stage[i] * places_[reading.channel](S[i]);
            }
            answer[reading.place] += value;
        }
        for (std::size_t c = 0; c < places_.size(); ++c) {
            double value = step.carry[c].lagged * lagged[c];
            for (std::size_t i = 0; i < stages; ++i) {
                value += step.carry[c].stage[i] * places_[c](S[i]);
            }
            lagged[c] = value;
        }
    }
    return answer;
}

std::vector<double> Tape::backward(std::span<const double> weights) {
    const Tableau& method = stepper_.method();
    const System& system = stepper_.system();
    const std::size_t stages = at(method.stages);
    std::vector<double> heat(steps_.size() * n_);
    std::vector<std::vector<double>> of_S(stages, std::vector<double>(n_));
    std::vector<std::vector<double>> of_dq(stages, std::vector<double>(n_));
    std::vector<double> of_end(n_);  // of the state at the end of the step
    std::vector<double> of_begin(n_);
    std::vector<double> z(n_);
    std::vector<double> lagged(places_.size());
    std::vector<double> lagged_before(places_.size());
    for (std::size_t k = steps_.size(); k-- > 0;) {
        const Step& step = steps_[k];
        linearise(step);
        const std::span<double> f = std::span(heat).subspan(k * n_, n_);
        for (std::size_t i = 0; i < stages; ++i) {
            std::ranges::fill(of_S[i], 0.0);
            std::ranges::fill(of_dq[i], 0.0);
        }
        const auto read = [&](const Readings::Form& form, std::size_t channel, double weight) {
            lagged_before[channel] += form.lagged * weight;
            const mesh::Functional& place = places_[channel];
            for (std::size_t i = 0; i < stages; ++i) {
                for (std::size_t m = 0; m < place.nodes.size(); ++m) {
                    of_S[i][at(place.nodes[m])] += form.stage[i] * weight * place.weights[m];
                }
            }
        };
        std::ranges::fill(lagged_before, 0.0);
        for (std::size_t c = 0; c < places_.size(); ++c) {
            read(step.carry[c], c, lagged[c]);
        }
        for (std::size_t r = first_reading_[k]; r < first_reading_[k + 1]; ++r) {
            read(readings_[r].form, readings_[r].channel, weights[readings_[r].place]);
        }
        lagged = lagged_before;
        std::ranges::fill(of_begin, 0.0);
        for (std::size_t i = 0; i < n_; ++i) {
            of_S[stages - 1][i] += of_end[i];
        }
        for (std::size_t stage = stages - 1; stage > 0; --stage) {
            for (std::size_t i = 0; i < n_; ++i) {
                of_S[stage][i] += now_.capacity[stage][i] * of_dq[stage][i] / now_.s;
            }
            Matrix& J = now_.J[stage];
            J.transposed = true;
            solve(J, of_S[stage], z);
            J.transposed = false;
            for (std::size_t i = 0; i < n_; ++i) {
                const double of_known = z[i] - of_dq[stage][i] / now_.s;
                f[i] += now_.s * z[i];
                of_begin[i] += now_.capacity[0][i] * of_known;
                for (std::size_t j = 0; j < stage; ++j) {
                    of_dq[j][i] += step.dt * method.a[stage][j] * of_known;
                }
            }
        }
        // The explicit stage: dq = dq/dT S + f in the cells, 0 at surfaces; S of the cells that of the step's begin.
        for (std::size_t i = 0; i < n_; ++i) {
            of_dq[0][i] = system.has_capacity(i) ? of_dq[0][i] : 0.0;
            f[i] += of_dq[0][i];
        }
        now_.J[0].multiply_transposed(of_dq[0], z);
        for (std::size_t i = 0; i < n_; ++i) {
            of_S[0][i] += (now_.capacity[0][i] * of_dq[0][i] - z[i]) / now_.s + of_begin[i];
        }
        settle_surfaces_back(of_S[0], f);
        of_end = of_S[0];
    }
    return heat;
}

}  // namespace tiretherm::solver
