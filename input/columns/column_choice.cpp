// SPDX-License-Identifier: BSD-3-Clause
// What a case says about the columns that may be causes: [diagnose] signals and ignore; and the columns as results list them.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "input/columns/column_kinds.hpp"
#include "input/files/wildcard.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_shown = 20;  ///< columns that a message lists

bool is_meant(const std::vector<LocatedString>& words, std::string_view name) {
    return std::ranges::any_of(words, [&](const LocatedString& word) { return matches(word.text, name); });
}

/// What to do about a word that means no column.
std::string remedy_for(const LocatedString& word, const std::vector<std::string>& names) {
    if (names.empty()) {
        return "the runs have no column that the model does not use";
    }
    if (!is_pattern(word.text) && !nearest(word.text, names).empty()) {
        return suggest(word.text, names, "columns");
    }
    const std::size_t shown = std::min(names.size(), most_shown);
    const std::vector<std::string> some(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown));
    return shown == names.size()
               ? fmt::format("the columns are {}", listed(some))
               : fmt::format("the columns are {} and {} more", fmt::join(some, ", "), names.size() - shown);
}

/// What a word means instead of an unused column.
std::string meant_instead(const std::string& word, const std::vector<MeasuredRun>& runs) {
    if (physics::find_signal(word) != nullptr) {
        return fmt::format("{} is an input of the model, which is always tried", word);
    }
    for (const MeasuredRun& run : runs) {
        if (std::ranges::find(run.problem.channels, word, &solver::Channel::name) != run.problem.channels.end()) {
            return fmt::format("{} is a sensor: what it reads is an effect and no cause", word);
        }
    }
    return {};
}

}  // namespace

SignalChoice read_signal_choice(TomlTable& diagnose) {
    SignalChoice choice;
    choice.has_signals = diagnose.has("signals");
    choice.signals = diagnose.texts("signals");
    choice.ignored = diagnose.texts("ignore");
    return choice;
}

void choose_signals(const SignalChoice& choice, std::vector<MeasuredRun>& runs, InputErrors& errors) {
    const bool has_file = std::ranges::any_of(runs, [](const MeasuredRun& run) { return !run.file.empty(); });
    const bool unread =
        std::ranges::any_of(runs, [](const MeasuredRun& run) { return !run.file.empty() && run.time.empty(); });
    if (!has_file || unread) {
        return;
    }
    std::vector<std::string> names = names_of(unused_columns(runs));
    const auto means_none = [&](const LocatedString& word) {
        return std::ranges::none_of(names, [&](const std::string& name) { return matches(word.text, name); });
    };
    for (const LocatedString& word : choice.signals) {
        if (means_none(word)) {
            const std::string other = meant_instead(word.text, runs);
            errors.add(word.place,
                       other.empty() ? fmt::format("no column that the model does not use is called \"{}\"", word.text)
                                     : other,
                       other.empty() ? remedy_for(word, names) : "take it out of signals");
        }
    }
    for (const LocatedString& word : choice.ignored) {
        if (means_none(word)) {
            errors.warn(word.place,
                        "ignore of [diagnose] names \"{}\", which is no column that the model does "
                        "not use: {}",
                        word.text, remedy_for(word, names));
        }
    }
    for (MeasuredRun& run : runs) {
        for (UnusedSignal& signal : run.unused) {
            const bool named = is_meant(choice.signals, signal.name);
            const bool was = signal.may_be_cause;
            signal.may_be_cause = !is_meant(choice.ignored, signal.name) && (choice.has_signals ? named : was);
            if (was && !signal.may_be_cause) {
                signal.reason = is_meant(choice.ignored, signal.name) ? "left out by ignore of [diagnose]"
                                                                      : "not among signals of [diagnose]";
            }
        }
    }
}

std::vector<ColumnSummary> unused_columns(const std::vector<MeasuredRun>& runs) {
    std::vector<ColumnSummary> columns;
    std::set<std::string_view> known;
    for (const MeasuredRun& run : runs) {
        for (const UnusedSignal& signal : run.unused) {
            if (known.insert(signal.name).second) {
                columns.push_back({.name = signal.name,
                                   .kind = signal.kind,
                                   .reason = signal.reason,
                                   .may_be_cause = signal.may_be_cause});
            }
        }
    }
    return columns;
}

std::string_view text_of(ColumnKind kind) {
    return kind == ColumnKind::temperature_of_tire ? "temperature of the tire" : word_of(kind);
}

std::string_view word_of(ColumnKind kind) {
    switch (kind) {
        case ColumnKind::drive:
            return "drive";
        case ColumnKind::temperature_of_tire:
            return "temperature_of_tire";
        case ColumnKind::copy:
            return "copy";
        case ColumnKind::result:
            return "result";
        case ColumnKind::clock:
            return "clock";
        case ColumnKind::constant:
            return "constant";
    }
    return "";
}

}  // namespace tiretherm::input
