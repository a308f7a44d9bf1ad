// SPDX-License-Identifier: BSD-3-Clause
// The verdict on quoted numbers in sentences: what explains them, how sure that is, and what cannot be concluded.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/detect/work_ahead.hpp"
#include "post/quoted/quoted_report.hpp"
#include "post/report/number_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;          // whose verdicts and
using namespace diagnosis::quoted;  // whose results are rendered here

namespace {

std::string percent(double share) { return fmt::format("{} %", std::lround(100.0 * share)); }

std::string experiments(const QuotedRecord& record, const std::vector<std::size_t>& chosen) {
    std::vector<std::string> names;
    for (const std::size_t one : chosen) {
        names.push_back("(" + record.result.numbers.experiments[one] + ")");
    }
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

/// "(M7, worst +6.0 u), (M13, worst -2.5 u)": experiments that are off, with their worst rows.
std::string off_text(const QuotedRecord& record, const Analysis& analysis) {
    std::vector<std::string> texts;
    for (const std::size_t experiment : analysis.off) {
        double worst = 0.0;
        for (std::size_t r = 0; r < analysis.counts.size(); ++r) {
            const QuotedResult& row = record.result.numbers.rows[r];
            const double score = row.residual(row.value) / row.total();
            if (analysis.counts[r] && row.experiment == experiment && std::abs(score) > std::abs(worst)) {
                worst = score;
            }
        }
        texts.push_back(fmt::format("({}, worst {:+.1f} u)", record.result.numbers.experiments[experiment], worst));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string value_text(const Addition& addition, const AdditionFit& fit, std::size_t k) {
    if (!addition.is_fitted()) {
        return addition.name();
    }
    const double half = std::max(0.5 * (fit.high[k] - fit.low[k]), 1e-3 * std::abs(addition.high - addition.low));
    return fmt::format("{} = {} {}({} to {})", addition.name(), to_its_digits(fit.values[k], half),
                       addition.unit == "1" ? "" : slashed_unit(addition.unit) + " ", to_its_digits(fit.low[k], half),
                       to_its_digits(fit.high[k], half));
}

std::string additions_text(const SetOfAdditions& set) {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < set.additions.size(); ++k) {
        texts.push_back(value_text(set.additions[k], set.fit, k));
    }
    return fmt::format("{}", fmt::join(texts, " and "));
}

std::string removed_text(const ShareInterval& share) {
    return fmt::format("{} of the error on experiments left out (95 %: {} to {})", percent(share.value),
                       percent(share.low), percent(share.high));
}

/// Additions that every set has, by name.
std::vector<std::string> in_all(const std::vector<SetOfAdditions>& sets) {
    std::vector<std::string> common;
    for (const Addition& one : sets.front().additions) {
        const bool is_in_all = std::ranges::all_of(sets, [&](const SetOfAdditions& set) {
            return std::ranges::any_of(set.additions, [&](const Addition& other) { return other.is_same_cause(one); });
        });
        if (is_in_all) {
            common.push_back(one.name());
        }
    }
    return common;
}

/// What sets of additions predict, and what they explain where they are fitted.
void say_sets(std::vector<std::string>& all, const QuotedRecord& record, const Analysis& analysis) {
    if (analysis.sizes.size() > 1) {
        const SetOfAdditions& best = *std::ranges::min_element(
            analysis.sizes, {}, [](const SetOfAdditions& set) { return set.held_out.rms_after; });
        const bool is_beyond = best.further.removed.low > 0.0;
        all.push_back(fmt::format(
            "Of sets of up to {}, {} predict best: they remove {}{}.", plural(most_additions, "addition"),
            additions_text(best), removed_text(best.held_out.removed),
            !is_beyond ? ", which is not proven"
            : best.choice.removed.low > 0.0
                ? ""
                : fmt::format(
                      "; chosen anew without each experiment it is {} (95 %: {} to {}), so the choice is not proven",
                      percent(best.choice.removed.value), percent(best.choice.removed.low),
                      percent(best.choice.removed.high))));
    }
    if (analysis.agreeing.empty()) {
        if (!analysis.sizes.empty()) {
            all.push_back(fmt::format(
                "No set of up to {} within their plausible ranges was found that agrees with these numbers.",
                plural(most_additions, "addition")));
        }
        return;
    }
    const SetOfAdditions& set = analysis.agreeing.front();
    if (set.additions.size() < 2) {
        return;
    }
    const std::vector<std::string> common = in_all(analysis.agreeing);
    all.push_back(
        fmt::format("Fitted to all of them, {} together agree with these numbers, and no fewer were found that do: {}. "
                    "Simulated together they leave {:.1f} u{}. This is a fit, not evidence: they remove {}.",
                    plural(set.additions.size(), "addition"), additions_text(set), analysis.rms_after,
                    analysis.off_after.empty()
                        ? ""
                        : ", and " + experiments(record, analysis.off_after) +
                              (analysis.off_after.size() == 1 ? " stays" : " stay") + " off by more than 2 u",
                    removed_text(set.held_out.removed)));
    if (analysis.n_agreeing > 1) {
        all.push_back(fmt::format(
            "{} with one of them exchanged agree as well; {}.",
            analysis.n_agreeing == 2 ? "One other set" : fmt::format("{} other sets", analysis.n_agreeing - 1),
            common.empty() ? "no addition is in all"
                           : fmt::format("of those shown below, all have {}", fmt::join(common, " and "))));
    }
}

std::string set_text(const Analysis& analysis) {
    std::vector<std::string> names;
    for (const std::vector<std::string>& one : analysis.set) {
        names.push_back(fmt::format("{}", fmt::join(one, " + ")));
    }
    return fmt::format("{}", fmt::join(names, "; "));
}

std::string best_text(const Analysis& analysis) {
    if (analysis.attempts.empty()) {
        return "";
    }
    const SingleAddition& best = analysis.attempts.front();
    if (best.held_out.removed.value < 0.01) {
        return "No addition makes the error on experiments left out smaller.";
    }
    return fmt::format(
        "The largest single improvement is {}; it removes {} of the error on experiments left out, with a 95 % "
        "interval of {} to {} that {}.",
        value_text(best.addition, best.fit, 0), percent(best.held_out.removed.value),
        percent(best.held_out.removed.low), percent(best.held_out.removed.high),
        best.held_out.removed.low > 0.0 ? "stays above zero" : "includes zero: it is not proven");
}

/// What could explain the numbers that are off, if nothing else were asked.
std::string fitting_text(const Analysis& analysis) {
    if (analysis.off.empty() || analysis.attempts.empty()) {
        return "";
    }
    std::vector<std::string> names;
    const SingleAddition* best = &analysis.attempts.front();
    for (const SingleAddition& attempt : analysis.attempts) {
        if (attempt.fits) {
            names.push_back(value_text(attempt.addition, attempt.fit, 0));
        }
        best = attempt.rms_fitted < best->rms_fitted ? &attempt : best;
    }
    if (names.empty()) {
        return fmt::format(
            "Even fitted to all of them, no single addition within its plausible range agrees with these numbers; {} "
            "comes nearest and leaves {:.1f} u.",
            value_text(best->addition, best->fit, 0), best->rms_fitted);
    }
    return fmt::format("Fitted to all of them, {} would agree with these numbers: {}. This is a fit, not evidence.",
                       names.size() == 1 ? "one addition" : fmt::format("each of {} additions", names.size()),
                       fmt::join(names, "; "));
}

/// One analysis in words. @param which "the decidable numbers"
void say(std::vector<std::string>& all, const QuotedRecord& record, const Analysis& analysis, const char* which) {
    const std::string lead =
        fmt::format("{} {} of {} ({}) leave an rms error of {:.1f} u{}.", analysis.n_rows, which,
                    plural(analysis.experiments.size(), "experiment"), experiments(record, analysis.experiments),
                    analysis.rms, analysis.kelvin > 0.0 ? fmt::format(" ({:.1f} K)", analysis.kelvin) : "");
    switch (analysis.verdict) {
        case Verdict::consistent:
            all.push_back(fmt::format(
                "The model agrees with the {} within their uncertainty: nothing is to be explained.", which));
            all.push_back(lead);
            return;
        case Verdict::cannot_tell:
            if (analysis.off.empty()) {
                all.push_back(fmt::format("The {} are too few for a conclusion.", which));
            } else {
                all.push_back(
                    fmt::format("Only {} {} off by more than 2 u. An explanation that is fitted there could not be "
                                "tested on another one: these numbers cannot name a cause, however well one fits.",
                                off_text(record, analysis), analysis.off.size() == 1 ? "is" : "are"));
            }
            all.push_back(lead);
            all.push_back(best_text(analysis));
            all.push_back(fitting_text(analysis));
            say_sets(all, record, analysis);
            return;
        case Verdict::unknown:
            all.push_back(
                fmt::format("No cause is proven: of the {} {} are off by more than 2 u, and no addition predicts "
                            "experiments that it was not fitted to better than the model as it is. The cause is none "
                            "of these alone, or the numbers are too uncertain to show it.",
                            which, off_text(record, analysis)));
            all.push_back(lead);
            all.push_back(best_text(analysis));
            all.push_back(fitting_text(analysis));
            say_sets(all, record, analysis);
            return;
        case Verdict::partial:
        case Verdict::named:
        case Verdict::confounded:
            break;
    }
    const SetOfAdditions& accepted = *analysis.accepted;
    const ShareInterval& removed = accepted.held_out.removed;
    if (analysis.verdict == Verdict::partial) {
        all.push_back(fmt::format("{} {} of the error on experiments left out (95 %: {} to {}).",
                                  additions_text(accepted), accepted.additions.size() == 1 ? "removes" : "remove",
                                  percent(removed.value), percent(removed.low), percent(removed.high)));
        all.push_back(lead);
        all.push_back(fmt::format("The other {} are none of these.", percent(1.0 - removed.value)));
    } else {
        all.push_back(fmt::format(
            "{} {} the {}: {} of the error on experiments left out is removed (95 %: {} to {}), and nothing "
            "significant is left.",
            additions_text(accepted), accepted.additions.size() == 1 ? "explains" : "explain", which,
            percent(removed.value), percent(removed.low), percent(removed.high)));
        all.push_back(lead);
    }
    if (analysis.set.size() > 1) {
        all.push_back("These numbers cannot tell apart: " + set_text(analysis) + ".");
    }
    for (std::size_t k = 0; k < accepted.additions.size(); ++k) {
        if (accepted.fit.is_bound[k]) {
            const Addition& addition = accepted.additions[k];
            all.push_back(fmt::format("{} ends at the limit of what is plausible: it may stand in for something else.",
                                      addition.name()));
        }
    }
    if (analysis.surrogate_error > 0.5) {
        all.push_back(fmt::format("Simulated together, the additions differ by up to {:.1f} u from what was fitted.",
                                  analysis.surrogate_error));
    }
}

}  // namespace

std::vector<std::string> quoted_sentences(const QuotedRecord& record) {
    const QuotedDiagnosis& result = record.result;
    std::vector<std::string> all;
    say(all, record, result.decidable, "decidable numbers");
    if (result.all.n_rows > result.decidable.n_rows) {
        all.emplace_back(
            "Weaker evidence, from all numbers, each as uncertain as the inputs that are not printed make it:");
        say(all, record, result.all, "numbers");
    }
    if (result.next) {
        const NextMeasurement& next = *result.next;
        all.push_back(fmt::format(
            "Discriminating measurement: {} at the end of {}. {} makes it {:.1f} degC, {} {:.1f} degC: {:.1f} times "
            "the {:.1f} K that a sensor can be trusted to.{}",
            next.channel, next.run, next.one, next.value_of_one, next.other, next.value_of_other,
            std::abs(next.value_of_one - next.value_of_other) / next.uncertainty, next.uncertainty,
            next.input.empty() || next.input_gain < 1.0
                ? ""
                : fmt::format(" Of the inputs that are not printed, {} is worth most to look up.", next.input)));
    }
    std::erase_if(all, [](const std::string& sentence) { return sentence.empty(); });
    return all;
}

}  // namespace tiretherm::post
