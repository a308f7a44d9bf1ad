// SPDX-License-Identifier: BSD-3-Clause
// Arranges samples, images and single numbers as rows, and simulates all runs in parallel with their parameter slopes.

#include "diagnosis/observations/observations.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "mesh/parallel.hpp"
#include "solver/sensitivity/prediction.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

std::vector<double> times_of(const input::MeasuredRun& run) {
    std::vector<double> times = run.time;
    for (const input::MeasuredNumber& number : run.numbers) {
        times.push_back(number.time);
    }
    for (const input::MeasuredFrames& frames : run.frames) {
        times.insert(times.end(), frames.time.begin(), frames.time.end());
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

std::size_t index_of(const std::vector<double>& times, double time) {
    return static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
}

bool are_finite(const Eigen::MatrixXd& matrix, const std::vector<Eigen::Index>& rows) {
    return std::ranges::all_of(rows, [&](Eigen::Index row) { return matrix.row(row).allFinite(); });
}

/// The frames of a camera, taken apart by size.
void add_images(const input::Experiment& experiment, std::size_t run, std::size_t which, Observations& all,
                std::vector<double>& values) {
    const input::MeasuredFrames& frames = experiment.runs[run].frames[which];
    ImageRows image{.run = run, .frames = which, .first = values.size(), .time = {}, .bands = bands_of(frames)};
    for (const double t : frames.time) {
        image.time.push_back(index_of(all.times[run], t));
    }
    // Runs whose images are as large share their noise, band by band.
    std::vector<int> noises;
    for (int band = 0; band < image.bands.bands(); ++band) {
        const std::string name = fmt::format("{}, {}", frames.camera, image.bands.name(band));
        const auto known = std::ranges::find(all.names, name) - all.names.begin();
        if (known == std::ssize(all.names)) {
            all.channels.push_back(frames.channels.first);
            all.names.push_back(name);
            all.stated.push_back(frames.standard_deviation.value_or(0.0));
        }
        noises.push_back(static_cast<int>(known));
    }
    const std::size_t n_pixels = frames.pixels.size();
    values.resize(values.size() + n_pixels * image.time.size());
    for (std::size_t f = 0; f < image.time.size(); ++f) {
        std::vector<double> pixels(frames.value.begin() + static_cast<std::ptrdiff_t>(f * n_pixels),
                                   frames.value.begin() + static_cast<std::ptrdiff_t>((f + 1) * n_pixels));
        image.bands.apply(pixels);
        for (std::size_t entry = 0; entry < n_pixels; ++entry) {
            values[image.row(entry, f)] = pixels[entry];
        }
    }
    for (std::size_t entry = 0; entry < n_pixels; ++entry) {
        all.blocks.push_back(series_block(noises[static_cast<std::size_t>(image.bands.band(entry))],
                                          static_cast<Eigen::Index>(image.row(entry, 0)), frames.time,
                                          std::span(values).subspan(image.row(entry, 0), image.time.size())));
        for (const std::size_t time : image.time) {
            all.rows.push_back({.run = run,
                                .channel = frames.channels.first,
                                .time = time,
                                .image = static_cast<int>(all.images.size())});
        }
    }
    all.images.push_back(std::move(image));
}

}  // namespace

std::pair<double, double> Observations::span_of(std::size_t recording) const {
    std::pair<double, double> span{0.0, 0.0};
    bool is_first = true;
    for (std::size_t run = 0; run < times.size(); ++run) {
        if (recordings[run] == recording && !times[run].empty()) {
            span.first = is_first ? times[run].front() : std::min(span.first, times[run].front());
            span.second = is_first ? times[run].back() : std::max(span.second, times[run].back());
            is_first = false;
        }
    }
    return span;
}

Observations observe(const input::Experiment& experiment) {
    Observations all;
    std::vector<double> values;
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        const input::MeasuredRun& run = experiment.runs[r];
        all.times.push_back(times_of(run));
        const auto same = std::ranges::find_if(experiment.runs, [&](const input::MeasuredRun& other) {
            return !run.corner.empty() && other.recording == run.recording;
        });
        const auto first = static_cast<std::size_t>(same - experiment.runs.begin());
        all.recordings.push_back(first < r ? all.recordings[first] : all.n_recordings());
        for (const input::MeasuredSeries& series : run.series) {
            if (series.frozen) {
                continue;
            }
            const auto known = std::ranges::find(all.channels, series.channel);
            const auto noise = static_cast<int>(known - all.channels.begin());
            if (known == all.channels.end()) {
                all.channels.push_back(series.channel);
                const solver::Channel& channel = run.problem.channels[series.channel];
                all.names.push_back(channel.name);
                all.stated.push_back(channel.standard_deviation.value_or(0.0));
            }
            all.blocks.push_back(series_block(noise, static_cast<Eigen::Index>(values.size()), run.time, series.value));
            for (std::size_t i = 0; i < run.time.size(); ++i) {
                if (!std::isnan(series.value[i])) {
                    all.rows.push_back({r, series.channel, index_of(all.times[r], run.time[i])});
                    values.push_back(series.value[i]);
                }
            }
        }
        for (std::size_t i = 0; i < run.frames.size(); ++i) {
            add_images(experiment, r, i, all, values);
        }
    }
    std::vector<double> deviations;
    const auto first = static_cast<Eigen::Index>(values.size());
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        for (const input::MeasuredNumber& number : experiment.runs[r].numbers) {
            all.rows.push_back({r, number.channel, index_of(all.times[r], number.time)});
            values.push_back(number.value);
            deviations.push_back(number.standard_deviation);
        }
    }
    if (!deviations.empty()) {
        all.blocks.push_back(numbers_block(first, std::move(deviations)));
    }
    all.measured = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
    for (const input::Lap& lap : all.n_recordings() == 1 ? experiment.runs.front().laps : std::vector<input::Lap>{}) {
        all.lap_ends.push_back(lap.end);
    }
    return all;
}

Simulator::Simulator(const input::Experiment& experiment, const Observations& observations)
    : experiment_(&experiment),
      observations_(&observations),
      start_(static_cast<Eigen::Index>(experiment.parameters.size())),
      step_ends_(experiment.runs.size()),
      parameters_(experiment.runs.size()),
      rows_(experiment.runs.size()) {
    for (std::size_t j = 0; j < experiment.parameters.size(); ++j) {
        const solver::FreeParameter& parameter = experiment.parameters[j];
        const std::size_t own = parameter.runs.empty() ? 0 : parameter.runs.front();
        start_[static_cast<Eigen::Index>(j)] = solver::value_of(experiment.runs[own].problem, parameter);
        for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
            if (parameter.belongs_to(r)) {
                parameters_[r].push_back(j);
            }
        }
    }
    for (std::size_t row = 0; row < observations.rows.size(); ++row) {
        if (observations.rows[row].image < 0) {
            rows_[observations.rows[row].run].push_back(static_cast<Eigen::Index>(row));
        }
    }
}

solver::Problem Simulator::problem(std::size_t run, const Eigen::VectorXd& values) const {
    solver::Problem problem = experiment_->runs[run].problem;
    for (const std::size_t j : parameters_[run]) {
        const auto i = static_cast<Eigen::Index>(j);
        solver::move(problem, experiment_->parameters[j], start_[i], values[i]);
    }
    return problem;
}

const ModelPrediction& Simulator::at(const Eigen::VectorXd& values) {
    solver::leave_if_stopped();
    // Values that went through units and back may differ in their last digits; each is judged by its own size.
    const bool same = last_values_.size() == values.size() && values.size() > 0 &&
                      ((last_values_ - values).array().abs() <= 1e-14 * values.array().abs()).all();
    if (!same) {
        last_values_ = values;
        last_ = predict(values);
    }
    return last_;
}

void Simulator::read_images(const ImageRows& image, const solver::Prediction& prediction, const solver::Problem& now,
                            ModelPrediction& into) const {
    const input::MeasuredFrames& frames = experiment_->runs[image.run].frames[image.frames];
    const std::vector<std::size_t>& numbers = parameters_[image.run];
    const ImageView view(frames, now);
    std::vector<std::optional<ImageView>> turned(numbers.size());  // of numbers of the pose
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const solver::FreeParameter& number = experiment_->parameters[numbers[k]];
        if (number.kind == solver::FreeParameter::Kind::effect && number.effect == frames.pose) {
            turned[k] = ImageView::slope(frames, now, number.parameter);
        }
    }
    std::vector<double> pixels(frames.pixels.size());
    std::vector<double> moved(pixels.size());
    for (std::size_t f = 0; f < image.time.size(); ++f) {
        const auto at = [&](const std::vector<double>& all, std::size_t first) {
            return std::span(all).subspan((first + image.time[f]) * prediction.n_channels, prediction.n_channels);
        };
        const auto put = [&](auto&& column, std::span<double> values) {
            image.bands.apply(values);
            for (std::size_t entry = 0; entry < values.size(); ++entry) {
                column[static_cast<Eigen::Index>(image.row(entry, f))] = values[entry];
            }
        };
        const std::span<const double> channels = at(prediction.value, 0);
        view.read(channels, pixels);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (turned[k]) {
                turned[k]->turn(channels, pixels, moved);
            } else {
                view.follow(channels, at(prediction.slope, k * prediction.n_times), pixels, moved);
            }
            put(into.slope.col(static_cast<Eigen::Index>(numbers[k])), moved);
        }
        put(into.simulated, pixels);
    }
}

bool Simulator::is_asked(std::size_t run) const {
    return !rows_[run].empty() ||
           std::ranges::any_of(observations_->images, [&](const ImageRows& image) { return image.run == run; });
}

solver::Prediction Simulator::simulate(std::size_t run, const Eigen::VectorXd& values) const {
    std::vector<solver::FreeParameter> asked;
    std::vector<double> now;
    for (const std::size_t j : parameters_[run]) {
        asked.push_back(experiment_->parameters[j]);
        now.push_back(values[static_cast<Eigen::Index>(j)]);
    }
    return solver::predict(problem(run, values), {.times = observations_->times[run],
                                                  .parameters = asked,
                                                  .values = now,
                                                  .step_ends = step_ends_[run],
                                                  .tolerance = 1e-4});
}

void Simulator::read_run(std::size_t run, const solver::Prediction& prediction, ModelPrediction& into) const {
    const input::MeasuredRun& measured = experiment_->runs[run];
    const auto fail = [&](const std::string& what) {
        into.status = {solver::Outcome::not_finite, fmt::format("run {}: {}", measured.name, what)};
    };
    for (const Eigen::Index row : rows_[run]) {
        const Observations::Row& what = observations_->rows[static_cast<std::size_t>(row)];
        into.simulated[row] = prediction.at(what.time, what.channel);
        if (!std::isfinite(into.simulated[row])) {
            return fail(fmt::format("{} is not a number at t = {:.6g} s", measured.problem.channels[what.channel].name,
                                    observations_->times[run][what.time]));
        }
        for (std::size_t k = 0; k < parameters_[run].size(); ++k) {
            into.slope(row, static_cast<Eigen::Index>(parameters_[run][k])) =
                prediction.slope_at(k, what.time, what.channel);
        }
    }
    if (!are_finite(into.slope, rows_[run])) {
        return fail("a sensitivity is not a number");
    }
    for (const std::string& name : prediction.non_smooth_parameters) {
        if (std::ranges::find(into.non_smooth_parameters, name) == into.non_smooth_parameters.end()) {
            into.non_smooth_parameters.push_back(name);
        }
    }
}

ModelPrediction Simulator::predict(const Eigen::VectorXd& values) {
    const std::size_t n_runs = experiment_->runs.size();
    std::vector<solver::Prediction> predictions(n_runs);
    in_parallel(n_runs, [&](std::size_t r) {
        if (is_asked(r)) {
            predictions[r] = simulate(r, values);
        }
    });
    solver::leave_if_stopped();
    for (std::size_t r = 0; r < n_runs; ++r) {
        simulations_ += is_asked(r) ? 1 : 0;
    }
    if (progress_) {
        progress_(simulations_);
    }

    ModelPrediction predicted;
    const auto n_rows = static_cast<Eigen::Index>(observations_->rows.size());
    predicted.simulated.resize(n_rows);
    predicted.slope.setZero(n_rows, start_.size());
    for (std::size_t r = 0; r < n_runs; ++r) {
        solver::Prediction& prediction = predictions[r];
        if (!prediction.status.ok()) {
            prediction.status.message = fmt::format("run {}: {}", experiment_->runs[r].name, prediction.status.message);
            predicted.status = prediction.status;
            return predicted;
        }
        if (!is_asked(r)) {
            continue;
        }
        step_ends_[r] = std::move(prediction.step_ends);
        read_run(r, prediction, predicted);
        if (!predicted.status.ok()) {
            return predicted;
        }
    }
    in_parallel(observations_->images.size(), [&](std::size_t i) {
        const ImageRows& image = observations_->images[i];
        read_images(image, predictions[image.run], problem(image.run, values), predicted);
    });
    for (const ImageRows& image : observations_->images) {
        const auto first = static_cast<Eigen::Index>(image.first);
        if (!predicted.simulated.segment(first, image.rows()).allFinite() ||
            !predicted.slope.middleRows(first, image.rows()).allFinite()) {
            predicted.status = {solver::Outcome::not_finite,
                                fmt::format("run {}: a pixel of {} is not a number", experiment_->runs[image.run].name,
                                            experiment_->runs[image.run].frames[image.frames].camera)};
            return predicted;
        }
    }
    return predicted;
}

input::Experiment with_fitted_inputs(input::Experiment experiment, const Eigen::VectorXd& values) {
    for (input::MeasuredRun& run : experiment.runs) {
        solver::Problem moved = run.problem;
        for (std::size_t j = 0; j < experiment.parameters.size(); ++j) {
            if (const solver::FreeParameter& number = experiment.parameters[j];
                number.kind == solver::FreeParameter::Kind::input) {
                solver::move(moved, number, solver::value_of(moved, number), values[static_cast<Eigen::Index>(j)]);
            }
        }
        run.problem.input_signals = std::move(moved.input_signals);
    }
    return experiment;
}

}  // namespace tiretherm::diagnosis
