// SPDX-License-Identifier: BSD-3-Clause
// Writes the interpretation of each verdict: causes with sizes and intervals, unknown sources, confounded effects, and
// the next experiment.

#include "post/diagnosis/diagnosis_sentences.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/diagnosis/tried_sections.hpp"
#include "post/diagnosis/where_it_shows.hpp"
#include "post/report/number_text.hpp"
#include "post/report/remark_text.hpp"
#include "post/report/stage_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Standard deviations of its discretisation error from which on a model is too coarse to diagnose data.
constexpr double coarse = 3.0;

std::string digits(const CauseNumber& number, double value) {
    return to_its_digits(value, 0.5 * (number.high - number.low));
}

bool has_interval(const CauseNumber& number) { return number.high > number.low; }

std::string full(const Cause& cause) {
    if (cause.kind == CauseKind::mesh) {
        return name_of(cause);
    }
    const std::string from = !cause.run.empty() ? fmt::format("the {:.4g} of the other runs", *cause.instead_of)
                             : cause.instead_of ? fmt::format("the case's {:.4g}", *cause.instead_of)
                                                : "no effect";
    return fmt::format("{}, {}, {:.1f} standard deviations from {}", name_of(cause), size_of(cause), cause.sigma, from);
}

std::string named(const Diagnosis& diagnosis) {
    const std::vector<std::size_t>& one = diagnosis.hypotheses.front();
    if (one.size() == 1) {
        return fmt::format("One cause explains what the model gets wrong: {}.", full(diagnosis.causes[one.front()]));
    }
    std::string text;
    for (const std::size_t cause : one) {
        text += (text.empty() ? "" : "; and ") + full(diagnosis.causes[cause]);
    }
    return fmt::format("{} causes together explain what the model gets wrong, none of them alone: {}.",
                       one.size() == 2 ? "Two" : fmt::format("{}", one.size()), text);
}

/// Standard deviations from which on two explanations can be told apart.
constexpr double enough = 2.0;

std::string separation_sentence(const Diagnosis& diagnosis) {
    const NextExperiment& next = diagnosis.next.front();
    if (next.now >= enough && !diagnosis.held_out_gains.empty()) {  // compared by what they predict
        return fmt::format(
            "They predict left-out data alike, as an error of the model stands beside them, though the sensors' noise "
            "alone would tell them apart ({:.2g} standard deviations). {} would set them further apart, by {:.2g}.",
            next.now, next.name, next.then);
    }
    return fmt::format(
        "To tell them apart: {}. This additional test would raise their separation from {:.2g} to {:.2g} standard "
        "deviations (2 to 3 are needed).",
        next.name, next.now, next.then);
}

std::string next_sentence(const Diagnosis& diagnosis) {
    const NextExperiment& next = diagnosis.next.front();
    if (diagnosis.told_apart.empty()) {
        return fmt::format("Next measurement: {}.", next.name);
    }
    return fmt::format("Next measurement: {}. It would tell {} by {:.2g} standard deviations, now {:.2g}{}.", next.name,
                       fmt::join(diagnosis.told_apart, " from "), next.then, next.now,
                       next.then < enough ? "; 2 to 3 are needed, and no manoeuvre that is possible brings them" : "");
}

std::string confounded(const Diagnosis& diagnosis, const input::Experiment& experiment) {
    std::string text;
    for (const std::vector<std::size_t>& one : diagnosis.hypotheses) {
        std::string both;
        for (const std::size_t cause : one) {
            const Cause& one_of = diagnosis.causes[cause];
            both += fmt::format("{}{}, {}{}", both.empty() ? "" : " with ", name_of(one_of), size_of(one_of),
                                one_of.instead_of ? fmt::format(" instead of {:.4g}", *one_of.instead_of) : "");
        }
        text += (text.empty() ? "" : "; or ") + both;
    }
    if (diagnosis.unknown) {
        text += fmt::format("; or, what no effect of the catalogue is, {}", text_of(*diagnosis.unknown, experiment));
    }
    return fmt::format("Something is missing, and these data cannot tell apart: {}.{}", text,
                       diagnosis.next.empty() ? "" : " " + separation_sentence(diagnosis));
}

std::string unknown(const Diagnosis& diagnosis, const input::Experiment& experiment) {
    if (!diagnosis.unknown) {
        return "Something is missing that no effect of the catalogue explains.";
    }
    const UnknownSource& source = *diagnosis.unknown;
    return fmt::format("Something is missing that no effect of the catalogue is: {}; {:.1f} standard deviations.{}",
                       text_of(source, experiment), source.sigma,
                       source.alike.empty()
                           ? ""
                           : fmt::format(" Equally consistent with the data: {}.", fmt::join(source.alike, "; ")));
}

/// The mesh as a cause has no number.
std::string short_form(const Cause& cause) {
    const std::string size = size_of(cause);
    return size.empty() ? name_of(cause) : fmt::format("{}, {}", name_of(cause), size);
}

std::string partial(const DiagnosisRecord& record) {
    const Diagnosis& diagnosis = record.result;
    std::string causes;
    for (const std::size_t cause : diagnosis.hypotheses.front()) {
        causes += (causes.empty() ? "" : "; with ") + short_form(diagnosis.causes[cause]);
    }
    const Gain& gain = diagnosis.gain;
    std::string text = fmt::format("The largest improvement found is {}.", causes);
    if (gain.measured) {
        const double removed = 100.0 * (1.0 - std::sqrt(std::max(0.0, 1.0 - gain.removed)));
        text += gain.removed > 0.0
                    ? fmt::format(
                          " It removes {:.0f} % of the error (rms) on data that were left out; the rest is none of "
                          "what was tried.",
                          removed)
                    : std::string(" It does not predict data that were left out better: it is a suspicion.");
        if (gain.removed > 0.0 && gain.removed_low <= 0.0) {
            text += " That may be chance: the interval reaches zero.";
        }
    }
    std::string others;
    for (std::size_t i = 1; i < diagnosis.hypotheses.size(); ++i) {
        std::string one;
        for (const std::size_t cause : diagnosis.hypotheses[i]) {
            one += (one.empty() ? "" : " with ") + short_form(diagnosis.causes[cause]);
        }
        others += (others.empty() ? "" : "; or ") + one;
    }
    return others.empty() ? text : fmt::format("{} Equally consistent with the data: {}.", text, others);
}

/// What is nearest to an answer, with its doubt.
std::string best_of_tried(const DiagnosisRecord& record) {
    const Diagnosis& diagnosis = record.result;
    if (diagnosis.n_candidates == 0) {
        return "No cause is certain: too little is left beside the free parameters. Longer runs, runs under other "
               "conditions or more sensors would help.";
    }
    const std::string none = fmt::format("No cause is certain: none of {} predicts data that were left out better",
                                         plural(diagnosis.n_candidates, "candidate"));
    if (diagnosis.tried.empty()) {
        return none + ".";
    }
    const TriedAddition& best = diagnosis.tried.front();
    const bool within_run = record.observations.n_recordings() == 1;
    if (best.removed <= 0.0) {
        return fmt::format("{}. The nearest is {}.", none, name_of(best));
    }
    const double rms = 100.0 * (1.0 - std::sqrt(1.0 - std::min(1.0, best.removed)));
    const auto of_rms = [](double share) { return 100.0 * (1.0 - std::sqrt(std::max(0.0, 1.0 - share))); };
    const std::string doubt =
        best.is_tested() ? fmt::format(" (95 %: {:.0f} to {:.0f} %)", of_rms(best.low), of_rms(best.high)) : "";
    return fmt::format(
        "No cause is certain. Best of {}: {}. It would remove {:.0f} % of the error (rms) on data that "
        "were left out{}; {}.",
        plural(diagnosis.n_candidates, "candidate"), name_of(best), rms, doubt,
        best.doubt == AdditionDoubt::none ? "another fit of the case does as well without it"
                                          : text_of(best.doubt, within_run));
}

std::string cannot_tell(const DiagnosisRecord& record) {
    const Diagnosis& diagnosis = record.result;
    const std::string reason = diagnosis.reason ? text_of(*diagnosis.reason) : "";
    if (diagnosis.stopped != Part::none) {
        return fmt::format("No answer after {}: {}{}{}", seconds_text(diagnosis.seconds), stop_text(diagnosis),
                           reason.empty() ? "" : " ", reason);
    }
    if (!reason.empty()) {
        const bool is_searched = diagnosis.n_candidates > 0;
        return fmt::format("{}: {}", is_searched ? "No cause is certain" : "These data do not allow a diagnosis",
                           reason);
    }
    if (diagnosis.numerical_error_sigma > coarse) {
        return fmt::format(
            "The model is too coarse for these data: its discretisation error (steps and grid) is {:.1f} standard "
            "deviations, and {:g} are allowed. It falls with the square of the spacing: {:.2g} times as many cells in "
            "every direction would do.",
            diagnosis.numerical_error_sigma, coarse, std::sqrt(diagnosis.numerical_error_sigma / coarse));
    }
    return best_of_tried(record);
}

}  // namespace

std::string stop_text(const Diagnosis& diagnosis) {
    const Activity& at = diagnosis.stopped_at;
    std::string text = fmt::format("stopped during the {}", text_of(diagnosis.stopped));
    if (at.is_counted()) {
        text += fmt::format(", at {} {} of {}", text_of(at), at.number, at.count);
        text += at.of.empty() ? "" : fmt::format(" ({})", at.of);
    }
    text += ".";
    return std::isfinite(diagnosis.rest_of_stage) && diagnosis.rest_of_stage > 0.0
               ? fmt::format("{} This stage needs about {} more.", text, seconds_text(diagnosis.rest_of_stage))
               : text;
}

std::string seconds_text(double seconds) { return to_its_digits(seconds, 0.05 * seconds) + " s"; }

std::string name_of(const Cause& cause) {
    if (cause.kind == CauseKind::mesh) {
        return fmt::format("a mesh that is too coarse ({} do better)", cause.place);
    }
    const std::string& where = cause.channel.empty() ? cause.place : cause.channel;
    return fmt::format("{}{}{}{}{}", cause.id, where.empty() ? "" : " of ", where, cause.run.empty() ? "" : " in ",
                       cause.run);
}

Value parameters_data(const Cause& cause) {
    Value parameters = Value::Object{};
    for (const CauseNumber& one : cause.numbers) {
        parameters.set(one.key,
                       {{"value", one.value}, {"unit", slashed_unit(one.unit)}, {"low", one.low}, {"high", one.high}});
    }
    return parameters;
}

std::string size_of(const CauseNumber& number) {
    const std::string unit = number.unit == "1" || number.unit.empty() ? "" : " " + slashed_unit(number.unit);
    if (!has_interval(number)) {
        return fmt::format("{} {:.4g}{}", number.key, number.value, unit);
    }
    return fmt::format("{} {}{} ({} to {})", number.key, digits(number, number.value), unit, digits(number, number.low),
                       digits(number, number.high));
}

std::string size_of(const Cause& cause) {
    std::string text;
    for (const CauseNumber& number : cause.numbers) {
        text += (text.empty() ? "" : ", ") + size_of(number);
    }
    return text;
}

std::string meaning_of(const Cause& cause) {
    const physics::Effect* effect = physics::find_effect(cause.id);
    return effect == nullptr ? "" : std::string(effect->meaning);
}

solver::ShownUnit unit_of(const UnknownSource& unknown, const input::Experiment& experiment) {
    const std::vector<solver::Channel>& channels = experiment.runs.front().problem.channels;
    const auto channel = std::ranges::find(channels, unknown.place, &solver::Channel::name);
    if (!unknown.sensor || channel == channels.end()) {
        return {.name = "W"};
    }
    const solver::ShownUnit unit = solver::shown_unit(channel->quantity);
    return {.name = channel->quantity == solver::Quantity::temperature ? "K" : unit.name, .factor = unit.factor};
}

std::string text_of(const UnknownSource& unknown, const input::Experiment& experiment) {
    const solver::ShownUnit unit = unit_of(unknown, experiment);
    const double half = unit.difference(0.5 * (unknown.high - unknown.low));
    const auto shown = [&](double si) { return to_its_digits(unit.difference(si), half); };
    const bool event = unknown.follows == "time window";
    const bool constant = unknown.follows == "1";
    const std::string pattern =
        event ? fmt::format("from {:.4g} s to {:.4g} s of {}", unknown.from, unknown.to, unknown.run)
              : (constant ? "that never changes" : fmt::format("that follows {}", unknown.follows));
    const std::string size =
        fmt::format("{} {}{} ({} to {})", shown(unknown.watts), unit.name,
                    event || constant ? "" : " where that is largest", shown(unknown.low), shown(unknown.high));
    return unknown.sensor
               ? fmt::format("an error in the reading of {} {}, not by heat: {}", unknown.place, pattern, size)
               : fmt::format("heat at {} {}: {}", unknown.place, pattern, size);
}

std::string text_of(const NextExperiment& next) {
    return fmt::format("{}: from {:.2g} to {:.2g} sigma", next.name, next.now, next.then);
}

std::vector<std::string> certainty_of(const DiagnosisRecord& record) {
    const Diagnosis& result = record.result;
    const Gain& gain = result.gain;
    std::vector<std::string> said;
    if (gain.measured) {
        // The channel that gains most, in its own unit.
        const ChannelGain* best = nullptr;
        for (const ChannelGain& channel : result.channels) {
            const bool known = channel.heldout_before > 0.0 && channel.heldout_after > 0.0;
            // By its share: kelvins and pascals have no common scale.
            const auto left = [](const ChannelGain& one) { return one.heldout_after / one.heldout_before; };
            if (known && (best == nullptr || left(channel) < left(*best))) {
                best = &channel;
            }
        }
        const std::string data = gain.within_run ? "held-out parts of the run" : "held-out runs";
        std::string text = gain.confirmed ? fmt::format("Confidence: confirmed on {}", data)
                           : gain.removed > 0.0
                               ? fmt::format("Confidence: not confirmed; {} are predicted better", data)
                               : fmt::format("Confidence: none; {} are not predicted better", data);
        if (best != nullptr) {
            const solver::Channel& channel = record.experiment.runs.front().problem.channels[best->channel];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            text +=
                fmt::format(" ({}: rms from {:.2g} to {:.2g} {})", channel.name, unit.difference(best->heldout_before),
                            unit.difference(best->heldout_after), difference_unit(unit.name));
        }
        text += "." + hardly_explained(record);
        if (const std::string range = driven_range(record); gain.confirmed && !range.empty()) {
            text += fmt::format(" Tested with {}, not beyond.", range);
        }
        said.push_back(text);
    }
    if (const std::string where = where_it_shows(record); !where.empty()) {
        said.push_back("Remaining error: " + where);
    }
    for (const std::string& one : {richer_mesh_sentence(record), drift_of_the_run(record)}) {
        if (!one.empty()) {
            said.push_back(one);
        }
    }
    if (!result.next.empty() && result.verdict != Verdict::confounded) {
        said.push_back(next_sentence(result));
    }
    return said;
}

namespace {

/// What the verdict of the data as they were read says.
std::string verdict_sentence(const DiagnosisRecord& record) {
    const Diagnosis& diagnosis = record.result;
    switch (diagnosis.verdict) {
        case Verdict::named:
            return named(diagnosis);
        case Verdict::confounded:
            return confounded(diagnosis, record.experiment);
        case Verdict::unknown:
            return unknown(diagnosis, record.experiment);
        case Verdict::consistent:
            return fmt::format(
                "The model, its free parameters fitted, agrees with these data within their noise; whatever "
                "else acts is smaller than its upper limit.{}",
                diagnosis.reason ? " " + text_of(*diagnosis.reason) : "");
        case Verdict::cannot_tell:
            return cannot_tell(record);
        case Verdict::partial:
            return partial(record);
    }
    return "";
}

}  // namespace

std::string reason_of(const DiagnosisRecord& record) {
    std::string faults;
    for (const DataFault& fault : record.result.data_faults) {
        faults += text_of(fault.remark) + " ";
    }
    return faults.empty() ? verdict_sentence(record)
                          : fmt::format("{}All else is of the data read so. {}", faults, verdict_sentence(record));
}

std::string id_of(const DataFault& fault) {
    switch (fault.what.kind) {
        case Relabelling::Kind::unit:
            return "unit";
        case Relabelling::Kind::exchange:
            return "channel_swap";
        case Relabelling::Kind::mirror:
            return "mirrored_inputs";
    }
    return "";
}

}  // namespace tiretherm::post
