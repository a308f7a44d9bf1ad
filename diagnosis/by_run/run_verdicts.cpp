// SPDX-License-Identifier: BSD-3-Clause
// Takes one run out of the experiment, and out of the same experiment on other meshes, and diagnoses it.

#include "diagnosis/by_run/run_verdicts.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <utility>

#include "mesh/parallel.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

RunVerdict verdict_of(const std::string& name, Diagnosis result) {
    RunVerdict verdict{.name = name,
                       .status = std::move(result.status),
                       .verdict = result.verdict,
                       .unknown = std::move(result.unknown),
                       .gain = std::move(result.gain),
                       .stopped = result.stopped};
    for (const std::vector<std::size_t>& hypothesis : result.hypotheses) {
        std::vector<Cause>& causes = verdict.hypotheses.emplace_back();
        for (const std::size_t cause : hypothesis) {
            causes.push_back(result.causes[cause]);
        }
    }
    return verdict;
}

}  // namespace

bool RunVerdicts::are_cut_short() const {
    const auto is_stopped = [](const RunVerdict& run) {
        return run.stopped != Part::none || run.status.outcome == solver::Outcome::stopped;
    };
    return (!runs.empty() && left_out != LeftOutRuns::none) || std::ranges::any_of(runs, is_stopped);
}

input::Experiment single_run(const input::Experiment& experiment, std::size_t run) {
    input::Experiment one{.runs = {experiment.runs[run]},
                          .parameters = {},
                          .noise = experiment.noise,
                          .robust = experiment.robust,
                          .candidates = experiment.candidates,
                          .instruments = experiment.instruments};
    for (const solver::FreeParameter& parameter : experiment.parameters) {
        if (parameter.belongs_to(run)) {
            one.parameters.push_back(parameter);
            if (!parameter.runs.empty()) {
                one.parameters.back().runs = {0};
            }
        }
    }
    for (input::Instrument& instrument : one.instruments) {
        std::erase_if(instrument.channels, [&](std::size_t channel) {
            return std::ranges::find(one.runs.front().series, channel, &input::MeasuredSeries::channel) ==
                   one.runs.front().series.end();
        });
    }
    std::erase_if(one.instruments, [](const input::Instrument& instrument) { return instrument.channels.size() < 2; });
    return one;
}

RunVerdicts diagnose_by_run(const input::Experiment& experiment, const DiagnosisOptions& choice) {
    std::vector<std::optional<RunVerdict>> found(experiment.runs.size());
    std::mutex one_at_a_time;
    std::vector<bool> through(found.size(), false);
    in_parallel(found.size(), [&](std::size_t r) {
        if (solver::stop_requested()) {
            return;
        }
        const std::string& name = experiment.runs[r].name;
        const input::Experiment one = single_run(experiment, r);
        std::optional<input::Experiment> finer;
        if (choice.finer != nullptr) {
            finer = single_run(*choice.finer, r);
        }
        std::vector<input::Experiment> meshes;
        meshes.reserve(choice.richer.size());  // options point into it
        DiagnosisOptions options{
            .measure_gain = choice.measure_gain, .finer = finer ? &*finer : nullptr, .only_verdict = true};
        for (const RicherModel& richer : choice.richer) {
            meshes.push_back(single_run(*richer.experiment, r));
            options.richer.push_back({.name = richer.name, .experiment = &meshes.back(), .change = richer.change});
        }
        if (choice.progress) {
            options.progress = [&](const Activity& stage, long simulations) {
                const std::scoped_lock lock(one_at_a_time);
                if (std::ranges::find(through, false) - through.begin() == static_cast<std::ptrdiff_t>(r)) {
                    Activity of_run = stage;
                    of_run.run = name;
                    choice.progress(of_run, simulations);
                }
            };
        }
        found[r] = verdict_of(name, diagnose(one, observe(one), options));
        const std::scoped_lock lock(one_at_a_time);
        through[r] = true;
    });
    RunVerdicts verdicts;
    for (std::optional<RunVerdict>& one : found) {
        if (!one) {  // they are begun in their order
            verdicts.left_out = LeftOutRuns::stopped_after;
            break;
        }
        verdicts.runs.push_back(std::move(*one));
    }
    return verdicts;
}

}  // namespace tiretherm::diagnosis
