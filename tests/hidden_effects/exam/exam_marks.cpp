// SPDX-License-Identifier: BSD-3-Clause
// Rules of marking: when a named cause, a set of hypotheses, an interval or an unknown source counts as right.

#include "hidden_effects/exam/exam_marks.hpp"

#include <algorithm>

#include "exam/exam_hiding_truth.hpp"

namespace hidden_effects {

namespace {

namespace diagnosis = tiretherm::diagnosis;
using diagnosis::Diagnosis;
using diagnosis::Verdict;

constexpr double alike = 0.95;

/// Of several layers it must be the right one. Of two lumps the bulk is what holds the heat in the truth, and its link has
/// no layer. Of a cause without a channel there it does not matter what the program says of the camera's, for there is
/// only one camera.
bool is_same(const Cause& truth, const diagnosis::Cause& found) {
    if (truth.id != found.id) {
        return false;
    }
    if (acts_on_layer(truth.id)) {
        return truth.channel.empty() ? truth.id != "layer_heat_capacity" || found.place != "surface"
                                     : truth.channel == found.place;
    }
    return truth.channel.empty() || truth.channel == found.channel;
}

bool is_true(const ExamDataSet& data_set, const diagnosis::Cause& found) {
    return std::ranges::any_of(data_set.hidden, [&](const Cause& truth) { return is_same(truth, found); });
}

/// Whether a hypothesis is what is hidden, no more and no less.
bool is_truth(const ExamDataSet& data_set, const Diagnosis& diagnosis, const std::vector<std::size_t>& hypothesis) {
    return !data_set.hidden.empty() && hypothesis.size() == data_set.hidden.size() &&
           std::ranges::all_of(data_set.hidden, [&](const Cause& truth) {
               return std::ranges::any_of(hypothesis,
                                          [&](std::size_t i) { return is_same(truth, diagnosis.causes[i]); });
           });
}

/// How like the truth a cause is that was found, 0 where the oracle does not know it.
double likeness_of(const ExamDataSet& data_set, const diagnosis::Cause& found) {
    const auto is_found = [&](const Variant& variant) { return is_same(cause_of(variant, 0.0, 0.0), found); };
    for (const Likeness& one : data_set.alike) {
        if (is_found(*one.variant)) {
            return one.strength();
        }
    }
    if (data_set.oracle_of_runs && data_set.runs.rig->costly) {
        const auto variant = std::ranges::find_if(*data_set.runs.rig->variants, is_found);
        return variant == data_set.runs.rig->variants->end() ? 0.0 : likeness(data_set, *variant).strength();
    }
    return 0.0;
}

std::string text_of(const Diagnosis& diagnosis, const std::vector<std::size_t>& hypothesis) {
    std::string text;
    for (const std::size_t i : hypothesis) {
        text += (text.empty() ? "" : " + ") + name_of(diagnosis.causes[i]);
    }
    return text;
}

/// Whether what was fitted of a hidden cause holds its number. Nothing where no interval was given.
std::optional<bool> holds(const Cause& truth, const Diagnosis& diagnosis) {
    for (const diagnosis::Cause& found : diagnosis.causes) {
        for (const diagnosis::CauseNumber& number : found.numbers) {
            const auto known = truth.parameters.find(number.key);
            // What goes along, the rim's conductance, and what was tried, a critical speed, are not numbers of their own.
            const bool own = number.key != "rim" && number.key != "critical_speed";
            if (is_same(truth, found) && own && known != truth.parameters.end() && number.low < number.high) {
                return number.low <= known->second && known->second <= number.high;
            }
        }
    }
    return std::nullopt;
}

void mark_names(const ExamDataSet& data_set, const Diagnosis& diagnosis, Mark& mark) {
    const auto& set = diagnosis.hypotheses;
    const auto right = [&](const auto& hypothesis) { return is_truth(data_set, diagnosis, hypothesis); };
    mark.in_set = std::ranges::any_of(set, right);
    mark.first_right = !set.empty() && right(set.front());
    const bool first_alike = !mark.first_right && mark.in_set && set.front().size() == 1 &&
                             data_set.hidden.size() == 1 &&
                             likeness_of(data_set, diagnosis.causes[set.front().front()]) > alike;
    mark.first_right_or_alike = mark.first_right || first_alike;
    mark.only_right = diagnosis.verdict == Verdict::named && set.size() == 1 && mark.first_right;
    if (!mark.in_set) {
        return;
    }
    mark.size_held = holds(data_set.hidden.front(), diagnosis);
    // Both numbers of a pair were fitted together only where the pair is all that is left.
    if (data_set.hidden.size() == 2) {
        const std::optional<bool> second = holds(data_set.hidden.back(), diagnosis);
        mark.size_held =
            mark.only_right && mark.size_held && second ? std::optional(*mark.size_held && *second) : std::nullopt;
    }
}

/// A time window is found where the program's covers half of it and is not twice as long.
bool is_window(const HiddenSource& source, const diagnosis::UnknownSource& found, const std::string& run) {
    const double both = std::min(source.to, found.to) - std::max(source.from, found.from);
    const double length = source.to - source.from;
    return found.run == run && both >= 0.5 * length && found.to - found.from <= 2.0 * length;
}

/// Every signal by its name, and no other: "throttle", "slip_angle x speed", "|slip_angle| speed". A time window follows
/// nothing, the time least of all.
bool follows(const HiddenSource& source, const std::string& said) {
    static const std::vector<std::string> known{
        "throttle", "speed",       "vertical_load", "slip_angle",       "camber", "lateral_force",
        "lamp",     "laser_power", "temperature",   "sliding_friction", "time"};
    return said.find("window") == std::string::npos && std::ranges::all_of(known, [&](const std::string& name) {
               const bool wanted = std::ranges::find(source.signals, name) != source.signals.end();
               return wanted == (said.find(name) != std::string::npos);
           });
}

void mark_unknown(const ExamDataSet& data_set, const Diagnosis& diagnosis, Mark& mark) {
    mark.named_though_unknown = !diagnosis.hypotheses.empty();
    mark.unknown = diagnosis.verdict == Verdict::unknown && diagnosis.unknown.has_value();
    if (!mark.unknown) {
        return;
    }
    const diagnosis::UnknownSource& found = *diagnosis.unknown;
    mark.first = "heat after " + found.follows + " in the " + found.place;
    const bool part = std::ranges::find(data_set.source.or_at, found.place) != data_set.source.or_at.end();
    mark.place_right = (found.place == data_set.source.place || part) && !found.sensor;
    mark.signal_right = data_set.source.signals.empty()
                            ? is_window(data_set.source, found, "run" + std::to_string(data_set.source.run + 1))
                            : follows(data_set.source, found.follows);
    // The watts of a part that stands for a place which the program does not know are not those of the place.
    if (mark.place_right && !part && mark.signal_right && found.low < found.high) {
        mark.size_held = found.low <= data_set.source.watts && data_set.source.watts <= found.high;
    }
}

}  // namespace

std::string name_of(const diagnosis::Cause& cause) {
    return cause.id + (cause.channel.empty() ? "" : " of " + cause.channel) +
           (cause.place.empty() ? "" : " in " + cause.place);
}

std::string Mark::faults() const {
    std::string all;
    const auto say = [&](bool wrong, const char* what) {
        if (wrong) {
            all += (all.empty() ? "" : ", ") + std::string(what);
        }
    };
    const bool of_the_catalogue = !hides_nothing(kind) && !is_unknown(kind);
    say(false_alarm, "false alarm");
    say(!hides_nothing(kind) && !detected, "missed");
    say(wrong_with_confidence, "wrong name with confidence");
    say(detected && of_the_catalogue && !in_set, "the truth is not in the set");
    say(in_set && !first_right_or_alike, "another name first");
    say(kind == Kind::pair && in_set && !only_right, "not the pair alone");
    say(is_unknown(kind) && detected && !unknown, "not recognised as unknown");
    say(unknown && !place_right, "wrong place");
    say(unknown && !signal_right, "wrong signal");
    say(!size_held.value_or(true), "size outside its interval");
    return all;
}

Mark mark_of(const ExamDataSet& data_set, const Diagnosis& diagnosis) {
    Mark mark{.bench = data_set.runs.rig->name,
              .kind = data_set.kind,
              .seed = data_set.seed,
              .sigma = data_set.sigma,
              .answer = answer_of(data_set),
              .verdict = std::string(diagnosis::word_of(diagnosis.verdict)),
              .first = {},
              .set = {}};
    mark.apart = data_set.confounded ? std::optional(data_set.confounded->apart) : std::nullopt;
    mark.numerical_error_sigma = diagnosis.numerical_error_sigma;
    mark.simulations = diagnosis.simulations;
    mark.seconds = diagnosis.seconds;
    if (!diagnosis.status.ok()) {
        mark.verdict = diagnosis.status.message;
        mark.first = "failed";
        mark.false_alarm = hides_nothing(data_set.kind);
        return mark;
    }
    const Verdict verdict = diagnosis.verdict;
    mark.first = diagnosis.hypotheses.empty() ? mark.verdict : text_of(diagnosis, diagnosis.hypotheses.front());
    for (const auto& hypothesis : diagnosis.hypotheses) {
        mark.set += (mark.set.empty() ? "{" : ", {") + text_of(diagnosis, hypothesis) + "}";
    }
    if (hides_nothing(data_set.kind)) {
        mark.false_alarm = verdict != Verdict::consistent;
        return mark;
    }
    mark.detected = verdict != Verdict::consistent && verdict != Verdict::cannot_tell;
    mark.wrong_with_confidence = verdict == Verdict::named && diagnosis.hypotheses.size() == 1 &&
                                 std::ranges::any_of(diagnosis.hypotheses.front(), [&](std::size_t i) {
                                     return !is_true(data_set, diagnosis.causes[i]);
                                 });
    if (is_unknown(data_set.kind)) {
        mark_unknown(data_set, diagnosis, mark);
    } else {
        mark_names(data_set, diagnosis, mark);
    }
    if (diagnosis.gain.measured) {
        mark.removed = diagnosis.gain.removable_removed;
        mark.confirmed = diagnosis.gain.confirmed;
    }
    return mark;
}

}  // namespace hidden_effects
