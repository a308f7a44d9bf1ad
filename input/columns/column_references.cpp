// SPDX-License-Identifier: BSD-3-Clause
// Takes inputs and sensors at samples that all runs share out among them.

#include "input/columns/column_references.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr std::size_t most_samples = 2000;    ///< of all runs together that courses are compared at
constexpr std::size_t least_samples = 100;    ///< where there are very many columns
constexpr std::size_t most_values = 4000000;  ///< of all columns together

void add_changing(std::string name, Course course, std::vector<Reference>& into) {
    if (!is_constant(course)) {
        std::vector<double> standard = standardised(course.value);
        into.push_back({.name = std::move(name), .course = std::move(course), .standard = std::move(standard)});
    }
}

}  // namespace

CommonSamples::CommonSamples(const std::vector<MeasuredRun>& runs, std::size_t n_columns) {
    const std::size_t most = std::clamp(most_values / std::max<std::size_t>(1, n_columns), least_samples, most_samples);
    const std::size_t share = most / std::max<std::size_t>(1, runs.size());
    for (const MeasuredRun& run : runs) {
        const std::size_t n = run.time.size();
        const std::size_t chosen = std::min(n, std::max<std::size_t>(20, share));
        std::vector<std::size_t>& rows = rows_.emplace_back();
        for (std::size_t i = 0; i < chosen; ++i) {
            rows.push_back(i * n / chosen);
        }
    }
}

std::vector<Reference> changing_inputs(const std::vector<MeasuredRun>& runs, const CommonSamples& samples) {
    std::vector<Reference> inputs;
    for (const physics::Signal& signal : physics::signals()) {
        if (std::ranges::none_of(runs,
                                 [&](const MeasuredRun& run) { return run.problem.input_signals.gives(signal); })) {
            continue;
        }
        Course course = samples.of([&](std::size_t r, std::size_t row) {
            return runs[r].problem.input_signals.at(runs[r].time[row], solver::JumpSide::before).*(signal.member);
        });
        add_changing(std::string(signal.name), std::move(course), inputs);
    }
    return inputs;
}

std::vector<Reference> products_of(const std::vector<Reference>& inputs) {
    std::vector<Reference> products;
    const auto add = [&](std::string name, const Reference& a, const Reference& b, auto what) {
        Course course = a.course;
        std::ranges::transform(a.course.value, b.course.value, course.value.begin(), what);
        add_changing(std::move(name), std::move(course), products);
    };
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const Reference& a = inputs[i];
        add(fmt::format("abs({})", a.name), a, a, [](double x, double) { return std::abs(x); });
        add(fmt::format("{}^2", a.name), a, a, [](double x, double) { return x * x; });
        for (std::size_t j = i + 1; j < inputs.size(); ++j) {
            const Reference& b = inputs[j];
            add(fmt::format("{} * {}", a.name, b.name), a, b, [](double x, double y) { return x * y; });
            add(fmt::format("abs({} * {})", a.name, b.name), a, b, [](double x, double y) { return std::abs(x * y); });
        }
    }
    return products;
}

std::vector<Reference> temperature_sensors(const std::vector<MeasuredRun>& runs, const CommonSamples& samples) {
    std::vector<Reference> sensors;
    std::vector<std::size_t> known;
    for (const MeasuredRun& run : runs) {
        for (const MeasuredSeries& series : run.series) {
            const solver::Channel& channel = run.problem.channels[series.channel];
            if (series.frozen || std::ranges::count(known, series.channel) > 0 ||
                solver::unit_of(channel.quantity) != std::string_view("K")) {
                continue;
            }
            known.push_back(series.channel);
            Course course = samples.of([&](std::size_t r, std::size_t row) {
                const auto same = std::ranges::find(runs[r].series, series.channel, &MeasuredSeries::channel);
                return same == runs[r].series.end() ? std::nan("") : same->value[row];
            });
            add_changing(channel.name, std::move(course), sensors);
        }
    }
    return sensors;
}

}  // namespace tiretherm::input
