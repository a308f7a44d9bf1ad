// SPDX-License-Identifier: BSD-3-Clause
// Simulates the measured runs of a case without fitting and reports the differences, channel by
// channel.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "calls/calls.hpp"
#include "calls/doing.hpp"
#include "post/comparison/comparison_report.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

namespace {

/// How much a look at the error of the grid would cost, where that is too much: it takes some seven times a run.
std::optional<diagnosis::GridLeftOut> too_costly_grid(const input::Experiment& experiment) {
    constexpr int most_cells = 400;
    constexpr double most_cell_samples = 4e6;  // half a minute
    diagnosis::GridLeftOut look{.cells = experiment.runs.front().problem.mesh.n_cells};
    for (const input::MeasuredRun& run : experiment.runs) {
        look.samples += std::max(run.time.size(), run.problem.input_signals.samples().size());
    }
    const bool is_small =
        look.cells <= most_cells && look.cells * static_cast<double>(look.samples) <= most_cell_samples;
    return is_small ? std::nullopt : std::optional(look);
}

/// The case with half the spacing.
std::optional<input::Experiment> on_finer_grid(const MeasuredCall& call) {
    return input::read_experiment(call.case_file, call.data_files(), input::ReadMode::measured, {.finer = 2})
        .experiment;
}

}  // namespace

int compare(const MeasuredCall& call, Caller& caller) {
    const std::optional<input::ExperimentReading> reading = read_measured(call, "nothing was compared", caller);
    if (!reading) {
        return Exit::input_error;
    }
    const std::string name = reading->experiment->runs.front().problem.name;
    const std::filesystem::path directory = folder_of(call, "out/" + name);
    const std::vector<std::string> names = post::comparison_names();
    now_doing(fmt::format("comparing {} and writing to {}", call.case_file, directory.string()));
    const auto folder = open_output(directory, reading->files, names, "nothing was compared", caller);
    if (!folder) {
        return Exit::input_error;
    }
    const bool has_grid = !reading->experiment->runs.front().problem.mesh.is_lumped();
    const auto left_out = has_grid ? too_costly_grid(*reading->experiment) : std::nullopt;
    const std::optional<input::Experiment> finer = has_grid && !left_out ? on_finer_grid(call) : std::nullopt;
    diagnosis::Comparison comparison = diagnosis::compare(*reading->experiment, name, finer ? &*finer : nullptr);
    if (!comparison.status.ok()) {
        caller.refuse(comparison.status.message, "nothing was compared");
        return comparison.status.outcome == solver::Outcome::stopped ? Exit::interrupted : Exit::numerical_failure;
    }
    comparison.grid_left_out = left_out;
    comparison.warnings = reading->warnings;
    const auto is_gross = [](const diagnosis::ComparedChannel& channel) {
        return channel.figures.rmse > diagnosis::gross_misfit;
    };
    if (std::ranges::any_of(comparison.channels, is_gross)) {
        comparison.findings = wrong_labels(call, *reading->experiment);
    }
    std::ranges::copy(reading->data_warnings, std::back_inserter(comparison.findings));
    std::vector<post::DrivenRun> driven;
    for (const auto& run : reading->experiment->runs) {
        driven.push_back({run.name, &run.problem});
    }
    const auto page = write_measured_page(
        call, *folder, names, "compare", caller,
        [&](const std::filesystem::path& stage) { return post::write_comparison(comparison, driven, stage); },
        [&](const auto& files) { return post::comparison_report(comparison, files); });
    if (!page) {
        return Exit::input_error;
    }
    caller.take(*page);
    return Exit::done;
}

}  // namespace tiretherm::calls
