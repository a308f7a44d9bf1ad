// SPDX-License-Identifier: BSD-3-Clause
// Picks the phases and the run in which the differences are largest, and the signal that they follow, from the figures of compare.

#include "post/diagnosis/where_it_shows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "diagnosis/assess/prediction_gain.hpp"
#include "diagnosis/compare/observed_comparison.hpp"
#include "input/text/word_lists.hpp"
#include "post/comparison/comparison_sentences.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/report/number_text.hpp"
#include "post/report/phase_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// A bias of a phase that is a smaller share of the rms says nothing of it.
constexpr double least_bias = 0.3;
/// Nor does one of a smaller share of the time.
constexpr double least_share_of_time = 0.05;
/// A run stands out whose rms is this many times that of all.
constexpr double stands_out = 1.25;
constexpr double beyond_chance = 3.0;  ///< standard deviations of a bias

/// "+2.0 K while slipping and -2.0 K while free rolling"
std::string phases_of(const ComparedChannel& channel) {
    std::vector<const PhaseFigures*> phases;
    for (const PhaseFigures& phase : channel.phases) {
        const Figures& f = phase.figures;
        if (phase.share > least_share_of_time && std::abs(f.bias) > least_bias * channel.figures.rmse &&
            std::abs(f.bias) > beyond_chance * f.bias_deviation) {
            phases.push_back(&phase);
        }
    }
    std::ranges::sort(phases, std::greater{},
                      [](const PhaseFigures* one) { return std::abs(one->figures.bias) * std::sqrt(one->share); });
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(2, phases.size()); ++i) {
        text += fmt::format("{}{} {} while {}", i == 0 ? "" : " and ", shown_signed(channel, phases[i]->figures.bias),
                            difference_unit(channel.unit.name), name_of(phases[i]->phase));
    }
    return text;
}

/// The run in which it is largest; empty where none stands out.
std::string run_of(const ComparedChannel& channel, const input::Experiment& experiment) {
    if (channel.runs.size() < 2) {
        return "";
    }
    const auto largest =
        std::ranges::max_element(channel.runs, {}, [](const RunFigures& one) { return one.figures.rmse; });
    return largest->figures.rmse > stands_out * channel.figures.rmse
               ? fmt::format("most in {}, {} {}", experiment.runs[largest->run].name,
                             shown(channel, largest->figures.rmse), difference_unit(channel.unit.name))
               : "";
}

std::string signal_of(const ComparedChannel& channel) {
    if (channel.regressors.empty()) {
        return "";
    }
    const RegressorFigures& closest = channel.regressors.front();
    if (closest.association.chance > channel.significant || closest.bins.empty()) {
        return fmt::format(" It follows none of {} signals beyond chance.", channel.regressors.size());
    }
    const std::string unit = difference_unit(channel.unit.name);
    return fmt::format(" It follows {} (correlation {:+.2f}): {} {} where that is small, {} {} where it is large.",
                       closest.name, closest.association.correlation, shown_signed(channel, closest.bins.front().mean),
                       unit, shown_signed(channel, closest.bins.back().mean), unit);
}

}  // namespace

std::string where_it_shows(const DiagnosisRecord& record) {
    const Diagnosis& result = record.result;
    if (result.model_error.empty()) {
        return "";
    }
    const ModelError& most = *std::ranges::max_element(result.model_error, {}, &ModelError::in_noise);
    const solver::Channel& sensor = record.experiment.runs.front().problem.channels[most.channel];
    const solver::ShownUnit unit = solver::shown_unit(sensor.quantity);
    std::string text = fmt::format("{} differs by {:.2g} {} rms beyond its noise", sensor.name,
                                   unit.difference(most.size), difference_unit(unit.name));
    const std::vector<ComparedChannel> left = compare_observed(record.experiment, record.observations, result.extended);
    const auto channel = std::ranges::find(left, sensor.name, &ComparedChannel::name);
    if (channel == left.end()) {
        return text + ".";
    }
    const std::string phases = phases_of(*channel);
    const std::string run = run_of(*channel, record.experiment);
    text += phases.empty() ? "" : ": " + phases;
    text += run.empty() ? "" : "; " + run;
    return text + "." + signal_of(*channel);
}

std::string hardly_explained(const DiagnosisRecord& record) {
    std::vector<std::string> names;
    for (std::size_t c = 0; c < std::min(record.result.channels.size(), record.observations.stated.size()); ++c) {
        const ChannelGain& channel = record.result.channels[c];
        const double stated = record.observations.stated[c];
        const double noise = stated > 0.0 ? std::min(stated, channel.rmse_after) : channel.rmse_after;
        const std::optional<double> share = share_explained(channel.heldout_before, channel.heldout_after, noise);
        if (share && *share < greater_part) {
            names.push_back(record.experiment.runs.front().problem.channels[channel.channel].name);
        }
    }
    return names.empty() || record.result.gain.confirmed || record.result.gain.removed <= 0.0
               ? ""
               : fmt::format(
                     " The greater part of what is wrong with {} is left, and the answer may stand for a part of it: "
                     "on other runs it may "
                     "predict worse.",
                     input::listed(names));
}

std::string drift_of_the_run(const DiagnosisRecord& record) {
    std::vector<std::string> names;
    for (const Cause& cause : record.result.causes) {
        if (cause.in_set && !cause.numbers.empty() && is_drift(cause.numbers.front().unit)) {
            names.push_back(name_of(cause));
        }
    }
    return record.observations.n_recordings() != 1 || names.empty() || !record.result.extended_model
               ? ""
               : fmt::format(
                     "{} of this run: whether it goes on in the next, begins anew or is gone, one run does not tell. "
                     "extended.toml lets it begin anew.",
                     input::listed(names));
}

std::string driven_range(const DiagnosisRecord& record) {
    double speed = 0.0;
    double load = 0.0;
    for (std::size_t r = 0; r < record.observations.times.size(); ++r) {
        const solver::InputSignals& signals = record.experiment.runs[r].problem.input_signals;
        for (const double time : record.observations.times[r]) {
            const physics::Inputs inputs = signals.at(time, solver::JumpSide::after);
            speed = std::max(speed, signals.gives(*physics::find_signal("speed")) ? inputs.speed : 0.0);
            load = std::max(load, signals.gives(*physics::find_signal("vertical_load")) ? inputs.vertical_load : 0.0);
        }
    }
    std::string text = speed > 0.0 ? fmt::format("speeds up to {:.3g} km/h", 3.6 * speed) : "";
    if (load > 0.0) {
        text += fmt::format("{}vertical loads up to {:.2g} kN", text.empty() ? "" : " and ", 1e-3 * load);
    }
    return text;
}

}  // namespace tiretherm::post
