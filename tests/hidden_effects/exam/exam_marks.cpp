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

bool is_true(const Paper& paper, const diagnosis::Cause& found) {
    return std::ranges::any_of(paper.hidden, [&](const Cause& truth) { return is_same(truth, found); });
}

/// Whether an explanation is what is hidden, no more and no less.
bool is_truth(const Paper& paper, const Diagnosis& diagnosis, const std::vector<std::size_t>& explanation) {
    return !paper.hidden.empty() && explanation.size() == paper.hidden.size() &&
           std::ranges::all_of(paper.hidden, [&](const Cause& truth) {
               return std::ranges::any_of(explanation,
                                          [&](std::size_t i) { return is_same(truth, diagnosis.causes[i]); });
           });
}

/// How like the truth a cause is that was found, 0 where the oracle does not know it.
double likeness_of(const Paper& paper, const diagnosis::Cause& found) {
    const auto is_found = [&](const Variant& variant) { return is_same(cause_of(variant, 0.0, 0.0), found); };
    for (const Likeness& one : paper.alike) {
        if (is_found(*one.variant)) {
            return one.strength();
        }
    }
    if (paper.oracle_of_runs && paper.runs.rig->costly) {
        const auto variant = std::ranges::find_if(*paper.runs.rig->variants, is_found);
        return variant == paper.runs.rig->variants->end() ? 0.0 : likeness(paper, *variant).strength();
    }
    return 0.0;
}

std::string text_of(const Diagnosis& diagnosis, const std::vector<std::size_t>& explanation) {
    std::string text;
    for (const std::size_t i : explanation) {
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

void mark_names(const Paper& paper, const Diagnosis& diagnosis, Mark& mark) {
    const auto& set = diagnosis.explanations;
    const auto right = [&](const auto& explanation) { return is_truth(paper, diagnosis, explanation); };
    mark.in_set = std::ranges::any_of(set, right);
    mark.first_right = !set.empty() && right(set.front());
    const bool first_alike = !mark.first_right && mark.in_set && set.front().size() == 1 && paper.hidden.size() == 1 &&
                             likeness_of(paper, diagnosis.causes[set.front().front()]) > alike;
    mark.first_right_or_alike = mark.first_right || first_alike;
    mark.only_right = diagnosis.verdict == Verdict::named && set.size() == 1 && mark.first_right;
    if (!mark.in_set) {
        return;
    }
    mark.size_held = holds(paper.hidden.front(), diagnosis);
    // Both numbers of a pair were fitted together only where the pair is all that is left.
    if (paper.hidden.size() == 2) {
        const std::optional<bool> second = holds(paper.hidden.back(), diagnosis);
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

void mark_unknown(const Paper& paper, const Diagnosis& diagnosis, Mark& mark) {
    mark.named_though_unknown = !diagnosis.explanations.empty();
    mark.unknown = diagnosis.verdict == Verdict::unknown && diagnosis.unknown.has_value();
    if (!mark.unknown) {
        return;
    }
    const diagnosis::UnknownSource& found = *diagnosis.unknown;
    mark.first = "heat after " + found.follows + " in the " + found.place;
    const bool part = std::ranges::find(paper.source.or_at, found.place) != paper.source.or_at.end();
    mark.place_right = (found.place == paper.source.place || part) && !found.sensor;
    mark.signal_right = paper.source.signals.empty()
                            ? is_window(paper.source, found, "run" + std::to_string(paper.source.run + 1))
                            : follows(paper.source, found.follows);
    // The watts of a part that stands for a place which the program does not know are not those of the place.
    if (mark.place_right && !part && mark.signal_right && found.low < found.high) {
        mark.size_held = found.low <= paper.source.watts && paper.source.watts <= found.high;
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

Mark mark_of(const Paper& paper, const Diagnosis& diagnosis) {
    Mark mark{.bench = paper.runs.rig->name,
              .kind = paper.kind,
              .seed = paper.seed,
              .sigma = paper.sigma,
              .answer = answer_of(paper),
              .verdict = std::string(diagnosis::word_of(diagnosis.verdict)),
              .first = {},
              .set = {}};
    mark.apart = paper.twin ? std::optional(paper.twin->apart) : std::nullopt;
    mark.numerical_error_sigma = diagnosis.numerical_error_sigma;
    mark.simulations = diagnosis.simulations;
    mark.seconds = diagnosis.seconds;
    if (!diagnosis.status.ok()) {
        mark.verdict = diagnosis.status.message;
        mark.first = "failed";
        mark.false_alarm = hides_nothing(paper.kind);
        return mark;
    }
    const Verdict verdict = diagnosis.verdict;
    mark.first = diagnosis.explanations.empty() ? mark.verdict : text_of(diagnosis, diagnosis.explanations.front());
    for (const auto& explanation : diagnosis.explanations) {
        mark.set += (mark.set.empty() ? "{" : ", {") + text_of(diagnosis, explanation) + "}";
    }
    if (hides_nothing(paper.kind)) {
        mark.false_alarm = verdict != Verdict::consistent;
        return mark;
    }
    mark.detected = verdict != Verdict::consistent && verdict != Verdict::cannot_tell;
    mark.wrong_with_confidence = verdict == Verdict::named && diagnosis.explanations.size() == 1 &&
                                 std::ranges::any_of(diagnosis.explanations.front(), [&](std::size_t i) {
                                     return !is_true(paper, diagnosis.causes[i]);
                                 });
    if (is_unknown(paper.kind)) {
        mark_unknown(paper, diagnosis, mark);
    } else {
        mark_names(paper, diagnosis, mark);
    }
    if (diagnosis.gain.measured) {
        mark.removed = diagnosis.gain.removable_removed;
        mark.confirmed = diagnosis.gain.confirmed;
    }
    return mark;
}

}  // namespace hidden_effects
